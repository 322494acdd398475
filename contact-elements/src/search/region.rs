//! Domains of the projected parameters and boxes of them.

use super::pair::Sides;
use crate::point::domain::Domain;

/// Stands for a missing bound of a domain.
pub(super) const FAR: f64 = 1e12;

/// The domain of all projected parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    pub(super) lower: [f64; 2],
    pub(super) upper: [f64; 2],
    /// ξ + η ≤ 1
    pub(super) triangle: bool,
    /// Parameters of the slave curve: 0 or 1.
    own: usize,
    domains: [Domain; 2],
    pub(super) p: usize,
}

impl Region {
    pub(super) fn new(sides: &Sides<'_>, domains: &[Domain; 2], periods: &[f64; 2]) -> Self {
        let (own, p) = (sides.slave.parameters(), sides.parameters());
        let (mut lower, mut upper) = ([0.0; 2], [0.0; 2]);
        for (i, (lower, upper)) in lower.iter_mut().zip(&mut upper).enumerate().take(p) {
            let [first, last] = domains;
            let (domain, at) = if own == 1 && i == 1 {
                (last, 0)
            } else {
                (first, i)
            };
            let (low, high) = bounds(domain, at);
            // one period is all there is
            let half = match i.checked_sub(own).and_then(|at| periods.get(at)) {
                Some(&period) if period > 0.0 => 0.5 * period,
                _ => FAR,
            };
            (*lower, *upper) = (low.max(-half), high.min(half));
        }
        Self {
            lower,
            upper,
            triangle: p == 2 && own == 0 && matches!(domains, [Domain::Triangle, _]),
            own,
            domains: *domains,
            p,
        }
    }

    /// 0, or the feature just beyond ζ on the sides that hold it.
    pub(super) fn feature(&self, zeta: &[f64; 2], outward: &[f64; 2]) -> u8 {
        let mut beyond = *zeta;
        for (i, value) in beyond.iter_mut().enumerate().take(self.p) {
            *value += 1e-6 * (self.upper[i] - self.lower[i]) * outward[i];
        }
        let [first, last] = &self.domains;
        if self.own == 0 {
            return first.feature(beyond, 0.0);
        }
        let ends = [(first, beyond[0]), (last, beyond[1])];
        match ends.map(|(domain, zeta)| domain.feature([zeta, 0.0], 0.0)) {
            [0, 0] => 0,
            [end, 0] => end - 4,
            [0, end] => end - 2,
            [slave, master] => slave + 2 * (master - 5),
        }
    }
}

/// Bounds of parameter `i`; infinite where a bound is missing.
fn bounds(domain: &Domain, i: usize) -> (f64, f64) {
    match *domain {
        Domain::Interval(lower, upper) => (lower, upper),
        Domain::Rectangle(lower, upper) => (lower[i.min(1)], upper[i.min(1)]),
        Domain::Triangle => (0.0, 1.0),
        Domain::Unbounded => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

/// A box of parameters.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Box {
    pub(super) lower: [f64; 2],
    pub(super) upper: [f64; 2],
    /// The piece ζ = (t, 1 − t) of the diagonal of a triangle, t from lower to upper of the first parameter.
    pub(super) is_diagonal: bool,
}

impl Box {
    pub(super) fn middle(&self) -> [f64; 2] {
        let middle = [0_usize, 1].map(|i| {
            let i = i.min(1);
            0.5 * (self.lower[i] + self.upper[i])
        });
        if self.is_diagonal {
            [middle[0], 1.0 - middle[0]]
        } else {
            middle
        }
    }

    /// Parameter `i` at one value only.
    pub(super) fn keep(&mut self, i: usize, value: f64) {
        if let (Some(lower), Some(upper)) = (self.lower.get_mut(i), self.upper.get_mut(i)) {
            (*lower, *upper) = (value, value);
        }
        if self.is_diagonal {
            (self.lower[1], self.upper[1]) = (1.0 - value, 1.0 - value);
        }
    }

    /// Leaves what lies on the diagonal; false if nothing does.
    pub(super) fn move_to_diagonal(&mut self) -> bool {
        let low = self.lower[0].max(1.0 - self.upper[1]);
        let high = self.upper[0].min(1.0 - self.lower[1]);
        *self = Self {
            lower: [low, 1.0 - high],
            upper: [high, 1.0 - low],
            is_diagonal: true,
        };
        low <= high
    }

    /// Two halves along parameter `i`.
    pub(super) fn halves(&self, i: usize) -> (Self, Self) {
        let (mut low, mut high) = (*self, *self);
        let i = i.min(1);
        let middle = 0.5 * (self.lower[i] + self.upper[i]);
        (low.upper[i], high.lower[i]) = (middle, middle);
        if self.is_diagonal {
            (low.lower[1], high.upper[1]) = (1.0 - middle, 1.0 - middle);
        }
        (low, high)
    }
}
