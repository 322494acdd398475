//! Carries the history of one contact point along to another element. [eq:transfer]

use crate::arithmetic::{abs, is_usable};
use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::element::receiver::OUTPUT_SIZE;
use crate::error::Error;
use crate::point::history::{HistoryLayout, is_status};
use crate::point::tangent_plane::TangentPlane;
use crate::point::values::{Status, dot};

/// Entries of the output that are read.
const PROJECTION: usize = 4;
const NORMAL: usize = 6;
const TANGENTS: usize = 13;
/// Most that the projections in history and output may differ, relative to 1 or themselves: the output may
/// come from a second evaluation of the accepted state.
const APART: f64 = 1e-6;
/// Most entries of a point's history.
const ROOM: usize = HistoryLayout::new(2, true, true, true, true).size();

/// One contact point of an element: its output, and its history that belongs to it.
#[derive(Clone, Copy)]
struct ContactPoint<'a> {
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

impl<'a> ContactPoint<'a> {
    /// What slices stand for that are long enough.
    fn new(
        element: &'a Descriptor,
        output: &'a [f64],
        history: &'a [f64],
        names: [i32; 3],
    ) -> Result<Self, Error> {
        let [_, of_output, of_history] = names;
        Ok(Self {
            element,
            output: output.get(..OUTPUT_SIZE).ok_or(Error::missing(of_output))?,
            history: history
                .get(..element.point_history())
                .ok_or(Error::missing(of_history))?,
            names,
        })
    }

    /// Values that an evaluation can have written, both arrays in the same one.
    fn check(&self) -> Result<(), Error> {
        let [element, output, history] = self.names;
        if !self.element.friction && !self.element.is_augmented() && !self.element.keeps_side {
            return Err(Error::new(code::ELEMENT, element, 0));
        }
        for (values, name) in [(self.output, output), (self.history, history)] {
            if let Some(entry) = values.iter().position(|&value| !is_usable(value)) {
                return Err(Error::new(code::NOT_FINITE, name, entry));
            }
        }
        let layout = self.element.history_layout();
        if !is_status(self.entry(HistoryLayout::STATUS)) {
            return Err(Error::new(code::HISTORY, history, HistoryLayout::STATUS));
        }
        let reach = self.element.reach();
        if let Some(entry) = layout.first_impossible(&reach, |entry| self.entry(entry)) {
            return Err(Error::new(code::HISTORY, history, entry));
        }
        for i in 0..layout.projected {
            let entry = HistoryLayout::PROJECTION + i;
            let (own, projected) = (self.entry(entry), self.at(PROJECTION + i));
            if abs(own - projected) > APART * abs(own).max(1.0) {
                return Err(Error::new(code::HISTORY, history, entry));
            }
        }
        Ok(())
    }

    /// Entry of the history.
    fn entry(&self, index: usize) -> f64 {
        self.history.get(index).copied().unwrap_or(0.0)
    }

    /// Projected parameter of the history.
    fn projection(&self, i: usize) -> f64 {
        self.entry(HistoryLayout::PROJECTION + i)
    }

    /// Entry of the output.
    fn at(&self, index: usize) -> f64 {
        self.output.get(index).copied().unwrap_or(0.0)
    }

    fn normal(&self) -> [f64; 3] {
        core::array::from_fn(|k| self.at(NORMAL + k))
    }

    /// The tangent plane with its normal on the side of `towards`.
    fn plane(&self, towards: [f64; 3]) -> Result<TangentPlane, Error> {
        let vector = |start: usize| core::array::from_fn(|k| self.at(start + k));
        let b = [vector(TANGENTS), vector(TANGENTS + 3)];
        let mut normal = self.normal();
        if self.element.keeps_side && dot(&normal, &towards) < 0.0 {
            normal = normal.map(|component| -component);
        }
        TangentPlane::new(b, normal, self.element.projected).ok_or(Error::cut_back(
            Status::Degenerate,
            self.names[1],
            TANGENTS,
        ))
    }

    /// Sticking or sliding; without friction in contact.
    fn is_held(&self) -> bool {
        let held: &[Status] = if self.element.friction {
            &[Status::Stick, Status::Slip]
        } else {
            &[Status::Closed]
        };
        let status = self.entry(0);
        held.iter().any(|&held| status == f64::from(held as i32))
    }

    /// Checks what the two elements must have in common.
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
        let layout = self.element.history_layout();
        let mut moved = [0.0; 2];
        for (i, moved) in moved.iter_mut().enumerate().take(layout.projected) {
            *moved = self.projection(i) - self.entry(layout.anchor_at() + i);
        }
        moved
    }
}

/// The trial history of `to`; `None` if the accepted point is not in contact, so that nothing is carried.
fn carried(from: &ContactPoint<'_>, to: &ContactPoint<'_>) -> Result<Option<[f64; ROOM]>, Error> {
    from.check()?;
    to.check()?;
    if from.kind() != to.kind() {
        return Err(Error::new(code::ELEMENT, argument::TO, 0));
    }
    if !from.is_held() {
        return Ok(None);
    }
    let (layout, own) = (to.element.history_layout(), from.element.history_layout());
    let mut history = [0.0; ROOM];
    let mut put = |entry: usize, value: f64| {
        if let Some(to) = history.get_mut(entry) {
            *to = value;
        }
    };
    for entry in 0..layout.size() {
        put(entry, to.entry(entry));
    }
    put(HistoryLayout::STATUS, from.entry(HistoryLayout::STATUS));
    if layout.slip > 0 {
        let anchor = anchor(from, to)?;
        for (i, anchor) in anchor.into_iter().enumerate().take(layout.projected) {
            put(layout.anchor_at() + i, anchor);
        }
        put(layout.path_at(), from.entry(own.path_at()));
    }
    // angles are about the curves, so they are carried unchanged if both roll
    for entry in 0..layout.rolling.min(own.rolling) {
        put(
            layout.rolling_at() + entry,
            from.entry(own.rolling_at() + entry),
        );
    }
    for entry in 0..layout.side {
        put(layout.side_at() + entry, from.entry(own.side_at() + entry));
    }
    if layout.multiplier > 0 {
        put(layout.multiplier_at(), from.entry(own.multiplier_at()));
    }
    Ok(Some(history))
}

