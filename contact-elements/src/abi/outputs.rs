//! Where the outputs of each contact of a batch go.

use super::batch_check::Checked;
use super::places::Map;
use super::target::Target;
use super::{OUTPUT_SIZE, request};

/// The outputs of the first contact, and how far those of the next are; 0 where there are none.
#[derive(Clone, Copy)]
pub(super) struct Outputs {
    first: Target,
    f: usize,
    k: usize,
    connectivity: usize,
    output: usize,
    history: usize,
    energy: usize,
}

impl Outputs {
    /// Of a batch whose pointers and strides were checked.
    pub(super) fn new(checked: &Checked<'_>) -> Self {
        let (element, batch) = (checked.element, checked.batch);
        let unknowns = checked.unknowns();
        let wanted = |bit: u32, pointer: *mut f64| {
            if batch.request & bit == 0 {
                core::ptr::null_mut()
            } else {
                pointer
            }
        };
        let first = Target {
            unknowns,
            history_layout: element.history_layout(),
            f: wanted(request::RESIDUAL, batch.f),
            k: wanted(request::TANGENT, batch.k),
            row_stride: unknowns,
            column_stride: 1,
            map: core::ptr::null(),
            f_scale: checked.f_scale,
            k_scale: checked.k_scale,
            global_f: wanted(request::RESIDUAL, batch.global_f),
            turn: checked.turn,
            connectivity: batch.connectivity,
            dimension: element.dimension,
            csr_values: wanted(request::TANGENT, batch.csr_values),
            csr_map: map(checked),
            output: wanted(request::OUTPUT, batch.output),
            history: wanted(request::HISTORY, batch.history_trial).cast(),
            energy: wanted(request::ENERGY, batch.energy),
        };
        let step = |is_null: bool, step: usize| if is_null { 0 } else { step };
        Self {
            f: step(first.f.is_null(), checked.f_stride),
            k: step(first.k.is_null(), checked.k_stride),
            connectivity: step(first.connectivity.is_null(), checked.nodes),
            output: step(first.output.is_null(), element.points * OUTPUT_SIZE),
            history: step(first.history.is_null(), element.history()),
            energy: step(first.energy.is_null(), 1),
            first,
        }
    }

    /// Those of one contact; its offsets were checked.
    #[inline(always)]
    pub(super) fn of(&self, contact: usize) -> Target {
        let first = &self.first;
        Target {
            f: first.f.wrapping_add(contact * self.f),
            k: first.k.wrapping_add(contact * self.k),
            connectivity: first.connectivity.wrapping_add(contact * self.connectivity),
            csr_map: first.csr_map.of(contact),
            output: first.output.wrapping_add(contact * self.output),
            history: first.history.wrapping_add(contact * self.history),
            energy: first.energy.wrapping_add(contact * self.energy),
            ..*first
        }
    }
}

/// The scatter map of the first contact.
fn map(checked: &Checked<'_>) -> Map {
    let (element, batch) = (checked.element, checked.batch);
    let has_blocks = batch.request & request::CSR_BY_BLOCKS != 0;
    Map {
        places: batch.csr_map,
        step: if batch.csr_map.is_null() {
            0
        } else {
            checked.map_size()
        },
        unknowns: checked.unknowns(),
        dimension: element.dimension,
        nodes: if has_blocks { checked.nodes } else { 0 },
        positions: checked.nodes - element.multipliers(),
    }
}
