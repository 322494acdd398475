//! Many contacts of one element: in lanes where it has a kernel for that, else one after the other. Sums are taken
//! in the order of the contacts.

use super::batch_check::{Checked, Layout};
use super::evaluate::{fault_of, history, parameters, slave_row, wanted, workspace};
use super::outputs::Outputs;
use super::screen::Screening;
use super::sizes::{Fault, reported, slave_count};
use super::target::Target;
use super::types::{Batch, is_whole};
use super::{Descriptor, argument, code, request};
use crate::runtime::{
    AllPlaces, Call, Contacts, Coordinates, History, Nodes, Places, ROOM, Status, Wanted, Width,
    one_by_one,
};

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
    // SAFETY: promised by the caller.
    unsafe { element_evaluate_batch_in(element, n, batch, Width::widest()) }
}

/// [`element_evaluate_batch`] with at most so many lanes.
///
/// # Safety
/// As [`element_evaluate_batch`].
pub unsafe fn element_evaluate_batch_in(
    element: *const Descriptor,
    n: i64,
    batch: *mut Batch,
    width: Width,
) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { guarded(element, n, batch, |checked| all(checked, width)) }
}

/// Checks a batch, has it evaluated and fills the scalars at the end of its struct.
///
/// # Safety
/// As [`element_evaluate_batch`].
pub(super) unsafe fn guarded(
    element: *const Descriptor,
    n: i64,
    batch: *mut Batch,
    evaluate: impl FnOnce(Checked<'_>) -> Result<Failures, Fault>,
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
    let outcome = match unsafe { element.as_ref() } {
        // SAFETY: promised by the caller.
        Some(element) => unsafe { Checked::new(element, n, batch) }.and_then(evaluate),
        None => Err((code::NULL, argument::ELEMENT, 0)),
    };
    let (code, failures) = match outcome {
        Ok(failures) if failures.count == 0 => (code::SUCCESS, failures),
        Ok(failures) => (code::CUT_BACK, failures),
        Err((code, argument, index)) => {
            let failures = Failures {
                count: 0,
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
#[derive(Clone, Copy)]
pub(super) struct Failures {
    pub(super) count: i64,
    pub(super) argument: i32,
    pub(super) index: usize,
}

impl Failures {
    pub(super) const NONE: Self = Self {
        count: 0,
        argument: argument::NONE,
        index: 0,
    };
}

/// Evaluates all contacts on this thread.
pub(super) fn all(checked: Checked<'_>, width: Width) -> Result<Failures, Fault> {
    let memory = checked.workspace()?;
    Ok(evaluate(checked, memory, width))
}

/// Evaluates all contacts in the order of their numbers.
pub(super) fn evaluate(checked: Checked<'_>, memory: &mut [f64], width: Width) -> Failures {
    if checked.count == 0 {
        return Failures::NONE;
    }
    let element = checked.element;
    // SAFETY: promised by the caller of the batch; there is a first contact.
    let shared = unsafe { checked.parameters_of(0) };
    let mut run = Run {
        outputs: Outputs::new(&checked),
        screening: Screening::new(&checked),
        checked,
        shared,
        memory,
        failures: Failures::NONE,
    };
    match element.lanes {
        Some(kernel) if run.checked.count > 1 => kernel(&mut run, width),
        _ => one_by_one(&mut run),
    }
    run.failures
}

/// A batch at work. Made of a batch that was checked, whose caller promised its pointers.
pub struct Run<'a> {
    checked: Checked<'a>,
    pub(super) outputs: Outputs,
    /// Parameters of the first contact.
    shared: Result<&'a [f64], Fault>,
    memory: &'a mut [f64],
    pub(super) screening: Screening,
    failures: Failures,
}

impl Run<'_> {
    /// The contacts as they were checked.
    #[inline]
    pub(super) fn checked(&self) -> &Checked<'_> {
        &self.checked
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    unsafe fn one(&mut self, e: usize) -> (Status, Fault) {
        let checked = &self.checked;
        let batch = checked.batch;
        // SAFETY: promised by the caller.
        let parameters = match unsafe { checked.parameters_of(e) } {
            Ok(parameters) => parameters,
            Err(fault) => return (Status::Open, fault),
        };
        // SAFETY: promised by the caller.
        let (history, row) = unsafe {
            let row = shifted(batch.slave_row, e * (checked.nslave + 1));
            (
                checked.history_of(e),
                slave_row(checked.element, row, checked.nslave),
            )
        };
        let call = Call {
            parameters,
            history,
            slave_row: row.unwrap_or(&[]),
            wanted: wanted(batch.request),
        };
        // SAFETY: promised by the caller.
        let nodes = unsafe { checked.nodes_of(e) };
        let mut target = self.outputs.of(e);
        match (checked.element.kernel)(&call, &nodes, self.memory, &mut target) {
            Ok(summary) => {
                if batch.request & request::SYMMETRISE != 0 && !target.k.is_null() {
                    target.symmetrise();
                }
                (summary.status, (code::SUCCESS, argument::NONE, 0))
            }
            Err(error) => (error.status().unwrap_or(Status::Open), fault_of(error)),
        }
    }

    #[inline]
    pub(super) fn note(&mut self, contact: usize, status: Status, (code, argument, _): Fault) {
        let batch = self.checked.batch;
        // SAFETY: promised by the caller: one entry per contact.
        unsafe {
            *batch.status.add(contact) = status as i32;
            if !batch.code.is_null() {
                *batch.code.add(contact) = code;
            }
        }
        if code != code::SUCCESS {
            if self.failures.count == 0 {
                (self.failures.argument, self.failures.index) = (argument, contact);
            }
            self.failures.count += 1;
        }
    }
}

impl Contacts for Run<'_> {
    type Receiver<'r>
        = Target
    where
        Self: 'r;

    #[inline(always)]
    fn next(&mut self, numbers: &mut [usize; ROOM]) -> usize {
        self.next_to_evaluate(numbers)
    }

    #[inline(always)]
    fn wanted(&self) -> Wanted {
        wanted(self.checked.batch.request)
    }

    #[inline(always)]
    fn reports(&self) -> bool {
        self.checked.batch.request & (request::OUTPUT | request::HISTORY) != 0
    }

    #[inline(always)]
    fn have_same_parameters(&self) -> bool {
        self.checked.parameter_stride == 0
    }

    #[inline(always)]
    fn parameters(&self, contact: usize) -> Option<&[f64]> {
        if self.have_same_parameters() {
            return self.shared.ok();
        }
        // SAFETY: promised by the caller.
        unsafe { self.checked.parameters_of(contact).ok() }
    }

    #[inline(always)]
    fn history(&self, contact: usize) -> Option<History<'_>> {
        // SAFETY: promised by the caller.
        unsafe { self.checked.history_of(contact) }
    }

    #[inline(always)]
    fn nodes(&self, contact: usize) -> Nodes<'_> {
        // SAFETY: promised by the caller.
        unsafe { self.checked.nodes_of(contact) }
    }

    #[inline(always)]
    fn places(&self) -> Option<AllPlaces<'_>> {
        let (checked, batch) = (&self.checked, self.checked.batch);
        let places = |values: *const f64, layout: Layout| Places {
            // SAFETY: promised by the caller; the length fits the memory.
            values: unsafe { core::slice::from_raw_parts(values, layout.length) },
            contact_stride: layout.element,
            node_stride: layout.node,
        };
        let has_displacements = !batch.u.is_null();
        if checked.x.component != 1 || has_displacements && checked.u.component != 1 {
            return None;
        }
        Some(AllPlaces {
            x: places(batch.x, checked.x),
            u: has_displacements.then(|| places(batch.u, checked.u)),
            connectivity: (!batch.connectivity.is_null()).then(|| {
                let length = checked.count * checked.nodes;
                // SAFETY: promised by the caller; the length fits the memory.
                unsafe { core::slice::from_raw_parts(batch.connectivity, length) }
            }),
        })
    }

    #[inline(always)]
    fn receiver(&mut self, contact: usize) -> Target {
        self.outputs.of(contact)
    }

    #[inline(never)]
    fn evaluate_alone(&mut self, contact: usize) {
        // SAFETY: promised by the caller.
        let (status, fault) = unsafe { self.one(contact) };
        self.note(contact, status, fault);
    }

    #[inline(always)]
    fn settle(&mut self, contact: usize, status: Status) {
        if self.checked.batch.request & request::SYMMETRISE != 0 {
            let mut target = self.receiver(contact);
            if !target.k.is_null() {
                target.symmetrise();
            }
        }
        self.note(contact, status, (code::SUCCESS, argument::NONE, 0));
    }
}

impl<'a> Checked<'a> {
    /// The caller's workspace, where the element needs one and there are contacts.
    pub(super) fn workspace(&self) -> Result<&'a mut [f64], Fault> {
        if self.count == 0 {
            return Ok(&mut []);
        }
        let needed = self.element.workspace(self.nodes);
        // SAFETY: promised by the caller of the batch.
        unsafe { workspace(self.batch.workspace, self.batch.workspace_size, needed) }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    #[inline]
    unsafe fn parameters_of(&self, e: usize) -> Result<&'a [f64], Fault> {
        // SAFETY: promised by the caller.
        unsafe {
            let values = self.batch.parameters.add(e * self.parameter_stride);
            parameters(self.element, values, self.batch.parameter_count)
        }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    #[inline(always)]
    pub(super) unsafe fn history_of(&self, e: usize) -> Option<History<'a>> {
        // SAFETY: promised by the caller.
        unsafe {
            let old = shifted(self.batch.history_accepted, e * self.element.history());
            history(self.element, old)
        }
    }

    /// # Safety
    /// As [`element_evaluate_batch`].
    #[inline(always)]
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
