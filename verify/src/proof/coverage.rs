//! Every status and feature must have been seen, and every return code and argument that a caller from safe Rust
//! can provoke; those that need a wrong pointer, stride or count are provoked by the clients in `tests/clients`.

use std::collections::BTreeSet;

use contact_elements::{
    Error, Evaluation, OUTPUT_SIZE, Status, Summary, argument, code, evaluate, request,
};

use super::Finding;
use crate::subject::{Input, Subject, Wanted};

/// What was seen while proving.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Status numbers.
    pub statuses: BTreeSet<i32>,
    /// Features beyond which projections lay.
    pub features: BTreeSet<u8>,
}

/// Statuses that must occur.
const STATUSES: [Status; 9] = [
    Status::Open,
    Status::Closed,
    Status::Stick,
    Status::Slip,
    Status::Outside,
    Status::NotConverged,
    Status::NotUnique,
    Status::Degenerate,
    Status::Law,
];

/// Checks the branches of the kernels (`seen`) and those of the interface's front door.
pub fn prove(subjects: &[Subject], seen: &mut Seen) -> Finding {
    let mut finding = Finding::default();
    passed_barrier(&mut finding, subjects, seen);
    far_start(&mut finding, subjects, seen);
    for status in STATUSES {
        if seen.statuses.contains(&(status as i32)) {
            finding.pass();
        } else {
            finding.fail(format!("status {status:?} was never reached"));
        }
    }
    for feature in 1..=8 {
        if seen.features.contains(&feature) {
            finding.pass();
        } else {
            finding.fail(format!("no projection lay beyond feature {feature}"));
        }
    }
    front_door(&mut finding, subjects, "PointQuad4", &FAULTS);
    front_door(
        &mut finding,
        subjects,
        "InterpolatedQuad4",
        &INTERPOLATED_FAULTS,
    );
    front_door(
        &mut finding,
        subjects,
        "PointQuad4Coulomb",
        &FRICTIONAL_FAULTS,
    );
    finding
}

/// A point behind a logarithmic barrier: outside the law's domain, nothing written.
fn passed_barrier(finding: &mut Finding, subjects: &[Subject], seen: &mut Seen) {
    let Some(subject) = subjects.iter().find(|s| s.name() == "PointQuad4LogBarrier") else {
        finding.fail("PointQuad4LogBarrier is not among the elements".to_string());
        return;
    };
    let answer = subject.call(
        &Input {
            reference: &FACET,
            displacement: &[0.0; 15],
            parameters: &[10.0, 0.2, 0.0, 1.0],
            history: &[0.0; 3],
            slave_row: &[],
            multipliers: &[],
        },
        Wanted::BOTH,
    );
    if answer.status() == Some(Status::Law) && answer.is_untouched() {
        seen.statuses.insert(Status::Law as i32);
        finding.pass();
    } else {
        finding.fail(format!("a passed barrier: {:?}", answer.outcome));
    }
}

