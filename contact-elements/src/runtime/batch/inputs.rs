//! From the host's arrays to the columns of a block.

use super::Contacts;
use super::block::{Column, Inputs, ROOM};
use crate::runtime::gather::{Nodes, is_usable};
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
pub(super) fn gather<C: Contacts, const D: usize>(
    contacts: &C,
    (first, length): (usize, usize),
    form: &Form<'_>,
    inputs: &mut Inputs<'_>,
) -> u32 {
    let are_same = contacts.have_same_parameters();
    let mut good = 0;
    for slot in 0..length.min(ROOM) {
        let contact = first + slot;
        let Some(parameters) = contacts.parameters(contact) else {
            continue;
        };
        if !start(contacts, contact, form, inputs, slot) {
            continue;
        }
        if !positions::<D>(&contacts.nodes(contact), form.vectors, inputs.x, slot) {
            continue;
        }
        if are_same && (first > 0 || slot > 0) {
            // the columns hold them already
        } else if are_same {
            for (column, &value) in inputs.parameters.iter_mut().zip(parameters) {
                *column = Column([value; ROOM]);
            }
        } else {
            for (column, &value) in inputs.parameters.iter_mut().zip(parameters) {
                column.set(slot, value);
            }
        }
        good |= 1 << slot;
    }
    good
}

/// Positions relative to the first node, by the rules of one call. [eq:local-origin]
#[inline(always)]
fn positions<const D: usize>(
    nodes: &Nodes<'_>,
    vectors: &[bool],
    x: &mut [Column],
    slot: usize,
) -> bool {
    let (columns, _) = x.as_chunks_mut::<D>();
    if nodes.check::<D>(columns.len()).is_err() {
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

/// Start of the search; false where the history cannot be used.
#[inline(always)]
fn start<C: Contacts>(
    contacts: &C,
    contact: usize,
    form: &Form<'_>,
    inputs: &mut Inputs<'_>,
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
