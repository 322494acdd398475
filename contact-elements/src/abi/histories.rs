//! Histories that are carried along or brought up to a trial state.

use super::pointers::write;
use crate::augment::augment;
use crate::codes::{argument, code};
use crate::element::receiver::OUTPUT_SIZE;
use crate::error::Error;
use crate::registered::Registered;
use crate::transfer::{Entered, Left, transfer};

/// The first pointer that is null.
fn check(pointers: &[(bool, i32)]) -> Result<(), Error> {
    match pointers.iter().find(|(is_null, _)| *is_null) {
        Some(&(_, name)) => Err(Error::missing(name)),
        None => Ok(()),
    }
}

/// Writes the argument that is at fault; returns the code.
///
/// # Safety
/// `fault` is null or valid.
unsafe fn returned(result: Result<(), Error>, fault: *mut i32) -> i32 {
    let (code, name) = match result {
        Ok(()) => (code::SUCCESS, argument::NONE),
        Err(error) => (error.code, error.argument),
    };
    // SAFETY: promised by the caller.
    unsafe { write(fault, name) };
    code
}

/// `cte_history_transfer`.
///
/// # Safety
/// The elements come from this interface or are null; the other addresses are null or valid for the shapes
/// that the header gives.
pub unsafe fn history_transfer(
    from: *const Registered,
    from_output: *const f64,
    from_history: *const f64,
    to: *const Registered,
    to_output: *const f64,
    to_history: *mut f64,
    fault: *mut i32,
) -> i32 {
    let pointers = [
        (from.is_null(), argument::FROM),
        (from_output.is_null(), argument::FROM_OUTPUT),
        (from_history.is_null(), argument::FROM_HISTORY),
        (to.is_null(), argument::TO),
        (to_output.is_null(), argument::TO_OUTPUT),
        (to_history.is_null(), argument::TO_HISTORY),
    ];
    let slice = core::slice::from_raw_parts;
    // SAFETY: promised by the caller; no pointer is null.
    let result = check(&pointers).and_then(|()| unsafe {
        let (from, to) = (&*from, &*to);
        let left = Left {
            element: from,
            output: slice(from_output, OUTPUT_SIZE),
            history: slice(from_history, from.point_history()),
        };
        let entered = Entered {
            element: to,
            output: slice(to_output, OUTPUT_SIZE),
            history: core::slice::from_raw_parts_mut(to_history, to.point_history()),
        };
        transfer(left, entered).map(|_| ())
    });
    // SAFETY: promised by the caller.
    unsafe { returned(result, fault) }
}

/// `cte_history_augment`.
///
/// # Safety
/// `element` comes from this interface or is null; the histories have its length or are null.
pub unsafe fn history_augment(
    element: *const Registered,
    trial: *const f64,
    accepted: *mut f64,
    fault: *mut i32,
) -> i32 {
    let pointers = [
        (element.is_null(), argument::ELEMENT),
        (trial.is_null(), argument::HISTORY_TRIAL),
        (accepted.is_null(), argument::HISTORY_ACCEPTED),
    ];
    // SAFETY: promised by the caller; no pointer is null.
    let result = check(&pointers).and_then(|()| unsafe {
        let element = &*element;
        let trial = core::slice::from_raw_parts(trial, element.history());
        let accepted = core::slice::from_raw_parts_mut(accepted, element.history());
        augment(element, trial, accepted)
    });
    // SAFETY: promised by the caller.
    unsafe { returned(result, fault) }
}
