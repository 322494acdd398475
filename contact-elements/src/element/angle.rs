//! Contact of two curves weighted by their angle: w W instead of W. [eq:angle-energy]
//!
//! ```text
//! R_(A,k)      = w N n·δr + form(A,k)                                    [eq:angle-residual]
//! K_(A,k)(B,l) = w (…) + A(A,k) B(B,l) + B(A,k) A(B,l) for each pair     [eq:angle-tangent]
//! form(A,k)    = s_A v_k + N^slave_A,1 t_k + N^master_A,1 t'_k + N^slave_A,11 b_k + N^master_A,11 b'_k
//! ```
//!
//! A point whose weight is zero is open, whatever its projection found. The functions are calls, not inlined, and an
//! element that acts at any angle makes no such call.

use crate::element::pass::{Contact, Pass};
use crate::element::receiver::{Call, Receiver, Write};
use crate::element::stage::Stage;
use crate::element::traits::Element;
use crate::point::blend::{AngleForm, Blend, FormRows};
use crate::point::law::Traction;
use crate::point::projection::constrained::nearest;
use crate::point::projection::foot::largest;
use crate::point::projection::step::SMALLEST;
use crate::point::state::Point;
use crate::point::values::{Gap, Status, Vectors, dot, is_zero};

/// w, w', w'' at a projected point; no weight if a curve has no tangent. [eq:angle-weight]
#[inline(always)]
pub(crate) fn weight<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    number: usize,
    x: &[[f64; D]],
    vectors: &Vectors<D, P, H>,
    parameters: &[f64],
) -> Result<[f64; 3], Status> {
    let tangents = E::curve_tangents(number, x, vectors, parameters);
    for tangent in &tangents {
        let square = dot(tangent, tangent);
        if !(SMALLEST * SMALLEST..=f64::MAX).contains(&square) {
            return Err(Status::Degenerate);
        }
    }
    let [position, rate] = E::angle_position(&tangents, parameters);
    // the window has a width: the parameters have been checked
    Ok(E::angle_weight([position.clamp(0.0, 1.0), rate]))
}

/// An open point, whose weight is zero.
#[inline(always)]
pub(crate) fn open<const D: usize, const P: usize, const H: usize>(
    zeta: [f64; P],
    vectors: Vectors<D, P, H>,
    iterations: u32,
) -> Point<D, P, H> {
    Point {
        status: Status::Open,
        feature: 0,
        zeta,
        vectors,
        gap: Gap::default(),
        orientation: 1.0,
        law: Traction::default(),
        blend: Blend::default(),
        multiplier: 0.0,
        iterations,
    }
}

/// Fallback without a projection: takes the weight at the nearest points found; if it is zero the point is open. For
/// nearly parallel curves the angle hardly depends on which points these are.
#[cold]
#[inline(never)]
pub(crate) fn without_projection<
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    number: usize,
    start: [f64; P],
    status: Status,
) -> Result<Point<D, P, H>, Status> {
    if !matches!(status, Status::NotUnique | Status::NotConverged) {
        return Err(status);
    }
    let (zeta, vectors) = nearest::<E, D, P, H>(stage.x, start, call.parameters, &mut stage.rows);
    let [weight, ..] = weight::<E, D, P, H>(number, stage.x, &vectors, call.parameters)?;
    if weight > 0.0 {
        return Err(status);
    }
    Ok(open(zeta, vectors, 0))
}

/// Whether a point whose weight is zero has a normal.
#[inline(always)]
pub(crate) fn has_normal<const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    vectors: &Vectors<D, P, H>,
) -> bool {
    !is_zero(&vectors.r, largest(x))
}

/// N, N' and W times the weight; the rest is kept.
#[inline(always)]
pub(crate) fn weigh<const D: usize, const P: usize, const H: usize>(
    point: &mut Point<D, P, H>,
    [weight, slope, curvature]: [f64; 3],
) {
    let Traction {
        traction,
        energy,
        slope: stiffness,
    } = point.law;
    point.blend = Blend {
        slope,
        curvature,
        traction,
        energy,
    };
    point.law = Traction {
        traction: weight * traction,
        slope: weight * stiffness,
        energy: weight * energy,
    };
}

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// Adds W w' δq. [eq:angle-residual]
    #[inline(never)]
    pub(crate) fn angle_residual(&mut self, contact: &Contact<'_, D, P, H>) {
        let (number, point, parameters) = (contact.number, contact.point, self.call.parameters);
        if !point.blend.changes() {
            return;
        }
        let (stage, receiver) = (&mut *self.stage, &mut *self.receiver);
        let weight = contact.weight;
        let tangents = E::curve_tangents(number, stage.x, &point.vectors, parameters);
        let form = E::angle_force(&tangents, &point.vectors, &point.gap, &point.blend);
        if P == 1 {
            E::slave_direction(number, parameters, stage.tangential.slave);
        }
        let rows = rows(stage);
        for a in 0..stage.rows.s.len() {
            for k in 0..D {
                let value = weight * rows.entry(&form, (a, k));
                receiver.force((a, k), value, Write::Add);
            }
        }
    }

    /// Adds w' N (δg Δq + δq Δg) + W w'' δq Δq + W w' D²q. [eq:angle-tangent]
    #[inline(never)]
    pub(crate) fn angle_tangent(&mut self, contact: &Contact<'_, D, P, H>) {
        let (number, point, parameters) = (contact.number, contact.point, self.call.parameters);
        if !point.blend.changes() {
            return;
        }
        let (stage, receiver) = (&mut *self.stage, &mut *self.receiver);
        let weight = contact.weight;
        let second = &mut stage.tangential.second;
        let third = E::higher(stage.x, &point.zeta, parameters, second);
        if P == 1 {
            E::slave_direction(number, parameters, stage.tangential.slave);
        }
        let tangents = E::curve_tangents(number, stage.x, &point.vectors, parameters);
        let coefficients =
            E::angle_tangent(&tangents, &point.vectors, &point.gap, &third, &point.blend);
        let unknowns = stage.rows.s.len() * D;
        let row = core::mem::take(&mut stage.temporaries.row);
        let rows = rows(stage);
        for unknown in 0..unknowns {
            let at = (unknown / D, unknown % D);
            let mut whole = AngleForm::default();
            for [left, right] in &coefficients.0 {
                whole.add(weight * rows.entry(left, at), right);
                whole.add(weight * rows.entry(right, at), left);
            }
            let Some(row) = row.get_mut(..unknowns) else {
                continue;
            };
            for (other, entry) in row.iter_mut().enumerate() {
                *entry = rows.entry(&whole, (other / D, other % D));
            }
            receiver.row(unknown, row, Write::Add);
        }
        stage.temporaries.row = row;
    }
}

/// The rows of a form: of two projected curves, or of an integration point of the slave and the projected master.
#[inline(always)]
fn rows<'a, const D: usize, const P: usize, const H: usize>(
    stage: &'a Stage<'_, D, P, H>,
) -> FormRows<'a> {
    let tangent = |i: usize| stage.rows.ds.get(i).map_or(&[][..], |row| &**row);
    let second = |h: usize| {
        let row = stage.tangential.second.get(h);
        row.map_or(&[][..], |row| &**row)
    };
    let s = &*stage.rows.s;
    FormRows(if P == 2 {
        [s, tangent(0), tangent(1), second(0), second(2)]
    } else {
        let slave = &*stage.tangential.slave;
        [s, slave, tangent(0), &[], second(0)]
    })
}
