//! One element from Rust: slices in, slices out, through the same door as a C host.

use super::evaluate::element_evaluate;
use super::types::Arguments;
use super::{Descriptor, OUTPUT_SIZE, argument, code, request};
use crate::runtime::Status;

/// Inputs and outputs of one evaluation. Shapes: x and u have nodes · dimension entries, node by node; of the node
/// of a multiplier the first entry of u counts.
#[derive(Debug, Default)]
pub struct Evaluation<'a> {
    /// Reference coordinates \[nodes · dimension\].
    pub x: &'a [f64],
    /// Displacements \[nodes · dimension\]; empty: zero.
    pub u: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// Accepted history; empty: the projection starts from the centre, and with friction contact begins here:
    /// no tangential force.
    pub history: &'a [f64],
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Residual \[unknowns\]; empty: not wanted.
    pub residual: &'a mut [f64],
    /// Tangent [unknowns · unknowns], row-major; empty: not wanted.
    pub tangent: &'a mut [f64],
    /// Output [points · [`OUTPUT_SIZE`]]; empty: not wanted.
    pub output: &'a mut [f64],
    /// Trial history; empty: not wanted. Copied to `history` when the step is accepted.
    pub trial: &'a mut [f64],
    /// Energy \[1\]; empty: not wanted.
    pub energy: &'a mut [f64],
    /// Workspace of an interpolated slave.
    pub workspace: &'a mut [f64],
    /// Further request bits: FREEZE_STATE, SYMMETRISE, PROJECTION_GIVEN.
    pub bits: u32,
}

/// Outcome of an evaluation from Rust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Return code.
    pub code: i32,
    /// Status of the element.
    pub status: i32,
    /// Closed points.
    pub closed: i32,
    /// Argument that an error names.
    pub argument: i32,
    /// Entry within it.
    pub index: i32,
}

/// Evaluates `element`. Slices that are too short give the code and argument that a C host would get for a
/// required pointer that is null; [`code::NODE_COUNT`] for an interpolated slave without a row.
pub fn evaluate(element: &Descriptor, evaluation: &mut Evaluation<'_>) -> Outcome {
    let d = element.dimension;
    let nslave = if element.interpolated {
        evaluation.slave_row.len().saturating_sub(1)
    } else {
        element.slave_nodes
    };
    let n = element.nodes(nslave);
    let (coordinates, unknowns) = (n * d, element.unknowns(n));
    // a null pointer would stand for zero displacements or a start at the centre
    for (slice, length, name) in [
        (evaluation.u, coordinates, argument::U),
        (
            evaluation.history,
            element.history(),
            argument::HISTORY_ACCEPTED,
        ),
    ] {
        if !slice.is_empty() && slice.len() < length {
            return too_short(name);
        }
    }
    let mut arguments = Arguments::EMPTY;
    arguments.nnode = n as i32;
    arguments.nslave = nslave as i32;
    arguments.parameter_count = evaluation.parameters.len() as i32;
    arguments.parameters = evaluation.parameters.as_ptr();
    arguments.x = input(evaluation.x, coordinates);
    arguments.u = input(evaluation.u, coordinates);
    arguments.history_accepted = input(evaluation.history, element.history());
    arguments.slave_row = input(evaluation.slave_row, nslave + 1);
    let mut wanted = evaluation.bits;
    let mut output = |slice: &mut [f64], length: usize, bit: u32| {
        if slice.is_empty() {
            return core::ptr::null_mut();
        }
        wanted |= bit;
        if slice.len() < length {
            core::ptr::null_mut()
        } else {
            slice.as_mut_ptr()
        }
    };
    arguments.f = output(evaluation.residual, unknowns, request::RESIDUAL);
    arguments.k = output(evaluation.tangent, unknowns * unknowns, request::TANGENT);
    arguments.output = output(
        evaluation.output,
        element.points * OUTPUT_SIZE,
        request::OUTPUT,
    );
    arguments.history_trial = output(evaluation.trial, element.history(), request::HISTORY);
    arguments.energy = output(evaluation.energy, 1, request::ENERGY);
    arguments.request = wanted;
    arguments.workspace = evaluation.workspace.as_mut_ptr();
    arguments.workspace_size = evaluation.workspace.len() as i64;
    finish(element, &mut arguments)
}

/// The slice's address where it is long enough, else null.
fn input(slice: &[f64], length: usize) -> *const f64 {
    if slice.is_empty() || slice.len() < length {
        core::ptr::null()
    } else {
        slice.as_ptr()
    }
}

/// The outcome of a slice that is shorter than it must be.
fn too_short(argument: i32) -> Outcome {
    Outcome {
        code: code::NULL,
        status: Status::Open as i32,
        closed: 0,
        argument,
        index: 0,
    }
}

fn finish(element: &Descriptor, arguments: &mut Arguments) -> Outcome {
    // SAFETY: every pointer is null or a slice of the length that the header asks for.
    let code = unsafe { element_evaluate(element, arguments) };
    Outcome {
        code,
        status: arguments.status,
        closed: arguments.closed_points,
        argument: arguments.error_argument,
        index: arguments.error_index,
    }
}

impl Outcome {
    /// The status of an evaluation that succeeded or has to be cut back.
    pub fn status(&self) -> Option<Status> {
        if self.code != code::SUCCESS && self.code != code::CUT_BACK {
            return None;
        }
        [
            Status::Open,
            Status::Closed,
            Status::Stick,
            Status::Slip,
            Status::Outside,
            Status::NotConverged,
            Status::NotUnique,
            Status::Degenerate,
            Status::Law,
        ]
        .into_iter()
        .find(|status| *status as i32 == self.status)
    }
}
