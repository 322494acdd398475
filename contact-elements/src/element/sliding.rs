//! Tangential contact of one point within an evaluation: from the history to force, tangent and trial history.
//!
//! The functions are calls, not inlined: the kernel of an element stays as small as without friction and compiles as fast.

use crate::arithmetic::abs;
use crate::element::receiver::{Call, Receiver};
use crate::element::stage::{Stage, TangentialRows, scale_variation};
use crate::element::tangential_contraction::{Shares, contract_sliding};
use crate::element::traits::Element;
use crate::point::friction::{Tangential, return_map};
use crate::point::history::{History, HistoryLayout, held, is_load};
use crate::point::placement::Placement;
use crate::point::state::{Point, Sliding};
use crate::point::values::{Coefficients, Frame, Gap, Rows, Status, Vectors};

/// Least share of an axis in the tangent plane.
const LEAST_SHARE: f64 = 1e-20;

/// Anchor and slip path of the accepted history; `None` where contact begins. [eq:anchor]
#[inline(always)]
fn accepted<const P: usize>(
    layout: &HistoryLayout,
    history: Option<History<'_>>,
) -> Option<([f64; P], f64)> {
    let history = history?;
    if !is_load(history.at(HistoryLayout::STATUS)) {
        return None;
    }
    let anchor = core::array::from_fn(|i| history.at(layout.anchor_at() + i));
    Some((anchor, history.at(layout.path_at())))
}

/// First pass over a closed point: frame, slip, return map, new anchor; writes no output.
#[inline(never)]
pub(crate) fn slide<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    (number, x): (usize, &[[f64; D]]),
    zeta: [f64; P],
    (vectors, gap, traction): (&Vectors<D, P, H>, &Gap<D>, f64),
    sliding: &mut Sliding<P>,
) -> Result<Status, Status> {
    let history = call
        .history
        .and_then(|history| history.from(number * E::HISTORY));
    // contact that begins is anchored where it is
    let remembered = accepted(&E::HISTORY_LAYOUT, history);
    let (anchor, path) = remembered.unwrap_or((zeta, 0.0));
    let moved = core::array::from_fn(|i| zeta[i] - anchor[i]);
    let frame = E::frame(number, x, vectors, gap, &moved, call.parameters);
    // an axis of length zero, or a slave curve that stands on the surface
    if !(is_finite(&frame) && frame.share > LEAST_SHARE) {
        return Err(Status::Degenerate);
    }
    let mut s = [0.0; 2];
    for (to, from) in s.iter_mut().zip(frame.s) {
        *to = from;
    }
    let own = call.parameters.get(E::LAYOUT.tangential..).unwrap_or(&[]);
    let forced = history
        .filter(|_| call.wanted.freeze)
        .and_then(|history| held(history.at(HistoryLayout::STATUS)));
    let status =
        return_map::<E::Tangential>(s, (-traction, path), own, forced, &mut sliding.tangential)?;
    if remembered.is_none() {
        sliding.tangential.c = [[0.0; 2]; 2]; // the anchor moves with the point
    }
    sliding.frame = frame;
    sliding.anchor = anchor;
    sliding.path = path;
    if status == Status::Slip {
        sliding.move_anchor(&zeta, s);
        // tangents so nearly parallel that no history could say where the slip began
        if !E::REACH.can_be_anchors(&sliding.anchor) {
            return Err(Status::Degenerate);
        }
    }
    Ok(status)
}

impl<const P: usize> Sliding<P> {
    /// The anchor that would give the force by sticking: ζ_st = ζ − E s_el; the path grows by |s − s_el|.
    /// [eq:anchor]
    #[inline(always)]
    fn move_anchor(&mut self, zeta: &[f64; P], s: [f64; 2]) {
        let elastic = self.tangential.elastic;
        for i in 0..P {
            self.anchor[i] = zeta[i];
            for q in 0..P {
                self.anchor[i] -= self.frame.e[i][q] * elastic.get(q).copied().unwrap_or(0.0);
            }
        }
        let (first, second) = (s[0] - elastic[0], s[1] - elastic[1]);
        self.path += crate::arithmetic::sqrt(first * first + second * second);
    }
}

#[inline(always)]
fn is_finite<const P: usize>(frame: &Frame<P>) -> bool {
    let mut finite = true;
    for i in 0..P {
        finite &= abs(frame.s[i]) <= f64::MAX;
        for &entry in &frame.e[i] {
            finite &= abs(entry) <= f64::MAX;
        }
    }
    finite
}

/// Gives the residual of a sticking or sliding point to the receiver, the normal one (`pull`: w N) included.
/// [eq:tangential-residual]
#[inline(always)]
pub(crate) fn residual<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    stage: &Stage<'_, D, P, H>,
    placement: &Option<Placement<D>>,
    point: &Point<D, P, H>,
    sliding: &Sliding<P>,
    (n, weight, pull, first): (&[f64; D], f64, f64, bool),
    receiver: &mut R,
) {
    let (frame, tangential) = (&sliding.frame, &sliding.tangential);
    let mut own = E::tangential_force(&point.vectors, &point.gap, frame, tangential);
    if let Some(placement) = placement {
        own.force = placement.vector_to_global(&own.force);
    }
    let mut force = [0.0; D];
    for k in 0..D {
        force[k] = pull * n[k] + weight * own.force[k];
    }
    let turn = own.turn.map(|turn| weight * turn);
    spread::<E, D, P, H>(stage, (n, &force, &turn), |place, value| {
        receiver.force(place, value, first);
    });
}

