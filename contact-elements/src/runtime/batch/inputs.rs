//! From the host's arrays to the columns of a block.

use core::cell::Cell;

use super::Contacts;
use super::block::{Column, Inputs, ROOM};
use crate::runtime::gather::{Nodes, are_usable};

/// Takes the inputs of `length` contacts; one bit for each whose inputs can be used.
#[inline(never)]
pub(super) fn gather<C: Contacts, const D: usize, const P: usize, const N: usize>(
    contacts: &C,
    (first, length): (usize, usize),
    (vectors, centre): (&[bool; N], &[f64; P]),
    inputs: &mut Inputs<'_, D, P, N>,
) -> u32 {
    let are_same = contacts.have_same_parameters();
    let blocks = if vectors.contains(&true) {
        None
    } else {
        contacts.blocks()
    };
    let mut good = 0;
    for slot in 0..length.min(ROOM) {
        let contact = first + slot;
        if !start(contacts.history(contact), centre, inputs, slot) {
            continue;
        }
        let are_usable = match blocks {
            Some((values, apart)) => {
                let block = values.get(contact * apart..);
                block.is_some_and(|block| dense(block, inputs.x, slot))
            }
            None => positions(&contacts.nodes(contact), vectors, inputs.x, slot),
        };
        if are_usable && (are_same || own_parameters(contacts, contact, inputs, slot)) {
            good |= 1 << slot;
        }
    }
    if are_same {
        let Some(parameters) = contacts.parameters(first) else {
            return 0;
        };
        if first == 0 {
            for (column, &value) in inputs.parameters.iter_mut().zip(parameters) {
                *column = Column([value; ROOM]);
            }
        }
    }
    good
}

/// Takes the parameters of one contact; false where they are refused.
#[inline(never)]
fn own_parameters<C: Contacts, const D: usize, const P: usize, const N: usize>(
    contacts: &C,
    contact: usize,
    inputs: &mut Inputs<'_, D, P, N>,
    slot: usize,
) -> bool {
    let Some(parameters) = contacts.parameters(contact) else {
        return false;
    };
    for (column, &value) in inputs.parameters.iter_mut().zip(parameters) {
        column.set(slot, value);
    }
    true
}

/// Positions relative to the first node, by the rules of one call. [eq:local-origin]
#[inline(never)]
fn positions<const D: usize, const N: usize>(
    nodes: &Nodes<'_>,
    vectors: &[bool; N],
    columns: &mut [[Column; D]; N],
    slot: usize,
) -> bool {
    if nodes.check::<D>(N).is_err() {
        return false;
    }
    let (Ok(origin), Ok(shift)) = (nodes.reference::<D>(0), nodes.displacement::<D>(0)) else {
        return false;
    };
    for (a, column) in columns.iter_mut().enumerate() {
        let (Ok(position), Ok(displacement)) =
            (nodes.reference::<D>(a), nodes.displacement::<D>(a))
        else {
            return false;
        };
        for k in 0..D {
            let value = if vectors.get(a).copied().unwrap_or(false) {
                position[k] + displacement[k]
            } else if a == 0 {
                0.0
            } else if nodes.u.is_some() {
                (position[k] - origin[k]) + (displacement[k] - shift[k])
            } else {
                position[k] - origin[k]
            };
            column[k].set(slot, value);
        }
    }
    true
}

/// [`positions`] of nodes that stand one after another.
#[inline(always)]
fn dense<const D: usize, const N: usize>(
    block: &[f64],
    columns: &mut [[Column; D]; N],
    slot: usize,
) -> bool {
    let Some(positions) = block.as_chunks::<D>().0.first_chunk::<N>() else {
        return false;
    };
    let origin = positions[0];
    if !are_usable(positions.as_flattened()) {
        return false;
    }
    for (column, position) in columns.iter_mut().zip(positions) {
        for k in 0..D {
            column[k].set(slot, position[k] - origin[k]);
        }
    }
    true
}

/// Status of the history and start of the search; false where they are no numbers. How far a start may be from the
/// domain is asked in lanes.
#[inline(always)]
fn start<const D: usize, const P: usize, const N: usize>(
    history: Option<&[Cell<f64>]>,
    centre: &[f64; P],
    inputs: &mut Inputs<'_, D, P, N>,
    slot: usize,
) -> bool {
    let (mut status, mut start) = (0.0, *centre);
    if let Some(history) = history {
        let Some((own, projection)) = history.split_first() else {
            return false;
        };
        let Some(projection) = projection.first_chunk::<P>() else {
            return false;
        };
        status = own.get();
        start = projection.each_ref().map(Cell::get);
        if !(are_usable(&[status]) & are_usable(&start)) {
            return false;
        }
    }
    inputs.frozen.set(slot, status);
    for i in 0..P {
        inputs.zeta[i].set(slot, start[i]);
    }
    true
}
