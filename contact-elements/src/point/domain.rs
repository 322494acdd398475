//! Parameter domain of a geometry.

use crate::arithmetic::abs;
use crate::lanes::Wide;

/// Parameter domain of a geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// No bounds.
    Unbounded,
    /// lower ≤ ξ ≤ upper.
    Interval(f64, f64),
    /// lower_i ≤ ξ^i ≤ upper_i.
    Rectangle([f64; 2], [f64; 2]),
    /// ξ, η ≥ 0, ξ + η ≤ 1.
    Triangle,
}

impl Domain {
    /// Start of the projection if the host gives none.
    #[inline(always)]
    pub const fn centre(&self) -> [f64; 2] {
        match *self {
            Domain::Unbounded => [0.0, 0.0],
            Domain::Interval(lower, upper) => [middle(lower, upper), 0.0],
            Domain::Rectangle(lower, upper) => {
                [middle(lower[0], upper[0]), middle(lower[1], upper[1])]
            }
            Domain::Triangle => [1.0 / 3.0, 1.0 / 3.0],
        }
    }

    /// Extent by which steps in parameter i are measured; infinite where an end is missing.
    #[inline(always)]
    pub const fn extent(&self, i: usize) -> f64 {
        match *self {
            Domain::Interval(lower, upper) => upper - lower,
            Domain::Rectangle(lower, upper) => upper[i] - lower[i],
            Domain::Triangle => 1.0,
            Domain::Unbounded => f64::INFINITY,
        }
    }

    /// 0 inside; 1 + edge (0 … 3) or 5 + vertex (0 … 3) outside. A point within `slack` of the
    /// boundary counts as inside.
    #[inline(always)]
    pub fn feature(&self, zeta: [f64; 2], slack: f64) -> u8 {
        match *self {
            Domain::Unbounded => 0,
            Domain::Interval(lower, upper) => {
                const FEATURE: [u8; 3] = [0, 5, 6];
                FEATURE[side(zeta[0], lower, upper, slack)]
            }
            Domain::Rectangle(lower, upper) => {
                let side = |i: usize| side(zeta[i], lower[i], upper[i], slack);
                // edges: 0 η low, 1 ξ high, 2 η high, 3 ξ low; vertices counter-clockwise from (low, low)
                const FEATURE: [[u8; 3]; 3] = [[0, 1, 3], [4, 5, 8], [2, 6, 7]];
                FEATURE[side(0)][side(1)]
            }
            Domain::Triangle => triangle_feature(zeta, slack),
        }
    }

    /// Where [`Domain::feature`] is 0, lane by lane.
    #[inline(always)]
    pub(crate) fn contains<T: Wide>(&self, zeta: [T; 2], slack: f64) -> T::Mask {
        let within = |zeta: T, lower: f64, upper: f64| {
            let slack = slack_of(lower, upper, slack);
            let (low, high) = (T::constant(lower - slack), T::constant(upper + slack));
            !zeta.below(low) & !high.below(zeta)
        };
        match *self {
            Domain::Unbounded => T::mask(T::all()),
            Domain::Interval(lower, upper) => within(zeta[0], lower, upper),
            Domain::Rectangle(lower, upper) => {
                within(zeta[0], lower[0], upper[0]) & within(zeta[1], lower[1], upper[1])
            }
            Domain::Triangle => {
                let (low, high) = (T::constant(-slack), T::constant(1.0 + slack));
                let outside =
                    zeta[0].below(low) | zeta[1].below(low) | high.below(zeta[0] + zeta[1]);
                !outside
            }
        }
    }
}

/// 0 within the bounds, 1 below, 2 above; slack relative to the extent, or to the one bound that is finite.
#[inline(always)]
fn side(zeta: f64, lower: f64, upper: f64, slack: f64) -> usize {
    let slack = slack_of(lower, upper, slack);
    if zeta < lower - slack {
        1
    } else if zeta > upper + slack {
        2
    } else {
        0
    }
}

#[inline(always)]
fn slack_of(lower: f64, upper: f64, slack: f64) -> f64 {
    slack
        * match (lower > -f64::MAX, upper < f64::MAX) {
            (true, true) => upper - lower,
            (true, false) => abs(lower),
            (false, true) => abs(upper),
            (false, false) => 0.0,
        }
}

/// Middle of an interval; the finite end, or 0, where an end is missing.
const fn middle(lower: f64, upper: f64) -> f64 {
    match (lower > -f64::MAX, upper < f64::MAX) {
        (true, true) => 0.5 * (lower + upper),
        (true, false) => lower,
        (false, true) => upper,
        (false, false) => 0.0,
    }
}

/// Edges: 0 η = 0, 1 ξ + η = 1, 2 ξ = 0; vertices (0,0), (1,0), (0,1).
#[inline(always)]
fn triangle_feature(zeta: [f64; 2], slack: f64) -> u8 {
    let low = zeta[1] < -slack;
    let left = zeta[0] < -slack;
    let beyond = zeta[0] + zeta[1] > 1.0 + slack;
    match (low, left, beyond) {
        (false, false, false) => 0,
        (true, false, false) => 1,
        (false, false, true) => 2,
        (false, true, false) => 3,
        (true, true, _) => 5,
        (true, false, true) => 6,
        (false, true, true) => 7,
    }
}
