//! One evaluation of an element: project every point, then add up the closed ones.
//!
//! The first pass touches no output, so a failure leaves everything as it was. Open points return before
//! anything that only closed contact needs.

use core::cell::Cell;

use super::contraction::{Temporaries, contract};
use super::element::Element;
use super::placement::Placement;
use super::projection::project;
use super::shape::{NormalLaw, Traction};
use super::values::{Coefficients, Gap, Rows, Status, Vectors};
use crate::arithmetic::abs;

/// Which outputs are wanted, and how.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted {
    /// Residual.
    pub residual: bool,
    /// Tangent.
    pub tangent: bool,
    /// Open or closed as the history says.
    pub freeze: bool,
    /// The history holds the projection itself.
    pub projection_given: bool,
}

/// Inputs of an evaluation besides the nodes.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// Parameters, checked.
    pub parameters: &'a [f64],
    /// Accepted history: per point status and projected parameters; none: start at the centre. Cells,
    /// because the host may hand in one array for the old and the new history; all reads come first.
    pub history: Option<&'a [Cell<f64>]>,
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Wanted outputs.
    pub wanted: Wanted,
}

/// What is known of one contact point after an evaluation.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// Outcome.
    pub status: Status,
    /// 0, or the feature beyond which the projection lies.
    pub feature: u8,
    /// Gap [length].
    pub gap: f64,
    /// Normal traction.
    pub traction: f64,
    /// Weight times Jacobian.
    pub weight: f64,
    /// Projected parameters.
    pub zeta: [f64; 2],
    /// Unit normal in the global frame; third entry 0 in 2D.
    pub normal: [f64; 3],
    /// Newton steps.
    pub iterations: u32,
}

/// Takes the outputs of an evaluation: dense arrays, strided ones, a sparse matrix.
pub trait Receiver {
    /// All of residual and tangent is zero: no point is closed.
    fn open(&mut self, unknowns: usize);
    /// Entry (node, component) of the residual; `first`: replaces, else adds.
    fn force(&mut self, place: (usize, usize), value: f64, first: bool);
    /// Row `unknown` of the tangent; `first`: replaces, else adds.
    fn row(&mut self, unknown: usize, row: &[f64], first: bool);
    /// Outcome of point `point`.
    fn report(&mut self, point: usize, report: &Report);
    /// Contact energy of the element.
    fn energy(&mut self, energy: f64);
}

/// Outcome of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Status of its worst point.
    pub status: Status,
    /// Closed points.
    pub closed: u32,
}

/// A point that could not be evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Why.
    pub status: Status,
    /// Which point.
    pub point: usize,
}

/// A point after the first pass.
#[derive(Clone, Copy)]
struct Point<const D: usize, const P: usize, const H: usize> {
    status: Status,
    feature: u8,
    zeta: [f64; P],
    vectors: Vectors<D, P, H>,
    gap: Gap<D>,
    /// Of a closed point.
    law: Traction,
    iterations: u32,
}

/// Nodes and scratch of an evaluation; see [`kernel`](super::fixed) for who makes them.
#[derive(Debug)]
pub struct Stage<'a, const D: usize, const P: usize> {
    /// Positions in the local frame, slave nodes first.
    pub x: &'a [[f64; D]],
    /// Reference positions of the slave nodes, for the reference measure.
    pub reference: &'a [[f64; D]],
    /// Largest local coordinate.
    pub scale: f64,
    /// Rows s_A, s_A,i; zero on entry.
    pub rows: Rows<'a, P>,
    /// Scratch of the contraction.
    pub temporaries: Temporaries<'a, D, P>,
    /// w N ∂J/∂x, where the measure moves.
    pub variation: &'a mut [f64],
}

/// Evaluates an element with Q contact points.
#[inline(always)]
pub fn evaluate<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
    const Q: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P>,
    receiver: &mut R,
) -> Result<Summary, Failure> {
    if Q == 1 {
        return evaluate_one::<E, R, D, P, H>(call, stage, receiver);
    }
    let mut points = [None; Q];
    for (number, slot) in points.iter_mut().enumerate() {
        match classify::<E, D, P, H>(call, stage, number) {
            Ok(point) => *slot = Some(point),
            Err(status) => {
                return Err(Failure {
                    status,
                    point: number,
                });
            }
        }
    }
    let placement = placement::<E, D, P, H>(call.parameters);
    let mut summary = Summary {
        status: Status::Open,
        closed: 0,
    };
    let mut energy = 0.0;
    for (number, point) in points.iter().enumerate() {
        let Some(point) = point else { continue };
        if point.status.rank() > summary.status.rank() {
            summary.status = point.status;
        }
        if point.status == Status::Closed {
            let first = summary.closed == 0;
            let again = Q > 1;
            energy += closed::<E, R, D, P, H>(
                call,
                stage,
                receiver,
                &placement,
                point,
                (number, first, again),
            );
            summary.closed += 1;
        } else {
            receiver.report(number, &report(point, &placement, 0.0, 0.0));
        }
    }
    if summary.closed == 0 {
        receiver.open(stage.x.len() * D);
    }
    receiver.energy(energy);
    Ok(summary)
}

