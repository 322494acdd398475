//! A batch from Rust.

use core::cell::Cell;

use super::arrays::Arrays;
use super::run::{Outputs, Run};
use super::shape::{Form, Present, Shape};
use super::sums::{Assembly, Sums};
use crate::batch::dispatch::one_by_one;
use crate::codes::{argument, request};
use crate::element::receiver::OUTPUT_SIZE;
use crate::error::Error;
use crate::evaluation::inputs::scratch;
use crate::evaluation::pattern::sizes;
use crate::evaluation::places::Map;
use crate::evaluation::single::cells;
use crate::evaluation::target::{Matrix, Share, Target};
use crate::lanes::Width;
use crate::point::history::History;
use crate::point::values::Status;
use crate::registered::Registered;

/// Inputs and outputs of many contacts of one element, contact after contact.
#[derive(Debug, Default)]
pub struct Batch<'a> {
    /// Reference coordinates, length: \[contacts · nodes · dimension\], or with a connectivity
    /// \[model nodes · dimension\].
    pub x: &'a [f64],
    /// Displacements likewise; empty for zero.
    pub u: &'a [f64],
    /// Model nodes of every contact \[contacts · nodes\]; empty if each contact has separate nodes.
    pub connectivity: &'a [i32],
    /// Slave nodes of an interpolated slave; 0 for the others.
    pub slave_nodes: usize,
    /// Parameters, one set for all contacts or one for each.
    pub parameters: &'a [f64],
    /// Accepted histories; if empty, contact begins everywhere.
    pub history: &'a [f64],
    /// Interpolated slaves: shape row and weight of each contact.
    pub slave_row: &'a [f64],
    /// Residuals \[contacts · unknowns\]; empty if not requested.
    pub residual: &'a mut [f64],
    /// Tangents \[contacts · unknowns²\]; empty if not requested.
    pub tangent: &'a mut [f64],
    /// Outputs \[contacts · points · [`OUTPUT_SIZE`]\]; empty if not requested.
    pub output: &'a mut [f64],
    /// Trial histories; empty if not requested.
    pub trial: &'a mut [f64],
    /// Energies \[contacts\]; empty if not requested.
    pub energy: &'a mut [f64],
    /// Sums that all contacts add to, by their connectivity.
    pub assembly: Assembly<'a>,
    /// Status or error of every contact; its length is the number of contacts.
    pub results: &'a mut [Result<Status, Error>],
    /// Workspace of an interpolated slave, [`Descriptor::workspace`](crate::Descriptor::workspace) entries.
    pub workspace: &'a mut [f64],
    /// Further bits of [`request`]: FREEZE_STATE, SYMMETRISE, PROJECTION_GIVEN, SCREEN.
    pub bits: u32,
}

