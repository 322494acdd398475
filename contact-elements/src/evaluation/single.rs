//! One contact of an element.

use core::cell::Cell;

use super::inputs::{check_parameters, check_request, node_counts, scratch, wanted};
use super::target::{Matrix, Target};
use crate::codes::{argument, request};
use crate::element::gather::{Coordinates, Nodes};
use crate::element::receiver::{Call, OUTPUT_SIZE, Summary};
use crate::error::Error;
use crate::point::history::History;
use crate::registered::Registered;

/// Inputs and outputs of one evaluation.
///
/// Nodes are the slave nodes, the master nodes, then a node for every multiplier. `x` and `u` have a row of
/// `dimension` entries for each; in the row of a multiplier the first entry of `u` counts.
#[derive(Debug, Default)]
pub struct Evaluation<'a> {
    /// Reference coordinates \[nodes · dimension\], length.
    pub x: &'a [f64],
    /// Displacements \[nodes · dimension\], length; empty for zero.
    pub u: &'a [f64],
    /// Parameters, in the units and ranges of [`Parameter`](crate::Parameter).
    pub parameters: &'a [f64],
    /// Accepted history. If empty, the projection starts from the centre, and with friction contact begins here
    /// without tangential force.
    pub history: &'a [f64],
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Residual dW/du \[unknowns\], the force on the contact's nodes with the opposite sign; empty if not requested.
    pub residual: &'a mut [f64],
    /// Tangent \[unknowns · unknowns\], the derivative of the residual, row after row; empty if not requested.
    pub tangent: &'a mut [f64],
    /// Output \[points · [`OUTPUT_SIZE`]\]; empty if not requested.
    pub output: &'a mut [f64],
    /// Trial history; empty if not requested. It becomes the accepted history when the step is accepted.
    pub trial: &'a mut [f64],
    /// Energy \[1\]; empty if not requested.
    pub energy: &'a mut [f64],
    /// Workspace of an interpolated slave, [`Descriptor::workspace`](crate::Descriptor::workspace) entries.
    pub workspace: &'a mut [f64],
    /// Further bits of [`request`]: FREEZE_STATE, SYMMETRISE, PROJECTION_GIVEN.
    pub bits: u32,
}

/// Evaluates one contact of an element; returns status and number of closed points.
///
/// An output is written where its slice is not empty. A gap is positive where the bodies are apart, a normal traction
/// is negative in contact.
///
/// # Errors
/// The outputs are untouched and the error names the argument: [`NULL`](crate::code::NULL) for a slice that is missing
/// or too short, [`NODE_COUNT`](crate::code::NODE_COUNT) for an interpolated slave without a row,
/// [`PARAMETER`](crate::code::PARAMETER), [`NOT_FINITE`](crate::code::NOT_FINITE), [`HISTORY`](crate::code::HISTORY)
/// for values that cannot be used, [`REQUEST`](crate::code::REQUEST) for a bit that the element does not offer,
/// [`WORKSPACE`](crate::code::WORKSPACE). [`CUT_BACK`](crate::code::CUT_BACK), with the status of the point, where the
/// state cannot be evaluated.
///
/// # Examples
/// ```
/// use contact_elements::{Evaluation, Status, evaluate};
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
/// let mut residual = [0.0; 15];
/// let mut evaluation = Evaluation {
///     x: &x,
///     parameters: &[1000.0, 0.0, 1.0], // eps_n, r0, orientation
///     residual: &mut residual,
///     ..Evaluation::default()
/// };
/// let summary = evaluate(PointQuad4::DESCRIPTOR, &mut evaluation)?;
/// assert_eq!((summary.status, summary.closed), (Status::Closed, 1));
/// assert!((residual[2] + 50.0).abs() < 1e-12); // dW/du: the contact pushes the point by +50
///
/// let negative = &mut Evaluation { x: &x, parameters: &[-1.0, 0.0, 1.0], ..Evaluation::default() };
/// let error = evaluate(PointQuad4::DESCRIPTOR, negative).unwrap_err();
/// assert_eq!(error.index, 0);
/// assert!(error.to_string().starts_with("argument `parameters`, entry 0: a parameter is missing"));
/// # Ok::<(), contact_elements::Error>(())
/// ```
pub fn evaluate(element: &Registered, evaluation: &mut Evaluation<'_>) -> Result<Summary, Error> {
    let nslave = if element.interpolated {
        evaluation.slave_row.len().saturating_sub(1)
    } else {
        element.slave_nodes
    };
    let n = element.nodes(nslave);
    let bits = evaluation.request();
    evaluation.check_optional(element, n)?;
    check_request(element.requests(), bits, !evaluation.history.is_empty())?;
    evaluation.check_needed(element, n)?;
    node_counts(element, 0, i32::try_from(nslave).unwrap_or(i32::MAX))?;
    check_parameters(element, evaluation.parameters)?;
    let coordinates = |values| Coordinates::one_by_one(values, element.dimension);
    let nodes = Nodes {
        x: coordinates(evaluation.x),
        u: (!evaluation.u.is_empty()).then(|| coordinates(evaluation.u)),
        connectivity: None,
        count: n,
    };
    let accepted = evaluation.history.get(..element.history());
    let call = Call {
        parameters: evaluation.parameters,
        history: accepted.filter(|own| !own.is_empty()).map(History::Own),
        slave_row: if element.interpolated {
            evaluation.slave_row
        } else {
            &[]
        },
        wanted: wanted(bits),
    };
    let unknowns = element.unknowns(n);
    let memory = scratch(evaluation.workspace, element.workspace(n))?;
    let matrix = evaluation.tangent.get_mut(..unknowns * unknowns);
    let mut target = Target {
        unknowns,
        dimension: element.dimension,
        history_layout: element.history_layout(),
        f: cells(evaluation.residual),
        k: matrix
            .filter(|own| !own.is_empty())
            .map_or(Matrix::None, Matrix::Dense),
        map: None,
        f_scale: 1.0,
        k_scale: 1.0,
        global_f: None,
        sparse: None,
        output: evaluation.output,
        history: cells(evaluation.trial),
        energy: evaluation.energy,
    };
    let symmetrise = bits & request::SYMMETRISE != 0;
    run(element, &call, &nodes, memory, &mut target, symmetrise)
}

