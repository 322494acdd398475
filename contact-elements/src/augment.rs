//! The multipliers of a history brought up to a trial state. [eq:uzawa]

use crate::arithmetic::is_usable;
use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::error::Error;
use crate::point::history::{is_remembered, is_status};
use crate::point::values::Status;

/// Values that an evaluation can have written.
fn check(element: &Descriptor, history: &[f64], name: i32) -> Result<(), Error> {
    if let Some(entry) = history.iter().position(|&value| !is_usable(value)) {
        return Err(Error::new(code::NOT_FINITE, name, entry));
    }
    let (size, p) = (element.point_history(), element.projected);
    let layout = element.history_layout();
    let sides = layout.side_at()..layout.side_at() + layout.side;
    for (number, own) in history.chunks(size.max(1)).enumerate() {
        if let Some(entry) = element.impossible_side(own) {
            return Err(Error::new(code::HISTORY, name, number * size + entry));
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
        Some(entry) => Err(Error::new(code::HISTORY, name, entry)),
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
fn check_anchors(element: &Descriptor, trial: &[f64], accepted: &[f64]) -> Result<(), Error> {
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
                return Err(Error::new(code::HISTORY, argument::HISTORY_TRIAL, entry));
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

/// One step of Uzawa's iteration: the multipliers of an accepted history become those of a trial state.
///
/// `trial` is the trial history of a converged evaluation with `accepted`; `accepted` stays the state at the start of
/// the step in all but its multipliers, and the anchors move with the points.
///
/// # Errors
/// `accepted` is untouched and the error names the argument: [`ELEMENT`](crate::code::ELEMENT) for an element without
/// multipliers in its history, [`NULL`](crate::code::NULL) for a history that is too short,
/// [`NOT_FINITE`](crate::code::NOT_FINITE), [`HISTORY`](crate::code::HISTORY) for one that no evaluation writes, or
/// for two that are not of one step.
pub fn augment(element: &Descriptor, trial: &[f64], accepted: &mut [f64]) -> Result<(), Error> {
    if !element.is_augmented() {
        return Err(Error::new(code::ELEMENT, argument::ELEMENT, 0));
    }
    let (length, size) = (element.history(), element.point_history());
    let trial = trial.get(..length);
    let trial = trial.ok_or(Error::missing(argument::HISTORY_TRIAL))?;
    let accepted = accepted.get_mut(..length);
    let accepted = accepted.ok_or(Error::missing(argument::HISTORY_ACCEPTED))?;
    check(element, trial, argument::HISTORY_TRIAL)?;
    check(element, accepted, argument::HISTORY_ACCEPTED)?;
    check_anchors(element, trial, accepted)?;
    let points = accepted.chunks_exact_mut(size);
    for (trial, accepted) in trial.chunks_exact(size).zip(points) {
        augment_point(element, trial, accepted);
    }
    Ok(())
}
