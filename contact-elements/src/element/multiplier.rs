//! Residual and tangent of a multiplier that is an unknown. [eq:multiplier]

use crate::element::receiver::{Call, Receiver};
use crate::element::sliding::spread_force;
use crate::element::stage::Stage;
use crate::element::traits::Element;
use crate::point::friction::{Tangential, TangentialLaw};
use crate::point::placement::Placement;
use crate::point::state::{Point, Sliding};

/// Adds R_λ = −λ/c of an open point and its derivative; returns its energy. [eq:multiplier-open]
#[inline(never)]
pub(crate) fn open<R: Receiver>(
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
pub(crate) fn closed<
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
        spread_force::<E, D, P, H>(
            (stage, placement),
            (point, &sliding.frame, &back),
            (n, weight),
            |(a, k), value| receiver.coupling(a * D + k, unknown, value),
        );
    }
}
