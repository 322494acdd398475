//! A patch from Rust: slices in, slices out.

use super::checked::{Checked, HISTORY, Patch};
use super::run::{WORKSPACE, run};
use super::sums::Sums;
use crate::codes::{argument, code};
use crate::element::gather::{Coordinates, Nodes};
use crate::element::receiver::{OUTPUT_SIZE, Summary};
use crate::error::Error;
use crate::evaluation::inputs::{check_offered, check_present_history};
use crate::evaluation::single::{Evaluation, cells};
use crate::evaluation::target::Strided;
use crate::point::history::History;

/// Doubles of the arrays of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatchSizes {
    /// Accepted and trial history.
    pub history: usize,
    /// Workspace.
    pub workspace: usize,
    /// Output.
    pub output: usize,
}

impl Patch<'_> {
    /// Doubles of history, workspace and output.
    pub fn sizes(&self) -> PatchSizes {
        PatchSizes {
            history: HISTORY * self.slave_points,
            workspace: WORKSPACE * self.slave_points,
            output: OUTPUT_SIZE * self.slave_points,
        }
    }
}

/// Evaluates a patch: its status and its closed points.
///
/// `evaluation` has x and u of all nodes, slave points first, and no slave row; residual and tangent are those of all
/// nodes of the patch, `workspace`, histories and output have the [`Patch::sizes`].
///
/// # Errors
/// The outputs are untouched and the error names the argument as in [`evaluate`](crate::evaluate);
/// [`ELEMENT`](crate::code::ELEMENT) for elements that do not belong together, [`INDEX`](crate::code::INDEX) for a node
/// that does not exist. With [`CUT_BACK`](crate::code::CUT_BACK) the index is the slave point that cannot be evaluated.
///
/// # Examples
/// ```
/// use contact_elements::{Evaluation, Patch, Status, evaluate_patch};
/// # mod pairs {
/// #     contact_elements::contact_elements! {
/// #         /// A point and a bilinear facet.
/// #         element PointQuad4 { slave: point; master: Quad4; normal: Penalty; }
/// #     }
/// # }
/// # use pairs::PointQuad4;
/// // the slave point, 0.05 below the facet, and the corners of the facet
/// let x = [
///     0.2, -0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
/// ];
/// let patch = Patch {
///     facet: PointQuad4::DESCRIPTOR,
///     edge: None,
///     vertex: None,
///     slave_points: 1,
///     master_nodes: 4,
///     connectivity: &[0, 1, 2, 3],
///     reach: 0.0,
/// };
/// let (mut residual, mut workspace) = ([0.0; 15], vec![0.0; patch.sizes().workspace]);
/// let mut evaluation = Evaluation {
///     x: &x,
///     parameters: &[1000.0, 0.0, 1.0], // eps_n, r0, orientation
///     residual: &mut residual,
///     workspace: &mut workspace,
///     ..Evaluation::default()
/// };
/// let summary = evaluate_patch(&patch, &mut evaluation)?;
/// assert_eq!((summary.status, summary.closed), (Status::Closed, 1));
/// assert!((residual[2] + 50.0).abs() < 1e-12);
/// # Ok::<(), contact_elements::Error>(())
/// ```
pub fn evaluate_patch(
    patch: &Patch<'_>,
    evaluation: &mut Evaluation<'_>,
) -> Result<Summary, Error> {
    let n = patch.slave_points + patch.master_nodes;
    let d = patch.facet.dimension;
    let unknowns = n * d;
    let sizes = patch.sizes();
    check_lengths(evaluation, unknowns, &sizes)?;
    let facets = patch.connectivity.len() / patch.facet.master_nodes.max(1);
    if facets == 0 {
        return Err(Error::new(code::NODE_COUNT, argument::FACETS, 0));
    }
    let bits = evaluation.request();
    let checked = Checked::new(patch)?;
    check_offered(checked.requests(), bits)?;
    check_present_history(bits, !evaluation.history.is_empty())?;
    let nodes = Nodes {
        x: Coordinates::one_by_one(evaluation.x, d),
        u: (!evaluation.u.is_empty()).then(|| Coordinates::one_by_one(evaluation.u, d)),
        connectivity: None,
        count: n,
    };
    let history = evaluation.history.get(..sizes.history).map(History::Own);
    let checked = checked.with(nodes, evaluation.parameters, history)?;
    let sums = Sums {
        unknowns,
        f: cells(evaluation.residual),
        k: Strided {
            cells: cells(evaluation.tangent),
            row: unknowns,
            column: 1,
        },
        map: None,
        f_scale: 1.0,
        k_scale: 1.0,
        output: cells(evaluation.output),
        history: cells(evaluation.trial),
        energy: cells(evaluation.energy),
    };
    let memory = evaluation.workspace.get_mut(..sizes.workspace);
    run(&checked, &sums, memory.unwrap_or_default(), bits)
}

/// Slices as long as the patch asks for; some may be empty.
fn check_lengths(
    evaluation: &Evaluation<'_>,
    unknowns: usize,
    sizes: &PatchSizes,
) -> Result<(), Error> {
    let needed = [
        (evaluation.x.len(), unknowns, argument::X),
        (
            evaluation.workspace.len(),
            sizes.workspace,
            argument::WORKSPACE,
        ),
    ];
    let optional = [
        (evaluation.u.len(), unknowns, argument::U),
        (
            evaluation.history.len(),
            sizes.history,
            argument::HISTORY_ACCEPTED,
        ),
    ];
    let given = optional.into_iter().filter(|(length, ..)| *length > 0);
    for (length, least, name) in needed.into_iter().chain(given) {
        if length < least {
            return Err(Error::missing(name));
        }
    }
    let matrix = unknowns * unknowns;
    evaluation.check_outputs([unknowns, matrix, sizes.history, sizes.output, 1])
}
