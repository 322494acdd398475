//! Every status, feature, return code and named argument of the interface must have been seen.

use std::collections::BTreeSet;

use contact_elements::abi::{Evaluation, argument, code, evaluate, request};
use contact_elements::runtime::Status;

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
const STATUSES: [Status; 7] = [
    Status::Open,
    Status::Closed,
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
    if let Some(subject) = subjects.iter().find(|s| s.name() == "PointQuad4") {
        front_door(&mut finding, subject);
    } else {
        finding.fail("PointQuad4 is not among the elements".to_string());
    }
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

/// One call with a fault, and the code and argument that must come out.
struct Fault {
    what: &'static str,
    code: i32,
    argument: i32,
    change: fn(&mut Data),
}

/// Inputs of a good call.
struct Data {
    x: Vec<f64>,
    u: Vec<f64>,
    parameters: Vec<f64>,
    history: Vec<f64>,
    output: Vec<f64>,
    bits: u32,
}

const FAULTS: [Fault; 9] = [
    Fault {
        what: "no coordinates",
        code: code::NULL,
        argument: argument::X,
        change: |d| d.x.clear(),
    },
    Fault {
        what: "NaN coordinate",
        code: code::NOT_FINITE,
        argument: argument::X,
        change: |d| d.x[4] = f64::NAN,
    },
    Fault {
        what: "infinite displacement",
        code: code::NOT_FINITE,
        argument: argument::U,
        change: |d| d.u[7] = f64::INFINITY,
    },
    Fault {
        what: "missing parameter",
        code: code::PARAMETER,
        argument: argument::PARAMETERS,
        change: |d| d.parameters.truncate(1),
    },
    Fault {
        what: "negative stiffness",
        code: code::PARAMETER,
        argument: argument::PARAMETERS,
        change: |d| d.parameters[0] = -1.0,
    },
    Fault {
        what: "NaN parameter",
        code: code::NOT_FINITE,
        argument: argument::PARAMETERS,
        change: |d| d.parameters[0] = f64::NAN,
    },
    Fault {
        what: "unknown request",
        code: code::REQUEST,
        argument: argument::REQUEST,
        change: |d| d.bits = 1 << 20,
    },
    Fault {
        what: "frozen without history",
        code: code::NULL,
        argument: argument::HISTORY_OLD,
        change: |d| {
            d.bits = request::FREEZE_STATE;
            d.history.clear();
        },
    },
    Fault {
        what: "huge history",
        code: code::NOT_FINITE,
        argument: argument::HISTORY_OLD,
        change: |d| d.history[1] = 1e300,
    },
];

fn front_door(finding: &mut Finding, subject: &Subject) {
    for fault in FAULTS {
        let mut data = Data {
            x: FACET.to_vec(),
            u: vec![0.0; 15],
            parameters: vec![1000.0, 0.0, 1.0],
            history: vec![0.0; 3],
            output: vec![0.0; 11],
            bits: 0,
        };
        (fault.change)(&mut data);
        let mut residual = vec![1.0; 15];
        let outcome = evaluate(
            subject.description.descriptor,
            &mut Evaluation {
                x: &data.x,
                u: &data.u,
                parameters: &data.parameters,
                history: &data.history,
                residual: &mut residual,
                output: &mut data.output,
                bits: data.bits,
                ..Evaluation::default()
            },
        );
        let untouched = residual.iter().all(|&value| value == 1.0);
        if outcome.code == fault.code && outcome.argument == fault.argument && untouched {
            finding.pass();
        } else {
            finding.fail(format!(
                "{}: {outcome:?}, untouched: {untouched}",
                fault.what
            ));
        }
    }
}
