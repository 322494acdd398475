//! First pass over a contact point: projection, gap, open or closed. It writes no output.

use super::angle::{self, Blend};
use super::driver::Stage;
use super::element::Element;
use super::enforcement::enforced;
use super::friction::TangentialLaw;
use super::history::History;
use super::projection::{largest, project};
use super::receiver::Call;
use super::rolling::roll;
use super::shape::{NormalLaw, Traction};
use super::side::side;
use super::sliding::{Sliding, slide};
use super::values::{Gap, Status, Vectors};
use crate::arithmetic::abs;

/// A point after the first pass.
#[derive(Clone, Copy)]
pub(super) struct Point<const D: usize, const P: usize, const H: usize> {
    pub(super) status: Status,
    pub(super) feature: u8,
    pub(super) zeta: [f64; P],
    pub(super) vectors: Vectors<D, P, H>,
    pub(super) gap: Gap<D>,
    /// ±1, factor of the normal.
    pub(super) orientation: f64,
    /// Of a closed point; of every point that has a multiplier.
    pub(super) law: Traction,
    /// What the weight by the angle does to it.
    pub(super) blend: Blend,
    /// λ; 0 where there is none.
    pub(super) multiplier: f64,
    pub(super) iterations: u32,
}

/// First pass: projection, gap, status.
#[inline(always)]
pub(super) fn classify<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    number: usize,
    sliding: &mut Sliding<P>,
) -> Result<Point<D, P, H>, Status> {
    load_slave::<E, D, P, H>(call, stage, number);
    let history = call
        .history
        .and_then(|history| history.from(number * E::HISTORY));
    let given = call.wanted.projection_given;
    let start = start::<E, D, P, H>(history);
    let found = project::<E, D, P, H>(stage.x, start, given, call.parameters, &mut stage.rows);
    let projected = match found {
        Ok(projected) => projected,
        Err(status) if E::ANGLE => {
            let from = (start, status);
            return angle::without_projection::<E, D, P, H>(call, stage, number, from);
        }
        Err(status) => return Err(status),
    };
    let mut point = Point {
        status: Status::Outside,
        feature: projected.feature,
        zeta: projected.zeta,
        vectors: projected.vectors,
        gap: Gap::default(),
        orientation: 1.0,
        law: Traction::default(),
        blend: Blend::default(),
        multiplier: 0.0,
        iterations: projected.iterations,
    };
    let mut weight = [1.0, 0.0, 0.0];
    if E::ANGLE {
        weight = angle::weight::<E, D, P, H>(number, stage.x, &point.vectors, call.parameters)?;
        if weight[0] <= 0.0 {
            let mut silent = angle::open(point.zeta, point.vectors, point.iterations);
            if angle::has_normal(stage.x, &silent.vectors) {
                silent.gap = E::gap(&silent.vectors, call.parameters, 1.0);
            }
            return Ok(silent);
        }
    }
    if !E::SIGNED && is_zero(&point.vectors.r, largest(stage.x)) {
        return Err(Status::Degenerate);
    }
    if !E::is_regular(number, stage.x, &point.vectors, call.parameters) {
        return Err(Status::Degenerate);
    }
    point.orientation =
        side::<E, D, P, H>(history, &point.vectors, point.feature, call.parameters)?;
    point.gap = E::gap(&point.vectors, call.parameters, point.orientation);
    if !(is_finite(&point.gap.n) & is_finite(&[point.gap.gap])) {
        return Err(Status::Degenerate);
    }
    let gap = point.gap.gap;
    let has_multiplier = E::AUGMENTED || E::MULTIPLIER;
    if has_multiplier {
        point.multiplier = multiplier::<E, D, P, H>(stage.multipliers, history, number);
        let law = law::<E, D, P, H>(gap, call.parameters)?;
        point.law = enforced::<E, D, P, H>(law, point.multiplier).ok_or(Status::Law)?;
    }
    if point.feature != 0 {
        return Ok(point);
    }
    let closed = match (call.wanted.freeze, history) {
        (true, Some(history)) => is_load(history.get(0)),
        _ if has_multiplier => point.law.traction < 0.0,
        _ => E::Law::active(gap, call.parameters) > 0.0,
    };
    if closed {
        point.status = Status::Closed;
        if !has_multiplier {
            point.law = law::<E, D, P, H>(gap, call.parameters)?;
        }
        if E::Tangential::ACTIVE {
            // copies: what a call is handed would be memory on every path
            let (vectors, gap) = (point.vectors, point.gap);
            let nodes = if E::SLAVE_AXIS { stage.x } else { &[] };
            let normal = (&vectors, &gap, point.law.traction);
            point.status = slide::<E, D, P, H>(call, (number, nodes), point.zeta, normal, sliding)?;
            if E::ROLLING.is_some() {
                roll::<E, D, P, H>(call, stage.x, number, &point, sliding)?;
            }
        }
        if E::ANGLE {
            angle::weigh(&mut point, weight);
        }
        if call.wanted.tangent && !has_derivatives(&point.vectors) {
            return Err(Status::Degenerate);
        }
    } else {
        point.status = Status::Open;
    }
    Ok(point)
}

