//! The multipliers of a history brought up to a trial state. [eq:uzawa]

use super::describe::write;
use super::safe::Outcome;
use super::sizes::{Fault, reported};
use super::{Descriptor, argument, code};
use crate::runtime::{Status, is_remembered, is_status, is_usable};

/// Values that an evaluation can have written.
fn check(element: &Descriptor, history: &[f64], name: i32) -> Result<(), Fault> {
    if let Some(entry) = history.iter().position(|&value| !is_usable(value)) {
        return Err((code::NOT_FINITE, name, entry));
    }
    let (size, p) = (element.point_history(), element.projected);
    let layout = element.history_layout();
    let sides = layout.side_at()..layout.side_at() + layout.side;
    for (number, own) in history.chunks(size.max(1)).enumerate() {
        if let Some(entry) = element.impossible_side(own) {
            return Err((code::HISTORY, name, number * size + entry));
        }
    }
    let possible = |(entry, &value): (usize, &f64)| match entry.checked_rem(size).unwrap_or(0) {
        0 => is_status(value),
        last if last + 1 == size => value <= 0.0,
        side if sides.contains(&side) => true,
        zeta if zeta <= p => element.can_be_projection(zeta - 1, value),
        anchor if anchor <= 2 * p => element.can_be_anchor(anchor - 1 - p, value),
        angle if angle >= 2 + 2 * p => is_remembered(angle - 2 - 2 * p, value),
        _ => value >= 0.0,
    };
    match history.iter().enumerate().position(|at| !possible(at)) {
        Some(entry) => Err((code::HISTORY, name, entry)),
        None => Ok(()),
    }
}

/// Sticking or sliding.
fn is_held(history: &[f64]) -> bool {
    let held = [Status::Stick, Status::Slip].map(|status| f64::from(status as i32));
    history.first().is_some_and(|status| held.contains(status))
}

/// Anchors that lie far outside once they are moved. The projections of trial and start differ by a step, so this is no
/// pair of histories of one step.
fn check_anchors(element: &Descriptor, trial: &[f64], accepted: &[f64]) -> Result<(), Fault> {
    let (size, p) = (element.point_history(), element.projected);
    for number in 0..element.points {
        let own = number * size..(number + 1) * size;
        let (Some(trial), Some(accepted)) = (trial.get(own.clone()), accepted.get(own)) else {
            continue;
        };
        for i in 0..p {
            let moved = moved_anchor(element, trial, accepted, i);
            if moved.is_some_and(|anchor| !element.can_be_anchor(i, anchor)) {
                let entry = number * size + 1 + p + i;
                return Err((code::HISTORY, argument::HISTORY_TRIAL, entry));
            }
        }
    }
    Ok(())
}

/// ζ_n − (ζ − ζ_st) of a point with friction that was and is in contact.
fn moved_anchor(element: &Descriptor, trial: &[f64], accepted: &[f64], i: usize) -> Option<f64> {
    let at = |history: &[f64], entry: usize| history.get(entry).copied().unwrap_or(0.0);
    let held = element.friction && is_held(trial) && is_held(accepted);
    let p = element.projected;
    held.then(|| at(accepted, 1 + i) - (at(trial, 1 + i) - at(trial, 1 + p + i)))
}

/// λ ← N; ζ_st ← ζ_n − (ζ − ζ_st) of a point that was in contact before. [eq:uzawa]
fn augment_point(element: &Descriptor, trial: &[f64], accepted: &mut [f64]) {
    let p = element.projected;
    for i in 0..p {
        let moved = moved_anchor(element, trial, accepted, i);
        if let (Some(anchor), Some(entry)) = (moved, accepted.get_mut(1 + p + i)) {
            *entry = anchor;
        }
    }
    if let (Some(to), Some(&multiplier)) = (accepted.last_mut(), trial.last()) {
        *to = multiplier;
    }
}

fn augmented(element: &Descriptor, trial: &[f64], accepted: &mut [f64]) -> Result<(), Fault> {
    if !element.is_augmented() {
        return Err((code::ELEMENT, argument::ELEMENT, 0));
    }
    let (length, size) = (element.history(), element.point_history());
    let trial = trial
        .get(..length)
        .ok_or((code::NULL, argument::HISTORY_TRIAL, 0))?;
    let accepted = accepted
        .get_mut(..length)
        .ok_or((code::NULL, argument::HISTORY_ACCEPTED, 0))?;
    check(element, trial, argument::HISTORY_TRIAL)?;
    check(element, accepted, argument::HISTORY_ACCEPTED)?;
    check_anchors(element, trial, accepted)?;
    for number in 0..element.points {
        let own = number * size..(number + 1) * size;
        if let (Some(trial), Some(accepted)) = (trial.get(own.clone()), accepted.get_mut(own)) {
            augment_point(element, trial, accepted);
        }
    }
    Ok(())
}

/// One step of Uzawa's iteration: `trial` is the new history of the converged evaluation with `accepted`, which
/// gets its multipliers and is otherwise the state at the start of the step. On anything but
/// [`code::SUCCESS`] it is as it was, and the outcome names the argument and its entry.
pub fn augment(element: &Descriptor, trial: &[f64], accepted: &mut [f64]) -> Outcome {
    let (code, argument, index) = match augmented(element, trial, accepted) {
        Ok(()) => (code::SUCCESS, argument::NONE, 0),
        Err(fault) => fault,
    };
    Outcome {
        code,
        status: Status::Open as i32,
        closed: 0,
        argument,
        index: reported(index),
    }
}

/// `cte_history_augment`.
///
/// # Safety
/// `element` comes from this interface or is null; the histories have its length or are null.
pub unsafe fn history_augment(
    element: *const Descriptor,
    trial: *const f64,
    accepted: *mut f64,
    fault: *mut i32,
) -> i32 {
    let pointers = [
        (element.is_null(), argument::ELEMENT),
        (trial.is_null(), argument::HISTORY_TRIAL),
        (accepted.is_null(), argument::HISTORY_ACCEPTED),
    ];
    let (code, name) = match pointers.iter().find(|(null, _)| *null) {
        Some(&(_, name)) => (code::NULL, name),
        // SAFETY: promised by the caller; none is null.
        None => unsafe {
            let element = &*element;
            let outcome = augment(
                element,
                core::slice::from_raw_parts(trial, element.history()),
                core::slice::from_raw_parts_mut(accepted, element.history()),
            );
            (outcome.code, outcome.argument)
        },
    };
    // SAFETY: promised by the caller.
    unsafe { write(fault, name) };
    code
}