/// Entries that are written one by one.
pub(crate) fn cells(values: &mut [f64]) -> &[Cell<f64>] {
    Cell::from_mut(values).as_slice_of_cells()
}

/// Runs the kernel on inputs that were checked.
#[inline(always)]
pub(crate) fn run(
    element: &Registered,
    call: &Call<'_>,
    nodes: &Nodes<'_>,
    memory: &mut [f64],
    target: &mut Target<'_>,
    symmetrise: bool,
) -> Result<Summary, Error> {
    let summary = (element.kernel)(call, nodes, memory, target)?;
    if symmetrise {
        target.symmetrise();
    }
    Ok(summary)
}

impl Evaluation<'_> {
    /// Bits of all requested outputs.
    pub(crate) fn request(&self) -> u32 {
        let outputs = [
            (&self.residual, request::RESIDUAL),
            (&self.tangent, request::TANGENT),
            (&self.output, request::OUTPUT),
            (&self.trial, request::HISTORY),
            (&self.energy, request::ENERGY),
        ];
        let wanted = outputs.iter().filter(|(slice, _)| !slice.is_empty());
        wanted.fold(self.bits, |bits, (_, bit)| bits | bit)
    }

    /// Inputs that may be left out, but not be too short.
    fn check_optional(&self, element: &Registered, n: usize) -> Result<(), Error> {
        let history = (self.history, element.history(), argument::HISTORY_ACCEPTED);
        for (slice, least, name) in [(self.u, n * element.dimension, argument::U), history] {
            if !slice.is_empty() && slice.len() < least {
                return Err(Error::missing(name));
            }
        }
        Ok(())
    }

    /// Inputs that every call needs, and requested outputs.
    fn check_needed(&self, element: &Registered, n: usize) -> Result<(), Error> {
        if self.x.len() < n * element.dimension {
            return Err(Error::missing(argument::X));
        }
        let unknowns = element.unknowns(n);
        let output = element.points * OUTPUT_SIZE;
        let matrix = unknowns * unknowns;
        let lengths = [unknowns, matrix, element.history(), output, 1];
        self.check_outputs(lengths)
    }

    /// Requested outputs: lengths of residual, tangent, trial history, output, energy.
    pub(crate) fn check_outputs(&self, lengths: [usize; 5]) -> Result<(), Error> {
        let bits = self.request();
        let outputs = [
            (&self.residual, request::RESIDUAL, argument::F),
            (&self.tangent, request::TANGENT, argument::K),
            (&self.trial, request::HISTORY, argument::HISTORY_TRIAL),
            (&self.output, request::OUTPUT, argument::OUTPUT),
            (&self.energy, request::ENERGY, argument::ENERGY),
        ];
        for ((slice, bit, name), least) in outputs.into_iter().zip(lengths) {
            if bits & bit != 0 && slice.len() < least {
                return Err(Error::missing(name));
            }
        }
        Ok(())
    }
}
