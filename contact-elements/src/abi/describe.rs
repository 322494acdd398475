//! What elements there are and what each needs.

use super::pointers::write;
use super::types::Info;
use super::versioned::is_whole;
use crate::codes::code;
use crate::describe::{check_parameters, find, initial_history, parameter_count, unknown};
use crate::evaluation::sizes::nodes_of_call;
use crate::registered::Registered;

/// Elements of a library.
pub(super) type Registry<'a> = &'a [&'static Registered];

/// `cte_element_count`.
pub fn element_count(elements: Registry<'_>) -> i32 {
    elements.len() as i32
}

/// `cte_element_get`.
pub fn element_get(elements: Registry<'_>, index: i32) -> *const Registered {
    usize::try_from(index)
        .ok()
        .and_then(|index| elements.get(index))
        .map_or(core::ptr::null(), |element| *element as *const Registered)
}

/// `cte_element_find`.
///
/// # Safety
/// `name` points to `length` bytes, `index` to an integer, or they are null.
pub unsafe fn element_find(
    elements: Registry<'_>,
    name: *const u8,
    length: i32,
    index: *mut i32,
) -> i32 {
    if name.is_null() || index.is_null() {
        return code::NULL;
    }
    let Ok(length) = usize::try_from(length) else {
        return code::NAME;
    };
    // SAFETY: promised by the caller.
    let wanted = unsafe { core::slice::from_raw_parts(name, length) };
    let found = find(elements, wanted);
    match found {
        Some(position) => {
            // SAFETY: promised by the caller.
            unsafe { *index = position as i32 };
            code::SUCCESS
        }
        None => code::NAME,
    }
}

/// `cte_element_info`.
///
/// # Safety
/// `element` comes from this interface or is null; `info` points to a struct or is null.
pub unsafe fn element_info(element: *const Registered, nnode: i32, info: *mut Info) -> i32 {
    // SAFETY: promised by the caller.
    let (Some(element), false) = (unsafe { element.as_ref() }, info.is_null()) else {
        return code::NULL;
    };
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(info) } {
        return code::STRUCT_SIZE;
    }
    let Some(n) = nodes_of_call(element, nnode) else {
        return code::NODE_COUNT;
    };
    let smallest = element.nodes(1) as i32;
    // SAFETY: the caller's struct is at least as large as ours.
    unsafe {
        *info = Info {
            struct_size: (*info).struct_size,
            dimension: element.dimension as i32,
            nodes_minimum: smallest,
            nodes_maximum: if element.interpolated { 0 } else { smallest },
            slave_nodes: element.slave_nodes as i32,
            master_nodes: element.master_nodes as i32,
            unknowns: element.unknowns(n) as i32,
            parameters: element.parameters.len() as i32,
            history: element.history() as i32,
            points: element.points as i32,
            projected: element.projected as i32,
            requests: element.requests(),
            symmetric: i32::from(element.symmetric),
            operations: element.operations as i32,
            workspace: element.workspace(n) as i64,
            formulation: element.formulation,
            name: element.name.as_ptr(),
            documentation: element.documentation.as_ptr(),
        };
    }
    code::SUCCESS
}

/// `cte_element_unknown`.
///
/// # Safety
/// `element` comes from this interface or is null; `node`, `kind` point to integers or are null.
pub unsafe fn element_unknown(
    element: *const Registered,
    nnode: i32,
    index: i32,
    node: *mut i32,
    kind: *mut i32,
) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    if node.is_null() || kind.is_null() {
        return code::NULL;
    }
    let Some(n) = nodes_of_call(element, nnode) else {
        return code::NODE_COUNT;
    };
    let index = usize::try_from(index).ok();
    let Some((own, number)) = index.and_then(|index| unknown(element, n, index)) else {
        return code::INDEX;
    };
    // SAFETY: promised by the caller.
    unsafe {
        *node = own as i32;
        *kind = number;
    }
    code::SUCCESS
}

/// `cte_element_parameter`.
///
/// # Safety
/// `element` comes from this interface or is null; outputs point to their types or are null.
pub unsafe fn element_parameter(
    element: *const Registered,
    index: i32,
    name: *mut *const u8,
    unit: *mut *const u8,
    lower: *mut f64,
    upper: *mut f64,
    closed: *mut i32,
) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    let parameter = usize::try_from(index)
        .ok()
        .and_then(|index| element.parameters.get(index));
    let Some(parameter) = parameter else {
        return code::INDEX;
    };
    let bits = if parameter.closed {
        i32::from(parameter.lower.is_finite()) | (i32::from(parameter.upper.is_finite()) << 1)
    } else {
        0
    };
    // SAFETY: promised by the caller; nulls are skipped.
    unsafe {
        write(name, parameter.name.as_ptr());
        write(unit, parameter.unit.as_ptr());
        write(lower, parameter.lower);
        write(upper, parameter.upper);
        write(closed, bits);
    }
    code::SUCCESS
}

/// `cte_element_check_parameters`.
///
/// # Safety
/// `element` comes from this interface or is null; `parameters` points to `count` numbers, `index` to an
/// integer, or they are null.
pub unsafe fn element_check_parameters(
    element: *const Registered,
    parameters: *const f64,
    count: i32,
    index: *mut i32,
) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    if parameters.is_null() {
        return code::NULL;
    }
    let count = parameter_count(element, count);
    // SAFETY: promised by the caller.
    let values = unsafe { core::slice::from_raw_parts(parameters, count) };
    match check_parameters(element, values) {
        Ok(()) => code::SUCCESS,
        Err(error) => {
            // SAFETY: promised by the caller.
            unsafe { write(index, error.index as i32) };
            error.code
        }
    }
}

/// `cte_element_history_init`.
///
/// # Safety
/// `element` comes from this interface or is null; `history` has room for the element's history or is
/// null.
pub unsafe fn element_history_init(element: *const Registered, history: *mut f64) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    if history.is_null() {
        return code::NULL;
    }
    // SAFETY: promised by the caller.
    let history = unsafe { core::slice::from_raw_parts_mut(history, element.history()) };
    match initial_history(element, history) {
        Ok(()) => code::SUCCESS,
        Err(error) => error.code,
    }
}
