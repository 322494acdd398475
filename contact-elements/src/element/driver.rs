//! One evaluation of an element: project every point, then add up the closed ones.
//!
//! The first pass touches no output, so a failure leaves everything as it was. Open points return before
//! anything that only closed contact needs.

use crate::element::angle;
use crate::element::classify::classify;
use crate::element::contraction::contract;
use crate::element::multiplier;
use crate::element::receiver::{Call, Failure, Receiver, Report, Summary};
use crate::element::rolling;
use crate::element::sliding;
use crate::element::stage::{Stage, load_slave, placement, scale_variation};
use crate::element::traits::Element;
use crate::point::enforcement::remembered;
use crate::point::friction::TangentialLaw;
use crate::point::placement::Placement;
use crate::point::state::{Point, Sliding};
use crate::point::values::{Coefficients, Status};

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
    stage: &mut Stage<'_, D, P, H>,
    receiver: &mut R,
) -> Result<Summary, Failure> {
    if Q == 1 {
        return evaluate_one::<E, R, D, P, H>(call, stage, receiver);
    }
    let mut points = [None; Q];
    let mut slidings = [Sliding::default(); Q];
    for (number, (slot, sliding)) in points.iter_mut().zip(&mut slidings).enumerate() {
        match classify::<E, D, P, H>(call, stage, number, sliding) {
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
    if E::MULTIPLIER {
        receiver.open(stage.x.len() * D + Q);
    }
    for (number, (point, sliding)) in points.iter().zip(&slidings).enumerate() {
        let Some(point) = point else { continue };
        if point.status.rank() > summary.status.rank() {
            summary.status = point.status;
        }
        if point.status.is_closed() {
            let first = summary.closed == 0 && !E::MULTIPLIER;
            let again = Q > 1;
            energy += closed::<E, R, D, P, H>(
                call,
                stage,
                receiver,
                &placement,
                (point, sliding),
                (number, first, again),
            );
            summary.closed += 1;
        } else {
            energy += unloaded::<E, R, D, P, H>(
                call,
                stage,
                receiver,
                &placement,
                (number, point, sliding),
            );
        }
    }
    if summary.closed == 0 && !E::MULTIPLIER {
        receiver.open(stage.x.len() * D);
    }
    receiver.energy(energy);
    Ok(summary)
}

/// An element with one contact point: nothing has to be stored between the passes.
#[inline(always)]
fn evaluate_one<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    receiver: &mut R,
) -> Result<Summary, Failure> {
    let mut sliding = Sliding::default();
    let point = match classify::<E, D, P, H>(call, stage, 0, &mut sliding) {
        Ok(point) => point,
        Err(status) => return Err(Failure { status, point: 0 }),
    };
    let placement = placement::<E, D, P, H>(call.parameters);
    let is_closed = point.status.is_closed();
    let positions = stage.x.len() * D;
    let energy = if is_closed {
        if E::MULTIPLIER {
            receiver.clear(positions);
        }
        let pass = (0, true, false);
        let point = (&point, &sliding);
        closed::<E, R, D, P, H>(call, stage, receiver, &placement, point, pass)
    } else {
        receiver.open(positions + usize::from(E::MULTIPLIER));
        let point = (0, &point, &sliding);
        unloaded::<E, R, D, P, H>(call, stage, receiver, &placement, point)
    };
    receiver.energy(energy);
    Ok(Summary {
        status: point.status,
        closed: u32::from(is_closed),
    })
}

/// Second pass of a point without load: its report, the residual of its multiplier. Returns its energy.
#[inline(always)]
fn unloaded<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    receiver: &mut R,
    placement: &Option<Placement<D>>,
    (number, point, state): (usize, &Point<D, P, H>, &Sliding<P>),
) -> f64 {
    if receiver.reports() {
        receiver.report(number, &report(point, state, placement, 0.0, 0.0));
    }
    if !E::MULTIPLIER {
        return 0.0;
    }
    let weight = weight::<E, D, P, H>(call, stage, number);
    let place = (stage.x.len() + number, stage.x.len() * D + number);
    let multiplier = (point.multiplier, point.law.slope);
    multiplier::open(call, place, multiplier, weight, receiver)
}