/// Evaluates the contacts of a batch, in lanes where the element has a kernel for that. Sums are taken in the order of
/// the contacts.
///
/// # Errors
/// A refused batch leaves all outputs untouched; the error names the argument as in [`evaluate`](crate::evaluate),
/// [`INDEX`](crate::code::INDEX) for a node or a place of the scatter map that does not exist. With
/// [`CUT_BACK`](crate::code::CUT_BACK) some contacts could not be evaluated: the error is that of the first of them, its
/// index the contact, and `results` has all. The other contacts have been evaluated.
///
/// # Examples
/// ```
/// use contact_elements::{Assembly, Batch, Status, evaluate_batch};
/// # mod pairs {
/// #     contact_elements::contact_elements! {
/// #         /// A point and a bilinear facet.
/// #         element PointQuad4 { slave: point; master: Quad4; normal: Penalty; }
/// #     }
/// # }
/// # use pairs::PointQuad4;
/// // a model of two slave points and one facet
/// let x = [
///     0.2, -0.1, -0.05, 0.0, 0.0, 1.0, // slave points: one below the facet, one far above
///     -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
/// ];
/// let (mut force, mut results) = ([0.0; 18], [Ok(Status::Open); 2]);
/// let mut batch = Batch {
///     x: &x,
///     connectivity: &[0, 2, 3, 4, 5, 1, 2, 3, 4, 5],
///     parameters: &[1000.0, 0.0, 1.0], // eps_n, r0, orientation: of both contacts
///     assembly: Assembly { force: &mut force, ..Assembly::default() },
///     results: &mut results,
///     ..Batch::default()
/// };
/// evaluate_batch(PointQuad4::DESCRIPTOR, &mut batch)?;
/// assert_eq!(results, [Ok(Status::Closed), Ok(Status::Open)]);
/// assert!((force[2] + 50.0).abs() < 1e-12 && force[5] == 0.0);
/// # Ok::<(), contact_elements::Error>(())
/// ```
pub fn evaluate_batch(element: &Registered, batch: &mut Batch<'_>) -> Result<(), Error> {
    let form = batch.form(element);
    let count = batch.results.len();
    let shape = Shape::new(element, element.requests(), count as i64, form)?;
    if count == 0 {
        return Ok(());
    }
    batch.check_lengths(&shape)?;
    let optional = |slice: &'_ [f64]| (!slice.is_empty()).then_some(());
    let arrays = Arrays {
        x: batch.x,
        u: optional(batch.u).map(|()| batch.u),
        connectivity: (!batch.connectivity.is_empty()).then_some(batch.connectivity),
        parameters: batch.parameters,
        history: optional(batch.history).map(|()| History::Own(batch.history)),
        slave_row: optional(batch.slave_row).map(|()| batch.slave_row),
    };
    arrays.check(&shape)?;
    let assembly = core::mem::take(&mut batch.assembly);
    let sums = Sums {
        force: cells(assembly.force),
        matrix: cells(assembly.matrix),
        map: Map::new(
            assembly.map,
            sizes(element, shape.nslave),
            assembly.by_blocks,
        ),
        connectivity: batch.connectivity,
        nodes: shape.nodes,
        dimension: element.dimension,
    };
    sums.check()?;
    let mut outputs = Slices {
        shape: &shape,
        residual: cells(batch.residual),
        tangent: batch.tangent,
        output: batch.output,
        trial: cells(batch.trial),
        energy: batch.energy,
        results: batch.results,
        sums: &sums,
    };
    let memory = scratch(batch.workspace, element.workspace(shape.nodes))?;
    let (kernel, screen) = (element.kernel, element.screen);
    let mut run = Run::new(kernel, screen, &shape, &arrays, &mut outputs, memory);
    match element.lanes {
        Some(kernel) if count > 1 => kernel(&mut run, Width::widest()),
        _ => one_by_one(&mut run),
    }
    run.failures.outcome()
}

