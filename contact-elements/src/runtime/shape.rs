//! What a declaration becomes: traits that the macro implements.

use super::batch::Wide;
use super::real::Real;
use super::values::{ShapeRows, Vectors};
use crate::arithmetic::abs;

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
    /// Start of the projection where the host gives none.
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
    pub(super) fn contains<T: Wide>(&self, zeta: [T; 2], slack: f64) -> T::Mask {
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

/// Curve (P = 1) or surface (P = 2) by N shape functions.
pub trait Shape<const P: usize, const H: usize, const N: usize> {
    /// Parameter domain.
    const DOMAIN: Domain;
    /// True where all second derivatives vanish: the projection is one linear solve.
    const AFFINE: bool;
    /// Number of weights of a rational geometry, else 0.
    const WEIGHTS: usize;
    /// Controls that are tangent vectors, not positions.
    const VECTORS: [bool; N];
    /// False where the N_A,ij vanish identically.
    const CURVED: [bool; H];
    /// N_A, N_A,i, N_A,ij.
    fn rows<T: Real>(zeta: &[T; P], weights: &[T]) -> ShapeRows<P, H, N, T>;
    /// N_A,111, N_A,112, N_A,122, N_A,222; a curve has the first only.
    fn third(zeta: &[f64; P], weights: &[f64]) -> [[f64; N]; 4];
}

/// Rigid curve or surface ρ(ζ; parameters).
pub trait Rigid<const D: usize, const P: usize, const H: usize> {
    /// Parameter domain.
    const DOMAIN: Domain;
    /// True where all second derivatives vanish.
    const AFFINE: bool;
    /// ρ, ρ_i, ρ_ij as the `r`, `b`, `second` of a position.
    fn position<T: Real>(zeta: &[T; P], parameters: &[T]) -> Vectors<D, P, H, T>;
    /// ρ_,111, ρ_,112, ρ_,122, ρ_,222; a curve has the first only.
    fn third(zeta: &[f64; P], parameters: &[f64]) -> [[f64; D]; 4];
    /// Closed projection of the point x, where declared.
    fn projection(x: &[f64; D], parameters: &[f64]) -> Option<[f64; P]>;
}

/// Rigid distance function d(x; parameters) of D coordinates. Its programs belong to the element.
pub trait Distance<const D: usize> {}

/// N, N' and W of a normal law at one gap.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traction<T = f64> {
    /// N = W', negative in contact.
    pub traction: T,
    /// N'
    pub slope: T,
    /// W; 0 where the law declares none.
    pub energy: T,
}

/// Normal law N(g; parameters). [eq:law]
pub trait NormalLaw {
    /// Number of parameters.
    const PARAMETERS: usize;
    /// True where the law declares its energy.
    const ENERGY: bool;
    /// True where the law acts below some gap, false where above.
    const CLOSES_BELOW: bool;
    /// Positive where the law acts.
    fn active<T: Real>(gap: T, parameters: &[T]) -> T;
    /// Positive where the law is defined.
    fn valid<T: Real>(gap: T, parameters: &[T]) -> T;
    /// N, N', W.
    fn evaluate<T: Real>(gap: T, parameters: &[T]) -> Traction<T>;
}