/// An element with one contact point: nothing has to be kept between the passes.
#[inline(always)]
fn evaluate_one<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P>,
    receiver: &mut R,
) -> Result<Summary, Failure> {
    let point = match classify::<E, D, P, H>(call, stage, 0) {
        Ok(point) => point,
        Err(status) => return Err(Failure { status, point: 0 }),
    };
    let placement = placement::<E, D, P, H>(call.parameters);
    let mut energy = 0.0;
    let is_closed = point.status == Status::Closed;
    if is_closed {
        let pass = (0, true, false);
        energy = closed::<E, R, D, P, H>(call, stage, receiver, &placement, &point, pass);
    } else {
        receiver.report(0, &report(&point, &placement, 0.0, 0.0));
        receiver.open(stage.x.len() * D);
    }
    receiver.energy(energy);
    Ok(Summary {
        status: point.status,
        closed: u32::from(is_closed),
    })
}

#[inline(always)]
fn placement<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> Option<Placement<D>> {
    E::LAYOUT
        .placement
        .map(|at| Placement::from_parameters(parameters.get(at..).unwrap_or(&[])))
}

/// First pass: projection, gap, status.
#[inline(always)]
fn classify<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P>,
    number: usize,
) -> Result<Point<D, P, H>, Status> {
    load_slave::<E, D, P, H>(call, stage, number);
    let history = call
        .history
        .and_then(|history| history.get(number * (1 + P)..));
    let mut start = E::centre();
    if let Some(history) = history {
        for (start, value) in start.iter_mut().zip(history.iter().skip(1)) {
            *start = value.get();
        }
    }
    let given = call.wanted.projection_given;
    let projected = project::<E, D, P, H>(
        stage.x,
        start,
        given,
        call.parameters,
        stage.scale,
        &mut stage.rows,
    )?;
    let mut point = Point {
        status: Status::Outside,
        feature: projected.feature,
        zeta: projected.zeta,
        vectors: projected.vectors,
        gap: Gap::default(),
        law: Traction::default(),
        iterations: projected.iterations,
    };
    if !E::SIGNED && is_zero(&point.vectors.r, stage.scale) {
        return Err(Status::Degenerate);
    }
    if !E::is_regular(number, stage.x, &point.vectors, call.parameters) {
        return Err(Status::Degenerate);
    }
    let orientation = orientation::<E, D, P, H>(call.parameters);
    point.gap = E::gap(&point.vectors, call.parameters, orientation);
    if !(is_finite(&point.gap.n) & is_finite(&[point.gap.gap])) {
        return Err(Status::Degenerate);
    }
    if point.feature != 0 {
        return Ok(point);
    }
    let gap = point.gap.gap;
    let closed = match (call.wanted.freeze, history) {
        (true, Some(history)) => history.first().map(Cell::get) == Some(1.0),
        _ => E::Law::active(gap, call.parameters) > 0.0,
    };
    if closed {
        point.status = Status::Closed;
        point.law = law::<E, D, P, H>(gap, call.parameters)?;
        if call.wanted.tangent && !has_derivatives(&point.vectors) {
            return Err(Status::Degenerate);
        }
    } else {
        point.status = Status::Open;
    }
    Ok(point)
}

/// N, N' and W of a closed point, where the law is defined and its values are numbers.
#[inline(always)]
fn law<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    gap: f64,
    parameters: &[f64],
) -> Result<Traction, Status> {
    if E::Law::valid(gap, parameters) <= 0.0 {
        return Err(Status::Law);
    }
    let law = E::Law::evaluate(gap, parameters);
    if is_finite(&[law.traction, law.slope, law.energy]) {
        Ok(law)
    } else {
        Err(Status::Law)
    }
}

