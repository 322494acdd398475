//! What a search finds.

/// What the search found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Verdict {
    /// One closest point, inside the domain or free on its boundary.
    Inside,
    /// One closest point, held by the boundary.
    Boundary,
    /// Two closest points at least, or a foot where F is not positive definite.
    NotUnique,
    /// Nothing within the reach.
    Beyond,
    /// The most boxes did not suffice.
    #[default]
    Undecided,
}

/// The closest point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Closest {
    /// The verdict.
    pub verdict: Verdict,
    /// Projected parameters.
    pub zeta: [f64; 2],
    /// |r|, length.
    pub distance: f64,
    /// 0, or the feature that holds it.
    pub feature: u8,
    /// Least eigenvalue of a⁻¹F at the foot: positive inside the domain where the projection exists and is
    /// unique nearby. [eq:admissible]
    pub definiteness: f64,
    /// Boxes looked at.
    pub boxes: u32,
    /// Newton steps, all together.
    pub steps: u32,
}

impl Closest {
    /// The answer for a point or a distance function as master.
    pub(crate) const NOTHING_PROJECTED: Self = Self {
        verdict: Verdict::Inside,
        zeta: [0.0; 2],
        distance: 0.0,
        feature: 0,
        definiteness: 1.0,
        boxes: 0,
        steps: 0,
    };
}

/// Most boxes looked at.
pub const MOST_BOXES: u32 = 20_000;
