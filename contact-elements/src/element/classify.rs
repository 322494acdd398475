//! First pass over a contact point: projection, gap, open or closed. It writes no output.

use crate::arithmetic::abs;
use crate::element::angle;
use crate::element::edge_side::side;
use crate::element::receiver::Call;
use crate::element::rolling::roll;
use crate::element::sliding::slide;
use crate::element::stage::{Stage, load_slave};
use crate::element::traits::Element;
use crate::point::blend::Blend;
use crate::point::enforcement::enforced;
use crate::point::friction::TangentialLaw;
use crate::point::history::{History, HistoryLayout, is_load};
use crate::point::law::{LARGEST_VALUE, NormalLaw, Traction};
use crate::point::projection::foot::largest;
use crate::point::projection::newton::project;
use crate::point::state::{Point, Sliding};
use crate::point::values::{Gap, Status, Vectors, is_zero};

/// First pass: projection, gap, status.
#[inline(always)]
pub(crate) fn classify<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
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
    let start = start::<E, D, P, H>(history, given);
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
        point.law = enforced(law, point.multiplier, E::MULTIPLIER).ok_or(Status::Law)?;
    }
    if point.feature != 0 {
        return Ok(point);
    }
    let closed = match (call.wanted.freeze, history) {
        (true, Some(history)) => is_load(history.at(HistoryLayout::STATUS)),
        _ if has_multiplier => point.law.traction < 0.0,
        _ => E::Law::active(gap, call.parameters) > 0.0,
    };
    if closed {
        point.status = Status::Closed;
        if !has_multiplier {
            point.law = law::<E, D, P, H>(gap, call.parameters)?;
        }
        if E::Tangential::ACTIVE {
            // copies: arguments of a call would be kept in memory on every path
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

/// Where the search begins: at the last projection, or at the centre.
#[inline(always)]
fn start<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    history: Option<History<'_>>,
    given: bool,
) -> [f64; P] {
    let Some(history) = history else {
        return E::centre();
    };
    let projection = core::array::from_fn(|i| history.at(HistoryLayout::PROJECTION + i));
    E::REACH.start(history.at(HistoryLayout::STATUS), projection, given)
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
    history.map_or(0.0, |history| history.at(E::HISTORY_LAYOUT.multiplier_at()))
}

/// N, N' and W of a closed point, if the law is defined and its values are small enough to form forces.
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
        // false for NaN
        usable &= abs(value) <= LARGEST_VALUE;
    }
    if usable { Ok(law) } else { Err(Status::Law) }
}

/// The tangents and second derivatives are finite.
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