impl Batch<'_> {
    /// The description of the batch as a host in C would give it.
    fn form(&self, element: &Registered) -> Form {
        let sets = element.parameters.len();
        let d = element.dimension.max(1);
        let outputs = [
            (
                self.residual.is_empty() && self.assembly.force.is_empty(),
                request::RESIDUAL,
            ),
            (
                self.tangent.is_empty() && self.assembly.matrix.is_empty(),
                request::TANGENT,
            ),
            (self.output.is_empty(), request::OUTPUT),
            (self.trial.is_empty(), request::HISTORY),
            (self.energy.is_empty(), request::ENERGY),
            (!self.assembly.by_blocks, request::CSR_BY_BLOCKS),
        ];
        let wanted = outputs.iter().filter(|(is_left_out, _)| !is_left_out);
        let is_shared = self.parameters.len() <= sets;
        Form {
            request: wanted.fold(self.bits, |bits, (_, bit)| bits | bit),
            nslave: i32::try_from(self.slave_nodes).unwrap_or(i32::MAX),
            parameter_count: i32::try_from(self.parameters.len().min(sets)).unwrap_or(i32::MAX),
            parameter_stride: if is_shared { 0 } else { sets as i64 },
            global_nodes: self.x.len().checked_div(d).unwrap_or(0) as i64,
            f_scale: 1.0,
            k_scale: 1.0,
            has: self.present(),
            ..Form::default()
        }
    }

    fn present(&self) -> Present {
        Present {
            x: !self.x.is_empty(),
            parameters: true,
            history: !self.history.is_empty(),
            slave_row: !self.slave_row.is_empty(),
            connectivity: !self.connectivity.is_empty(),
            status: true,
            f: !self.residual.is_empty(),
            k: !self.tangent.is_empty(),
            global_f: !self.assembly.force.is_empty(),
            csr_values: !self.assembly.matrix.is_empty(),
            csr_map: !self.assembly.map.is_empty(),
            trial: !self.trial.is_empty(),
            output: !self.output.is_empty(),
            energy: !self.energy.is_empty(),
        }
    }

    /// Slices as long as the shape says, or empty.
    fn check_lengths(&self, shape: &Shape<'_>) -> Result<(), Error> {
        let (count, unknowns) = (shape.count, shape.unknowns());
        let history = count * shape.element.history();
        let of_nodes = shape.form.global_nodes as usize * shape.element.dimension;
        let lengths = [
            (self.x.len(), shape.x.length, argument::X),
            (self.u.len(), shape.u.length, argument::U),
            (
                self.connectivity.len(),
                count * shape.nodes,
                argument::CONNECTIVITY,
            ),
            (
                self.parameters.len(),
                shape.parameter_length(),
                argument::PARAMETERS,
            ),
            (self.history.len(), history, argument::HISTORY_ACCEPTED),
            (
                self.slave_row.len(),
                count * (shape.nslave + 1),
                argument::SLAVE_ROW,
            ),
            (self.residual.len(), count * unknowns, argument::F),
            (self.tangent.len(), count * unknowns * unknowns, argument::K),
            (self.trial.len(), history, argument::HISTORY_TRIAL),
            (
                self.output.len(),
                count * shape.element.points * OUTPUT_SIZE,
                argument::OUTPUT,
            ),
            (self.energy.len(), count, argument::ENERGY),
            (self.assembly.force.len(), of_nodes, argument::F),
            (
                self.assembly.map.len(),
                count * shape.map_size(),
                argument::CSR,
            ),
        ];
        let short = lengths
            .iter()
            .find(|(own, least, _)| *own > 0 && own < least);
        short.map_or(Ok(()), |&(.., name)| Err(Error::missing(name)))
    }
}

/// Outputs of a batch in slices.
struct Slices<'a> {
    shape: &'a Shape<'a>,
    residual: &'a [Cell<f64>],
    tangent: &'a mut [f64],
    output: &'a mut [f64],
    trial: &'a [Cell<f64>],
    energy: &'a mut [f64],
    results: &'a mut [Result<Status, Error>],
    sums: &'a Sums<'a>,
}

/// The entries of contact `number`, `size` for each.
fn own<T>(values: &[T], number: usize, size: usize) -> &[T] {
    let rest = values.get(number * size..).unwrap_or_default();
    rest.get(..size).unwrap_or_default()
}

/// The entries of contact `number`, `size` for each.
fn own_mut<T>(values: &mut [T], number: usize, size: usize) -> &mut [T] {
    let rest = values.get_mut(number * size..).unwrap_or_default();
    rest.get_mut(..size).unwrap_or_default()
}

impl Outputs for Slices<'_> {
    fn target(&mut self, contact: usize) -> Target<'_> {
        let element = self.shape.element;
        let unknowns = self.shape.unknowns();
        let matrix = own_mut(self.tangent, contact, unknowns * unknowns);
        let sums = Share {
            sums: self.sums,
            contact,
        };
        Target {
            unknowns,
            dimension: element.dimension,
            history_layout: element.history_layout(),
            f: own(self.residual, contact, unknowns),
            k: match matrix {
                [] => Matrix::None,
                matrix => Matrix::Dense(matrix),
            },
            map: None,
            f_scale: 1.0,
            k_scale: 1.0,
            global_f: (!self.sums.force.is_empty()).then_some(sums),
            sparse: (!self.sums.matrix.is_empty()).then_some(sums),
            output: own_mut(self.output, contact, element.points * OUTPUT_SIZE),
            history: own(self.trial, contact, element.history()),
            energy: own_mut(self.energy, contact, 1),
        }
    }

    fn note(&mut self, contact: usize, result: Result<Status, Error>) {
        if let Some(to) = self.results.get_mut(contact) {
            *to = result;
        }
    }
}
