//! A patch from Rust: slices in, slices out, through the same door as a C host.

use super::super::safe::{Evaluation, Outcome};
use super::super::types::Arguments;
use super::super::{Descriptor, OUTPUT_SIZE, argument, code, request};
use super::{HISTORY, Patch, WORKSPACE, patch_evaluate};

/// Facets that share edges and vertices, and the elements that stand for them.
#[derive(Clone, Copy, Debug)]
pub struct Facets<'a> {
    /// A slave point against a facet.
    pub facet: &'static Descriptor,
    /// Against the curve that bounds the facet; none: beyond an edge the point is outside.
    pub edge: Option<&'static Descriptor>,
    /// Against a vertex; none: beyond it the point is outside.
    pub vertex: Option<&'static Descriptor>,
    /// Slave points.
    pub slave_points: usize,
    /// Master nodes.
    pub master_nodes: usize,
    /// Master nodes of every facet, from 0.
    pub connectivity: &'a [i32],
    /// Nothing farther is looked for \[length\]; 0: no limit.
    pub reach: f64,
}

impl Facets<'_> {
    /// Doubles of history, workspace and output.
    pub fn sizes(&self) -> [usize; 3] {
        [HISTORY, WORKSPACE, OUTPUT_SIZE].map(|size| size * self.slave_points)
    }
}

/// Evaluates a patch. `evaluation`: x and u of all nodes, slave points first; no slave row. Slices that are too short
/// give the code and argument that a C host would get for a null pointer.
pub fn evaluate_patch(facets: &Facets<'_>, evaluation: &mut Evaluation<'_>) -> Outcome {
    let n = facets.slave_points + facets.master_nodes;
    let unknowns = n * facets.facet.dimension;
    let [history, workspace, output] = facets.sizes();
    let fault = |name: i32| Outcome {
        code: code::NULL,
        status: 0,
        closed: 0,
        argument: name,
        index: 0,
    };
    let nodes = facets.facet.master_nodes.max(1);
    let count = facets.connectivity.len().checked_div(nodes).unwrap_or(0);
    let inputs = [
        (evaluation.x.len(), unknowns, false, argument::X),
        (evaluation.u.len(), unknowns, true, argument::U),
        (
            evaluation.history.len(),
            history,
            true,
            argument::HISTORY_ACCEPTED,
        ),
        (
            evaluation.workspace.len(),
            workspace,
            false,
            argument::WORKSPACE,
        ),
        (evaluation.residual.len(), unknowns, true, argument::F),
        (
            evaluation.tangent.len(),
            unknowns * unknowns,
            true,
            argument::K,
        ),
        (evaluation.output.len(), output, true, argument::OUTPUT),
        (
            evaluation.trial.len(),
            history,
            true,
            argument::HISTORY_TRIAL,
        ),
    ];
    for (length, least, may_be_empty, name) in inputs {
        if length < least && !(may_be_empty && length == 0) {
            return fault(name);
        }
    }
    let patch = Patch {
        slave_points: facets.slave_points as i32,
        master_nodes: facets.master_nodes as i32,
        facets: count as i32,
        facet: facets.facet,
        edge: facets.edge.map_or(core::ptr::null(), core::ptr::from_ref),
        vertex: facets.vertex.map_or(core::ptr::null(), core::ptr::from_ref),
        connectivity: facets.connectivity.as_ptr(),
        reach: facets.reach,
        ..Patch::EMPTY
    };
    let mut arguments = Arguments::EMPTY;
    let mut wanted = evaluation.bits;
    let mut target = |slice: &mut [f64], bit: u32| {
        if slice.is_empty() {
            return core::ptr::null_mut();
        }
        wanted |= bit;
        slice.as_mut_ptr()
    };
    arguments.f = target(evaluation.residual, request::RESIDUAL);
    arguments.k = target(evaluation.tangent, request::TANGENT);
    arguments.output = target(evaluation.output, request::OUTPUT);
    arguments.history_trial = target(evaluation.trial, request::HISTORY);
    arguments.energy = target(evaluation.energy, request::ENERGY);
    arguments.request = wanted;
    arguments.parameters = evaluation.parameters.as_ptr();
    arguments.parameter_count = evaluation.parameters.len() as i32;
    let or_null = |slice: &[f64]| match slice {
        [] => core::ptr::null(),
        _ => slice.as_ptr(),
    };
    arguments.x = evaluation.x.as_ptr();
    (arguments.u, arguments.history_accepted) =
        (or_null(evaluation.u), or_null(evaluation.history));
    arguments.workspace = evaluation.workspace.as_mut_ptr();
    arguments.workspace_size = evaluation.workspace.len() as i64;
    // SAFETY: every pointer is null or a slice of the length that the header asks for.
    let code = unsafe { patch_evaluate(&patch, &mut arguments) };
    Outcome {
        code,
        status: arguments.status,
        closed: arguments.closed_points,
        argument: arguments.error_argument,
        index: arguments.error_index,
    }
}
