//! The history of a contact point: where its entries stand, and which values can stand there.
//!
//! All zero is a valid beginning for every element: open, no projection yet (the search starts at the centre), no
//! anchor, no side, no multiplier.

use core::cell::Cell;

use crate::arithmetic::{abs, is_usable};
use crate::point::values::{Status, dot};

/// Lengths of the parts of a contact point's history after the status, in their order; 0 where a part is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HistoryLayout {
    /// ζ
    pub projected: usize,
    /// Anchor and slip path, with friction.
    pub slip: usize,
    /// Anchors and paths of both angles and the regime, with rolling.
    pub rolling: usize,
    /// The normal, for edges.
    pub side: usize,
    /// The multiplier, if the history carries one.
    pub multiplier: usize,
}

/// φ0_1, φ0_2, both paths, which curves roll.
const ROLLING: usize = 5;
/// n
const SIDE: usize = 3;

impl HistoryLayout {
    /// The layout of a point with these parts.
    pub const fn new(
        projected: usize,
        has_friction: bool,
        rolls: bool,
        keeps_side: bool,
        is_augmented: bool,
    ) -> Self {
        Self {
            projected,
            slip: if has_friction { projected + 1 } else { 0 },
            rolling: if rolls { ROLLING } else { 0 },
            side: if keeps_side { SIDE } else { 0 },
            multiplier: if is_augmented { 1 } else { 0 },
        }
    }

    /// Where the status stands.
    pub const STATUS: usize = 0;

    /// Where the projection begins.
    pub const PROJECTION: usize = 1;

    /// Where the anchor begins.
    pub const fn anchor_at(&self) -> usize {
        Self::PROJECTION + self.projected
    }

    /// Where the slip path stands.
    pub const fn path_at(&self) -> usize {
        self.anchor_at() + self.projected
    }

    /// Where the part of rolling begins.
    pub const fn rolling_at(&self) -> usize {
        self.anchor_at() + self.slip
    }

    /// Where the normal begins.
    pub const fn side_at(&self) -> usize {
        self.rolling_at() + self.rolling
    }

    /// Where the multiplier stands.
    pub const fn multiplier_at(&self) -> usize {
        self.side_at() + self.side
    }

    /// Doubles of a contact point.
    pub const fn size(&self) -> usize {
        self.multiplier_at() + self.multiplier
    }

    /// Makes `to` the initial history of a point whose projection is `zeta`; with friction it is the anchor too.
    pub(crate) fn begin(&self, zeta: [f64; 2], to: &mut [f64]) {
        to.fill(0.0);
        let anchor = (self.slip > 0).then_some(self.anchor_at());
        for begin in [Some(Self::PROJECTION), anchor].into_iter().flatten() {
            let own = to.iter_mut().skip(begin).take(self.projected);
            own.zip(zeta).for_each(|(to, zeta)| *to = zeta);
        }
    }

    /// Refuses a history, of any number of points, that no evaluation can have written.
    #[inline(always)]
    pub(crate) fn check(&self, reach: &Reach, history: &History<'_>) -> Result<(), Refused> {
        for entry in 0..history.len() {
            if !is_usable(history.at(entry)) {
                return Err(Refused::NotUsable(entry));
            }
        }
        let mut first = 0;
        while let Some(own) = history.part(first, self.size()) {
            if let Some(entry) = self.first_impossible(reach, |entry| own.at(entry)) {
                return Err(Refused::Impossible(first + entry));
            }
            first += self.size();
        }
        Ok(())
    }

    /// An entry of one point's history that no evaluation writes. All entries are usable numbers. The status decides
    /// nothing without friction or a multiplier, so a host may write there what it likes.
    #[inline(always)]
    pub(crate) fn first_impossible(
        &self,
        reach: &Reach,
        at: impl Fn(usize) -> f64,
    ) -> Option<usize> {
        for i in 0..self.projected {
            if !reach.can_be_projection(i, at(Self::PROJECTION + i)) {
                return Some(Self::PROJECTION + i);
            }
        }
        let side = self.side_at();
        if self.side > 0 && !is_side(&core::array::from_fn(|k| at(side + k))) {
            return Some(side);
        }
        if self.slip == 0 && self.multiplier == 0 {
            return None;
        }
        if !is_status(at(Self::STATUS)) {
            return Some(Self::STATUS);
        }
        if self.slip > 0
            && let Some(entry) = self.first_impossible_of_slip(reach, &at)
        {
            return Some(entry);
        }
        let multiplier = self.multiplier_at();
        (self.multiplier > 0 && at(multiplier) > 0.0).then_some(multiplier)
    }

    #[inline(always)]
    fn first_impossible_of_slip(&self, reach: &Reach, at: impl Fn(usize) -> f64) -> Option<usize> {
        for i in 0..self.projected {
            if !reach.can_be_anchor(i, at(self.anchor_at() + i)) {
                return Some(self.anchor_at() + i);
            }
        }
        if at(self.path_at()) < 0.0 {
            return Some(self.path_at());
        }
        for entry in 0..self.rolling {
            if !is_remembered(entry, at(self.rolling_at() + entry)) {
                return Some(self.rolling_at() + entry);
            }
        }
        None
    }
}

/// Why a history is refused, and the entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refused {
    /// The entry is NaN or too large.
    NotUsable(usize),
    /// No evaluation writes this: the number of no status, a projection or an anchor far outside, a negative path, an
    /// angle beyond [`FARTHEST_ANGLE`], the number of no regime, no unit normal, a multiplier that pulls.
    Impossible(usize),
}