/// A start a thousand turns along a close-wound helix, a radian per step: too far for the projection, which
/// must say so.
fn far_start(finding: &mut Finding, subjects: &[Subject], seen: &mut Seen) {
    let Some(subject) = subjects.iter().find(|s| s.name() == "PointHelix") else {
        finding.fail("PointHelix is not among the elements".to_string());
        return;
    };
    // eps_n, r0, radius, rise, placement
    let parameters = [1000.0, 0.5, 1.0, 0.01, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let answer = subject.call(
        &Input {
            reference: &[0.3, 0.0, 0.2],
            displacement: &[0.0; 3],
            parameters: &parameters,
            history: &[0.0, 6000.0],
            slave_row: &[],
            multipliers: &[],
        },
        Wanted::BOTH,
    );
    if answer.status() == Some(Status::NotConverged) && answer.is_untouched() {
        seen.statuses.insert(Status::NotConverged as i32);
        finding.pass();
    } else {
        finding.fail(format!("a far start: {:?}", answer.outcome));
    }
}

/// A point 0.1 below a unit facet.
const FACET: [f64; 15] = [
    0.1, 0.2, -0.1, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
];

/// A fault put into a good call: what it is, and the code and argument that must come out.
type Fault = (&'static str, i32, i32, fn(&mut Data));

/// Inputs and outputs of a good call.
struct Data {
    x: Vec<f64>,
    u: Vec<f64>,
    parameters: Vec<f64>,
    history: Vec<f64>,
    slave_row: Vec<f64>,
    residual: Vec<f64>,
    tangent: Vec<f64>,
    output: Vec<f64>,
    trial: Vec<f64>,
    energy: Vec<f64>,
    workspace: Vec<f64>,
    bits: u32,
}

/// A good call for a point on a facet.
#[rustfmt::skip]
const FAULTS: [Fault; 17] = [
    ("no coordinates", code::NULL, argument::X, |d| d.x.clear()),
    ("NaN coordinate", code::NOT_FINITE, argument::X, |d| d.x[4] = f64::NAN),
    ("few displacements", code::NULL, argument::U, |d| d.u.truncate(14)),
    ("infinite displacement", code::NOT_FINITE, argument::U, |d| d.u[7] = f64::INFINITY),
    ("missing parameter", code::PARAMETER, argument::PARAMETERS, |d| d.parameters.truncate(1)),
    ("negative stiffness", code::PARAMETER, argument::PARAMETERS, |d| d.parameters[0] = -1.0),
    ("NaN parameter", code::NOT_FINITE, argument::PARAMETERS, |d| d.parameters[0] = f64::NAN),
    ("unknown request", code::REQUEST, argument::REQUEST, |d| d.bits = 1 << 20),
    ("short history", code::NULL, argument::HISTORY_ACCEPTED, |d| d.history.truncate(2)),
    ("huge history", code::NOT_FINITE, argument::HISTORY_ACCEPTED, |d| d.history[1] = 1e300),
    ("frozen without history", code::NULL, argument::HISTORY_ACCEPTED, |d| {
        d.bits = request::FREEZE_STATE;
        d.history.clear();
    }),
    ("short residual", code::NULL, argument::F, |d| d.residual.truncate(14)),
    ("short tangent", code::NULL, argument::K, |d| d.tangent.truncate(224)),
    ("short output", code::NULL, argument::OUTPUT, |d| d.output.truncate(10)),
    ("short new history", code::NULL, argument::HISTORY_TRIAL, |d| d.trial.truncate(2)),
    ("energy without its array", code::NULL, argument::ENERGY, |d| {
        d.bits = request::ENERGY;
        d.energy.clear();
    }),
    ("facet without area", code::CUT_BACK, argument::X, |d| d.x[3..].fill(0.0)),
];

/// A good call for an interpolated slave with one node on a facet.
#[rustfmt::skip]
const INTERPOLATED_FAULTS: [Fault; 3] = [
    ("no slave row", code::NODE_COUNT, argument::NSLAVE, |d| d.slave_row.clear()),
    ("NaN in the slave row", code::NOT_FINITE, argument::SLAVE_ROW, |d| d.slave_row[0] = f64::NAN),
    ("small workspace", code::WORKSPACE, argument::WORKSPACE, |d| d.workspace.truncate(1)),
];

/// A good call for a point with friction on a facet: eps_n, eps_t, mu, r0, orientation; status, ζ, anchor, path.
#[rustfmt::skip]
const FRICTIONAL_FAULTS: [Fault; 7] = [
    ("tangential stiffness of zero", code::PARAMETER, argument::PARAMETERS, |d| d.parameters[1] = 0.0),
    ("negative coefficient of friction", code::PARAMETER, argument::PARAMETERS, |d| d.parameters[2] = -0.1),
    ("history without anchor", code::NULL, argument::HISTORY_ACCEPTED, |d| d.history.truncate(3)),
    ("anchor that is NaN", code::NOT_FINITE, argument::HISTORY_ACCEPTED, |d| d.history[3] = f64::NAN),
    ("anchor far away", code::HISTORY, argument::HISTORY_ACCEPTED, |d| d.history[3] = 6e7),
    ("negative path", code::HISTORY, argument::HISTORY_ACCEPTED, |d| d.history[5] = -1.0),
    ("status of no kind", code::HISTORY, argument::HISTORY_ACCEPTED, |d| d.history[0] = 2.5),
];

/// Puts every fault into a separate call.
fn front_door(finding: &mut Finding, subjects: &[Subject], name: &str, faults: &[Fault]) {
    let Some(subject) = subjects.iter().find(|s| s.name() == name) else {
        finding.fail(format!("{name} is not among the elements"));
        return;
    };
    let descriptor = subject.description.descriptor;
    for &(what, code, argument, change) in faults {
        let mut data = Data {
            x: FACET.to_vec(),
            u: vec![0.0; 15],
            parameters: match descriptor.friction {
                true => vec![1000.0, 500.0, 0.3, 0.0, 1.0],
                false => vec![1000.0, 0.0, 1.0],
            },
            history: vec![0.0; descriptor.history()],
            slave_row: vec![1.0, 1.0],
            residual: vec![1.0; 15],
            tangent: vec![1.0; 225],
            output: vec![1.0; OUTPUT_SIZE],
            trial: vec![1.0; descriptor.history()],
            energy: vec![1.0],
            workspace: vec![0.0; descriptor.workspace(5)],
            bits: 0,
        };
        let good = called(subject, &mut data);
        change(&mut data);
        for array in data.outputs() {
            array.fill(1.0);
        }
        let outcome = called(subject, &mut data);
        let untouched = data.outputs().into_iter().flatten().all(|&mut v| v == 1.0);
        let is_named = outcome.is_err_and(|error| (error.code, error.argument) == (code, argument));
        if good.is_ok() && is_named && untouched {
            finding.pass();
        } else {
            finding.fail(format!(
                "{what}: {good:?}, then {outcome:?}, untouched: {untouched}"
            ));
        }
    }
}

impl Data {
    fn outputs(&mut self) -> [&mut Vec<f64>; 5] {
        [
            &mut self.residual,
            &mut self.tangent,
            &mut self.output,
            &mut self.trial,
            &mut self.energy,
        ]
    }
}

fn called(subject: &Subject, data: &mut Data) -> Result<Summary, Error> {
    let slave_row: &[f64] = match subject.description.descriptor.interpolated {
        true => &data.slave_row,
        false => &[],
    };
    evaluate(
        subject.description.descriptor,
        &mut Evaluation {
            x: &data.x,
            u: &data.u,
            parameters: &data.parameters,
            history: &data.history,
            slave_row,
            residual: &mut data.residual,
            tangent: &mut data.tangent,
            output: &mut data.output,
            trial: &mut data.trial,
            energy: &mut data.energy,
            workspace: &mut data.workspace,
            bits: data.bits,
        },
    )
}
