//! The multipliers of a history brought up to a trial state. [eq:uzawa]

use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::error::Error;
use crate::point::history::{History, HistoryLayout, Refused, held};

/// Refuses values that no evaluation can have written.
fn check(element: &Descriptor, history: &[f64], name: i32) -> Result<(), Error> {
    let layout = element.history_layout();
    let checked = layout.check(&element.reach(), &History::Own(history));
    checked.map_err(|refused| match refused {
        Refused::NotUsable(entry) => Error::new(code::NOT_FINITE, name, entry),
        Refused::Impossible(entry) => Error::new(code::HISTORY, name, entry),
    })
}

/// True where the point sticks or slides.
fn is_held(history: &[f64]) -> bool {
    let status = history.get(HistoryLayout::STATUS);
    status.is_some_and(|&status| held(status).is_some())
}

/// Anchors that would lie far outside once they are moved. The projections of trial and start differ by a step, so such
/// histories are not a pair of one step.
fn check_anchors(element: &Descriptor, trial: &[f64], accepted: &[f64]) -> Result<(), Error> {
    let (size, p) = (element.point_history(), element.projected);
    for number in 0..element.points {
        let own = number * size..(number + 1) * size;
        let (Some(trial), Some(accepted)) = (trial.get(own.clone()), accepted.get(own)) else {
            continue;
        };
        for i in 0..p {
            let moved = moved_anchor(element, trial, accepted, i);
            if moved.is_some_and(|anchor| !element.reach().can_be_anchor(i, anchor)) {
                let entry = number * size + element.history_layout().anchor_at() + i;
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
    let (own, anchor) = (
        HistoryLayout::PROJECTION + i,
        element.history_layout().anchor_at() + i,
    );
    held.then(|| at(accepted, own) - (at(trial, own) - at(trial, anchor)))
}

/// λ ← N; ζ_st ← ζ_n − (ζ − ζ_st) of a point that was in contact before. [eq:uzawa]
fn augment_point(element: &Descriptor, trial: &[f64], accepted: &mut [f64]) {
    let layout = element.history_layout();
    for i in 0..element.projected {
        let moved = moved_anchor(element, trial, accepted, i);
        if let (Some(anchor), Some(entry)) = (moved, accepted.get_mut(layout.anchor_at() + i)) {
            *entry = anchor;
        }
    }
    if let (Some(to), Some(&multiplier)) = (accepted.last_mut(), trial.last()) {
        *to = multiplier;
    }
}

/// One step of Uzawa's iteration: the multipliers of an accepted history become those of a trial state.
///
/// `trial` is the trial history of a converged evaluation with `accepted`. Apart from its multipliers, `accepted` keeps the
/// state at the start of the step; the anchors move with the points.
///
/// # Errors
/// `accepted` is untouched and the error names the argument: [`ELEMENT`](crate::code::ELEMENT) for an element without
/// multipliers in its history, [`NULL`](crate::code::NULL) for a history that is too short,
/// [`NOT_FINITE`](crate::code::NOT_FINITE), [`HISTORY`](crate::code::HISTORY) for one that no evaluation writes, or
/// for two that are not of one step.
///
/// # Examples
/// ```
/// use contact_elements::{Evaluation, augment, evaluate, initial_history};
/// # mod pairs {
/// #     contact_elements::contact_elements! {
/// #         /// A point and a bilinear facet.
/// #         element Augmented { slave: point; master: Quad4; normal: Penalty; enforcement: augmented; }
/// #     }
/// # }
/// # use pairs::Augmented;
/// // the slave point, 0.05 below the facet, and the corners of the facet
/// let x = [
///     0.2, -0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
/// ];
/// let element = Augmented::DESCRIPTOR;
/// let (mut accepted, mut trial) = ([0.0; 4], [0.0; 4]);
/// initial_history(element, &mut accepted)?;
/// let mut evaluation = Evaluation {
///     x: &x,
///     parameters: &[1000.0, 0.0, 1.0], // eps_n, r0, orientation
///     history: &accepted,
///     trial: &mut trial,
///     ..Evaluation::default()
/// };
/// evaluate(element, &mut evaluation)?;
/// augment(element, &trial, &mut accepted)?;
/// assert!((accepted[3] + 50.0).abs() < 1e-12); // the multiplier: compression is negative
/// # Ok::<(), contact_elements::Error>(())
/// ```
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
    for point in 0..element.points {
        let own = point * size..(point + 1) * size;
        if let (Some(trial), Some(accepted)) = (trial.get(own.clone()), accepted.get_mut(own)) {
            augment_point(element, trial, accepted);
        }
    }
    Ok(())
}
