//! Moments about two curves: from the history to moments, residual, tangent and new history.
//!
//! ```text
//! M_c          = the law at φ_c − φ0_c, wrapped into (−π, π]                [eq:rolling-moment]
//! R_(A,k)      = t^eff_q Z_q(A,k) + explicit(A,k)                            [eq:rolling-residual]
//! K_(A,k)(B,l) = … + A(A,k) B(B,l) + B(A,k) A(B,l) for each pair             [eq:rolling-tangent]
//! ```
//!
//! Calls, not inlined, and none for an element without rolling.

use core::cell::Cell;

use super::classify::Point;
use super::driver::Stage;
use super::element::Element;
use super::receiver::{Call, Receiver};
use super::sliding::Sliding;
use super::values::{Rows, Status};
use crate::arithmetic::abs;

/// Doubles that a point remembers: φ0_1, φ0_2, both paths, which curves roll.
pub(super) const HISTORY: usize = crate::abi::ROLLING_HISTORY;

/// Least |w_⊥|²/|w|² of a reference direction: below it, it points along the curve.
const LEAST_SHARE: f64 = 1e-20;
/// Least angle by which the principal normal's curve turns over its length: below it, it is straight.
const LEAST_BEND: f64 = 1e-10;
/// Largest anchor of an angle [rad].
const FARTHEST: f64 = 1e3;

/// Where the parameters of rolling begin in an element's list.
#[derive(Clone, Copy, Debug)]
pub struct RollingLayout {
    /// Law.
    pub law: usize,
    /// Directors, slave first; none where the principal normals serve.
    pub directors: Option<usize>,
}

/// Angles about both curves.
#[derive(Clone, Copy, Debug, Default)]
pub struct RollingAngles {
    /// φ_c in (−π, π] [rad].
    pub angle: [f64; 2],
    /// Square of the part of the reference direction across the curve, relative to the whole.
    pub share: [f64; 2],
    /// Length of that part over that of the tangent: how fast the curve turns with its parameter.
    pub bend: [f64; 2],
}

/// Angles and moments of a closed point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rolling {
    /// φ_c [rad]
    pub angle: [f64; 2],
    /// M_c
    pub moment: [f64; 2],
    /// ∂M_c/∂φ_c
    pub stiffness: [f64; 2],
    /// ∂M_c/∂p
    pub by_pressure: [f64; 2],
    /// φ0_c for the next step [rad].
    pub anchor: [f64; 2],
    /// Path of each angle for the next step [rad].
    pub path: [f64; 2],
    /// Which curves roll: 1 for the first, 2 for the second, 3 for both.
    pub regime: f64,
}

/// A linear form over the unknowns of two curves.
#[derive(Clone, Copy, Debug)]
pub struct Motion<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i.
    pub turning: [[f64; D]; P],
    /// Multiplies s_A,ii.
    pub bending: [[f64; D]; P],
    /// Multiplies s_A,iii.
    pub third: [[f64; D]; P],
}

/// Coefficients of the residual of the moments.
#[derive(Clone, Copy, Debug)]
pub struct RollingForce<const D: usize, const P: usize> {
    /// Added to t_q in what multiplies δζ̂^q.
    pub share: [f64; 2],
    /// The rest.
    pub explicit: Motion<D, P>,
}

/// Coefficients of the tangent of the moments.
#[derive(Clone, Copy, Debug)]
pub struct RollingCoefficients<const D: usize, const P: usize> {
    /// A, B of A⊗B + B⊗A.
    pub symmetric: [[Motion<D, P>; 2]; 9],
    /// A, B of A⊗B.
    pub moment: [[Motion<D, P>; 2]; 2],
}

impl<const D: usize, const P: usize> Default for Motion<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            position: [0.0; D],
            turning: [[0.0; D]; P],
            bending: [[0.0; D]; P],
            third: [[0.0; D]; P],
        }
    }
}

impl<const D: usize, const P: usize> Default for RollingForce<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            share: [0.0; 2],
            explicit: Motion::default(),
        }
    }
}

