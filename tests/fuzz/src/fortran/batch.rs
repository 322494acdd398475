//! `cte_f77_batch_`.

use contact_elements::abi::Batch;

use crate::contacts::Contacts;
use crate::element::Element;
use crate::harness::{Checked, Harness};
use crate::interface::Fortran;
use crate::ledger::function;
use crate::memory::Output;

/// Its index among the functions.
pub const FUNCTION: usize = function("cte_f77_batch_");
/// Before a call in integers.
const UNSET: i32 = 0x5a5a_5a5a;
/// Integers of a batch.
const INTEGERS: usize = 11;

/// The call with its numbers in place.
#[derive(Clone, Copy)]
pub struct ManyContacts {
    integers: [*const i32; INTEGERS],
    f_scale: *const f64,
    k_scale: *const f64,
    state: Output<i32>,
    code: Output<i32>,
    fortran: Fortran,
}

impl ManyContacts {
    /// Places the numbers of a batch; `None` where Fortran cannot say it.
    pub fn new(
        harness: &mut Harness,
        element: &Element,
        contacts: &Contacts,
        batch: &Batch,
    ) -> Option<Self> {
        let plan = &contacts.plan;
        let nodes = plan.state.nodes as i64;
        let has_structs = plan.struct_size == 0 && !matches!(contacts.null, Some(0 | 1));
        let gathers = contacts.connectivity.is_some() == (contacts.global_nodes != 0);
        if !(has_structs && gathers) || contacts.output_strides != [0; 2] {
            return None;
        }
        let leading = |[apart, node, component]: [i64; 3]| match (apart, node, component) {
            (0, 0, 0) => Some(0),
            // nodes by their numbers: the contacts have no distance, and Fortran cannot say a wrong one
            (0..=0xffff, node, 1) if contacts.connectivity.is_some() => Some(node),
            (apart, node, 1) if node.checked_mul(nodes) == Some(apart) => Some(node),
            _ => None,
        };
        let [x, u] = contacts.strides.map(leading);
        let short = |value: i64| i32::try_from(value).ok();
        let into = i32::from(contacts.own) + 2 * i32::from(contacts.scattered);
        let values = [
            element.index,
            short(contacts.n)?,
            plan.request as i32,
            plan.nslave,
            short(contacts.global_nodes)?,
            short(x?)?,
            short(u?)?,
            plan.parameter_count,
            short(contacts.parameter_stride)?,
            into,
            short(batch.workspace_size)?,
        ];
        let edge = plan.edge;
        let slots = &mut harness.slots;
        let mut rest = slots.integers.iter_mut();
        let integers = values.map(|value| {
            let slot = rest.next().expect("as many slots as integers");
            slot.input(&[value], edge)
        });
        let code = rest.next().expect("a slot for the code");
        Some(Self {
            integers,
            f_scale: slots.result.input(&plan.scales[..1], edge),
            k_scale: slots.patch.input(&plan.scales[1..], edge),
            state: slots.connectivity.output(&[UNSET; 4], edge),
            code: code.output(&[UNSET], edge),
            fortran: harness.interface.fortran,
        })
    }

    /// Calls, and puts the outcome where C has it.
    ///
    /// # Safety
    /// `pointer` is a whole struct as the header demands it, or as it says is refused.
    pub unsafe fn call(&self, pointer: *mut Batch) -> i32 {
        let [
            index,
            n,
            request,
            nslave,
            nodes,
            ldx,
            ldu,
            count,
            ldp,
            into,
            room,
        ] = self.integers;
        // SAFETY: promised by the caller.
        unsafe {
            let b = &mut *pointer;
            (self.fortran.batch)(
                index,
                n,
                request,
                nslave,
                nodes,
                b.connectivity,
                b.x,
                ldx,
                b.u,
                ldu,
                b.parameters,
                count,
                ldp,
                b.history_accepted,
                b.history_trial,
                b.slave_row,
                into,
                self.f_scale,
                self.k_scale,
                b.f,
                b.k,
                b.global_f,
                b.csr_values,
                b.csr_map,
                b.output,
                b.energy,
                b.status,
                b.code,
                b.workspace,
                room,
                self.state.pointer,
                self.code.pointer,
            );
            let state = self.state.values();
            b.failed = i64::from(state[1]);
            (b.error_argument, b.error_index) = (state[2], state[3]);
        }
        self.code.values()[0]
    }

    /// Nothing was written beside the outcome.
    pub fn check(&self) -> Checked {
        self.state.check_margins("state")?;
        self.code.check_margins("code")
    }
}
