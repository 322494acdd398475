//! Inputs of an evaluation other than the nodes, and its outputs.

use crate::point::history::{History, Refused};
use crate::point::motion::Rolling;
use crate::point::values::Status;

/// Which outputs are requested, and how.
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

/// Inputs of an evaluation other than the nodes.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// Parameters, checked.
    pub parameters: &'a [f64],
    /// Accepted history: per point status and projected parameters, with friction also anchor and slip
    /// path, with rolling what [`Rolling`] remembers. `None`: start at the centre.
    pub history: Option<History<'a>>,
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Requested outputs.
    pub wanted: Wanted,
}

/// Doubles of output per contact point: a [`Report`] entry by entry.
pub const OUTPUT_SIZE: usize = 23;

/// What is known about one contact point after an evaluation.
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
    /// Tangential force along d_1 and d_2, per weight; 0 without friction.
    pub tangential: [f64; 2],
    /// b_1 and b_2 in the global frame; zero beyond the number of parameters.
    pub tangents: [[f64; 3]; 2],
    /// Anchor for the next step, with friction.
    pub anchor: [f64; 2],
    /// Slip path for the next step [length].
    pub path: f64,
    /// Multiplier for the next step, if the history carries one.
    pub multiplier: f64,
    /// Moments about two curves, if the element has them.
    pub rolling: Rolling,
}

/// What a value does to the output that is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Write {
    /// It takes its place: the first point that writes.
    Replace,
    /// It is added.
    Add,
}

/// Takes the outputs of an evaluation: dense arrays, strided ones, a sparse matrix.
pub trait Receiver {
    /// All of residual and tangent is zero: no point is closed.
    fn open(&mut self, unknowns: usize);
    /// Residual, row and column of one unknown are zero: a multiplier of the only point.
    fn clear(&mut self, unknown: usize);
    /// Entry (node, component) of the residual.
    fn force(&mut self, place: (usize, usize), value: f64, write: Write);
    /// All entries of the residual, which they replace.
    fn forces(&mut self, forces: &[f64], dimension: usize) {
        for (node, force) in forces.chunks(dimension).enumerate() {
            for (component, &value) in force.iter().enumerate() {
                self.force((node, component), value, Write::Replace);
            }
        }
    }
    /// The memory for the rows of the tangent, one after another, and their distance, if they may be written at once.
    fn rows(&mut self) -> Option<(&mut [f64], usize)> {
        None
    }
    /// Row `unknown` of the tangent.
    fn row(&mut self, unknown: usize, row: &[f64], write: Write);
    /// Adds to the residual of a multiplier: its node and unknown.
    fn multiplier(&mut self, place: (usize, usize), value: f64);
    /// Adds to one entry of the tangent.
    fn coupling(&mut self, row: usize, column: usize, value: f64);
    /// False where [`Receiver::report`] would do nothing.
    fn reports(&self) -> bool {
        true
    }
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
    /// The status of the point.
    pub status: Status,
    /// The number of the point.
    pub point: usize,
}

/// An input that cannot be used: which array, which node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputError {
    /// A reference coordinate of this node is missing, NaN, infinite or beyond 1e30.
    Position(usize),
    /// A displacement of this node is missing, NaN, infinite or beyond 1e30.
    Displacement(usize),
    /// This entry of the history is NaN, infinite or too large.
    History(usize),
    /// This entry of the history could not come from an evaluation: invalid status or regime, projection or anchor far
    /// outside, negative path, non-unit normal, positive multiplier.
    Impossible(usize),
    /// Entry of the slave row.
    SlaveRow(usize),
    /// The side of edges comes from a history, and there is no history.
    NoHistory,
    /// The workspace is too small.
    Workspace,
    /// A contact point failed.
    Point(Failure),
}

impl From<Refused> for InputError {
    #[inline(always)]
    fn from(refused: Refused) -> Self {
        match refused {
            Refused::NotUsable(entry) => InputError::History(entry),
            Refused::Impossible(entry) => InputError::Impossible(entry),
        }
    }
}

impl From<Failure> for InputError {
    #[inline(always)]
    fn from(failure: Failure) -> Self {
        InputError::Point(failure)
    }
}

impl InputError {
    /// Status of the contact point that failed, if one did.
    pub fn status(&self) -> Option<Status> {
        match self {
            InputError::Point(failure) => Some(failure.status),
            _ => None,
        }
    }
}
