//! One evaluation of an element: project every point, then add up the closed ones.
//!
//! The first pass touches no output, so a failure leaves everything as it was. Open points return before
//! anything that only closed contact needs.

use crate::element::contraction::{NormalContraction, contract};
use crate::element::pass::{Contact, Pass};
use crate::element::receiver::{Call, Failure, Receiver, Report, Summary, Write};
use crate::element::stage::{Stage, scale_variation};
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
    let mut pass = Pass::<E, R, D, P, H>::new(call, stage, receiver);
    if Q == 1 {
        pass.evaluate_one()
    } else {
        pass.evaluate_all::<Q>()
    }
}

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// Q points: the first pass over all of them, then the second.
    #[inline(always)]
    fn evaluate_all<const Q: usize>(&mut self) -> Result<Summary, Failure> {
        let mut points = [None; Q];
        let mut states = [Sliding::default(); Q];
        for (number, (slot, state)) in points.iter_mut().zip(&mut states).enumerate() {
            let failed = |status| Failure {
                status,
                point: number,
            };
            *slot = Some(self.classify(number, state).map_err(failed)?);
        }
        let mut summary = Summary {
            status: Status::Open,
            closed: 0,
        };
        let mut energy = 0.0;
        let positions = self.stage.x.len() * D;
        if E::MULTIPLIER {
            self.receiver.open(positions + Q);
        }
        for (number, (point, state)) in points.iter().zip(&states).enumerate() {
            let Some(point) = point else { continue };
            if point.status.rank() > summary.status.rank() {
                summary.status = point.status;
            }
            if point.status.is_closed() {
                // the rows still hold what the last point of the first pass left
                self.load_slave(number);
                E::kinematics(
                    self.stage.x,
                    &point.zeta,
                    self.call.parameters,
                    &mut self.stage.rows,
                );
                let is_first = summary.closed == 0 && !E::MULTIPLIER;
                let write = if is_first { Write::Replace } else { Write::Add };
                energy += self.closed(number, point, state, write);
                summary.closed += 1;
            } else {
                energy += self.unloaded(number, point, state);
            }
        }
        if summary.closed == 0 && !E::MULTIPLIER {
            self.receiver.open(positions);
        }
        self.receiver.energy(energy);
        Ok(summary)
    }

    /// One point: nothing has to be stored between the passes.
    #[inline(always)]
    fn evaluate_one(&mut self) -> Result<Summary, Failure> {
        let mut state = Sliding::default();
        let point = match self.classify(0, &mut state) {
            Ok(point) => point,
            Err(status) => return Err(Failure { status, point: 0 }),
        };
        let is_closed = point.status.is_closed();
        let positions = self.stage.x.len() * D;
        let energy = if is_closed {
            if E::MULTIPLIER {
                self.receiver.clear(positions);
            }
            self.closed(0, &point, &state, Write::Replace)
        } else {
            self.receiver.open(positions + usize::from(E::MULTIPLIER));
            self.unloaded(0, &point, &state)
        };
        self.receiver.energy(energy);
        Ok(Summary {
            status: point.status,
            closed: u32::from(is_closed),
        })
    }

    /// Second pass of a point without load: its report, the residual of its multiplier. Returns its energy.
    #[inline(always)]
    fn unloaded(&mut self, number: usize, point: &Point<D, P, H>, state: &Sliding<P>) -> f64 {
        if self.receiver.reports() {
            let report = report(point, state, &self.placement, 0.0, 0.0);
            self.receiver.report(number, &report);
        }
        if !E::MULTIPLIER {
            return 0.0;
        }
        let weight = self.weight(number);
        self.open_multiplier(number, point, weight)
    }

    /// Second pass of a closed point: law, residual, tangent. Returns its energy.
    #[inline(always)]
    fn closed(
        &mut self,
        number: usize,
        point: &Point<D, P, H>,
        state: &Sliding<P>,
        write: Write,
    ) -> f64 {
        let contact = Contact {
            number,
            point,
            state,
            weight: self.weight(number),
            n: self.to_global(&point.gap.n),
            write,
        };
        if self.call.wanted.residual {
            self.residual(&contact);
        }
        if self.call.wanted.tangent {
            self.tangent(&contact);
        }
        if E::MULTIPLIER {
            self.closed_multiplier(&contact);
        }
        let (law, weight) = (point.law, contact.weight);
        if self.receiver.reports() {
            let report = report(point, state, &self.placement, law.traction, weight);
            self.receiver.report(number, &report);
        }
        weight * (law.energy + state.tangential.energy)
    }

    /// Residual of a closed point.
    #[inline(always)]
    fn residual(&mut self, contact: &Contact<'_, D, P, H>) {
        if E::Tangential::ACTIVE {
            self.sliding_residual(contact);
            if E::ROLLING.is_some() {
                self.rolling_residual(contact);
            }
            return;
        }
        self.normal_residual(contact);
        if E::ANGLE {
            self.angle_residual(contact);
        }
    }

    /// R_(A,k) = N s_A n_k of a point with force N n. [eq:residual]
    #[inline(always)]
    fn normal_residual(&mut self, contact: &Contact<'_, D, P, H>) {
        let weighted_traction = contact.weight * contact.point.law.traction;
        let force = contact.n.map(|n| weighted_traction * n);
        let s = &*self.stage.rows.s;
        if contact.write == Write::Replace {
            let row = &mut *self.stage.temporaries.row;
            let (forces, _) = row.as_chunks_mut::<D>();
            for (to, &s) in forces.iter_mut().zip(s.iter()) {
                *to = force.map(|force| s * force);
            }
            let forces = row.get(..s.len() * D).unwrap_or(&[]);
            self.receiver.forces(forces, D);
            return;
        }
        for (a, &s) in s.iter().enumerate() {
            for k in 0..D {
                self.receiver.force((a, k), s * force[k], Write::Add);
            }
        }
    }

    /// The point's weight: from the call, or from the slave's area.
    #[inline(always)]
    fn weight(&mut self, number: usize) -> f64 {
        if E::SLAVE_NODES == 0 {
            return self.call.slave_row.last().copied().unwrap_or(1.0);
        }
        let measure = E::measure(
            number,
            self.stage.reference,
            self.stage.x,
            self.call.parameters,
            self.stage.variation,
        );
        measure.weight
    }

    /// Adds the tangent of a closed point.
    #[inline(always)]
    fn tangent(&mut self, contact: &Contact<'_, D, P, H>) {
        let point = contact.point;
        let mut coefficients = E::tangent(
            &point.vectors,
            &point.gap,
            &point.law,
            self.call.parameters,
            point.orientation,
        );
        if E::Tangential::ACTIVE && Self::MERGES_WITH_NORMAL {
            self.merge_with_normal(contact, &mut coefficients);
        }
        let coefficients = in_global_frame(coefficients, &self.placement, contact.weight);
        if E::Tangential::ACTIVE && !Self::MERGES_WITH_NORMAL {
            self.sliding_tangent(contact, &coefficients);
            if E::ROLLING.is_some() {
                self.rolling_tangent(contact);
            }
        } else {
            self.normal_tangent(contact, &coefficients);
        }
        if E::ANGLE {
            self.angle_tangent(contact);
        }
    }

    /// Contracts the coefficients of the normal law.
    #[inline(always)]
    fn normal_tangent(
        &mut self,
        contact: &Contact<'_, D, P, H>,
        coefficients: &Coefficients<D, P>,
    ) {
        let stage = &mut *self.stage;
        let measure: &[f64] = if E::CURRENT {
            scale_variation(stage.variation, contact.point.law.traction, &self.placement);
            stage.variation
        } else {
            &[]
        };
        let contraction = NormalContraction {
            s: stage.rows.s,
            ds: core::array::from_fn(|j| &*stage.rows.ds[j]),
            n: &contact.n,
            coefficients,
            measure,
            moving: E::MOVING,
            write: contact.write,
        };
        contract(&contraction, &mut stage.temporaries, self.receiver);
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
