//! Many contacts of one element, one after the other in order: sums are reproducible.

use super::evaluate::{
    Fault, check_request, fault_of, history, parameters, scale, slave_row, wanted, workspace,
};
use super::target::Target;
use super::types::Batch;
use super::{Descriptor, OUTPUT_SIZE, argument, code, request};
use crate::runtime::{Call, Coordinates, Nodes, Status};

/// `cte_element_batch_workspace`.
///
/// # Safety
/// `element` comes from this interface or is null.
pub unsafe fn element_batch_workspace(element: *const Descriptor, nslave: i32) -> i64 {
    // SAFETY: promised by the caller.
    match unsafe { element.as_ref() } {
        Some(element) => {
            let nslave = usize::try_from(nslave).unwrap_or(0);
            element.workspace(element.nodes(nslave)) as i64
        }
        None => 0,
    }
}

/// `cte_element_evaluate_batch`.
///
/// # Safety
/// `element` comes from this interface or is null; `batch` points to a struct whose pointers are valid for
/// the shapes that the header gives, or is null.
pub unsafe fn element_evaluate_batch(element: *const Descriptor, n: i64, batch: *mut Batch) -> i32 {
    // SAFETY: promised by the caller.
    let (Some(element), false) = (unsafe { element.as_ref() }, batch.is_null()) else {
        return code::NULL;
    };
    // SAFETY: every struct begins with its size.
    if (unsafe { (*batch).struct_size } as usize) < size_of::<Batch>() {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    let batch = unsafe { &mut *batch };
    // SAFETY: promised by the caller.
    let outcome = unsafe { Run::new(element, n, batch).and_then(|run| run.all()) };
    let (failed, code, fault) = match outcome {
        Ok((0, _)) => (0, code::SUCCESS, (argument::NONE, 0)),
        Ok((failed, (_, name, index))) => (failed, code::CUT_BACK, (name, index)),
        Err((code, name, index)) => (0, code, (name, index)),
    };
    batch.failed = failed;
    (batch.error_argument, batch.error_index) = (fault.0, fault.1 as i32);
    code
}

/// A checked batch.
struct Run<'a> {
    element: &'a Descriptor,
    batch: &'a Batch,
    count: usize,
    nodes: usize,
    nslave: usize,
    f_scale: f64,
    k_scale: f64,
}

impl<'a> Run<'a> {
    /// Checks what concerns the batch as a whole.
    ///
    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn new(element: &'a Descriptor, n: i64, batch: &'a Batch) -> Result<Self, Fault> {
        check_request(element, batch.request, batch.hist_old.is_null())?;
        let count = usize::try_from(n).map_err(|_| (code::INDEX, argument::BATCH, 0))?;
        let nslave = match usize::try_from(batch.nslave) {
            Ok(n) if element.interpolated && n > 0 => n,
            Ok(n) if !element.interpolated && (n == 0 || n == element.slave_nodes) => {
                element.slave_nodes
            }
            _ => return Err((code::NODE_COUNT, argument::NSLAVE, 0)),
        };
        let run = Self {
            element,
            batch,
            count,
            nodes: element.nodes(nslave),
            nslave,
            f_scale: scale(batch.f_scale)?,
            k_scale: scale(batch.k_scale)?,
        };
        run.check_pointers()?;
        run.check_strides()?;
        // SAFETY: promised by the caller.
        unsafe { run.check_connectivity()? };
        Ok(run)
    }

    fn check_pointers(&self) -> Result<(), Fault> {
        let batch = self.batch;
        let bits = batch.request;
        let wants = |bit: u32| bits & bit != 0;
        let scattered = !batch.global_f.is_null() || !batch.csr_values.is_null();
        let required = [
            (true, batch.x.is_null(), argument::X),
            (true, batch.parameters.is_null(), argument::PARAMETERS),
            (true, batch.status.is_null(), argument::STATUS),
            (
                wants(request::RESIDUAL),
                batch.f.is_null() && batch.global_f.is_null(),
                argument::F,
            ),
            (
                wants(request::TANGENT),
                batch.k.is_null() && batch.csr_values.is_null(),
                argument::K,
            ),
            (
                wants(request::HISTORY),
                batch.hist_new.is_null(),
                argument::HISTORY_NEW,
            ),
            (
                wants(request::OUTPUT),
                batch.output.is_null(),
                argument::OUTPUT,
            ),
            (
                wants(request::ENERGY),
                batch.energy.is_null(),
                argument::ENERGY,
            ),
            (
                scattered,
                batch.connectivity.is_null(),
                argument::CONNECTIVITY,
            ),
            (
                !batch.csr_values.is_null(),
                batch.csr_map.is_null(),
                argument::CSR,
            ),
            (
                self.element.interpolated,
                batch.slave_row.is_null(),
                argument::SLAVE_ROW,
            ),
        ];
        for (needed, null, name) in required {
            if needed && null {
                return Err((code::NULL, name, 0));
            }
        }
        if wants(request::SYMMETRISE) && !batch.csr_values.is_null() && !self.element.symmetric {
            return Err((code::REQUEST, argument::REQUEST, 6));
        }
        Ok(())
    }

    fn check_strides(&self) -> Result<(), Fault> {
        let batch = self.batch;
        let lists = [
            (
                [
                    batch.x_element_stride,
                    batch.x_node_stride,
                    batch.x_component_stride,
                ],
                argument::X,
            ),
            (
                [
                    batch.u_element_stride,
                    batch.u_node_stride,
                    batch.u_component_stride,
                ],
                argument::U,
            ),
            (
                [batch.f_element_stride, batch.parameter_element_stride, 0],
                argument::F,
            ),
            ([batch.k_element_stride, 0, 0], argument::K_STRIDE),
        ];
        for (list, name) in lists {
            if list.iter().any(|&stride| stride < 0) {
                return Err((code::STRIDE, name, 0));
            }
        }
        Ok(())
    }

