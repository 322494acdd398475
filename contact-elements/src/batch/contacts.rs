//! The contacts of a batch.

use crate::batch::block::ROOM;
use crate::element::gather::Nodes;
use crate::element::receiver::{Receiver, Wanted};
use crate::point::history::History;
use crate::point::values::Status;

/// The contacts of a batch, as its kernel sees them.
pub trait Contacts {
    /// Takes the outputs of one contact.
    type Receiver<'r>: Receiver
    where
        Self: 'r;
    /// The numbers of the next contacts to be evaluated, ascending, and their count; 0 means that all are done.
    fn next(&mut self, numbers: &mut [usize; ROOM]) -> usize;
    /// Requested outputs of each contact.
    fn wanted(&self) -> Wanted;
    /// True where history or output of a point is requested.
    fn reports(&self) -> bool;
    /// True where all contacts have the same parameters.
    fn have_same_parameters(&self) -> bool;
    /// Parameters of a contact; `None` where they are refused.
    fn parameters(&self, contact: usize) -> Option<&[f64]>;
    /// Accepted history of a contact.
    fn history(&self, contact: usize) -> Option<History<'_>>;
    /// Nodes of a contact.
    fn nodes(&self, contact: usize) -> Nodes<'_>;
    /// All coordinates, if the components of a node are contiguous.
    fn places(&self) -> Option<AllPlaces<'_>>;
    /// Where the outputs of a contact go.
    fn receiver(&mut self, contact: usize) -> Self::Receiver<'_>;
    /// Evaluates a contact by the kernel of a single call.
    fn evaluate_alone(&mut self, contact: usize);
    /// Notes that a contact is done.
    fn settle(&mut self, contact: usize, status: Status);
}

/// Coordinates in which the components of a node are contiguous.
#[derive(Clone, Copy, Debug)]
pub struct Places<'a> {
    /// The array.
    pub values: &'a [f64],
    /// Distance from contact to contact; unused with a connectivity.
    pub contact_stride: usize,
    /// Distance from node to node.
    pub node_stride: usize,
}

/// The coordinates of all contacts.
#[derive(Clone, Copy, Debug)]
pub struct AllPlaces<'a> {
    /// Reference coordinates.
    pub x: Places<'a>,
    /// Displacements; `None` for zero.
    pub u: Option<Places<'a>>,
    /// Numbers of the nodes in the arrays, contact after contact; `None` if the nodes of a contact follow one another.
    pub connectivity: Option<&'a [i32]>,
}
