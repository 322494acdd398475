//! Where the entries of a contact point's history stand.

use core::cell::Cell;

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
