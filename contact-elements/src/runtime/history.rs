//! Where the entries of a contact point's history stand.

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
