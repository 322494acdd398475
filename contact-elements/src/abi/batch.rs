//! Many contacts of one element.

use super::outputs::Pointers;
use super::ownership::Ownership;
use super::pointers::{history, optional, workspace};
use super::types::Batch;
use super::versioned::is_whole;
use crate::batch::dispatch::one_by_one;
use crate::codes::{argument, code, request};
use crate::error::Error;
use crate::evaluation::batch::arrays::Arrays;
use crate::evaluation::batch::run::{Failures, Run};
use crate::evaluation::batch::shape::{Form, Present, Shape};
use crate::evaluation::sizes::{reported, slave_count};
use crate::lanes::Width;
use crate::registered::Registered;

/// `cte_element_batch_workspace`.
///
/// # Safety
/// `element` comes from this interface or is null.
pub unsafe fn element_batch_workspace(element: *const Registered, nslave: i32) -> i64 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return i64::from(code::NULL);
    };
    match slave_count(element, nslave) {
        Ok(nslave) => element.workspace(element.nodes(nslave)) as i64,
        Err(error) => i64::from(error.code),
    }
}

/// `cte_element_evaluate_batch`.
///
/// # Safety
/// `element` comes from this interface or is null; `batch` points to a struct whose pointers are valid for
/// the shapes that the header gives, or is null.
pub unsafe fn element_evaluate_batch(element: *const Registered, n: i64, batch: *mut Batch) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { element_evaluate_batch_in(element, n, batch, Width::widest()) }
}

/// [`element_evaluate_batch`] with at most so many lanes.
///
/// # Safety
/// As [`element_evaluate_batch`].
pub unsafe fn element_evaluate_batch_in(
    element: *const Registered,
    n: i64,
    batch: *mut Batch,
    width: Width,
) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { guarded(element, n, batch, |work| work.all(width)) }
}

/// A checked batch of a host.
pub(super) struct Work<'a> {
    pub(super) element: &'a Registered,
    pub(super) batch: &'a Batch,
    pub(super) shape: Shape<'a>,
    pub(super) arrays: Arrays<'a>,
    /// Scatter map into the sparse matrix.
    pub(super) map: &'a [i64],
}

