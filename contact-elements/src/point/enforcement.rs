//! A multiplier λ beside the normal law: N = λ + N(g), closed where N < 0. [eq:augmented] [eq:multiplier]
//!
//! ```text
//! W = N²/(2c) − λ²/(2c) ,  R = ∂W/∂x = N n·δr ,  R_λ = ∂W/∂λ = g      closed, c = N'
//! W =         − λ²/(2c) ,  R = 0              ,  R_λ = −λ/c           open
//! ```
//!
//! A multiplier of the history is not an unknown: R_λ and −λ²/(2c) are left out.

use crate::arithmetic::abs;
use crate::point::law::Traction;

/// Least stiffness of a law with a multiplier, and largest traction: λ/c and N²/c stay finite, and the history
/// can hold every multiplier.
const LEAST_STIFFNESS: f64 = 1e-200;
const LARGEST_TRACTION: f64 = 1e30;

/// Traction and energy of a closed point with a multiplier; `None` where the law is not a spring or
/// the traction is too large. `is_unknown` says whether the multiplier is an unknown.
///
/// N² − λ² is formed as N(g) (N + λ): nothing cancels at small gaps.
#[inline(always)]
pub(crate) fn enforced(law: Traction, multiplier: f64, is_unknown: bool) -> Option<Traction> {
    let traction = multiplier + law.traction;
    let (first, last) = if is_unknown {
        (law.traction, traction + multiplier)
    } else {
        (traction, traction)
    };
    let is_spring = law.slope >= LEAST_STIFFNESS
        && abs(law.traction) <= LARGEST_TRACTION
        && abs(traction) <= LARGEST_TRACTION;
    is_spring.then(|| Traction {
        traction,
        slope: law.slope,
        energy: 0.5 * first * (last / law.slope),
    })
}

/// Multiplier of a closed point for the trial history. [eq:uzawa]
#[inline(always)]
pub(crate) fn remembered(traction: f64) -> f64 {
    traction.min(0.0)
}
