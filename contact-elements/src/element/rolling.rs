//! Moments about two curves: from the history to moments, residual, tangent and trial history.
//!
//! ```text
//! M_c          = the law at φ_c − φ0_c, wrapped into (−π, π]                [eq:rolling-moment]
//! R_(A,k)      = t^eff_q Z_q(A,k) + explicit(A,k)                            [eq:rolling-residual]
//! K_(A,k)(B,l) = … + A(A,k) B(B,l) + B(A,k) A(B,l) for each pair             [eq:rolling-tangent]
//! ```
//!
//! The functions are calls, not inlined; an element without rolling makes no such call.

use crate::arithmetic::abs;
use crate::element::pass::{Contact, Pass};
use crate::element::receiver::{Call, Receiver, Write};
use crate::element::traits::Element;
use crate::point::history::{History, HistoryLayout, held, is_load};
use crate::point::motion::{MotionRows, Rolling, RollingAngles, RollingForce, RollingLayout};
use crate::point::state::{Point, Sliding};
use crate::point::values::Status;

/// Least |w_⊥|²/|w|² of a reference direction: below it, it points along the curve.
const LEAST_SHARE: f64 = 1e-20;
/// Least angle by which the principal normal's curve turns over its length: below it, it is straight.
const LEAST_BEND: f64 = 1e-10;

/// An angle, at most [`FARTHEST`] and a few turns, in (−π, π].
fn wrapped(angle: f64) -> f64 {
    const TURN: f64 = core::f64::consts::TAU;
    let turns = angle / TURN;
    let nearest = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i64;
    let rest = angle - TURN * nearest as f64;
    if rest <= -core::f64::consts::PI {
        rest + TURN
    } else {
        rest
    }
}

/// Contents of the accepted history.
struct Accepted {
    anchor: [f64; 2],
    path: [f64; 2],
    /// With a frozen state: whether each curve rolls.
    forced: [Option<Status>; 2],
}

/// `None` where contact begins.
#[inline(always)]
fn accepted(layout: &HistoryLayout, history: Option<History<'_>>) -> Option<Accepted> {
    let history = history?;
    let own = |entry: usize| history.at(layout.rolling_at() + entry);
    let status = history.at(HistoryLayout::STATUS);
    if !is_load(status) {
        return None;
    }
    let rolled = own(4) as u8;
    let forced = |curve: u8| match held(status) {
        Some(_) if rolled & curve != 0 => Some(Status::Slip),
        Some(_) => Some(Status::Stick),
        None => None,
    };
    Some(Accepted {
        anchor: [own(0), own(1)],
        path: [own(2), own(3)],
        forced: [forced(1), forced(2)],
    })
}

impl RollingAngles {
    /// True if both reference directions stand across their curves and the angles are not NaN.
    fn are_known<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
        &self,
        layout: &RollingLayout,
    ) -> bool {
        (0..2).all(|c| {
            let turn = self.bend[c] * E::extent(c.min(P.saturating_sub(1)));
            let curved = layout.directors.is_some() || turn > LEAST_BEND;
            curved && self.share[c] > LEAST_SHARE && abs(self.angle[c]) <= f64::MAX
        })
    }
}

/// First pass over a closed point: angles, moments, new anchors, and their share of the factor of δζ̂.
/// [eq:rolling-moment] [eq:rolling-history]
#[inline(never)]
pub(crate) fn roll<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    x: &[[f64; D]],
    number: usize,
    point: &Point<D, P, H>,
    sliding: &mut Sliding<P>,
) -> Result<(), Status> {
    let Some(layout) = E::ROLLING else {
        return Ok(());
    };
    let history = call
        .history
        .and_then(|history| history.from(number * E::HISTORY));
    let angles = E::rolling_angles(&point.vectors, &point.gap, call.parameters);
    if !angles.are_known::<E, D, P, H>(&layout) {
        return Err(Status::Degenerate);
    }
    let remembered = accepted(&E::HISTORY_LAYOUT, history);
    let begins = remembered.is_none();
    let Accepted {
        anchor,
        path,
        forced,
    } = remembered.unwrap_or(Accepted {
        anchor: angles.angle,
        path: [0.0; 2],
        forced: [None; 2],
    });
    let parameters = call.parameters.get(layout.law..).unwrap_or(&[]);
    let mut rolling = Rolling {
        angle: angles.angle,
        anchor,
        path,
        ..Rolling::default()
    };
    for (c, weight) in [1.0, 2.0].into_iter().enumerate() {
        let moved = wrapped(angles.angle[c] - anchor[c]);
        let forced = forced[c].filter(|_| call.wanted.freeze);
        let pressure = -point.law.traction;
        let (status, law) = E::rolling_law(moved, pressure, path[c], parameters, forced)?;
        rolling.moment[c] = law.t[0];
        rolling.by_pressure[c] = law.h[0];
        // where contact begins the anchor moves with the point
        rolling.stiffness[c] = if begins { 0.0 } else { law.c[0][0] };
        if status == Status::Slip {
            rolling.anchor[c] = wrapped(angles.angle[c] - law.elastic[0]);
            rolling.path[c] += abs(moved - law.elastic[0]);
            rolling.regime += weight;
        }
        sliding.tangential.energy += law.energy;
    }
    sliding.rolling = rolling;
    share::<E, D, P, H>(call, x, point, sliding)
}

