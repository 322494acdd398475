//! How closely things must agree: the only table of tolerances, each with its reason.
//!
//! Errors are relative to the largest entry of the expected vector or matrix.

/// Residual and tangent of random, well-conditioned states against the oracle. The states have gaps of at
/// least 1e-2 of their size, at up to a few sizes from the origin, so the gap alone carries up to about
/// 5e-16·10³ of rounding; shallower gaps are judged by the spread of their data in the reference cases.
pub const RANDOM: f64 = 1e-12;

/// Energy of the same states: it grows with the square of the gap, so its relative error is twice the gap's.
pub const ENERGY: f64 = 2.0 * RANDOM;

/// Output of contact points of the same states: gap and projection relative to the size of the problem, where
/// they carry the rounding of a few coordinates; traction, weight and normal as R, which is their product.
pub const POINTS: f64 = RANDOM;

/// Steps of frictional sequences: every step passes on the rounding of its anchor; up to eight in a row.
pub const SEQUENCES: f64 = 10.0 * RANDOM;

/// Reference cases: this, or [`REFERENCE_SPREADS`] times what half an ulp of noise in the data does.
pub const REFERENCE: f64 = 1e-13;
/// See [`REFERENCE`].
pub const REFERENCE_SPREADS: f64 = 8.0;

/// The edge cases sit on boundaries and at tiny gaps of 1e-9 of the size: the gap keeps only about
/// 2e-16·10⁹ relative digits; both sides carry that noise.
pub const EDGE: f64 = 1e-6;

/// Balance of force and moment, relative to the largest nodal force (times the size for the moment): a sum
/// of at most 18 rounded terms.
pub const BALANCE: f64 = 1e-12;

/// Rigid motion: states moved by a random rotation and a shift of ten sizes; coordinates then carry ten
/// times the rounding, gaps of 1e-3 another factor of 10³.
pub const MOTION: f64 = 1e-10;

/// Change of units by 1000: not a power of two, so every coordinate is rounded again.
pub const UNITS: f64 = 1e-11;

/// Distance at a foot of the global projection and against the nearest of a grid, relative to the size: rounding of a
/// sum over the nodes, several sizes from the origin.
pub const FOOT: f64 = 1e-12;

/// r·r_,i at a foot, relative to the larger of |r_,i| and √F_ii times the size: flat minima leave the root of the
/// rounding of r·r, which is √F_ii times a distance in the slope.
pub const STATIONARY: f64 = 1e-7;

/// K − Kᵀ of symmetric elements: the same products summed in another order.
pub const SYMMETRY: f64 = 1e-13;

/// A term that moves no entry by more than this vanishes: sines and cosines cancel to rounding.
pub const NO_CHANGE: f64 = 1e-14;

/// Derivatives in the tables (shape rows to third order, law slopes, distance gradients) against duals of
/// the declared values, relative to the largest entry of the row block.
pub const DERIVATIVES: f64 = 1e-12;

/// Slopes of the error of `tangent_plane` elements in L, between L/16 and L/64: 1 for D²g, 2 for the
/// whole tangent with r0 = 0; with friction at a given force at least 1 for the whole tangent, and 1 for the
/// balance of moment.
pub const SLOPE: f64 = 0.05;

/// A `tangent_plane` tangent that agrees this closely at L ≠ 0 means that the check sees nothing.
pub const SLOPE_FLOOR: f64 = 1e-9;

/// Largest error of `found` against `expected`, relative to the largest expected entry; a NaN
/// counts as infinite.
pub fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let top = expected.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut worst = 0.0_f64;
    for (a, b) in found.iter().zip(expected) {
        let difference = (a - b).abs();
        if difference.is_nan() {
            return f64::INFINITY;
        }
        worst = worst.max(difference);
    }
    if worst == 0.0 { 0.0 } else { worst / top }
}
