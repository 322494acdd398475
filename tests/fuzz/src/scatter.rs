//! Where a batch adds its matrices, and the same sums by a map that has a place for every entry.

use contact_elements::abi::Batch;

use crate::batch::{Arrays, place};
use crate::called::mode;
use crate::contacts::Contacts;
use crate::element::Element;
use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::pattern::Pattern;
use crate::plan::request;

const FUNCTION: usize = function("cte_element_evaluate_batch");
/// Sparse values.
pub const PLACES: usize = 50;
/// Places before those that the rows and columns of a node can reach from there.
const FIRST: usize = PLACES - 8;

/// Places for every entry or every pair of nodes, as the request says, no place beyond [`PLACES`].
pub fn map(element: &Element, contacts: &Contacts, entropy: &mut Entropy) -> Vec<i64> {
    let (count, nodes) = (contacts.states.len(), contacts.plan.state.nodes);
    let unknowns = element.unknowns(nodes);
    if contacts.plan.request & request::CSR_BY_BLOCKS == 0 {
        return (0..count * unknowns * unknowns)
            .map(|at| ((at * 7 + entropy.below(3)) % PLACES) as i64)
            .collect();
    }
    let places = (0..count * nodes * (nodes + 1)).map(|at| match (at + 1) % (nodes + 1) {
        // how far the rows are apart; they may be the same
        0 => entropy.below(4),
        _ => (at * 7 + entropy.below(3)) % FIRST,
    });
    places.map(|place| place as i64).collect()
}

/// Bits of all sums.
pub fn sums(arrays: &Arrays) -> Vec<u64> {
    let sums = arrays.global_f.values().iter();
    let sums = sums.chain(arrays.csr_values.values());
    sums.map(|value| value.to_bits()).collect()
}

/// A batch that was scattered by blocks gives the same sums by all the entries of its blocks.
pub fn by_entries(
    harness: &mut Harness,
    element: &Element,
    contacts: &Contacts,
    (code, sums_by_blocks): (i32, Vec<u64>),
) -> Checked {
    if !contacts.scattered || contacts.plan.request & request::CSR_BY_BLOCKS == 0 {
        return Ok(());
    }
    let mut same = contacts.clone();
    same.plan.request &= !request::CSR_BY_BLOCKS;
    same.map = Pattern::expanded(element, same.plan.state.nodes, &contacts.map);
    let (batch, arrays) = place(harness, element, &same)?;
    // SAFETY: a struct without padding is bytes.
    let bytes: [u8; size_of::<Batch>()] = unsafe { std::mem::transmute(batch) };
    let block = harness.slots.arguments.output(&bytes, same.plan.edge);
    let evaluate = harness.interface.table.element_evaluate_batch;
    // SAFETY: what the header demands.
    let call = || unsafe { evaluate(element.pointer, same.n, block.pointer.cast()) };
    let (found, _) = harness.noting(FUNCTION, mode(element), call);
    harness.ledger.code(FUNCTION, found);
    match found == code && sums(&arrays) == sums_by_blocks {
        true => Ok(()),
        false => Err(format!("other sums by blocks, codes {code} and {found}")),
    }
}
