//! From the host's arrays to the columns of a block.

use crate::arithmetic::are_usable;
use crate::batch::block::{Column, Inputs, ROOM, store_lanes};
use crate::batch::compiled::BatchLanes;
use crate::batch::contacts::Contacts;
use crate::point::history::{History, HistoryLayout, Reach};

/// Takes the inputs of the first `length` contacts; returns one bit for each whose inputs can be used. The list is filled
/// up with the last number.
#[inline(always)]
pub(crate) fn gather<C: Contacts, T: BatchLanes, const D: usize, const P: usize, const N: usize>(
    contacts: &C,
    (numbers, length): (&[usize; ROOM + 8], usize),
    (vectors, reach, given): (&[bool; N], &Reach, bool),
    inputs: &mut Inputs<'_, D, P, N>,
) -> u32 {
    let mut good = 0;
    for group in (0..length).step_by(T::WIDTH) {
        let Some(own) = numbers.get(group..).and_then(<[usize]>::first_chunk) else {
            break;
        };
        let mut x = [[T::constant(0.0); D]; N];
        let usable = T::positions(contacts, vectors, own, &mut x);
        for (columns, x) in inputs.x.iter_mut().zip(x) {
            for k in 0..D {
                store_lanes(x[k], &mut columns[k], group);
            }
        }
        good |= usable << group;
    }
    good & others(contacts, (numbers, length), (reach, given), inputs)
}

/// Start of the search and parameters; one bit for each contact that has them.
#[inline(never)]
fn others<C: Contacts, const D: usize, const P: usize, const N: usize>(
    contacts: &C,
    (numbers, length): (&[usize; ROOM + 8], usize),
    reach: (&Reach, bool),
    inputs: &mut Inputs<'_, D, P, N>,
) -> u32 {
    let are_same = contacts.have_same_parameters();
    let mut good = 0;
    for (slot, &number) in numbers.iter().enumerate().take(length.min(ROOM)) {
        if start(contacts.history(number), reach, inputs, slot)
            && (are_same || own_parameters(contacts, number, inputs, slot))
        {
            good |= 1 << slot;
        }
    }
    good
}

/// Takes the parameters that all contacts share, where they do; false where they are refused.
#[inline(never)]
pub(crate) fn shared<C: Contacts>(contacts: &C, to: &mut [Column]) -> bool {
    if !contacts.have_same_parameters() {
        return true;
    }
    let Some(parameters) = contacts.parameters(0) else {
        return false;
    };
    for (column, &value) in to.iter_mut().zip(parameters) {
        *column = Column([value; ROOM]);
    }
    true
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

/// Status of the history and start of the search; false where they are NaN. The distance of a start from the
/// domain is checked in lanes.
#[inline(always)]
fn start<const D: usize, const P: usize, const N: usize>(
    history: Option<History<'_>>,
    (reach, given): (&Reach, bool),
    inputs: &mut Inputs<'_, D, P, N>,
    slot: usize,
) -> bool {
    let (mut status, mut start) = (0.0, reach.centre());
    if let Some(history) = history {
        if history.len() <= P {
            return false;
        }
        status = history.at(HistoryLayout::STATUS);
        let projection: [f64; P] =
            core::array::from_fn(|i| history.at(HistoryLayout::PROJECTION + i));
        if !(are_usable(&[status]) & are_usable(&projection)) {
            return false;
        }
        start = reach.start(status, projection, given);
    }
    inputs.frozen.set(slot, status);
    for i in 0..P {
        inputs.zeta[i].set(slot, start[i]);
    }
    true
}
