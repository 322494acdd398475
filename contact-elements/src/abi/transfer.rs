//! The history of one contact point taken along to another element. [eq:transfer]

use super::describe::write;
use super::safe::Outcome;
use super::sizes::{Fault, reported};
use super::{Descriptor, OUTPUT_SIZE, argument, code};
use crate::arithmetic::abs;
use crate::runtime::{
    HistoryLayout, Status, TangentPlane, dot, is_remembered, is_status, is_usable,
};

/// Entries of the output that are read.
const PROJECTION: usize = 4;
const NORMAL: usize = 6;
const TANGENTS: usize = 13;
/// Most that the projections in history and output may differ, relative to 1 or themselves: the output may
/// come from an evaluation of the accepted state anew.
const APART: f64 = 1e-6;
/// Most entries of a point's history.
const ROOM: usize = HistoryLayout::new(2, true, true, true, true).size();

/// One contact point of an element: its output, and its history that belongs to it.
#[derive(Clone, Copy)]
struct Place<'a> {
    element: &'a Descriptor,
    output: &'a [f64],
    history: &'a [f64],
    /// How errors name the three.
    names: [i32; 3],
}

const FROM: [i32; 3] = [
    argument::FROM,
    argument::FROM_OUTPUT,
    argument::FROM_HISTORY,
];
const TO: [i32; 3] = [argument::TO, argument::TO_OUTPUT, argument::TO_HISTORY];

impl<'a> Place<'a> {
    /// What slices stand for that are long enough.
    fn new(
        element: &'a Descriptor,
        output: &'a [f64],
        history: &'a [f64],
        names: [i32; 3],
    ) -> Result<Self, Fault> {
        let [_, of_output, of_history] = names;
        Ok(Self {
            element,
            output: output
                .get(..OUTPUT_SIZE)
                .ok_or((code::NULL, of_output, 0))?,
            history: history
                .get(..element.point_history())
                .ok_or((code::NULL, of_history, 0))?,
            names,
        })
    }

    /// Values that an evaluation can have written, both arrays in the same one.
    fn check(&self) -> Result<(), Fault> {
        let [element, output, history] = self.names;
        if !self.element.friction && !self.element.is_augmented() && !self.element.keeps_side {
            return Err((code::ELEMENT, element, 0));
        }
        for (values, name) in [(self.output, output), (self.history, history)] {
            if let Some(entry) = values.iter().position(|&value| !is_usable(value)) {
                return Err((code::NOT_FINITE, name, entry));
            }
        }
        let p = self.element.projected;
        if !is_status(self.entry(0)) {
            return Err((code::HISTORY, history, 0));
        }
        if self.element.friction && self.entry(1 + 2 * p) < 0.0 {
            return Err((code::HISTORY, history, 1 + 2 * p));
        }
        if let Some(entry) = self.element.impossible_side(self.history) {
            return Err((code::HISTORY, history, entry));
        }
        let last = self.element.point_history() - 1;
        if self.element.is_augmented() && self.entry(last) > 0.0 {
            return Err((code::HISTORY, history, last));
        }
        let angles = self.element.history_layout().rolling;
        let rolling = self.history.iter().enumerate().skip(2 + 2 * p);
        for (entry, &value) in rolling.take(angles) {
            if !is_remembered(entry - 2 - 2 * p, value) {
                return Err((code::HISTORY, history, entry));
            }
        }
        for i in 0..p {
            let (own, projected) = (self.entry(1 + i), self.at(PROJECTION + i));
            let possible = self.element.can_be_projection(i, own);
            if !possible || abs(own - projected) > APART * abs(own).max(1.0) {
                return Err((code::HISTORY, history, 1 + i));
            }
        }
        Ok(())
    }

    /// Entry of the history.
    fn entry(&self, index: usize) -> f64 {
        self.history.get(index).copied().unwrap_or(0.0)
    }

    /// Entry of the output.
    fn at(&self, index: usize) -> f64 {
        self.output.get(index).copied().unwrap_or(0.0)
    }

    fn normal(&self) -> [f64; 3] {
        core::array::from_fn(|k| self.at(NORMAL + k))
    }

    /// The tangent plane with its normal on the side of `towards`.
    fn plane(&self, towards: [f64; 3]) -> Result<TangentPlane, Fault> {
        let vector = |start: usize| core::array::from_fn(|k| self.at(start + k));
        let b = [vector(TANGENTS), vector(TANGENTS + 3)];
        let mut normal = self.normal();
        if self.element.keeps_side && dot(&normal, &towards) < 0.0 {
            normal = normal.map(|component| -component);
        }
        TangentPlane::new(b, normal, self.element.projected).ok_or((
            code::CUT_BACK,
            self.names[1],
            TANGENTS,
        ))
    }

    /// Sticking or sliding; in contact where there is no friction.
    fn is_held(&self) -> bool {
        let held: &[Status] = if self.element.friction {
            &[Status::Stick, Status::Slip]
        } else {
            &[Status::Closed]
        };
        let status = self.entry(0);
        held.iter().any(|&held| status == f64::from(held as i32))
    }

    /// What the two elements must have in common.
    fn kind(&self) -> (usize, usize, bool, bool, bool) {
        let element = self.element;
        (
            element.dimension,
            element.projected,
            element.friction,
            element.is_augmented(),
            element.keeps_side,
        )
    }