/// Closed, stick or slip.
#[inline(always)]
fn is_load(status: Option<f64>) -> bool {
    status.is_some_and(|status| (1.0..=3.0).contains(&status))
}

/// Where the search begins: at the last projection, or at the centre.
#[inline(always)]
fn start<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    history: Option<History<'_>>,
) -> [f64; P] {
    let mut start = E::centre();
    if let Some(history) = history {
        for (i, start) in start.iter_mut().enumerate() {
            *start = history.get(1 + i).unwrap_or(*start);
        }
    }
    start
}

/// λ of the history or of the unknowns.
#[inline(always)]
fn multiplier<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    unknowns: &[f64],
    history: Option<History<'_>>,
    number: usize,
) -> f64 {
    if E::MULTIPLIER {
        return unknowns.get(number).copied().unwrap_or(0.0);
    }
    history.map_or(0.0, |history| history.at(E::HISTORY - 1))
}

/// Largest N, N' and W [as declared]: ½ ε g² of the largest ε and g that are taken. Products of larger ones would
/// overflow, even such that no output needs.
pub(super) const LARGEST: f64 = 1e90;

/// N, N' and W of a closed point, where the law is defined and its values are such that forces can be made of them.
#[inline(always)]
fn law<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    gap: f64,
    parameters: &[f64],
) -> Result<Traction, Status> {
    if E::Law::valid(gap, parameters) <= 0.0 {
        return Err(Status::Law);
    }
    let law = E::Law::evaluate(gap, parameters);
    let mut usable = true;
    for value in [law.traction, law.slope, law.energy] {
        // false of what is no number
        usable &= abs(value) <= LARGEST;
    }
    if usable { Ok(law) } else { Err(Status::Law) }
}

/// The tangents and second derivatives are numbers.
#[inline(always)]
fn has_derivatives<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> bool {
    // no chain of the two: with its running pointer the vectors could not stay in registers
    let mut finite = true;
    for vector in &vectors.b {
        finite &= is_finite(vector);
    }
    for vector in &vectors.second {
        finite &= is_finite(vector);
    }
    finite
}

#[inline(always)]
fn is_finite<const N: usize>(values: &[f64; N]) -> bool {
    let mut finite = true;
    for &value in values {
        finite &= abs(value) <= f64::MAX;
    }
    finite
}

/// |r| is zero to rounding.
#[inline(always)]
pub(super) fn is_zero<const D: usize>(r: &[f64; D], scale: f64) -> bool {
    r.iter()
        .all(|&component| abs(component) <= (8.0 * f64::EPSILON * scale).max(1e-30))
}

#[inline(always)]
pub(super) fn orientation<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> f64 {
    match E::LAYOUT.orientation.and_then(|at| parameters.get(at)) {
        Some(&value) if value < 0.0 => -1.0,
        _ => 1.0,
    }
}

/// The slave's fixed row: of the declaration, or handed in.
#[inline(always)]
pub(super) fn load_slave<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    number: usize,
) {
    if E::SLAVE_NODES == 0 {
        let slaves = call.slave_row.len().saturating_sub(1);
        for (s, &value) in stage
            .rows
            .s
            .iter_mut()
            .zip(call.slave_row.iter().take(slaves))
        {
            *s = value;
        }
    } else {
        E::slave(number, call.parameters, stage.rows.s);
    }
}
