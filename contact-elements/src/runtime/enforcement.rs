//! A multiplier λ beside the normal law: N = λ + N(g), closed where N < 0. [eq:augmented] [eq:multiplier]
//!
//! ```text
//! W = N²/(2c) − λ²/(2c) ,  R = ∂W/∂x = N n·δr ,  R_λ = ∂W/∂λ = g      closed, c = N'
//! W =         − λ²/(2c) ,  R = 0              ,  R_λ = −λ/c           open
//! ```
//!
//! The history's multiplier is no unknown: R_λ and −λ²/(2c) are left out.

use super::classify::Point;
use super::driver::Stage;
use super::element::Element;
use super::friction::{Tangential, TangentialLaw};
use super::placement::Placement;
use super::receiver::{Call, Receiver};
use super::shape::Traction;
use super::sliding::Sliding;
use crate::arithmetic::abs;

/// How the normal law holds the bodies apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enforcement {
    /// By itself.
    Penalty,
    /// Beside a multiplier that the history carries.
    Augmented,
    /// Beside a multiplier that is an unknown.
    Multiplier,
}

/// Least stiffness of a law beside a multiplier, and largest traction: λ/c and N²/c stay numbers, and the history
/// takes every multiplier.
const LEAST_STIFFNESS: f64 = 1e-200;
const LARGEST_TRACTION: f64 = 1e30;

/// Traction and energy of a closed point with a multiplier beside its law; none where the law is no spring here or
/// the traction too large. N² − λ² is formed as N(g) (N + λ): nothing cancels at small gaps.
#[inline(always)]
pub(super) fn enforced<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    law: Traction,
    multiplier: f64,
) -> Option<Traction> {
    let traction = multiplier + law.traction;
    let (first, last) = if E::MULTIPLIER {
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

/// What the history of a closed point says next time. [eq:uzawa]
#[inline(always)]
pub(super) fn remembered(traction: f64) -> f64 {
    traction.min(0.0)
}

/// Adds R_λ = −λ/c of an open point and its derivative; returns its energy. [eq:multiplier-open]
#[inline(never)]
pub(super) fn open<R: Receiver>(
    call: &Call<'_>,
    (node, unknown): (usize, usize),
    (multiplier, slope): (f64, f64),
    weight: f64,
    receiver: &mut R,
) -> f64 {
    if call.wanted.residual {
        receiver.multiplier((node, unknown), -weight * (multiplier / slope));
    }
    if call.wanted.tangent {
        receiver.coupling(unknown, unknown, -weight / slope);
    }
    -0.5 * weight * multiplier * (multiplier / slope)
}

/// Number of a contact point, the point, its normal in the global frame, its weight.
type Enforced<'a, const D: usize, const P: usize, const H: usize> =
    (usize, &'a Point<D, P, H>, &'a [f64; D], f64);

/// Adds R_λ = g of a closed point, ∂R_λ/∂x = n·δr and ∂R/∂λ = n·δr − h_q Z_q. [eq:multiplier-closed]
#[inline(never)]
pub(super) fn closed<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &Stage<'_, D, P, H>,
    placement: &Option<Placement<D>>,
    sliding: &Sliding<P>,
    (number, point, n, weight): Enforced<'_, D, P, H>,
    receiver: &mut R,
) {
    let (node, unknown) = (stage.x.len() + number, stage.x.len() * D + number);
    if call.wanted.residual {
        receiver.multiplier((node, unknown), weight * point.gap.gap);
    }
    if !call.wanted.tangent {
        return;
    }
    for (a, &s) in stage.rows.s.iter().enumerate() {
        for k in 0..D {
            let value = weight * s * n[k];
            receiver.coupling(unknown, a * D + k, value);
            receiver.coupling(a * D + k, unknown, value);
        }
    }
    if E::Tangential::ACTIVE {
        let back = Tangential {
            t: sliding.tangential.h.map(|h| -h),
            ..Tangential::default()
        };
        super::sliding::spread_force::<E, D, P, H>(
            (stage, placement),
            (point, &sliding.frame, &back),
            (n, weight),
            |(a, k), value| receiver.coupling(a * D + k, unknown, value),
        );
    }
}