    /// ζ − ζ_st
    fn moved(&self) -> [f64; 2] {
        let p = self.element.projected;
        let mut moved = [0.0; 2];
        for (i, moved) in moved.iter_mut().enumerate().take(p) {
            *moved = self.entry(1 + i) - self.entry(1 + p + i);
        }
        moved
    }
}

/// The new history of `to`; none where the accepted point is not in contact, and nothing is to be carried.
fn carried(from: &Place<'_>, to: &Place<'_>) -> Result<Option<[f64; ROOM]>, Fault> {
    from.check()?;
    to.check()?;
    if from.kind() != to.kind() {
        return Err((code::ELEMENT, argument::TO, 0));
    }
    if !from.is_held() {
        return Ok(None);
    }
    let p = to.element.projected;
    let anchor = if to.element.friction {
        anchor(from, to)?
    } else {
        [0.0; 2]
    };
    let slid = if to.element.friction { p } else { 0 };
    let path = Some(from.entry(1 + 2 * p)).filter(|_| to.element.friction);
    // angles are about the curves: they go along as they are
    let angles = if from.element.rolling { from } else { to };
    let layout = to.element.history_layout();
    let rolled = (0..layout.rolling).map(|entry| angles.entry(2 + 2 * p + entry));
    let at = from.element.history_layout().side_at();
    let side = (0..layout.side).map(|entry| from.entry(at + entry));
    let multiplier = from.history.last().copied();
    let values = [from.entry(0)]
        .into_iter()
        .chain((0..p).map(|i| to.entry(1 + i)))
        .chain(anchor.into_iter().take(slid))
        .chain(path)
        .chain(rolled)
        .chain(side)
        .chain(multiplier.filter(|_| to.element.is_augmented()));
    let mut history = [0.0; ROOM];
    for (entry, value) in history.iter_mut().zip(values) {
        *entry = value;
    }
    Ok(Some(history))
}

/// The anchor on `to` that keeps the elastic slip.
fn anchor(from: &Place<'_>, to: &Place<'_>) -> Result<[f64; 2], Fault> {
    let p = to.element.projected;
    let (old, new) = (from.plane(from.normal())?, to.plane(from.normal())?);
    let degenerate = (code::CUT_BACK, argument::TO_OUTPUT, NORMAL);
    let s = old.turned(&old.slip(from.moved()), &new);
    let moved = s.and_then(|s| new.parameters(&s)).ok_or(degenerate)?;
    let mut anchor = [0.0; 2];
    for (i, (anchor, moved)) in anchor.iter_mut().zip(moved).enumerate().take(p) {
        *anchor = to.entry(1 + i) - moved;
        if !to.element.can_be_anchor(i, *anchor) {
            return Err(degenerate);
        }
    }
    Ok(anchor)
}

/// Takes an elastic slip along when the projection passes from one element to its neighbour; output and history
/// of one contact point each. `to_history` came, with `to_output`, from an evaluation of `to` with its initial
/// history; status, anchor, slip path, normal of edges and multiplier of the accepted point are put into it, and where both roll
/// the angles with their paths. On anything but
/// [`code::SUCCESS`] it is as it was, and the outcome names the argument and its entry.
pub fn transfer(
    (from, from_output, from_history): (&Descriptor, &[f64], &[f64]),
    (to, to_output, to_history): (&Descriptor, &[f64], &mut [f64]),
) -> Outcome {
    let carried = Place::new(from, from_output, from_history, FROM)
        .and_then(|from| carried(&from, &Place::new(to, to_output, to_history, TO)?));
    let (code, argument, index) = match carried {
        Ok(history) => {
            for (entry, value) in to_history.iter_mut().zip(history.iter().flatten()) {
                *entry = *value;
            }
            (code::SUCCESS, argument::NONE, 0)
        }
        Err(fault) => fault,
    };
    let status = match (code, to_history.first()) {
        (code::SUCCESS, Some(&status)) => status as i32,
        (code::CUT_BACK, _) => Status::Degenerate as i32,
        _ => Status::Open as i32,
    };
    Outcome {
        code,
        status,
        closed: i32::from(status == Status::Stick as i32 || status == Status::Slip as i32),
        argument,
        index: reported(index),
    }
}

/// `cte_history_transfer`.
///
/// # Safety
/// The elements come from this interface or are null; the other addresses are null or valid for the shapes
/// that the header gives.
pub unsafe fn history_transfer(
    from: *const Descriptor,
    from_output: *const f64,
    from_history: *const f64,
    to: *const Descriptor,
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
    let (code, name) = match pointers.iter().find(|(null, _)| *null) {
        Some(&(_, name)) => (code::NULL, name),
        // SAFETY: promised by the caller; none is null.
        None => unsafe {
            let (from, to) = (&*from, &*to);
            let slice = core::slice::from_raw_parts;
            let to_history = core::slice::from_raw_parts_mut(to_history, to.point_history());
            let outcome = transfer(
                (
                    from,
                    slice(from_output, OUTPUT_SIZE),
                    slice(from_history, from.point_history()),
                ),
                (to, slice(to_output, OUTPUT_SIZE), to_history),
            );
            (outcome.code, outcome.argument)
        },
    };
    // SAFETY: promised by the caller.
    unsafe { write(fault, name) };
    code
}