/// w t_q Z_q of other tangential forces in the same frame. [eq:tangential-residual]
#[inline(always)]
pub(crate) fn spread_force<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    (stage, placement): (&Stage<'_, D, P, H>, &Option<Placement<D>>),
    (point, frame, tangential): (&Point<D, P, H>, &Frame<P>, &Tangential),
    (n, weight): (&[f64; D], f64),
    add: impl FnMut((usize, usize), f64),
) {
    let mut own = E::tangential_force(&point.vectors, &point.gap, frame, tangential);
    if let Some(placement) = placement {
        own.force = placement.vector_to_global(&own.force);
    }
    let force = own.force.map(|force| weight * force);
    let turn = own.turn.map(|turn| weight * turn);
    spread::<E, D, P, H>(stage, (n, &force, &turn), add);
}

/// s_A f_k + s_A,i g_i n_k for every node and component.
#[inline(always)]
fn spread<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    stage: &Stage<'_, D, P, H>,
    (n, force, turn): (&[f64; D], &[f64; D], &[f64; P]),
    mut add: impl FnMut((usize, usize), f64),
) {
    for (a, &s) in stage.rows.s.iter().enumerate() {
        let mut along = 0.0;
        if E::MOVING {
            for i in 0..P {
                along += turn[i] * stage.rows.ds[i].get(a).copied().unwrap_or(0.0);
            }
        }
        for k in 0..D {
            let mut value = s * force[k];
            if E::MOVING {
                value += along * n[k];
            }
            add((a, k), value);
        }
    }
}

/// Number of a contact point, the point, its normal in the global frame, its weight, whether it is the first.
pub(crate) type Place<'a, const D: usize, const P: usize, const H: usize> =
    (usize, &'a Point<D, P, H>, &'a [f64; D], f64, bool);

/// Gives the tangent of a sticking or sliding point to the receiver, the normal one included.
/// [eq:tangential-contraction]
#[inline(always)]
pub(crate) fn tangent<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    placement: &Option<Placement<D>>,
    sliding: &Sliding<P>,
    (number, point, n, weight, first): Place<'_, D, P, H>,
    normal: &Coefficients<D, P>,
    receiver: &mut R,
) {
    let scratch = &mut stage.tangential;
    let third = E::higher(stage.x, &point.zeta, call.parameters, &mut scratch.second);
    if E::SLAVE_AXIS {
        E::slave_direction(number, call.parameters, scratch.slave);
    }
    let (vectors, gap) = (point.vectors, point.gap);
    let mut coefficients = E::tangential_tangent(
        (number, stage.x),
        &vectors,
        &gap,
        &sliding.frame,
        &third,
        (&sliding.tangential, point.law.slope),
        call.parameters,
    );
    if let Some(placement) = placement {
        coefficients.turn(|vector| placement.vector_to_global(vector));
    }
    if weight != 1.0 {
        coefficients.weigh(weight);
    }
    if E::CURRENT {
        scale_variation(stage.variation, 1.0, placement);
    }
    let shares = Shares {
        n,
        normal,
        tangential: &coefficients,
        measure: if E::CURRENT { stage.variation } else { &[] },
        traction: point.law.traction,
        t: core::array::from_fn(|q| sliding.tangential.t.get(q).copied().unwrap_or(0.0)),
        first,
    };
    // made here: a call that got the stage itself would have all that it refers to go through memory
    let rows = Rows {
        s: &mut *stage.rows.s,
        ds: stage.rows.ds.each_mut().map(|row| &mut **row),
    };
    let blocks = stage.temporaries.u.each_mut().map(|row| &mut **row);
    let mut scratch = TangentialRows {
        second: scratch.second.each_mut().map(|row| &mut **row),
        slave: &mut *scratch.slave,
        columns: &mut *scratch.columns,
    };
    contract_sliding::<E, R, D, P, H>(&rows, &shares, blocks, &mut scratch, receiver);
}

/// Where no unknown turns the tangents, no axis moves with the slave and no measure with the point, the
/// tangential tangent multiplies s_A s_B alone and joins the normal one: it costs no contraction.
#[inline(always)]
pub(crate) fn joins<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>() -> bool {
    !E::MOVING && !E::SLAVE_AXIS && !E::CURRENT
}

/// Adds the tangential tangent to the coefficients of the normal one, see [`joins`].
#[inline(always)]
pub(crate) fn join<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    x: &[[f64; D]],
    (number, point, sliding): (usize, &Point<D, P, H>, &Sliding<P>),
    coefficients: &mut Coefficients<D, P>,
) {
    let third = E::higher(
        x,
        &point.zeta,
        call.parameters,
        &mut core::array::from_fn(|_| <&mut [f64]>::default()),
    );
    let (vectors, gap) = (point.vectors, point.gap);
    let joined = E::joined_tangent(
        (number, x),
        &vectors,
        &gap,
        &sliding.frame,
        &third,
        (&sliding.tangential, point.law.slope),
        call.parameters,
    );
    for (to, from) in coefficients
        .p
        .iter_mut()
        .flatten()
        .zip(joined.as_flattened())
    {
        *to += from;
    }
}
