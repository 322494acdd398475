//! What elements there are and what each needs.

use super::sizes::nodes_of_call;
use super::types::{ApiTable, Info, is_whole};
use super::{Descriptor, VERSION, code, kind};
use crate::runtime::Status;

/// Elements of a library.
type Registry<'a> = &'a [&'static Descriptor];

/// `cte_element_count`.
pub fn element_count(elements: Registry<'_>) -> i32 {
    elements.len() as i32
}

/// `cte_element_get`.
pub fn element_get(elements: Registry<'_>, index: i32) -> *const Descriptor {
    usize::try_from(index)
        .ok()
        .and_then(|index| elements.get(index))
        .map_or(core::ptr::null(), |element| *element as *const Descriptor)
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
    let wanted = wanted.trim_ascii_end();
    let found = elements
        .iter()
        .position(|element| element.name.trim_end_matches('\0').as_bytes() == wanted);
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
pub unsafe fn element_info(element: *const Descriptor, nnode: i32, info: *mut Info) -> i32 {
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
    element: *const Descriptor,
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
    let index = match usize::try_from(index) {
        Ok(index) if index < element.unknowns(n) => index,
        _ => return code::INDEX,
    };
    let (a, component) = element.place(n, index);
    let positions = n - element.multipliers().min(n);
    let first = positions - element.vectors.len().min(positions);
    let vector = a
        .checked_sub(first)
        .and_then(|a| element.vectors.get(a))
        .copied()
        .unwrap_or(false);
    let first = if a >= positions {
        kind::MULTIPLIER
    } else if vector {
        kind::TANGENT_VECTOR
    } else {
        kind::DISPLACEMENT
    };
    // SAFETY: promised by the caller.
    unsafe {
        *node = a as i32;
        *kind = first + component as i32;
    }
    code::SUCCESS
}

/// `cte_element_parameter`.
///
/// # Safety
/// `element` comes from this interface or is null; outputs point to their types or are null.
pub unsafe fn element_parameter(
    element: *const Descriptor,
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

/// Writes where the pointer is not null.
///
/// # Safety
/// `to` is null or valid.
pub(super) unsafe fn write<T>(to: *mut T, value: T) {
    if !to.is_null() {
        // SAFETY: promised by the caller.
        unsafe { *to = value };
    }
}

/// Least width of a window of angles [rad].
const LEAST_WINDOW: f64 = 1e-6;

/// The first parameter that cannot be used, with its return code.
#[inline]
pub(super) fn bad_parameter(element: &Descriptor, values: &[f64]) -> Option<(i32, usize)> {
    for (index, parameter) in element.parameters.iter().enumerate() {
        let Some(&value) = values.get(index) else {
            return Some((code::PARAMETER, index));
        };
        if !crate::runtime::is_usable(value) {
            return Some((code::NOT_FINITE, index));
        }
        if !parameter.allows(value) {
            return Some((code::PARAMETER, index));
        }
    }
    let at = element.angle?;
    let angle = |index: usize| values.get(index).copied().unwrap_or(0.0);
    let is_window = angle(at + 1) - angle(at) >= LEAST_WINDOW;
    (!is_window).then_some((code::PARAMETER, at + 1))
}

/// `cte_element_check_parameters`.
///
/// # Safety
/// `element` comes from this interface or is null; `parameters` points to `count` numbers, `index` to an
/// integer, or they are null.
pub unsafe fn element_check_parameters(
    element: *const Descriptor,
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
    let count = usize::try_from(count).unwrap_or(0);
    let count = count.min(element.parameters.len());
    // SAFETY: promised by the caller.
    let values = unsafe { core::slice::from_raw_parts(parameters, count) };
    match bad_parameter(element, values) {
        None => code::SUCCESS,
        Some((code, bad)) => {
            // SAFETY: promised by the caller.
            unsafe { write(index, bad as i32) };
            code
        }
    }
}

/// `cte_element_history_init`.
///
/// # Safety
/// `element` comes from this interface or is null; `history` has room for the element's history or is
/// null.
pub unsafe fn element_history_init(element: *const Descriptor, history: *mut f64) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    if history.is_null() {
        return code::NULL;
    }
    let size = element.point_history();
    for point in 0..element.points {
        // SAFETY: promised by the caller.
        unsafe {
            let entry = history.add(point * size);
            for k in 0..size {
                *entry.add(k) = 0.0;
            }
            *entry = f64::from(Status::Open as i32);
            for (i, &centre) in element.centre.iter().take(element.projected).enumerate() {
                *entry.add(1 + i) = centre;
                if element.friction {
                    *entry.add(1 + element.projected + i) = centre;
                }
            }
        }
    }
    code::SUCCESS
}

/// `cte_api`.
///
/// # Safety
/// `table` points to a struct or is null.
pub unsafe fn api(major: u32, table: *mut ApiTable, own: ApiTable) -> i32 {
    if table.is_null() {
        return code::NULL;
    }
    if major != VERSION >> 16 {
        return code::VERSION;
    }
    // SAFETY: every struct begins with its size.
    if (unsafe { (*table).struct_size } as usize) < size_of::<ApiTable>() {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    unsafe { *table = own };
    code::SUCCESS
}