/// Adds the share of the moments to the factor of δζ̂. [eq:rolling-share]
fn share<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    x: &[[f64; D]],
    point: &Point<D, P, H>,
    sliding: &mut Sliding<P>,
) -> Result<(), Status> {
    let force = force::<E, D, P, H>(call, x, point, sliding, &mut no_rows());
    let mut finite = force.explicit.is_finite();
    for (q, share) in force.share.into_iter().enumerate() {
        sliding.tangential.force[q] = sliding.tangential.t[q] + share;
        finite &= abs(sliding.tangential.force[q]) <= f64::MAX;
    }
    if finite {
        Ok(())
    } else {
        Err(Status::Degenerate)
    }
}

#[inline(always)]
fn no_rows<'a, const H: usize>() -> [&'a mut [f64]; H] {
    core::array::from_fn(|_| <&mut [f64]>::default())
}

/// Coefficients of the residual; fills the rows s_A,ij.
fn force<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    x: &[[f64; D]],
    point: &Point<D, P, H>,
    sliding: &Sliding<P>,
    second: &mut [&mut [f64]; H],
) -> RollingForce<D, P> {
    let third = E::higher(x, &point.zeta, call.parameters, second);
    E::rolling_force(
        &point.vectors,
        &point.gap,
        &sliding.frame,
        &third,
        &sliding.rolling,
        call.parameters,
    )
}

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// Adds the part of the residual that the tangential residual does not contain. [eq:rolling-residual]
    #[inline(never)]
    pub(crate) fn rolling_residual(&mut self, contact: &Contact<'_, D, P, H>) {
        let (stage, receiver) = (&mut *self.stage, &mut *self.receiver);
        let weight = contact.weight;
        let second = &mut stage.tangential.second;
        let (point, state) = (contact.point, contact.state);
        let force = force::<E, D, P, H>(self.call, stage.x, point, state, second);
        let nodes = stage.rows.s.len();
        let second = stage.tangential.second.each_mut().map(|row| &mut **row);
        let rows = MotionRows {
            rows: &stage.rows.reborrow(),
            second: &second,
            third: &no_rows(),
        };
        for a in 0..nodes {
            for k in 0..D {
                let value = weight * rows.entry(&force.explicit, (a, k));
                receiver.force((a, k), value, Write::Add);
            }
        }
    }

    /// Adds the tangent of the moments. [eq:rolling-tangent]
    ///
    /// The rows of third derivatives overwrite those of the normal tangent, which are no longer needed.
    #[inline(never)]
    pub(crate) fn rolling_tangent(&mut self, contact: &Contact<'_, D, P, H>) {
        let (stage, receiver) = (&mut *self.stage, &mut *self.receiver);
        let weight = contact.weight;
        let (point, state, parameters) = (contact.point, contact.state, self.call.parameters);
        let scratch = &mut stage.tangential;
        let third = E::higher(stage.x, &point.zeta, parameters, &mut scratch.second);
        for row in &mut stage.temporaries.g {
            row.fill(0.0);
        }
        let nodes = stage.rows.s.len();
        let thirds = &mut stage.temporaries.g;
        let mut own: [&mut [f64]; P] = no_rows();
        for (to, from) in own.iter_mut().zip(thirds) {
            *to = from.get_mut(..nodes).unwrap_or_default();
        }
        E::third_rows(&point.zeta, &mut own);
        let coefficients = E::rolling_tangent(
            &point.vectors,
            &point.gap,
            &state.frame,
            &third,
            (&state.rolling, point.law.slope),
            parameters,
        );
        let second = scratch.second.each_mut().map(|row| &mut **row);
        let rows = MotionRows {
            rows: &stage.rows.reborrow(),
            second: &second,
            third: &own,
        };
        let unknowns = nodes * D;
        let Some(row) = stage.temporaries.row.get_mut(..unknowns) else {
            return;
        };
        for unknown in 0..unknowns {
            let at = (unknown / D, unknown % D);
            let whole = coefficients.row(|form| weight * rows.entry(form, at));
            for (other, entry) in row.iter_mut().enumerate() {
                *entry = rows.entry(&whole, (other / D, other % D));
            }
            receiver.row(unknown, row, Write::Add);
        }
    }
}
