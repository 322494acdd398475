//! Histories: initial, carried to a neighbour, augmented.

use super::super::describe::{Registry, element_history_init};
use super::super::histories::{history_augment, history_transfer};
use super::super::pointers::write;
use super::addresses::element;
use crate::codes::argument;

/// `CTE_F77_HISTORY_INIT`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn history_init(
    elements: Registry<'_>,
    index: *const i32,
    values: *mut f64,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let code = match element(elements, index, argument::ELEMENT) {
            Ok(element) => element_history_init(element, values),
            Err(error) => error.code,
        };
        write(result, code);
    }
}

/// One side of `CTE_F77_HISTORY_TRANSFER`: an element and its output.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Side {
    pub element: *const i32,
    pub output: *const f64,
}

/// `CTE_F77_HISTORY_TRANSFER`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn transfer(
    elements: Registry<'_>,
    from: Side,
    from_history: *const f64,
    to: Side,
    to_history: *mut f64,
    fault: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let pair = element(elements, from.element, argument::FROM)
            .and_then(|from| Ok((from, element(elements, to.element, argument::TO)?)));
        let code = match pair {
            Ok((one, other)) => history_transfer(
                one,
                from.output,
                from_history,
                other,
                to.output,
                to_history,
                fault,
            ),
            Err(error) => {
                write(fault, error.argument);
                error.code
            }
        };
        write(result, code);
    }
}

/// `CTE_F77_HISTORY_AUGMENT`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn augment(
    elements: Registry<'_>,
    index: *const i32,
    trial: *const f64,
    accepted: *mut f64,
    fault: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let code = match element(elements, index, argument::ELEMENT) {
            Ok(element) => history_augment(element, trial, accepted, fault),
            Err(error) => {
                write(fault, error.argument);
                error.code
            }
        };
        write(result, code);
    }
}
