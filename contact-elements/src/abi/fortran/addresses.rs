//! Values behind addresses, and where the outcome of a call goes.

use super::super::describe::{Registry, element_get};
use super::super::pointers::write;
use super::super::types::Arguments;
use crate::codes::code;
use crate::error::Error;
use crate::registered::Registered;

/// The value behind an address, which belongs to the argument `name`.
///
/// # Safety
/// `address` is null or points to a value.
pub(super) unsafe fn value<T: Copy>(address: *const T, name: i32) -> Result<T, Error> {
    // SAFETY: promised by the caller.
    match unsafe { address.as_ref() } {
        Some(value) => Ok(*value),
        None => Err(Error::missing(name)),
    }
}

/// The element of an index, which belongs to the argument `name`.
pub(super) fn element_at(
    elements: Registry<'_>,
    index: i32,
    name: i32,
) -> Result<*const Registered, Error> {
    let element = element_get(elements, index);
    if element.is_null() {
        return Err(Error::new(code::INDEX, name, 0));
    }
    Ok(element)
}

/// The element behind the address of an index, which belongs to the argument `name`.
///
/// # Safety
/// `index` is null or points to an integer.
pub(super) unsafe fn element(
    elements: Registry<'_>,
    index: *const i32,
    name: i32,
) -> Result<*const Registered, Error> {
    // SAFETY: promised by the caller.
    element_at(elements, unsafe { value(index, name)? }, name)
}

/// Writes status, closed points, argument and index.
///
/// # Safety
/// `state` is null or has four entries.
pub(super) unsafe fn report(state: *mut i32, values: [i32; 4]) {
    if !state.is_null() {
        // SAFETY: promised by the caller.
        unsafe { core::ptr::copy_nonoverlapping(values.as_ptr(), state, values.len()) };
    }
}

/// Writes the outcome of a call whose struct could not be filled.
///
/// # Safety
/// `state` is null or has four entries, `result` one.
pub(super) unsafe fn refuse(state: *mut i32, result: *mut i32, fault: Error) {
    // SAFETY: promised by the caller.
    unsafe {
        report(state, [0, 0, fault.argument, 0]);
        write(result, fault.code);
    }
}

/// What an evaluation left in its struct.
pub(super) fn state_of(arguments: &Arguments) -> [i32; 4] {
    [
        arguments.status,
        arguments.closed_points,
        arguments.error_argument,
        arguments.error_index,
    ]
}
