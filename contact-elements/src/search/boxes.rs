//! Branch and bound over boxes of parameters.

use super::descent::{Foot, definiteness, dot, least_in_box, square};
use super::enclosure::{Enclosure, size};
use super::interval::{Interval, MOST_OPERATIONS, Scratch};
use super::sides::{Local, Sides};
use super::{Closest, MOST_BOXES, Verdict};
use crate::arithmetic::{abs, sqrt};
use crate::runtime::Domain;

/// What stands for a missing bound of a domain.
const FAR: f64 = 1e12;
/// Boxes that wait.
const WAITING: usize = 256;
/// Boxes narrower than this part of the extent are split no more.
const NARROW: f64 = 1e-9;
/// Squared distances that differ by less than this part are the same.
const SAME: f64 = 1e-10;
/// Feet nearer than this part of the extent are the same.
const NEAR: f64 = 1e-6;
/// Least definiteness of a unique foot.
pub(super) const REGULAR: f64 = 1e-13;

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
    p: usize,
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
    fn feature(&self, zeta: &[f64; 2], outward: &[f64; 2]) -> u8 {
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

/// Bounds of parameter `i`; infinite where there is none.
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
    fn keep(&mut self, i: usize, value: f64) {
        if let (Some(lower), Some(upper)) = (self.lower.get_mut(i), self.upper.get_mut(i)) {
            (*lower, *upper) = (value, value);
        }
        if self.is_diagonal {
            (self.lower[1], self.upper[1]) = (1.0 - value, 1.0 - value);
        }
    }

    /// Leaves what lies on the diagonal; false where nothing does.
    fn move_to_diagonal(&mut self) -> bool {
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
    fn halves(&self, i: usize) -> (Self, Self) {
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

/// The state of a search.
pub(super) struct Search<'a> {
    sides: &'a Sides<'a>,
    region: Region,
    waiting: [Box; WAITING],
    count: usize,
    /// Squared distance of the best foot, or of the reach.
    best: f64,
    foot: Option<Foot>,
    /// Another foot as near as the best.
    is_double: bool,
    overflows: bool,
    boxes: u32,
    steps: u32,
}

impl<'a> Search<'a> {
    pub(super) fn new(sides: &'a Sides<'a>, region: Region, reach: f64) -> Self {
        Self {
            sides,
            region,
            waiting: [Box::default(); WAITING],
            count: 0,
            best: if reach > 0.0 { reach * reach } else { f64::MAX },
            foot: None,
            is_double: false,
            overflows: false,
            boxes: 0,
            steps: 0,
        }
    }

    /// Looks at boxes until none is left.
    pub(super) fn run(mut self) -> Closest {
        let mut scratch = [Interval::ZERO; MOST_OPERATIONS];
        let whole = Box {
            lower: self.region.lower,
            upper: self.region.upper,
            is_diagonal: false,
        };
        self.sample(&whole);
        self.push(whole);
        while let Some(next) = self.pop() {
            if self.boxes == MOST_BOXES {
                self.overflows = true;
                break;
            }
            self.boxes += 1;
            self.look(next, &mut scratch);
        }
        self.finish()
    }

    /// A distance to begin with: the least of a few points.
    fn sample(&mut self, whole: &Box) {
        const SHARES: [f64; 4] = [0.08, 0.36, 0.64, 0.92];
        let near = |lower: f64, upper: f64| {
            let (low, high) = match upper - lower >= FAR {
                true => (-4.0, 4.0),
                false => (lower, upper),
            };
            SHARES.map(|share| (low + share * (high - low)).max(lower).min(upper))
        };
        let mut least = f64::MAX;
        for first in near(whole.lower[0], whole.upper[0]) {
            for last in near(whole.lower[1], whole.upper[1]) {
                let last = match self.region.triangle {
                    true => last * (1.0 - first),
                    false => last,
                };
                least = least.min(square(&self.sides.at(&[first, last]).r));
            }
        }
        // nothing farther than this point is looked at
        self.best = self.best.min(least * (1.0 + SAME));
    }

    fn push(&mut self, next: Box) {
        match self.waiting.get_mut(self.count) {
            Some(place) => {
                *place = next;
                self.count += 1;
            }
            None => self.overflows = true,
        }
    }

    fn pop(&mut self) -> Option<Box> {
        self.count = self.count.checked_sub(1)?;
        self.waiting.get(self.count).copied()
    }

    /// Drops a box, takes its only minimum, or splits it.
    fn look(&mut self, mut next: Box, scratch: &mut Scratch) {
        if self.region.triangle && !next.is_diagonal && next.lower[0] + next.lower[1] > 1.0 {
            return;
        }
        let known = Enclosure::new(self.sides, &next, self.region.p, scratch);
        if known.least > self.best * (1.0 + SAME) {
            return;
        }
        match self.shrink(&mut next, &known.slopes) {
            Some(false) => return,
            Some(true) => return self.push(next),
            None => {}
        }
        let widths = self.widths(&next);
        let widest = if widths[1] > widths[0] { 1 } else { 0 };
        let is_wide = |i: usize| i < self.region.p && next.upper[i] > next.lower[i];
        let wide = [is_wide(0), is_wide(1) && !next.is_diagonal];
        if known.is_convex(wide) || known.is_point || widths[widest] < NARROW {
            let (foot, steps) = least_in_box(self.sides, &next, self.region.triangle);
            self.steps += steps;
            return self.take(foot);
        }
        let (low, high) = next.halves(widest);
        self.push(low);
        self.push(high);
    }

    /// Where r·r has no stationary point along a parameter: drops the box (false) or leaves the face of the
    /// domain towards which it falls (true).
    fn shrink(&self, next: &mut Box, slopes: &[Interval; 2]) -> Option<bool> {
        let ends = if next.is_diagonal {
            ([0.0; 2], [1.0; 2])
        } else {
            (self.region.lower, self.region.upper)
        };
        for i in (0..2).take(self.region.p) {
            if next.upper[i] <= next.lower[i] || (next.is_diagonal && i == 1) {
                continue;
            }
            if slopes[i].lower > 0.0 {
                if next.lower[i] > ends.0[i] {
                    return Some(false);
                }
                next.keep(i, next.lower[i]);
                return Some(true);
            }
            if slopes[i].upper < 0.0 {
                if self.region.triangle && !next.is_diagonal {
                    if next.upper[0] + next.upper[1] < 1.0 {
                        return Some(false);
                    }
                    return Some(next.move_to_diagonal());
                }
                if next.upper[i] < ends.1[i] {
                    return Some(false);
                }
                next.keep(i, next.upper[i]);
                return Some(true);
            }
        }
        None
    }

    /// Widths relative to the extents; of unbounded parameters their own size.
    fn widths(&self, next: &Box) -> [f64; 2] {
        [0_usize, 1].map(|i| {
            let i = i.min(1);
            let width = (next.upper[i] - next.lower[i]) / self.extent(i);
            if next.is_diagonal && i == 1 {
                0.0
            } else {
                width
            }
        })
    }

    fn extent(&self, i: usize) -> f64 {
        let i = i.min(1);
        let extent = self.region.upper[i] - self.region.lower[i];
        // never zero: what is divided by it may be divided before anyone looks
        if extent > 0.0 && extent < FAR {
            extent
        } else {
            1.0
        }
    }

    /// Keeps the nearer of two feet.
    fn take(&mut self, foot: Foot) {
        let near = |other: &Foot| {
            (0..2)
                .take(self.region.p)
                .all(|i| abs(foot.zeta[i] - other.zeta[i]) <= NEAR * self.extent(i))
        };
        let Some(best) = self.foot else {
            if foot.square <= self.best * (1.0 + SAME) {
                (self.best, self.foot) = (foot.square.min(self.best), Some(foot));
            }
            return;
        };
        if foot.square < best.square * (1.0 - SAME) {
            (self.best, self.foot, self.is_double) = (foot.square, Some(foot), false);
        } else if foot.square <= best.square * (1.0 + SAME) {
            if !near(&best) && self.are_apart(&foot, &best) {
                self.is_double = true;
            } else if foot.square < best.square {
                (self.best, self.foot) = (foot.square, Some(foot));
            }
        }
    }

    /// Two feet are two points of the slave or of the master: not the same one of a closed curve.
    fn are_apart(&self, a: &Foot, b: &Foot) -> bool {
        let size = size(&self.sides.at(&a.zeta), self.region.p);
        let (first, last) = (self.sides.positions(&a.zeta), self.sides.positions(&b.zeta));
        first.iter().zip(last).any(|(first, last)| {
            let difference = [first[0] - last[0], first[1] - last[1], first[2] - last[2]];
            square(&difference) > NEAR * NEAR * size * size
        })
    }

    fn finish(self) -> Closest {
        let mut closest = Closest {
            verdict: Verdict::Beyond,
            zeta: [0.0; 2],
            distance: 0.0,
            feature: 0,
            definiteness: 0.0,
            boxes: self.boxes,
            steps: self.steps,
        };
        if let Some(foot) = self.foot {
            let local = self.sides.at(&foot.zeta);
            closest.zeta = foot.zeta;
            closest.distance = sqrt(foot.square);
            closest.feature = self
                .region
                .feature(&foot.zeta, &self.outward(&foot, &local));
            closest.definiteness = definiteness(&local, self.region.p);
            closest.verdict = if self.is_double {
                Verdict::NotUnique
            } else if closest.feature != 0 {
                Verdict::Boundary
            } else if closest.definiteness > REGULAR {
                Verdict::Inside
            } else {
                Verdict::NotUnique
            };
        }
        if self.overflows {
            closest.verdict = Verdict::Undecided;
        }
        closest
    }

    /// The sides of the domain that hold a foot: r·r falls beyond them, by more than rounding.
    fn outward(&self, foot: &Foot, local: &Local<f64>) -> [f64; 2] {
        let slopes = [0_usize, 1].map(|i| {
            let i = i.min(1);
            dot(&local.r, &local.b[i])
        });
        let rounding =
            |i: usize| 1e-12 * sqrt(square(&local.b[i.min(1)])) * size(local, self.region.p);
        let (low, high) = (self.region.lower, self.region.upper);
        let slack = |i: usize| 1e-12 * self.extent(i);
        let diagonal = self.region.triangle
            && foot.zeta[0] + foot.zeta[1] >= 1.0 - slack(0)
            && slopes[0] + slopes[1] < -(rounding(0) + rounding(1));
        let mean = if diagonal {
            0.5 * (slopes[0] + slopes[1])
        } else {
            0.0
        };
        core::array::from_fn(|i| {
            if i >= self.region.p {
                return 0.0;
            }
            let i = i.min(1);
            let slope = slopes[i] - mean;
            let below = foot.zeta[i] <= low[i] + slack(i) && slope > rounding(i);
            let above = foot.zeta[i] >= high[i] - slack(i) && slope < -rounding(i) && !diagonal;
            f64::from(u8::from(above || diagonal)) - f64::from(u8::from(below))
        })
    }
}
