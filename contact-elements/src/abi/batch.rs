//! Many contacts of one element, one after the other in order: sums are reproducible.

use super::batch_check::{Checked, Layout};
use super::evaluate::{fault_of, history, parameters, slave_row, wanted, workspace};
use super::sizes::{Fault, reported, slave_count};
use super::target::Target;
use super::types::{Batch, is_whole};
use super::{Descriptor, OUTPUT_SIZE, argument, code, request};
use crate::runtime::{Call, Coordinates, Nodes, Status};

/// `cte_element_batch_workspace`.
///
/// # Safety
/// `element` comes from this interface or is null.
pub unsafe fn element_batch_workspace(element: *const Descriptor, nslave: i32) -> i64 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return i64::from(code::NULL);
    };
    match slave_count(element, nslave) {
        Ok(nslave) => element.workspace(element.nodes(nslave)) as i64,
        Err((code, ..)) => i64::from(code),
    }
}

/// `cte_element_evaluate_batch`.
///
/// # Safety
/// `element` comes from this interface or is null; `batch` points to a struct whose pointers are valid for
/// the shapes that the header gives, or is null.
pub unsafe fn element_evaluate_batch(element: *const Descriptor, n: i64, batch: *mut Batch) -> i32 {
    if batch.is_null() {
        return code::NULL;
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole::<Batch>(batch.cast()) } {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    let batch = unsafe { &mut *batch };
    // SAFETY: promised by the caller.
    let outcome = match unsafe { element.as_ref() } {
        // SAFETY: promised by the caller.
        Some(element) => unsafe { Checked::new(element, n, batch).and_then(|run| run.all()) },
        None => Err((code::NULL, argument::ELEMENT, 0)),
    };
    let (code, failures) = match outcome {
        Ok(failures) if failures.count == 0 => (code::SUCCESS, failures),
        Ok(failures) => (code::CUT_BACK, failures),
        Err((code, argument, index)) => {
            let count = 0;
            let failures = Failures {
                count,
                argument,
                index,
            };
            (code, failures)
        }
    };
    batch.failed = failures.count;
    batch.error_argument = failures.argument;
    batch.error_index = reported(failures.index);
    code
}

/// How many contacts failed; which was the first, and what its fault names.
struct Failures {
    count: i64,
    argument: i32,
    index: usize,
}

impl<'a> Checked<'a> {
    /// Evaluates all contacts.
    ///
    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn all(&self) -> Result<Failures, Fault> {
        let mut failures = Failures {
            count: 0,
            argument: argument::NONE,
            index: 0,
        };
        if self.count == 0 {
            return Ok(failures);
        }
        let needed = self.element.workspace(self.nodes);
        // SAFETY: promised by the caller.
        let memory = unsafe { workspace(self.batch.workspace, self.batch.workspace_size, needed)? };
        for e in 0..self.count {
            // SAFETY: promised by the caller.
            let (status, (code, argument, _)) = unsafe { self.one(e, memory) };
            // SAFETY: promised by the caller: one entry per contact.
            unsafe {
                *self.batch.status.add(e) = status as i32;
                if !self.batch.code.is_null() {
                    *self.batch.code.add(e) = code;
                }
            }
            if code != code::SUCCESS {
                if failures.count == 0 {
                    (failures.argument, failures.index) = (argument, e);
                }
                failures.count += 1;
            }
        }
        Ok(failures)
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn one(&self, e: usize, memory: &mut [f64]) -> (Status, Fault) {
        let batch = self.batch;
        // SAFETY: promised by the caller.
        let prepared = unsafe {
            let values = batch.parameters.add(e * self.parameter_stride);
            parameters(self.element, values, batch.parameter_count)
        };
        let parameters = match prepared {
            Ok(parameters) => parameters,
            Err(fault) => return (Status::Open, fault),
        };
        // SAFETY: promised by the caller.
        let (history, row) = unsafe {
            let old = shifted(batch.hist_old, e * self.element.history());
            let row = shifted(batch.slave_row, e * (self.nslave + 1));
            (
                history(self.element, old),
                slave_row(self.element, row, self.nslave),
            )
        };
        let call = Call {
            parameters,
            history,
            slave_row: row.unwrap_or(&[]),
            wanted: wanted(batch.request),
        };
        // SAFETY: promised by the caller.
        let (nodes, mut target) = unsafe { (self.nodes_of(e), self.target(e)) };
        match (self.element.kernel)(&call, &nodes, memory, &mut target) {
            Ok(summary) => {
                if batch.request & request::SYMMETRISE != 0 && !target.k.is_null() {
                    target.symmetrise();
                }
                (summary.status, (code::SUCCESS, argument::NONE, 0))
            }
            Err(error) => (error.status().unwrap_or(Status::Open), fault_of(error)),
        }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn nodes_of(&self, e: usize) -> Nodes<'a> {
        let batch = self.batch;
        let coordinates = |values: *const f64, layout: Layout| Coordinates {
            // SAFETY: promised by the caller; the length fits the memory.
            values: unsafe { core::slice::from_raw_parts(values, layout.length) },
            offset: e * layout.element,
            node_stride: layout.node,
            component_stride: layout.component,
        };
        Nodes {
            x: coordinates(batch.x, self.x),
            u: (!batch.u.is_null()).then(|| coordinates(batch.u, self.u)),
            // SAFETY: promised by the caller.
            connectivity: (!batch.connectivity.is_null()).then(|| unsafe {
                let list = batch.connectivity.add(e * self.nodes);
                core::slice::from_raw_parts(list, self.nodes)
            }),
            count: self.nodes,
        }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn target(&self, e: usize) -> Target {
        let batch = self.batch;
        let unknowns = self.unknowns();
        let at = |bit: u32, pointer: *mut f64, stride: usize| {
            if batch.request & bit == 0 || pointer.is_null() {
                core::ptr::null_mut()
            } else {
                // SAFETY: promised by the caller; the offset was checked.
                unsafe { pointer.add(e * stride) }
            }
        };
        let points = self.element.points;
        Target {
            unknowns,
            projected: self.element.projected,
            friction: self.element.friction,
            augmented: self.element.is_augmented(),
            rolling: self.element.rolling,
            keeps_side: self.element.keeps_side,
            f: at(request::RESIDUAL, batch.f, self.f_stride),
            k: at(request::TANGENT, batch.k, self.k_stride),
            row_stride: unknowns,
            column_stride: 1,
            map: core::ptr::null(),
            f_scale: self.f_scale,
            k_scale: self.k_scale,
            global_f: at(request::RESIDUAL, batch.global_f, 0),
            // SAFETY: promised by the caller.
            connectivity: unsafe { shifted(batch.connectivity, e * self.nodes) },
            dimension: self.element.dimension,
            csr_values: at(request::TANGENT, batch.csr_values, 0),
            // SAFETY: promised by the caller.
            csr_map: unsafe { shifted(batch.csr_map, e * unknowns * unknowns) },
            output: at(request::OUTPUT, batch.output, points * OUTPUT_SIZE),
            history: at(request::HISTORY, batch.hist_new, self.element.history()).cast(),
            energy: at(request::ENERGY, batch.energy, 1),
        }
    }
}

/// The pointer moved by `offset`, or null.
///
/// # Safety
/// `pointer` is null or valid for `offset` entries.
unsafe fn shifted<T>(pointer: *const T, offset: usize) -> *const T {
    if pointer.is_null() {
        pointer
    } else {
        // SAFETY: promised by the caller.
        unsafe { pointer.add(offset) }
    }
}
