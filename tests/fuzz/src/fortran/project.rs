//! `cte_f77_project_`.

use contact_elements::abi::{Arguments, Projection};

use super::numbers::Numbers;
use crate::harness::{Checked, Harness};
use crate::interface::Fortran;
use crate::ledger::function;
use crate::memory::{CANARY, Output};
use crate::plan::{Array, Plan};

/// Its index among the functions.
pub const FUNCTION: usize = function("cte_f77_project_");
/// Doubles of a projection.
const SIZE: usize = 8;

/// The call with its numbers in place.
#[derive(Clone, Copy)]
pub struct Project {
    numbers: Numbers,
    index: *const i32,
    nslave: *const i32,
    reach: *const f64,
    found: Output<f64>,
    fortran: Fortran,
}

impl Project {
    /// Places the numbers of a plan; `None` where Fortran cannot say it.
    pub fn new(harness: &mut Harness, plan: &Plan, reach: f64, points: usize) -> Option<Self> {
        let fits = plan
            .strides
            .iter()
            .all(|&stride| i32::try_from(stride).is_ok());
        let is_whole = plan.struct_size == 0;
        let has_handles = !matches!(plan.null, Some(Array::Element | Array::Arguments));
        if !(fits && is_whole && has_handles) {
            return None;
        }
        let numbers = Numbers::new(harness, plan, 0, 0);
        let index = harness.elements[plan.element].index;
        let [index, nslave] = numbers.integers(harness, [index, plan.nslave]);
        let fortran = harness.interface.fortran;
        let slots = &mut harness.slots;
        Some(Self {
            numbers,
            index,
            nslave,
            reach: slots.patch.input(&[reach], plan.edge),
            found: slots.connectivity.canaries(SIZE * points, plan.edge),
            fortran,
        })
    }

    /// Calls, and puts what was found where C has it.
    ///
    /// # Safety
    /// `pointer` is a whole struct as the header demands it; `history` null or the element's.
    pub unsafe fn call(
        &self,
        pointer: *mut Arguments,
        result: *mut Projection,
        history: *mut f64,
    ) -> i32 {
        let n = &self.numbers;
        let to = match result.is_null() {
            true => std::ptr::null_mut(),
            false => self.found.pointer,
        };
        // SAFETY: promised by the caller.
        unsafe {
            let a = &mut *pointer;
            (self.fortran.project)(
                self.index,
                n.nnode,
                self.nslave,
                a.x,
                n.ldx,
                a.u,
                n.ldu,
                a.parameters,
                n.count,
                a.slave_row,
                self.reach,
                to,
                history,
                n.state.pointer,
                n.code.pointer,
            );
            let state = n.state.values();
            (a.error_argument, a.error_index) = (state[2], state[3]);
            let code = n.code.values()[0];
            for (at, numbers) in self.found.values().chunks_exact(SIZE).enumerate() {
                if code == 0 {
                    let count = |at: usize| numbers[at] as i32;
                    result.add(at).write(Projection {
                        zeta: [numbers[0], numbers[1]],
                        distance: numbers[2],
                        definiteness: numbers[3],
                        verdict: count(4),
                        feature: count(5),
                        boxes: count(6),
                        steps: count(7),
                    });
                }
            }
            code
        }
    }

    /// Nothing was written beside the results, and where something is refused at once not there either.
    pub fn check(&self, stays: bool) -> Checked {
        self.numbers.check()?;
        self.found.check_margins("projections")?;
        let is_touched = |value: &f64| value.to_bits() != CANARY;
        match stays && self.found.values().iter().any(is_touched) {
            true => Err("projections: written".to_string()),
            false => Ok(()),
        }
    }
}
