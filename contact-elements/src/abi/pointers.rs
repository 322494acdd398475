//! From a host's pointers to slices, and results back.

use core::cell::Cell;

use super::types::Arguments;
use super::versioned::is_whole;
use crate::codes::{argument, code, request};
use crate::descriptor::Descriptor;
use crate::element::gather::{Coordinates, Nodes};
use crate::element::receiver::Summary;
use crate::error::Error;
use crate::evaluation::inputs::node_extent;
use crate::evaluation::sizes::{reported, spacing};
use crate::point::history::History;
use crate::point::values::Status;

/// The caller's arguments, or the code of what is wrong with their struct.
///
/// # Safety
/// `arguments` points to a struct that begins with its size, or is null.
#[inline]
pub(super) unsafe fn whole_arguments<'a>(
    arguments: *mut Arguments,
) -> Result<&'a mut Arguments, i32> {
    if arguments.is_null() {
        return Err(code::NULL);
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(arguments) } {
        return Err(code::STRUCT_SIZE);
    }
    // SAFETY: the caller's struct is at least as large as ours.
    Ok(unsafe { &mut *arguments })
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

/// `length` entries, or `None` for null.
///
/// # Safety
/// `values` is null or has so many entries.
#[inline(always)]
pub(super) unsafe fn optional<'a, T>(values: *const T, length: usize) -> Option<&'a [T]> {
    // SAFETY: promised by the caller.
    (!values.is_null()).then(|| unsafe { core::slice::from_raw_parts(values, length) })
}

/// `length` cells; empty for null.
///
/// # Safety
/// `values` is null or has so many entries.
#[inline(always)]
pub(super) unsafe fn cells<'a>(values: *mut f64, length: usize) -> &'a [Cell<f64>] {
    // SAFETY: promised by the caller; Cell<f64> has the layout of f64.
    unsafe { optional(values.cast_const().cast(), length) }.unwrap_or_default()
}

/// `length` entries that are written; empty for null.
///
/// # Safety
/// `values` is null or has so many entries, and nothing else refers to them as long as the slice lives.
#[inline(always)]
pub(super) unsafe fn outputs<'a>(values: *mut f64, length: usize) -> &'a mut [f64] {
    if values.is_null() {
        return &mut [];
    }
    // SAFETY: promised by the caller.
    unsafe { core::slice::from_raw_parts_mut(values, length) }
}

/// The accepted history, which may be the trial history too.
///
/// # Safety
/// `values` is null or has so many entries.
#[inline(always)]
pub(super) unsafe fn history<'a>(values: *const f64, length: usize) -> Option<History<'a>> {
    // SAFETY: promised by the caller; Cell<f64> has the layout of f64.
    unsafe { optional(values.cast(), length) }.map(History::Shared)
}

/// Where the coordinates of the arguments stand.
///
/// # Safety
/// `x` has n nodes at its stride, `u` likewise where it is not null.
#[inline]
pub(super) unsafe fn nodes<'a>(
    element: &Descriptor,
    arguments: &Arguments,
    n: usize,
) -> Result<Nodes<'a>, Error> {
    let d = element.dimension;
    let coordinates = |values: *const f64, (node_stride, length)| Coordinates {
        // SAFETY: promised by the caller.
        values: unsafe { core::slice::from_raw_parts(values, length) },
        offset: 0,
        node_stride,
        component_stride: 1,
    };
    let of_x = node_extent(n, d, arguments.x_node_stride, argument::X)?;
    let x = coordinates(arguments.x, of_x);
    let u = if arguments.u.is_null() {
        let fault = Error::new(code::STRIDE, argument::U, 0);
        spacing(arguments.u_node_stride, d).ok_or(fault)?;
        None
    } else {
        let of_u = node_extent(n, d, arguments.u_node_stride, argument::U)?;
        Some(coordinates(arguments.u, of_u))
    };
    Ok(Nodes {
        x,
        u,
        connectivity: None,
        count: n,
    })
}

/// The workspace, where one is needed.
///
/// # Safety
/// `memory` is null or has `size` entries.
#[inline]
pub(super) unsafe fn workspace<'a>(
    memory: *mut f64,
    size: i64,
    needed: usize,
) -> Result<&'a mut [f64], Error> {
    if needed == 0 {
        return Ok(&mut []);
    }
    if memory.is_null() {
        return Err(Error::missing(argument::WORKSPACE));
    }
    match usize::try_from(size) {
        // SAFETY: promised by the caller.
        Ok(size) if size >= needed => Ok(unsafe { outputs(memory, needed) }),
        _ => Err(Error::new(code::WORKSPACE, argument::WORKSPACE, 0)),
    }
}

/// The first requested output that is missing, after x and the parameters.
#[inline]
pub(super) fn check_pointers(arguments: &Arguments) -> Result<(), Error> {
    let bits = arguments.request;
    let missing = |bit: u32, pointer: *mut f64| bits & bit != 0 && pointer.is_null();
    let name = if arguments.x.is_null() {
        argument::X
    } else if arguments.parameters.is_null() {
        argument::PARAMETERS
    } else if missing(request::RESIDUAL, arguments.f) {
        argument::F
    } else if missing(request::TANGENT, arguments.k) {
        argument::K
    } else if missing(request::HISTORY, arguments.history_trial) {
        argument::HISTORY_TRIAL
    } else if missing(request::OUTPUT, arguments.output) {
        argument::OUTPUT
    } else if missing(request::ENERGY, arguments.energy) {
        argument::ENERGY
    } else {
        return Ok(());
    };
    Err(Error::missing(name))
}

/// The pointer, or null where the request does not ask for it.
#[inline(always)]
pub(super) fn if_wanted(bits: u32, bit: u32, pointer: *mut f64) -> *mut f64 {
    if bits & bit != 0 {
        pointer
    } else {
        core::ptr::null_mut()
    }
}

/// Writes the results into the arguments; returns the code.
#[inline]
pub(super) fn report(arguments: &mut Arguments, result: Result<Summary, Error>) -> i32 {
    arguments.dt_ratio = 1.0;
    arguments.closed_points = 0;
    arguments.status = Status::Open as i32;
    (arguments.error_argument, arguments.error_index) = (argument::NONE, 0);
    match result {
        Ok(summary) => {
            arguments.status = summary.status as i32;
            arguments.closed_points = summary.closed as i32;
            code::SUCCESS
        }
        Err(error) => {
            if let Some(status) = error.status {
                arguments.status = status as i32;
                arguments.dt_ratio = 0.5;
            }
            refuse(arguments, error)
        }
    }
}

/// Names the argument that is at fault; returns the code.
pub(super) fn refuse(arguments: &mut Arguments, error: Error) -> i32 {
    arguments.error_argument = error.argument;
    arguments.error_index = reported(error.index);
    error.code
}