    /// # Safety
    /// The connectivity is null or has n · nnode entries.
    unsafe fn check_connectivity(&self) -> Result<(), Fault> {
        if self.batch.connectivity.is_null() {
            return Ok(());
        }
        let length = self.count * self.nodes;
        // SAFETY: promised by the caller.
        let list = unsafe { core::slice::from_raw_parts(self.batch.connectivity, length) };
        for (index, &node) in list.iter().enumerate() {
            if node < 0 || i64::from(node) >= self.batch.global_nodes {
                return Err((code::INDEX, argument::CONNECTIVITY, index));
            }
        }
        Ok(())
    }

    /// Evaluates all elements. Returns how many failed and the fault of the first.
    ///
    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn all(&self) -> Result<(i64, Fault), Fault> {
        let mut failed = 0;
        let mut first = (code::SUCCESS, argument::NONE, 0);
        let needed = self.element.workspace(self.nodes);
        // SAFETY: promised by the caller.
        let memory = unsafe { workspace(self.batch.workspace, self.batch.workspace_size, needed)? };
        for e in 0..self.count {
            // SAFETY: promised by the caller.
            let (status, fault) = unsafe { self.one(e, memory) };
            // SAFETY: promised by the caller: one entry per element.
            unsafe {
                *self.batch.status.add(e) = status as i32;
                super::describe::write(
                    if self.batch.code.is_null() {
                        core::ptr::null_mut()
                    } else {
                        self.batch.code.add(e)
                    },
                    fault.0,
                );
            }
            if fault.0 != code::SUCCESS {
                if failed == 0 {
                    first = fault;
                }
                failed += 1;
            }
        }
        Ok((failed, first))
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn one(&self, e: usize, memory: &mut [f64]) -> (Status, Fault) {
        let batch = self.batch;
        let fine = (code::SUCCESS, argument::NONE, 0);
        let skip = usize::try_from(batch.parameter_element_stride).unwrap_or(0) * e;
        // SAFETY: promised by the caller.
        let prepared = unsafe {
            parameters(
                self.element,
                batch.parameters.add(skip),
                batch.parameter_count,
            )
        };
        let parameters = match prepared {
            Ok(parameters) => parameters,
            Err(fault) => return (Status::Open, fault),
        };
        let size = self.element.history();
        // SAFETY: promised by the caller.
        let (old, row) = unsafe {
            (
                history(self.element, shifted(batch.hist_old, e * size)),
                slave_row(
                    self.element,
                    shifted(batch.slave_row, e * (self.nslave + 1)),
                    self.nslave,
                ),
            )
        };
        let call = Call {
            parameters,
            history: old,
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
                (summary.status, fine)
            }
            Err(error) => (error.status().unwrap_or(Status::Open), fault_of(error)),
        }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn nodes_of(&self, e: usize) -> Nodes<'a> {
        let batch = self.batch;
        let d = self.element.dimension;
        let view = |values: *const f64, [element, node, component]: [i64; 3]| {
            let [element, node, component] =
                [element, node, component].map(|stride| usize::try_from(stride).unwrap_or(0));
            let dense = element == 0 && node == 0 && component == 0;
            let gathered = !batch.connectivity.is_null();
            let (element, node, component) = match (gathered, dense) {
                (true, true) => (0, d, 1),
                (true, false) => (0, node, component),
                (false, true) => (self.nodes * d, d, 1),
                (false, false) => (element, node, component),
            };
            let most = if gathered {
                usize::try_from(batch.global_nodes)
                    .unwrap_or(0)
                    .saturating_sub(1)
            } else {
                self.nodes - 1
            };
            let length = e * element + most * node + (d - 1) * component + 1;
            Coordinates {
                // SAFETY: promised by the caller.
                values: unsafe { core::slice::from_raw_parts(values, length) },
                offset: e * element,
                node_stride: node,
                component_stride: component,
            }
        };
        let u = [
            batch.u_element_stride,
            batch.u_node_stride,
            batch.u_component_stride,
        ];
        Nodes {
            x: view(
                batch.x,
                [
                    batch.x_element_stride,
                    batch.x_node_stride,
                    batch.x_component_stride,
                ],
            ),
            u: (!batch.u.is_null()).then(|| view(batch.u, u)),
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
        let unknowns = self.nodes * self.element.dimension;
        let bits = batch.request;
        let or_dense = |stride: i64, dense: usize| match usize::try_from(stride) {
            Ok(stride) if stride > 0 => stride,
            _ => dense,
        };
        let at = |bit: u32, pointer: *mut f64, offset: usize| {
            if bits & bit == 0 || pointer.is_null() {
                core::ptr::null_mut()
            } else {
                // SAFETY: promised by the caller.
                unsafe { pointer.add(offset) }
            }
        };
        let squared = unknowns * unknowns;
        Target {
            unknowns,
            projected: self.element.projected,
            f: at(
                request::RESIDUAL,
                batch.f,
                e * or_dense(batch.f_element_stride, unknowns),
            ),
            k: at(
                request::TANGENT,
                batch.k,
                e * or_dense(batch.k_element_stride, squared),
            ),
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
            csr_map: unsafe { shifted(batch.csr_map, e * squared) },
            output: at(
                request::OUTPUT,
                batch.output,
                e * self.element.points * OUTPUT_SIZE,
            ),
            history: at(request::HISTORY, batch.hist_new, e * self.element.history()).cast(),
            energy: at(request::ENERGY, batch.energy, e),
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
