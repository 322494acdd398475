//! Many contacts of one element in lanes: gather, projection and gap of all, law and coefficients of the closed
//! ones, then the outputs contact after contact.
//!
//! | file | question |
//! |---|---|
//! | `wide`, `x86` | what is a lane |
//! | `dispatch` | how many lanes has this processor |
//! | `block` | where the values of some contacts stand |
//! | `screen` | which contacts are open wherever their projection lies |
//! | `inputs`, `places` | what do the host's arrays hold |
//! | `newton` | where is the projection |
//! | `point` | open, outside, closed or to be evaluated alone |
//! | `closed` | law and coefficients of the closed ones |
//! | `outputs` | what reaches the receiver, in the order of the contacts |
//!
//! Each lane has the bits of the scalar evaluation: the same operations in the same order, none fused. What leaves
//! the common path is evaluated alone, by the kernel of one contact.

mod block;
mod closed;
mod dispatch;
mod inputs;
mod newton;
mod outputs;
mod places;
mod point;
mod screen;
mod wide;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use block::ROOM;
pub use dispatch::{Width, evaluate_batch, one_by_one};
pub use places::{AllPlaces, Places};
pub use screen::{SCREENED, is_screened, screen};

use super::element::Element;
use super::gather::Nodes;
use super::history::History;
use super::receiver::{Receiver, Wanted};
use super::values::Status;
use block::{Block, Records};
pub(super) use wide::{Quad, Wide};
#[cfg(target_arch = "x86_64")]
pub(super) use x86::Four;

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

/// Evaluates all contacts in lanes of type T.
#[inline(always)]
fn evaluate<
    E: Element<D, P, H>,
    C: Contacts,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &mut C,
    vectors: &[bool; N],
) {
    const {
        assert!(
            P > 0 && N * D <= block::MOST_UNKNOWNS && E::LAYOUT.count <= block::MOST_PARAMETERS
        );
        assert!(!E::KEEPS_SIDE);
    };
    let wanted = contacts.wanted();
    let form = (vectors, &E::centre());
    let mut block = Block::<D, P, H, N>::new();
    let mut records = Records::<N>::new();
    let mut numbers = [0; ROOM + 8];
    let has_parameters = inputs::shared(contacts, &mut block.parameters);
    while let length @ 1.. = next(contacts, &mut numbers) {
        block.good = inputs::gather::<C, T, D, P, N>(
            contacts,
            (&numbers, length),
            form,
            &mut block.inputs(),
        );
        if !has_parameters {
            block.good = 0;
        }
        (block.closed, block.inside) = (0, 0);
        for group in (0..length).step_by(T::WIDTH) {
            point::classify::<E, T, D, P, H, N>(&mut block, group, &wanted);
        }
        closed::load::<E, T, D, P, H, N>(&mut block, &mut records, &wanted);
        let own = numbers.get(..length).unwrap_or(&[]);
        T::write::<C, D, P, N>(&block.points::<E>(), contacts, own, &records);
    }
}

/// The numbers of the next contacts, the last of them repeated at the end.
#[inline(always)]
fn next<C: Contacts>(contacts: &mut C, numbers: &mut [usize; ROOM + 8]) -> usize {
    let Some(own) = numbers.first_chunk_mut() else {
        return 0;
    };
    let length = contacts.next(own).min(ROOM);
    let last = numbers.get(length.wrapping_sub(1)).copied().unwrap_or(0);
    for number in numbers.iter_mut().skip(length) {
        *number = last;
    }
    length
}