/// The tangents and second derivatives are numbers.
#[inline(always)]
fn has_derivatives<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> bool {
    let mut finite = true;
    for vector in vectors.b.iter().chain(&vectors.second) {
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
fn is_zero<const D: usize>(r: &[f64; D], scale: f64) -> bool {
    r.iter()
        .all(|&component| abs(component) <= (8.0 * f64::EPSILON * scale).max(1e-30))
}

#[inline(always)]
fn orientation<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> f64 {
    match E::LAYOUT.orientation.and_then(|at| parameters.get(at)) {
        Some(&value) if value < 0.0 => -1.0,
        _ => 1.0,
    }
}

/// The slave's fixed row: of the declaration, or handed in.
#[inline(always)]
fn load_slave<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P>,
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

/// Second pass of a closed point: law, residual, tangent. Returns its energy.
#[inline(always)]
fn closed<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P>,
    receiver: &mut R,
    placement: &Option<Placement<D>>,
    point: &Point<D, P, H>,
    (number, first, again): (usize, bool, bool),
) -> f64 {
    if again {
        load_slave::<E, D, P, H>(call, stage, number);
        E::kinematics(stage.x, &point.zeta, call.parameters, &mut stage.rows);
    }
    let law = point.law;
    let weight = if E::SLAVE_NODES == 0 {
        call.slave_row.last().copied().unwrap_or(1.0)
    } else {
        E::measure(
            number,
            stage.reference,
            stage.x,
            call.parameters,
            stage.variation,
        )
        .weight
    };
    let n = match placement {
        Some(placement) => placement.vector_to_global(&point.gap.n),
        None => point.gap.n,
    };
    if call.wanted.residual {
        let pull = weight * law.traction;
        for (a, &s) in stage.rows.s.iter().enumerate() {
            for k in 0..D {
                receiver.force((a, k), pull * s * n[k], first);
            }
        }
    }
    if call.wanted.tangent {
        let orientation = orientation::<E, D, P, H>(call.parameters);
        let coefficients = E::tangent(
            &point.vectors,
            &point.gap,
            &law,
            call.parameters,
            orientation,
        );
        let coefficients = in_global_frame(coefficients, placement, weight);
        let variation: &[f64] = if E::CURRENT {
            scale_variation(stage.variation, law.traction, placement);
            stage.variation
        } else {
            &[]
        };
        contract(
            stage.rows.s,
            core::array::from_fn(|j| &*stage.rows.ds[j]),
            &n,
            &coefficients,
            variation,
            E::MOVING,
            first,
            &mut stage.temporaries,
            receiver,
        );
    }
    receiver.report(number, &report(point, placement, law.traction, weight));
    weight * law.energy
}

/// N w ∂J/∂x in the global frame.
#[inline(always)]
fn scale_variation<const D: usize>(
    variation: &mut [f64],
    traction: f64,
    placement: &Option<Placement<D>>,
) {
    let (blocks, _) = variation.as_chunks_mut::<D>();
    for block in blocks {
        if let Some(placement) = placement {
            *block = placement.vector_to_global(block);
        }
        for entry in block {
            *entry *= traction;
        }
    }
}

/// The coefficients times the point's weight, turned out of the frame of a placed geometry.
#[inline(always)]
fn in_global_frame<const D: usize, const P: usize>(
    mut c: Coefficients<D, P>,
    placement: &Option<Placement<D>>,
    weight: f64,
) -> Coefficients<D, P> {
    if let Some(placement) = placement {
        c.p = placement.tensor_to_global(&c.p);
        for vector in c.right.iter_mut().chain(&mut c.left) {
            *vector = placement.vector_to_global(vector);
        }
    }
    if weight != 1.0 {
        let entries = c.p.iter_mut().chain(&mut c.right).chain(&mut c.left);
        for entry in entries.flatten() {
            *entry *= weight;
        }
        for entry in c.s.iter_mut().flatten() {
            *entry *= weight;
        }
    }
    c
}

#[inline(always)]
fn report<const D: usize, const P: usize, const H: usize>(
    point: &Point<D, P, H>,
    placement: &Option<Placement<D>>,
    traction: f64,
    weight: f64,
) -> Report {
    let n = match placement {
        Some(placement) => placement.vector_to_global(&point.gap.n),
        None => point.gap.n,
    };
    let mut report = Report {
        status: point.status,
        feature: point.feature,
        gap: point.gap.gap,
        traction,
        weight,
        zeta: [0.0; 2],
        normal: [0.0; 3],
        iterations: point.iterations,
    };
    for (to, &from) in report.zeta.iter_mut().zip(&point.zeta) {
        *to = from;
    }
    for (to, &from) in report.normal.iter_mut().zip(&n) {
        *to = from;
    }
    report
}