/// Checks a batch, has it evaluated and fills the scalars at the end of its struct.
///
/// # Safety
/// As [`element_evaluate_batch`].
pub(super) unsafe fn guarded(
    element: *const Registered,
    n: i64,
    batch: *mut Batch,
    evaluate: impl FnOnce(&Work<'_>) -> Result<Failures, Error>,
) -> i32 {
    if batch.is_null() {
        return code::NULL;
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(batch) } {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    let batch = unsafe { &mut *batch };
    // SAFETY: promised by the caller.
    let result = match unsafe { element.as_ref() } {
        // SAFETY: promised by the caller.
        Some(element) => unsafe { Work::new(element, n, batch) }.and_then(|work| evaluate(&work)),
        None => Err(Error::missing(argument::ELEMENT)),
    };
    let failed = result.map_or(0, |failures| failures.count);
    batch.failed = failed as i64;
    (batch.error_argument, batch.error_index) = (argument::NONE, 0);
    match result.and_then(|failures| failures.outcome()) {
        Ok(()) => code::SUCCESS,
        Err(error) => {
            batch.error_argument = error.argument;
            batch.error_index = reported(error.index);
            error.code
        }
    }
}

/// Counts, strides and arrays as the struct gives them.
fn form(batch: &Batch) -> Form {
    Form {
        request: batch.request,
        nslave: batch.nslave,
        parameter_count: batch.parameter_count,
        x_strides: [
            batch.x_element_stride,
            batch.x_node_stride,
            batch.x_component_stride,
        ],
        u_strides: [
            batch.u_element_stride,
            batch.u_node_stride,
            batch.u_component_stride,
        ],
        f_stride: batch.f_element_stride,
        k_stride: batch.k_element_stride,
        parameter_stride: batch.parameter_element_stride,
        global_nodes: batch.global_nodes,
        f_scale: batch.f_scale,
        k_scale: batch.k_scale,
        has: Present {
            x: !batch.x.is_null(),
            parameters: !batch.parameters.is_null(),
            history: !batch.history_accepted.is_null(),
            slave_row: !batch.slave_row.is_null(),
            connectivity: !batch.connectivity.is_null(),
            status: !batch.status.is_null(),
            f: !batch.f.is_null(),
            k: !batch.k.is_null(),
            global_f: !batch.global_f.is_null(),
            csr_values: !batch.csr_values.is_null(),
            csr_map: !batch.csr_map.is_null(),
            trial: !batch.history_trial.is_null(),
            output: !batch.output.is_null(),
            energy: !batch.energy.is_null(),
        },
    }
}

impl<'a> Work<'a> {
    /// Checks everything but the values.
    ///
    /// # Safety
    /// The pointers of the batch are valid for the shapes that the header gives, as long as this lives.
    unsafe fn new(element: &'a Registered, n: i64, batch: &'a Batch) -> Result<Self, Error> {
        let shape = Shape::new(element, element.requests(), n, form(batch))?;
        let count = shape.count;
        // SAFETY: promised by the caller; the lengths fit the memory.
        let arrays = unsafe {
            Arrays {
                x: optional(batch.x, shape.x.length).unwrap_or_default(),
                u: optional(batch.u, shape.u.length),
                connectivity: optional(batch.connectivity, count * shape.nodes),
                parameters: optional(batch.parameters, shape.parameter_length())
                    .unwrap_or_default(),
                history: history(batch.history_accepted, count * element.history()),
                slave_row: optional(batch.slave_row, count * (shape.nslave + 1))
                    .filter(|_| element.interpolated),
            }
        };
        arrays.check(&shape)?;
        let is_scattered = batch.request & request::TANGENT != 0 && !batch.csr_values.is_null();
        let length = if is_scattered {
            count * shape.map_size()
        } else {
            0
        };
        Ok(Self {
            element,
            batch,
            // SAFETY: promised by the caller; the length fits the memory.
            map: unsafe { optional(batch.csr_map, length) }.unwrap_or_default(),
            shape,
            arrays,
        })
    }

    /// The caller's workspace, where the element needs one and there are contacts.
    pub(super) fn workspace(&self) -> Result<&'a mut [f64], Error> {
        let needed = match self.shape.count {
            0 => 0,
            _ => self.element.workspace(self.shape.nodes),
        };
        // SAFETY: promised by the caller of the batch.
        unsafe { workspace(self.batch.workspace, self.batch.workspace_size, needed) }
    }

    /// Evaluates all contacts on this thread.
    pub(super) fn all(&self, width: Width) -> Result<Failures, Error> {
        let memory = self.workspace()?;
        if self.shape.count == 0 {
            return Ok(Failures::NONE);
        }
        let list = self.arrays.connectivity.unwrap_or(&[]);
        // SAFETY: promised by the caller of the batch.
        let mut outputs =
            unsafe { Pointers::new(&self.shape, self.batch, 0, self.map, list, Ownership::FREE) };
        let (shape, arrays) = (&self.shape, &self.arrays);
        Ok(evaluate(
            self.element,
            shape,
            arrays,
            &mut outputs,
            memory,
            width,
        ))
    }
}

/// Evaluates contacts in the order of their numbers.
pub(super) fn evaluate<'a>(
    element: &Registered,
    shape: &'a Shape<'a>,
    arrays: &'a Arrays<'a>,
    outputs: &'a mut Pointers<'_, '_>,
    memory: &'a mut [f64],
    width: Width,
) -> Failures {
    let mut run = Run::new(
        element.kernel,
        element.screen,
        shape,
        arrays,
        outputs,
        memory,
    );
    match element.lanes {
        Some(kernel) if run.shape.count > 1 => kernel(&mut run, width),
        _ => one_by_one(&mut run),
    }
    run.failures
}