/// Second pass of a closed point: law, residual, tangent. Returns its energy.
#[inline(always)]
fn closed<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    receiver: &mut R,
    placement: &Option<Placement<D>>,
    (point, state): (&Point<D, P, H>, &Sliding<P>),
    (number, first, again): (usize, bool, bool),
) -> f64 {
    if again {
        load_slave::<E, D, P, H>(call, stage, number);
        E::kinematics(stage.x, &point.zeta, call.parameters, &mut stage.rows);
    }
    let law = point.law;
    let weight = weight::<E, D, P, H>(call, stage, number);
    let n = match placement {
        Some(placement) => placement.vector_to_global(&point.gap.n),
        None => point.gap.n,
    };
    if call.wanted.residual {
        let pull = weight * law.traction;
        if E::Tangential::ACTIVE {
            let place = (&n, weight, pull, first);
            sliding::residual::<E, R, D, P, H>(stage, placement, point, state, place, receiver);
            if E::ROLLING.is_some() {
                let state = (state, weight);
                rolling::residual::<E, R, D, P, H>(call, stage, point, state, receiver);
            }
        } else {
            normal_residual(stage, &n.map(|n| pull * n), first, receiver);
            if E::ANGLE {
                angle::residual::<E, R, D, P, H>(call, stage, point, (number, weight), receiver);
            }
        }
    }
    if call.wanted.tangent {
        let pass = (number, &n, weight, first);
        let both = (point, state);
        tangent::<E, R, D, P, H>(call, stage, receiver, placement, both, pass);
        if E::ANGLE {
            angle::tangent::<E, R, D, P, H>(call, stage, point, (number, weight), receiver);
        }
    }
    if E::MULTIPLIER {
        let place = (number, point, &n, weight);
        multiplier::closed::<E, R, D, P, H>(call, stage, placement, state, place, receiver);
    }
    if receiver.reports() {
        let report = report(point, state, placement, law.traction, weight);
        receiver.report(number, &report);
    }
    weight * (law.energy + state.tangential.energy)
}

/// R_(A,k) = N s_A n_k of a point with force N n. [eq:residual]
#[inline(always)]
fn normal_residual<R: Receiver, const D: usize, const P: usize, const H: usize>(
    stage: &mut Stage<'_, D, P, H>,
    force: &[f64; D],
    first: bool,
    receiver: &mut R,
) {
    if first {
        let (forces, _) = stage.temporaries.row.as_chunks_mut::<D>();
        for (to, &s) in forces.iter_mut().zip(stage.rows.s.iter()) {
            *to = force.map(|force| s * force);
        }
        let unknowns = stage.rows.s.len() * D;
        receiver.forces(stage.temporaries.row.get(..unknowns).unwrap_or(&[]), D);
        return;
    }
    for (a, &s) in stage.rows.s.iter().enumerate() {
        for k in 0..D {
            receiver.force((a, k), s * force[k], false);
        }
    }
}

/// The point's own weight: from the caller, or from the slave's area.
#[inline(always)]
fn weight<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    number: usize,
) -> f64 {
    if E::SLAVE_NODES == 0 {
        return call.slave_row.last().copied().unwrap_or(1.0);
    }
    let measure = E::measure(
        number,
        stage.reference,
        stage.x,
        call.parameters,
        stage.variation,
    );
    measure.weight
}

/// Adds the tangent of a closed point with global normal `n`.
#[inline(always)]
fn tangent<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
    stage: &mut Stage<'_, D, P, H>,
    receiver: &mut R,
    placement: &Option<Placement<D>>,
    (point, state): (&Point<D, P, H>, &Sliding<P>),
    (number, n, weight, first): (usize, &[f64; D], f64, bool),
) {
    let mut coefficients = E::tangent(
        &point.vectors,
        &point.gap,
        &point.law,
        call.parameters,
        point.orientation,
    );
    let joins = sliding::joins::<E, D, P, H>();
    if E::Tangential::ACTIVE && joins {
        let place = (number, point, state);
        sliding::join::<E, D, P, H>(call, stage.x, place, &mut coefficients);
    }
    let coefficients = in_global_frame(coefficients, placement, weight);
    if E::Tangential::ACTIVE && !joins {
        let place = (number, point, n, weight, first);
        sliding::tangent::<E, R, D, P, H>(
            call,
            stage,
            placement,
            state,
            place,
            &coefficients,
            receiver,
        );
        if E::ROLLING.is_some() {
            rolling::tangent::<E, R, D, P, H>(call, stage, point, (state, weight), receiver);
        }
        return;
    }
    let variation: &[f64] = if E::CURRENT {
        scale_variation(stage.variation, point.law.traction, placement);
        stage.variation
    } else {
        &[]
    };
    contract(
        stage.rows.s,
        core::array::from_fn(|j| &*stage.rows.ds[j]),
        n,
        &coefficients,
        variation,
        E::MOVING,
        first,
        &mut stage.temporaries,
        receiver,
    );
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
    state: &Sliding<P>,
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
        tangential: state.tangential.t,
        tangents: [[0.0; 3]; 2],
        anchor: [0.0; 2],
        path: state.path,
        multiplier: remembered(traction),
        rolling: state.rolling,
    };
    for (to, b) in report.tangents.iter_mut().zip(&point.vectors.b) {
        let b = match placement {
            Some(placement) => placement.vector_to_global(b),
            None => *b,
        };
        for (to, from) in to.iter_mut().zip(b) {
            *to = from;
        }
    }
    for (to, &from) in report.anchor.iter_mut().zip(&state.anchor) {
        *to = from;
    }
    for (to, &from) in report.zeta.iter_mut().zip(&point.zeta) {
        *to = from;
    }
    for (to, &from) in report.normal.iter_mut().zip(&n) {
        *to = from;
    }
    report
}
