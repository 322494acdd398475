//! Tangential contact of one point within an evaluation: from the history to force, tangent and trial history.
//!
//! The functions are calls, not inlined: the kernel of an element stays as small as without friction and compiles as fast.

use crate::arithmetic::{abs, sqrt};
use crate::element::pass::{Contact, Pass};
use crate::element::receiver::{Call, Receiver};
use crate::element::stage::{TangentialRows, scale_variation};
use crate::element::tangential_contraction::{Shares, contract_sliding};
use crate::element::traits::Element;
use crate::point::friction::{Tangential, return_map};
use crate::point::history::{History, HistoryLayout, held, is_load};
use crate::point::state::Sliding;
use crate::point::tangential::TangentialCoefficients;
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

/// A closed point as friction sees it.
pub(crate) struct Touch<'t, const D: usize, const P: usize, const H: usize> {
    pub(crate) number: usize,
    /// Nodes, where the slave's tangent is an axis.
    pub(crate) nodes: &'t [[f64; D]],
    pub(crate) zeta: [f64; P],
    pub(crate) vectors: Vectors<D, P, H>,
    pub(crate) gap: Gap<D>,
    /// N
    pub(crate) traction: f64,
}

/// First pass over a closed point: frame, slip, return map, new anchor; writes no output.
#[inline(never)]
pub(crate) fn slide<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    touch: &Touch<'_, D, P, H>,
    sliding: &mut Sliding<P>,
) -> Result<Status, Status> {
    let Touch {
        number,
        nodes,
        zeta,
        vectors,
        gap,
        traction,
    } = touch;
    let history = call
        .history
        .and_then(|history| history.from(*number * E::HISTORY));
    // contact that begins is anchored where it is
    let remembered = accepted(&E::HISTORY_LAYOUT, history);
    let (anchor, path) = remembered.unwrap_or((*zeta, 0.0));
    let moved = core::array::from_fn(|i| zeta[i] - anchor[i]);
    let frame = E::frame(*number, nodes, vectors, gap, &moved, call.parameters);
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
        sliding.move_anchor(zeta, s);
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
        self.path += sqrt(first * first + second * second);
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

/// s_A f_k + s_A,i g_i n_k for every node and component, g: `lever`.
#[inline(always)]
fn spread<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    rows: &Rows<'_, P>,
    n: &[f64; D],
    force: &[f64; D],
    lever: &[f64; P],
    mut add: impl FnMut((usize, usize), f64),
) {
    for (a, &s) in rows.s.iter().enumerate() {
        let mut along = 0.0;
        if E::MOVING {
            for i in 0..P {
                along += lever[i] * rows.ds[i].get(a).copied().unwrap_or(0.0);
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

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// True where no unknown turns the tangents, no axis moves with the slave and no measure with the point: the tangential
    /// tangent multiplies s_A s_B alone and merges with the normal one, so it costs no contraction.
    pub(crate) const MERGES_WITH_NORMAL: bool = !E::MOVING && !E::SLAVE_AXIS && !E::CURRENT;

    /// Passes the residual of a sticking or sliding point to the receiver, the normal one included.
    /// [eq:tangential-residual]
    #[inline(always)]
    pub(crate) fn sliding_residual(&mut self, contact: &Contact<'_, D, P, H>) {
        // copies: with rolling the contact is handed to a call, and would be read again for every entry
        let Contact {
            point,
            state,
            n,
            weight,
            write,
            ..
        } = *contact;
        let own = E::tangential_force(&point.vectors, &point.gap, &state.frame, &state.tangential);
        let tangential = self.to_global(&own.force);
        let weighted_traction = weight * point.law.traction;
        let mut force = [0.0; D];
        for k in 0..D {
            force[k] = weighted_traction * n[k] + weight * tangential[k];
        }
        let lever = own.turn.map(|turn| weight * turn);
        let (stage, receiver) = (&*self.stage, &mut *self.receiver);
        spread::<E, D, P, H>(&stage.rows, &n, &force, &lever, |place, value| {
            receiver.force(place, value, write);
        });
    }

    /// w t_q Z_q of other tangential forces in the frame of the point: row and column of the multiplier `unknown`.
    /// [eq:tangential-residual]
    #[inline(always)]
    pub(crate) fn couple(
        &mut self,
        contact: &Contact<'_, D, P, H>,
        tangential: &Tangential,
        unknown: usize,
    ) {
        let (point, frame) = (contact.point, &contact.state.frame);
        let own = E::tangential_force(&point.vectors, &point.gap, frame, tangential);
        let force = self
            .to_global(&own.force)
            .map(|force| contact.weight * force);
        let lever = own.turn.map(|turn| contact.weight * turn);
        let receiver = &mut *self.receiver;
        spread::<E, D, P, H>(
            &self.stage.rows,
            &contact.n,
            &force,
            &lever,
            |(a, k), value| {
                receiver.coupling(a * D + k, unknown, value);
            },
        );
    }

    /// Adds the tangential tangent to the coefficients of the normal one, see [`Self::MERGES_WITH_NORMAL`].
    #[inline(always)]
    pub(crate) fn merge_with_normal(
        &self,
        contact: &Contact<'_, D, P, H>,
        coefficients: &mut Coefficients<D, P>,
    ) {
        let (x, point, state) = (self.stage.x, contact.point, contact.state);
        let third = E::higher(
            x,
            &point.zeta,
            self.call.parameters,
            &mut core::array::from_fn(|_| <&mut [f64]>::default()),
        );
        let (vectors, gap) = (point.vectors, point.gap);
        let merged = E::joined_tangent(
            (contact.number, x),
            &vectors,
            &gap,
            &state.frame,
            &third,
            (&state.tangential, point.law.slope),
            self.call.parameters,
        );
        let entries = coefficients.p.iter_mut().flatten();
        for (to, from) in entries.zip(merged.as_flattened()) {
            *to += from;
        }
    }

    /// Coefficients of the tangential tangent in the global frame, times the weight of the point. Fills the rows s_A,ij
    /// and that of the slave's tangent.
    #[inline(always)]
    fn sliding_coefficients(
        &mut self,
        contact: &Contact<'_, D, P, H>,
    ) -> TangentialCoefficients<D, P, H> {
        let (point, state) = (contact.point, contact.state);
        let scratch = &mut self.stage.tangential;
        let parameters = self.call.parameters;
        let third = E::higher(self.stage.x, &point.zeta, parameters, &mut scratch.second);
        if E::SLAVE_AXIS {
            E::slave_direction(contact.number, parameters, scratch.slave);
        }
        let (vectors, gap) = (point.vectors, point.gap);
        let mut coefficients = E::tangential_tangent(
            (contact.number, self.stage.x),
            &vectors,
            &gap,
            &state.frame,
            &third,
            (&state.tangential, point.law.slope),
            parameters,
        );
        if let Some(placement) = &self.placement {
            coefficients.rotate(|vector| placement.vector_to_global(vector));
        }
        if contact.weight != 1.0 {
            coefficients.weigh(contact.weight);
        }
        coefficients
    }

    /// Passes the tangent of a sticking or sliding point to the receiver, the normal one included.
    /// [eq:tangential-contraction]
    #[inline(always)]
    pub(crate) fn sliding_tangent(
        &mut self,
        contact: &Contact<'_, D, P, H>,
        normal: &Coefficients<D, P>,
    ) {
        let coefficients = self.sliding_coefficients(contact);
        let stage = &mut *self.stage;
        if E::CURRENT {
            scale_variation(stage.variation, 1.0, &self.placement);
        }
        let t = &contact.state.tangential.t;
        let shares = Shares {
            n: &contact.n,
            normal,
            tangential: &coefficients,
            measure: if E::CURRENT { stage.variation } else { &[] },
            traction: contact.point.law.traction,
            t: core::array::from_fn(|q| t.get(q).copied().unwrap_or(0.0)),
            write: contact.write,
        };
        // made here: a call with the stage itself would force all that it refers to through memory
        let rows = stage.rows.reborrow();
        let blocks = stage.temporaries.u.each_mut().map(|row| &mut **row);
        let scratch = &mut stage.tangential;
        let mut scratch = TangentialRows {
            second: scratch.second.each_mut().map(|row| &mut **row),
            slave: &mut *scratch.slave,
            columns: &mut *scratch.columns,
        };
        contract_sliding::<E, R, D, P, H>(&rows, &shares, blocks, &mut scratch, self.receiver);
    }
}
