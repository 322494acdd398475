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
    /// The numbers of the next contacts to be evaluated, ascending, and how many they are; none: all are done.
    fn next(&mut self, numbers: &mut [usize; ROOM]) -> usize;
    /// Wanted outputs of each.
    fn wanted(&self) -> Wanted;
    /// True where somebody asks for history or output of a point.
    fn reports(&self) -> bool;
    /// True where all contacts have the same parameters.
    fn have_same_parameters(&self) -> bool;
    /// Parameters of a contact; none where they are refused.
    fn parameters(&self, contact: usize) -> Option<&[f64]>;
    /// Accepted history of a contact.
    fn history(&self, contact: usize) -> Option<History<'_>>;
    /// Nodes of a contact.
    fn nodes(&self, contact: usize) -> Nodes<'_>;
    /// All coordinates, where the components of a node stand side by side.
    fn places(&self) -> Option<AllPlaces<'_>>;
    /// Where the outputs of a contact go.
    fn receiver(&mut self, contact: usize) -> Self::Receiver<'_>;
    /// Evaluates a contact by the kernel of one.
    fn evaluate_alone(&mut self, contact: usize);
    /// Notes that a contact is done.
    fn settle(&mut self, contact: usize, status: Status);
}

/// Coordinates in which the components of a node stand side by side.
#[derive(Clone, Copy, Debug)]
pub struct Places<'a> {
    /// The array.
    pub values: &'a [f64],
    /// From contact to contact; with a connectivity not used.
    pub contact_stride: usize,
    /// From node to node.
    pub node_stride: usize,
}

/// The coordinates of all contacts.
#[derive(Clone, Copy, Debug)]
pub struct AllPlaces<'a> {
    /// Reference coordinates.
    pub x: Places<'a>,
    /// Displacements; none: zero.
    pub u: Option<Places<'a>>,
    /// Numbers of the nodes in the arrays, contact after contact; none: those of a contact are one after another.
    pub connectivity: Option<&'a [i32]>,
}