/// The anchor on `to` that keeps the elastic slip.
fn anchor(from: &ContactPoint<'_>, to: &ContactPoint<'_>) -> Result<[f64; 2], Error> {
    let p = to.element.projected;
    let (old, new) = (from.plane(from.normal())?, to.plane(from.normal())?);
    let degenerate = Error::cut_back(Status::Degenerate, argument::TO_OUTPUT, NORMAL);
    let s = old.turned(&old.slip(from.moved()), &new);
    let moved = s.and_then(|s| new.parameters(&s)).ok_or(degenerate)?;
    let mut anchor = [0.0; 2];
    for (i, (anchor, moved)) in anchor.iter_mut().zip(moved).enumerate().take(p) {
        *anchor = to.projection(i) - moved;
        if !to.element.reach().can_be_anchor(i, *anchor) {
            return Err(degenerate);
        }
    }
    Ok(anchor)
}

/// A contact point of an element, of whose history something is carried along.
#[derive(Clone, Copy, Debug)]
pub struct Left<'a> {
    /// The element.
    pub element: &'a Descriptor,
    /// Output of the point \[[`OUTPUT_SIZE`]\].
    pub output: &'a [f64],
    /// History of the point that belongs to it.
    pub history: &'a [f64],
}

/// A contact point of the element that the projection has passed to.
#[derive(Debug)]
pub struct Entered<'a> {
    /// The element.
    pub element: &'a Descriptor,
    /// Output of the point \[[`OUTPUT_SIZE`]\].
    pub output: &'a [f64],
    /// History of the point; it came, with `output`, from an evaluation with the initial history.
    pub history: &'a mut [f64],
}

/// Carries the history of a contact point along when its projection passes from one element to a neighbour.
///
/// Status, anchor (so that the elastic slip stays), slip path, normal of edges and multiplier of the accepted point are
/// put into the history of `to`, and where both roll the angles with their paths. Returns the status that `to` has
/// then.
///
/// # Errors
/// The history of `to` is untouched and the error names the argument: [`NULL`](crate::code::NULL) for a slice that is
/// too short, [`NOT_FINITE`](crate::code::NOT_FINITE), [`HISTORY`](crate::code::HISTORY) for a history that no
/// evaluation writes or that does not belong to the output, [`ELEMENT`](crate::code::ELEMENT) for elements that
/// remember nothing or different things, [`CUT_BACK`](crate::code::CUT_BACK) for tangents that span no plane.
///
/// # Examples
/// A slave point leaves one facet and enters a neighbour; here both have the same corners.
/// ```
/// use contact_elements::{Entered, Evaluation, Left, OUTPUT_SIZE, Status, evaluate, transfer};
/// # mod pairs {
/// #     contact_elements::contact_elements! {
/// #         /// A point and a bilinear facet.
/// #         element Sliding { slave: point; master: Quad4; normal: Penalty; tangential: Coulomb; }
/// #     }
/// # }
/// # use pairs::Sliding;
/// // the slave point, 0.05 below the facet, and the corners of the facet
/// let x = [
///     0.2, -0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
/// ];
/// let parameters = [1000.0, 500.0, 0.3, 0.0, 1.0]; // eps_n, eps_t, mu, r0, orientation
/// let mut at = |accepted: &[f64], moved: f64| {
///     let (mut x, mut output, mut history) = (x, [0.0; OUTPUT_SIZE], [0.0; 6]);
///     x[0] += moved;
///     let mut evaluation = Evaluation {
///         x: &x,
///         parameters: &parameters,
///         history: accepted,
///         output: &mut output,
///         trial: &mut history,
///         ..Evaluation::default()
///     };
///     evaluate(Sliding::DESCRIPTOR, &mut evaluation).map(|_| (output, history))
/// };
/// let (_, touched) = at(&[], 0.0)?;
/// let (output, history) = at(&touched, 0.01)?; // sticks, 0.01 from its anchor
/// let (entered, mut entered_history) = at(&[], 0.01)?;
/// let left = Left { element: Sliding::DESCRIPTOR, output: &output, history: &history };
/// let entered = Entered {
///     element: Sliding::DESCRIPTOR,
///     output: &entered,
///     history: &mut entered_history,
/// };
/// assert_eq!(transfer(left, entered)?, Status::Stick);
/// assert!((entered_history[3] - 0.2).abs() < 1e-12); // the anchor came along
/// # Ok::<(), contact_elements::Error>(())
/// ```
pub fn transfer(from: Left<'_>, to: Entered<'_>) -> Result<Status, Error> {
    let left = ContactPoint::new(from.element, from.output, from.history, FROM)?;
    let entered = ContactPoint::new(to.element, to.output, to.history, TO)?;
    let carried = carried(&left, &entered)?;
    for (entry, value) in to.history.iter_mut().zip(carried.iter().flatten()) {
        *entry = *value;
    }
    let status = to.history.first().copied().unwrap_or(0.0);
    Ok(Status::of_number(status).unwrap_or(Status::Open))
}
