//! Where the entries of a contact point's history stand.

use core::cell::Cell;

use crate::arithmetic::{abs, is_usable};
use crate::point::values::dot;

/// Lengths of the parts of a contact point's history after the status, in their order; 0 where a part is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HistoryLayout {
    /// ζ
    pub projected: usize,
    /// Anchor and slip path, with friction.
    pub slip: usize,
    /// Anchors and paths of both angles and the regime, with rolling.
    pub rolling: usize,
    /// The normal, of edges.
    pub side: usize,
    /// The multiplier, where the history carries one.
    pub multiplier: usize,
}

/// φ0_1, φ0_2, both paths, which curves roll.
const ROLLING: usize = 5;
/// n
const SIDE: usize = 3;

impl HistoryLayout {
    /// Of a point with these parts.
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

    /// Where the normal begins.
    pub const fn side_at(&self) -> usize {
        1 + self.projected + self.slip + self.rolling
    }

    /// Doubles of a contact point.
    pub const fn size(&self) -> usize {
        self.side_at() + self.side + self.multiplier
    }
}

/// The accepted history of a call: numbers that nobody else writes, or cells, where the host handed in one array for the
/// accepted and the trial history. All reads of a point come before its writes.
#[derive(Clone, Copy, Debug)]
pub enum History<'a> {
    /// An array of its own.
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

/// An anchor is at most this many extents from the middle of a bounded domain.
const FARTHEST: f64 = 1e3;

/// A projection is at most this many extents from the middle of a bounded domain: Newton's method gives up before.
pub(crate) const FARTHEST_PROJECTION: f64 = 1e7;

/// Whether an anchor lies within [`FARTHEST`] extents of the middle of a bounded domain.
#[inline(always)]
pub(crate) fn can_be_anchor(value: f64, centre: f64, extent: f64) -> bool {
    is_usable(value) && abs(value - centre) <= FARTHEST * extent
}

/// Whether all of them are anchors.
#[inline(never)]
pub(crate) fn can_be_anchors<const P: usize>(
    values: &[f64; P],
    centre: &[f64; P],
    extent: &[f64; P],
) -> bool {
    let mut possible = true;
    for i in 0..P {
        possible &= can_be_anchor(values[i], centre[i], extent[i]);
    }
    possible
}

/// Whether a projection lies within [`FARTHEST_PROJECTION`] extents of the middle of a bounded domain.
#[inline(always)]
pub(crate) fn can_be_projection(value: f64, centre: f64, extent: f64) -> bool {
    is_usable(value) && abs(value - centre) <= FARTHEST_PROJECTION * extent
}

/// The number of a status.
#[inline(always)]
pub(crate) fn is_status(value: f64) -> bool {
    (0.0..=8.0).contains(&value) && f64::from(value as u8) == value
}

/// Largest anchor of an angle [rad].
const FARTHEST_ANGLE: f64 = 1e3;

/// Anchor, path and regime that an evaluation can have written; `entry` counts from the first of them.
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

/// Whether an evaluation or a beginning can have left this.
#[inline]
pub(crate) fn is_side(normal: &[f64; 3]) -> bool {
    *normal == [0.0; 3] || abs(dot(normal, normal) - 1.0) <= UNIT
}
