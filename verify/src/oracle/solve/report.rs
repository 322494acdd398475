//! What an evaluation finds.

use crate::oracle::geometry::Feature;
use crate::oracle::history::FrictionHistory;
use crate::oracle::projection::Conditioning;
use crate::oracle::tangential::return_map::Regime;

/// Status of a contact point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointStatus {
    /// Projected, but the law does not act: no residual, no tangent.
    Open,
    /// The law acts.
    Closed,
    /// The closest point lies on the master's boundary (or a curve's end): nothing is added.
    Outside(Feature),
    /// No unique projection or no normal: nothing is added.
    Degenerate,
    /// The projection did not converge: nothing is added.
    NotConverged,
}

/// What was found at one contact point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointReport {
    /// Status.
    pub status: PointStatus,
    /// Projected parameters, slave's first; on the boundary if outside; NaN if the projection found no point.
    pub zeta: [f64; 2],
    /// Gap (length); if outside, distance to the boundary point minus `r0`; NaN without a projection.
    pub gap: f64,
    /// N times the factor of the angle, zero if not closed.
    pub force: f64,
    /// Unit normal; NaN if outside or without a projection.
    pub normal: [f64; 3],
    /// Weight times measure.
    pub weight: f64,
    /// Conditioning of a projection inside.
    pub conditioning: Option<Conditioning>,
    /// Newton iterations.
    pub iterations: usize,
    /// Friction of a closed point.
    pub friction: Option<FrictionReport>,
}

/// Friction of a closed point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionReport {
    /// Sticks or slips.
    pub regime: Regime,
    /// Trial traction over its bound; above one it slips.
    pub utilisation: f64,
    /// |s| since the anchor (length).
    pub distance: f64,
    /// T_i.
    pub covariant: [f64; 2],
    /// t_1, t_2 along the axes.
    pub components: [f64; 2],
    /// d_1, d_2; without an axis of the law d_1 is along b_1.
    pub axes: [[f64; 3]; 2],
    /// Energy of the spring, `Σ t_q² / (2 e_q)`.
    pub energy: f64,
    /// Moments about two curves.
    pub rolling: Option<RollingReport>,
    /// What to remember if this state is accepted.
    pub history: FrictionHistory,
}

/// Moments about both curves, slave's first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingReport {
    /// Angles (rad).
    pub angle: [f64; 2],
    /// Moments.
    pub moment: [f64; 2],
    /// Whether each spring holds.
    pub regime: [Regime; 2],
    /// Trial moments over their bounds.
    pub utilisation: [f64; 2],
    /// Angles since their anchors (rad).
    pub turned: [f64; 2],
}

/// Derivatives of the potential by the multipliers, where those are unknowns.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Couplings {
    /// R_λ, one entry per contact point.
    pub residual: Vec<f64>,
    /// ∂R/∂λ, for each contact point one entry per unknown.
    pub columns: Vec<f64>,
    /// ∂R_λ/∂x, in the same order.
    pub rows: Vec<f64>,
    /// ∂R_λ/∂λ by rows, points² entries.
    pub block: Vec<f64>,
}

impl Couplings {
    /// The four parts.
    pub fn parts(&self) -> [&[f64]; 4] {
        [&self.residual, &self.columns, &self.rows, &self.block]
    }
}

/// Result for a pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Evaluation {
    /// `Σ w J W`, plus the energy of the tangential springs; NaN if the law has no energy.
    pub energy: f64,
    /// Sum of the magnitudes that the energy is made of; they may cancel where multipliers are unknowns.
    pub energy_size: f64,
    /// R, one entry per unknown.
    pub residual: Vec<f64>,
    /// K by rows, `unknowns²` entries; empty if not asked for.
    pub tangent: Vec<f64>,
    /// K times each direction asked for.
    pub products: Vec<Vec<f64>>,
    /// By the multipliers; empty where they are no unknowns.
    pub couplings: Couplings,
    /// One per contact point.
    pub points: Vec<PointReport>,
}
