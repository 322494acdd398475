//! From the host's arrays to the columns of a block.

use super::Contacts;
use super::block::{Column, Inputs, ROOM};
use crate::runtime::gather::{Nodes, are_usable, is_usable};
use crate::runtime::kernel::can_be_projection;

/// What the inputs of an element look like.
pub(super) struct Form<'a> {
    /// Which nodes are tangent vectors.
    pub(super) vectors: &'a [bool],
    /// Where the search begins without history.
    pub(super) centre: &'a [f64],
    pub(super) extents: &'a [f64],
}

/// Takes the inputs of `length` contacts; one bit for each whose inputs can be used.
#[inline(never)]
pub(super) fn gather<C: Contacts, const D: usize, const N: usize>(
    contacts: &C,
    (first, length): (usize, usize),
    form: &Form<'_>,
    inputs: &mut Inputs<'_, D, N>,
) -> u32 {
    let are_same = contacts.have_same_parameters();
    let has_vectors = form.vectors.contains(&true);
    let simple = if has_vectors { None } else { contacts.blocks() };
    let mut good = 0;
    for slot in 0..length.min(ROOM) {
        let contact = first + slot;
        if !start(contacts, contact, form, inputs, slot) {
            continue;
        }
        let are_usable = match simple {
            Some((values, apart)) => {
                let block = values
                    .get(contact * apart..)
                    .and_then(|own| own.get(..N * D));
                block.is_some_and(|block| dense(block, inputs.x, slot))
            }
            None => positions(&contacts.nodes(contact), form.vectors, inputs.x, slot),
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
fn own_parameters<C: Contacts, const D: usize, const N: usize>(
    contacts: &C,
    contact: usize,
    inputs: &mut Inputs<'_, D, N>,
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
    vectors: &[bool],
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

/// Start of the search; false where the history cannot be used.
#[inline(always)]
fn start<C: Contacts, const D: usize, const N: usize>(
    contacts: &C,
    contact: usize,
    form: &Form<'_>,
    inputs: &mut Inputs<'_, D, N>,
    slot: usize,
) -> bool {
    let columns = inputs
        .zeta
        .iter_mut()
        .zip(form.centre.iter().zip(form.extents));
    let Some(history) = contacts.history(contact) else {
        for (column, (&centre, _)) in columns {
            column.set(slot, centre);
        }
        return true;
    };
    let Some((status, projection)) = history.split_first() else {
        return false;
    };
    let mut possible = is_usable(status.get());
    for ((column, (&centre, &extent)), value) in columns.zip(projection) {
        possible &= can_be_projection(value.get(), centre, extent);
        column.set(slot, value.get());
    }
    inputs.frozen.set(slot, status.get());
    possible
}