impl<const D: usize, const P: usize> Default for RollingCoefficients<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            symmetric: [[Motion::default(); 2]; 9],
            moment: [[Motion::default(); 2]; 2],
        }
    }
}

/// The rows that a [`Motion`] multiplies.
struct MotionRows<'a, const P: usize, const H: usize> {
    rows: &'a Rows<'a, P>,
    second: &'a [&'a mut [f64]; H],
    third: &'a [&'a mut [f64]; P],
}

impl<const P: usize, const H: usize> MotionRows<'_, P, H> {
    /// Entry (node, component) of a form.
    #[inline(always)]
    fn entry<const D: usize>(&self, form: &Motion<D, P>, (a, k): (usize, usize)) -> f64 {
        let at = |row: &[f64]| row.get(a).copied().unwrap_or(0.0);
        let mut sum = at(self.rows.s) * form.position[k];
        for i in 0..P {
            sum += at(self.rows.ds[i]) * form.turning[i][k] + at(self.third[i]) * form.third[i][k];
            // 11 and 22 in the order 11, 12, 22
            if let Some(second) = self.second.get(2 * i) {
                sum += at(second) * form.bending[i][k];
            }
        }
        sum
    }
}

impl<const D: usize, const P: usize> Motion<D, P> {
    /// self + factor·other
    #[inline(always)]
    fn add(&mut self, factor: f64, other: &Self) {
        for k in 0..D {
            self.position[k] += factor * other.position[k];
            for i in 0..P {
                self.turning[i][k] += factor * other.turning[i][k];
                self.bending[i][k] += factor * other.bending[i][k];
                self.third[i][k] += factor * other.third[i][k];
            }
        }
    }

    #[inline(always)]
    fn is_finite(&self) -> bool {
        let rows = self.turning.iter().chain(&self.bending).chain(&self.third);
        let mut entries = rows.chain([&self.position]).flatten();
        entries.all(|&entry| abs(entry) <= f64::MAX)
    }
}

/// Anchor, path and regime that an evaluation can have written; `entry` counts from the first of them.
pub(crate) fn is_remembered(entry: usize, value: f64) -> bool {
    match entry {
        0 | 1 => abs(value) <= FARTHEST,
        2 | 3 => value >= 0.0,
        _ => (0.0..=3.0).contains(&value) && f64::from(value as u8) == value,
    }
}

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

/// The entries of the accepted history: the anchors, both paths, the regime; none where contact begins.
#[inline(always)]
fn accepted<const P: usize>(
    history: Option<&[Cell<f64>]>,
) -> Option<([f64; 2], [f64; 2], [Option<Status>; 2])> {
    let history = history?;
    let at = |index: usize| history.get(index).map_or(0.0, Cell::get);
    let own = |entry: usize| at(2 + 2 * P + entry);
    let status = at(0);
    if status < 1.0 || status > 3.0 {
        return None;
    }
    let rolled = own(4) as u8;
    let forced = |curve: u8| match status {
        2.0 | 3.0 if rolled & curve != 0 => Some(Status::Slip),
        2.0 | 3.0 => Some(Status::Stick),
        _ => None,
    };
    Some(([own(0), own(1)], [own(2), own(3)], [forced(1), forced(2)]))
}

