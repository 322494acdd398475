//! Fortran 77: everything by address, no CHARACTER arguments, elements by index.

use super::describe::{element_get, element_history_init, element_info};
use super::evaluate::element_evaluate;
use super::histories::{history_augment, history_transfer};
use super::pointers::write;
use super::types::{Arguments, Info};
use crate::codes::{argument, code};
use crate::element::kernel::workspace;
use crate::registered::Registered;

/// Slave nodes of an interpolated element that this interface has scratch for.
const MOST_SLAVES: usize = 64;
/// Scratch for those and a master of up to 16 nodes in 3D.
const SCRATCH: usize = workspace(MOST_SLAVES + 16, 3, 2, true);

/// The element behind an index.
///
/// # Safety
/// `index` is null or points to an integer.
unsafe fn element(elements: &[&'static Registered], index: *const i32) -> *const Registered {
    // SAFETY: promised by the caller.
    match unsafe { index.as_ref() } {
        Some(&index) => element_get(elements, index),
        None => core::ptr::null(),
    }
}

/// The integer behind an address, 0 for null.
///
/// # Safety
/// `value` is null or points to an integer.
unsafe fn integer(value: *const i32) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { value.as_ref() }.copied().unwrap_or(0)
}

/// `CTE_F77_EVALUATE`: see the header for shapes.
///
/// # Safety
/// All addresses are valid for the shapes that the header gives.
#[allow(clippy::too_many_arguments)]
pub unsafe fn evaluate(
    elements: &[&'static Registered],
    (index, request, nnode, nslave): (*const i32, *const i32, *const i32, *const i32),
    (x, u): (*const f64, *const f64),
    (parameters, parameter_count): (*const f64, *const i32),
    (history_accepted, history_trial): (*const f64, *mut f64),
    slave_row: *const f64,
    (f, k, ldk): (*mut f64, *mut f64, *const i32),
    (output, energy): (*mut f64, *mut f64),
    (status, result): (*mut i32, *mut i32),
) {
    // SAFETY: promised by the caller.
    unsafe {
        let element = element(elements, index);
        if element.is_null() {
            write(result, code::INDEX);
            return;
        }
        let mut scratch = [0.0; SCRATCH];
        let needs_scratch = (&*element).interpolated;
        let mut arguments = Arguments::EMPTY;
        arguments.request = integer(request) as u32;
        arguments.nnode = integer(nnode);
        arguments.nslave = integer(nslave);
        arguments.parameter_count = integer(parameter_count);
        (arguments.x, arguments.u, arguments.parameters) = (x, u, parameters);
        (arguments.history_accepted, arguments.history_trial) = (history_accepted, history_trial);
        (arguments.slave_row, arguments.f, arguments.k) = (slave_row, f, k);
        (arguments.k_row_stride, arguments.k_col_stride) = (1, i64::from(integer(ldk)));
        (arguments.output, arguments.energy) = (output, energy);
        if needs_scratch {
            arguments.workspace = scratch.as_mut_ptr();
            arguments.workspace_size = SCRATCH as i64;
        }
        write(result, element_evaluate(element, &raw mut arguments));
        write(status, arguments.status);
    }
}

/// `CTE_F77_INFO`: dimension, nodes_minimum, unknowns, parameters, history, points, projected, symmetric;
/// all −1 for an index or node count that does not exist.
///
/// # Safety
/// All addresses are valid; `sizes` has 8 entries.
pub unsafe fn info(
    elements: &[&'static Registered],
    index: *const i32,
    nnode: *const i32,
    sizes: *mut i32,
) {
    if sizes.is_null() {
        return;
    }
    let mut info = Info {
        dimension: -1,
        nodes_minimum: -1,
        unknowns: -1,
        parameters: -1,
        history: -1,
        points: -1,
        projected: -1,
        symmetric: -1,
        ..Info::EMPTY
    };
    // SAFETY: promised by the caller.
    unsafe {
        element_info(element(elements, index), integer(nnode), &raw mut info);
        let values = [
            info.dimension,
            info.nodes_minimum,
            info.unknowns,
            info.parameters,
            info.history,
            info.points,
            info.projected,
            info.symmetric,
        ];
        core::ptr::copy_nonoverlapping(values.as_ptr(), sizes, values.len());
    }
}

/// `CTE_F77_HISTORY_INIT`.
///
/// # Safety
/// All addresses are valid.
pub unsafe fn history_init(
    elements: &[&'static Registered],
    index: *const i32,
    values: *mut f64,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let element = element(elements, index);
        let code = if element.is_null() {
            code::INDEX
        } else {
            element_history_init(element, values)
        };
        write(result, code);
    }
}

/// `CTE_F77_HISTORY_TRANSFER`.
///
/// # Safety
/// All addresses are valid for the shapes that the header gives.
pub unsafe fn transfer(
    elements: &[&'static Registered],
    (from, from_output, from_history): (*const i32, *const f64, *const f64),
    (to, to_output, to_history): (*const i32, *const f64, *mut f64),
    (fault, result): (*mut i32, *mut i32),
) {
    // SAFETY: promised by the caller.
    unsafe {
        let pair = [element(elements, from), element(elements, to)];
        let names = [argument::FROM, argument::TO];
        if let Some((_, &name)) = pair.iter().zip(&names).find(|(e, _)| e.is_null()) {
            write(fault, name);
            write(result, code::INDEX);
            return;
        }
        let [from, to] = pair;
        let code = history_transfer(
            from,
            from_output,
            from_history,
            to,
            to_output,
            to_history,
            fault,
        );
        write(result, code);
    }
}

/// `CTE_F77_HISTORY_AUGMENT`.
///
/// # Safety
/// All addresses are valid for the shapes that the header gives.
pub unsafe fn augment(
    elements: &[&'static Registered],
    index: *const i32,
    (trial, accepted): (*const f64, *mut f64),
    (fault, result): (*mut i32, *mut i32),
) {
    // SAFETY: promised by the caller.
    unsafe {
        let element = element(elements, index);
        if element.is_null() {
            write(fault, argument::ELEMENT);
            write(result, code::INDEX);
            return;
        }
        write(result, history_augment(element, trial, accepted, fault));
    }
}