/// How far histories may lead: the middle of the domain and its extent, infinite where a bound is missing, of each
/// projected parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Where the search for a projection starts without a history.
    pub centre: [f64; 2],
    /// Extents.
    pub extent: [f64; 2],
}

/// An anchor is at most this many extents from the middle of a bounded domain.
const FARTHEST: f64 = 1e3;

/// A projection is at most this many extents from the middle of a bounded domain: Newton's method gives up before.
pub(crate) const FARTHEST_PROJECTION: f64 = 1e7;

impl Reach {
    /// True for an anchor of parameter `i` within [`FARTHEST`] extents of the middle, and for 0: nothing remembered.
    #[inline(always)]
    pub(crate) fn can_be_anchor(&self, i: usize, value: f64) -> bool {
        self.contains(i, value, FARTHEST)
    }

    /// True where all of them are anchors. A call: it is asked off the common path.
    #[inline(never)]
    pub(crate) fn can_be_anchors(&self, values: &[f64]) -> bool {
        let mut all = values.iter().enumerate();
        all.all(|(i, &value)| self.can_be_anchor(i, value))
    }

    /// True for a projection within [`FARTHEST_PROJECTION`] extents of the middle, and for 0.
    #[inline(always)]
    pub(crate) fn can_be_projection(&self, i: usize, value: f64) -> bool {
        self.contains(i, value, FARTHEST_PROJECTION)
    }

    #[inline(always)]
    fn contains(&self, i: usize, value: f64, extents: f64) -> bool {
        let (Some(centre), Some(extent)) = (self.centre.get(i), self.extent.get(i)) else {
            return false;
        };
        is_usable(value) && (abs(value - centre) <= extents * extent || value == 0.0)
    }

    /// The first parameters of the centre.
    #[inline(always)]
    pub(crate) fn centre<const P: usize>(&self) -> [f64; P] {
        core::array::from_fn(|i| self.centre.get(i).copied().unwrap_or(0.0))
    }

    /// Where the search begins: at the accepted projection. A point that is open and has all zeros there has none yet, so
    /// it begins at the centre as without a history, unless the projection is `given`.
    #[inline(always)]
    pub(crate) fn start<const P: usize>(
        &self,
        status: f64,
        projection: [f64; P],
        given: bool,
    ) -> [f64; P] {
        let centre = self.centre();
        if centre != [0.0; P] && !given && status == 0.0 && projection == [0.0; P] {
            centre
        } else {
            projection
        }
    }
}

/// The accepted history of a call: numbers that nobody else writes, or cells if the host passed one array for the
/// accepted and the trial history. All reads of a point come before its writes.
#[derive(Clone, Copy, Debug)]
pub enum History<'a> {
    /// A separate array.
    Own(&'a [f64]),
    /// An array that may be the trial history too.
    Shared(&'a [Cell<f64>]),
}

impl History<'_> {
    /// Number of entries.
    #[inline(always)]
    pub fn len(&self) -> usize {
        match self {
            Self::Own(values) => values.len(),
            Self::Shared(values) => values.len(),
        }
    }

    /// True where the element has no history.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One entry.
    #[inline(always)]
    pub fn get(&self, entry: usize) -> Option<f64> {
        match self {
            Self::Own(values) => values.get(entry).copied(),
            Self::Shared(values) => values.get(entry).map(Cell::get),
        }
    }

    /// One entry; 0 beyond the end.
    #[inline(always)]
    pub fn at(&self, entry: usize) -> f64 {
        self.get(entry).unwrap_or(0.0)
    }

    /// The entries from `first` on.
    #[inline(always)]
    pub fn from(&self, first: usize) -> Option<Self> {
        Some(match self {
            Self::Own(values) => Self::Own(values.get(first..)?),
            Self::Shared(values) => Self::Shared(values.get(first..)?),
        })
    }

    /// `count` entries from `first` on.
    #[inline(always)]
    pub fn part(&self, first: usize, count: usize) -> Option<Self> {
        Some(match self {
            Self::Own(values) => Self::Own(values.get(first..)?.get(..count)?),
            Self::Shared(values) => Self::Shared(values.get(first..)?.get(..count)?),
        })
    }
}

/// True for the number of a status.
#[inline(always)]
pub(crate) fn is_status(value: f64) -> bool {
    (0.0..=8.0).contains(&value) && f64::from(value as u8) == value
}

/// True for the status of a point in contact: closed, stick or slip.
#[inline(always)]
pub(crate) fn is_load(status: f64) -> bool {
    (1.0..=3.0).contains(&status)
}

/// Sticking or sliding, where a status says so.
#[inline(always)]
pub(crate) fn held(status: f64) -> Option<Status> {
    if status == Status::Stick as i32 as f64 {
        Some(Status::Stick)
    } else if status == Status::Slip as i32 as f64 {
        Some(Status::Slip)
    } else {
        None
    }
}

/// Largest anchor of an angle [rad].
pub(crate) const FARTHEST_ANGLE: f64 = 1e3;

/// True for an anchor, path or regime that an evaluation can have written; `entry` counts from the first of them.
#[inline]
pub(crate) fn is_remembered(entry: usize, value: f64) -> bool {
    match entry {
        0 | 1 => abs(value) <= FARTHEST_ANGLE,
        2 | 3 => value >= 0.0,
        _ => (0.0..=3.0).contains(&value) && f64::from(value as u8) == value,
    }
}

/// Most that the squared length of a remembered normal differs from 1.
const UNIT: f64 = 1e-6;

/// True for a unit normal, and for zero: no side is remembered.
#[inline]
pub(crate) fn is_side(normal: &[f64; 3]) -> bool {
    *normal == [0.0; 3] || abs(dot(normal, normal) - 1.0) <= UNIT
}