/// First pass over a closed point: angles, moments, new anchors, and their share of what multiplies δζ̂.
/// [eq:rolling-moment] [eq:rolling-history]
#[inline(never)]
pub(super) fn roll<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
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
        .and_then(|history| history.get(number * E::HISTORY..));
    let angles = E::rolling_angles(&point.vectors, &point.gap, call.parameters);
    let mut rolling = Rolling {
        angle: angles.angle,
        ..Rolling::default()
    };
    let remembered = accepted::<P>(history);
    let (anchor, path, forced) = remembered.unwrap_or((angles.angle, [0.0; 2], [None; 2]));
    let parameters = call.parameters.get(layout.law..).unwrap_or(&[]);
    for (c, weight) in [1.0, 2.0].into_iter().enumerate() {
        let straight = layout.directors.is_none()
            && !(angles.bend[c] * E::extent(c.min(P.saturating_sub(1))) > LEAST_BEND);
        if straight || !(angles.share[c] > LEAST_SHARE) || !(abs(angles.angle[c]) <= f64::MAX) {
            return Err(Status::Degenerate);
        }
        let moved = wrapped(angles.angle[c] - anchor[c]);
        let forced = forced[c].filter(|_| call.wanted.freeze);
        let pressure = -point.law.traction;
        let (status, law) = E::rolling_law(moved, pressure, path[c], parameters, forced)?;
        rolling.moment[c] = law.t[0];
        rolling.by_pressure[c] = law.h[0];
        // where contact begins the anchor moves with the point
        rolling.stiffness[c] = if remembered.is_some() {
            law.c[0][0]
        } else {
            0.0
        };
        (rolling.anchor[c], rolling.path[c]) = (anchor[c], path[c]);
        if status == Status::Slip {
            rolling.anchor[c] = wrapped(angles.angle[c] - law.elastic[0]);
            rolling.path[c] += abs(moved - law.elastic[0]);
            rolling.regime += weight;
        }
        sliding.tangential.energy += law.energy;
    }
    sliding.rolling = rolling;
    let force = force::<E, D, P, H>(call, x, point, sliding, &mut no_rows());
    for (q, share) in force.share.into_iter().enumerate() {
        let whole = sliding.tangential.t[q] + share;
        if !(abs(whole) <= f64::MAX) || !force.explicit.is_finite() {
            return Err(Status::Degenerate);
        }
        sliding.tangential.force[q] = whole;
    }
    Ok(())
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

/// Adds the part of the residual that is no part of the tangential one. [eq:rolling-residual]
#[inline(never)]
pub(super) fn residual<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    point: &Point<D, P, H>,
    (sliding, weight): (&Sliding<P>, f64),
    receiver: &mut R,
) {
    let second = &mut stage.tangential.second;
    let force = force::<E, D, P, H>(call, stage.x, point, sliding, second);
    let rows = MotionRows {
        rows: &stage.rows,
        second: &stage.tangential.second,
        third: &no_rows(),
    };
    for a in 0..stage.rows.s.len() {
        for k in 0..D {
            let value = weight * rows.entry(&force.explicit, (a, k));
            receiver.force((a, k), value, false);
        }
    }
}

/// Adds the tangent of the moments. [eq:rolling-tangent]
///
/// The rows of third derivatives stand where those of the normal tangent stood, which is done with.
#[inline(never)]
pub(super) fn tangent<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    point: &Point<D, P, H>,
    (sliding, weight): (&Sliding<P>, f64),
    receiver: &mut R,
) {
    let scratch = &mut stage.tangential;
    let third = E::higher(stage.x, &point.zeta, call.parameters, &mut scratch.second);
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
        &sliding.frame,
        &third,
        (&sliding.rolling, point.law.slope),
        call.parameters,
    );
    let rows = MotionRows {
        rows: &stage.rows,
        second: &scratch.second,
        third: &own,
    };
    let unknowns = nodes * D;
    let Some(row) = scratch.row.get_mut(..unknowns) else {
        return;
    };
    for unknown in 0..unknowns {
        let whole = coefficients.row(|form| weight * rows.entry(form, (unknown / D, unknown % D)));
        for (other, entry) in row.iter_mut().enumerate() {
            *entry = rows.entry(&whole, (other / D, other % D));
        }
        receiver.row(unknown, row, false);
    }
}

impl<const D: usize, const P: usize> RollingCoefficients<D, P> {
    /// A row of K is itself a form: Σ A(unknown) B + B(unknown) A.
    #[inline(always)]
    fn row(&self, at: impl Fn(&Motion<D, P>) -> f64) -> Motion<D, P> {
        let mut whole = Motion::default();
        for [left, right] in &self.symmetric {
            whole.add(at(left), right);
            whole.add(at(right), left);
        }
        for [left, right] in &self.moment {
            whole.add(at(left), right);
        }
        whole
    }
}
