//! Numbers behind addresses, each in pages of its own.

use std::ptr::null;

use contact_elements::abi::Arguments;

pub use crate::called::Outcome as Call;
use crate::harness::{Checked, Harness};
use crate::memory::{Edge, Output};
use crate::plan::Plan;

/// Before a call in integers.
const UNSET: i32 = 0x5a5a_5a5a;
/// `CTE_CUT_BACK`.
const CUT_BACK: i32 = 1;

/// What an evaluation of an element and of a patch have in common.
#[derive(Clone, Copy)]
pub struct Numbers {
    pub request: *const i32,
    pub nnode: *const i32,
    pub ldx: *const i32,
    pub ldu: *const i32,
    pub count: *const i32,
    pub mapped: *const i32,
    pub ldk: *const i32,
    pub workspace_size: *const i32,
    pub f_scale: *const f64,
    pub k_scale: *const f64,
    pub state: Output<i32>,
    pub code: Output<i32>,
    edge: Edge,
}

impl Numbers {
    /// How many of them can be null.
    pub const COUNT: usize = 10;
    /// Slots that they take.
    const SLOTS: usize = 8;

    /// Those of a plan; `workspace`: doubles that the call needs.
    pub fn new(harness: &mut Harness, plan: &Plan, ldk: i32, workspace: i64) -> Self {
        let room = workspace.saturating_sub(plan.short);
        let size = room.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32;
        let strides = plan.strides.map(|stride| stride as i32);
        let values = [
            plan.request as i32,
            plan.nnode,
            strides[0],
            strides[1],
            plan.parameter_count,
            i32::from(plan.map.is_some()),
            ldk,
            size,
        ];
        let edge = plan.edge;
        let slots = &mut harness.slots;
        let mut addresses = [null(); Self::SLOTS];
        for ((address, slot), value) in addresses.iter_mut().zip(&mut slots.integers).zip(values) {
            *address = slot.input(&[value], edge);
        }
        let [request, nnode, ldx, ldu, count, mapped, ldk, workspace_size] = addresses;
        Self {
            request,
            nnode,
            ldx,
            ldu,
            count,
            mapped,
            ldk,
            workspace_size,
            f_scale: slots.csr_values.input(&plan.scales[..1], edge),
            k_scale: slots.global_f.input(&plan.scales[1..], edge),
            state: slots.status.output(&[UNSET; 4], edge),
            code: slots.code.output(&[UNSET], edge),
            edge,
        }
    }

    /// Further integers.
    pub fn integers<const N: usize>(
        &self,
        harness: &mut Harness,
        values: [i32; N],
    ) -> [*const i32; N] {
        let mut slots = harness.slots.integers.iter_mut().skip(Self::SLOTS);
        values.map(|value| {
            let slot = slots.next().expect("as many slots as integers");
            slot.input(&[value], self.edge)
        })
    }

    /// Takes one of them away.
    pub fn remove(&mut self, which: usize) {
        let integers = [
            &mut self.request,
            &mut self.nnode,
            &mut self.ldx,
            &mut self.ldu,
            &mut self.count,
            &mut self.mapped,
            &mut self.ldk,
            &mut self.workspace_size,
        ];
        match integers.into_iter().nth(which) {
            Some(address) => *address = null(),
            None if which == Self::SLOTS => self.f_scale = null(),
            None => self.k_scale = null(),
        }
    }

    /// Puts the outcome where C has it; the code.
    pub fn fill(&self, arguments: &mut Arguments) -> i32 {
        let code = self.code.values()[0];
        let state = self.state.values();
        arguments.dt_ratio = if code == CUT_BACK { 0.5 } else { 1.0 };
        (arguments.status, arguments.closed_points) = (state[0], state[1]);
        (arguments.error_argument, arguments.error_index) = (state[2], state[3]);
        code
    }

    /// Nothing was written beside the outcome.
    pub fn check(&self) -> Checked {
        self.state.check_margins("state")?;
        self.code.check_margins("code")
    }
}
