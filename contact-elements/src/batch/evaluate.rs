//! All contacts of a batch in lanes: block after block.

use crate::batch::block::{Block, MOST_PARAMETERS, MOST_UNKNOWNS, ROOM, Records};
use crate::batch::compiled::BatchLanes;
use crate::batch::contacts::Contacts;
use crate::batch::{closed, inputs, point};
use crate::element::traits::Element;

/// Evaluates all contacts in lanes of type T.
#[inline(always)]
pub(crate) fn evaluate<
    E: Element<D, P, H>,
    C: Contacts,
    T: BatchLanes,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &mut C,
    vectors: &[bool; N],
) {
    const {
        assert!(P > 0 && N * D <= MOST_UNKNOWNS && E::LAYOUT.count <= MOST_PARAMETERS);
        assert!(!E::KEEPS_SIDE);
    };
    let wanted = contacts.wanted();
    let form = (vectors, &E::REACH, wanted.projection_given);
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
