//! Energy, residual and tangent of a pair, from dual and hyper-dual sweeps.
//!
//! - [`evaluate`]: residual and full tangent; [`tangent_times`]: residual and tangent times given
//!   directions (for big elements); [`residual`], [`energy`], [`reports`]: less;
//! - [`solve_point`]: one contact point, with gradient and Hessian of its gap and of its
//!   projected parameters.
//!
//! Where the law has an energy and the measure does not move, residual and tangent are gradient
//! and Hessian of `Σ_q w_q J_q W(g_q)`. Otherwise the residual is `Σ_q w_q J_q N(g_q) dg_q`, `dg`
//! from the hyper-dual gap, and the tangent its derivative. A contact that acts at some angles only has the energy
//! `Σ_q w_q J_q f_q W(g_q)` with the factor f of [`super::angle`]. Friction adds `Σ_q w_q J_q T_i dζ^i`, rolling
//! `Σ_q w_q J_q M_c dφ_c`.

mod assemble;
mod couplings;
mod friction;
mod point;
mod rolling;

pub use assemble::{energy, evaluate, reports, residual, tangent_times};
pub use friction::{Accepted, FrictionHistory, FrictionReport};
pub use point::{HyperPoint, PointSolution, Seed, Sweep};
pub use rolling::RollingReport;

use num_dual::Dual64;

use super::angle;
use super::error::OracleError;
use super::geometry::Feature;
use super::kinematics::Frame;
use super::law::Activity;
use super::pair::{Master, Pair};
use super::projection::{Conditioning, Projection, Root, project, search};
use super::vector::{dot, norm};

/// Where the projections start.
#[derive(Debug, Clone, Copy)]
pub enum Start<'s> {
    /// Parameters (slave's first) for each contact point, or once for all.
    Given(&'s [[f64; 2]]),
    /// The best of a regular grid of samples.
    Search,
}

/// State of a pair. Positions are `reference + displacement`; both hold all unknowns: slave
/// nodes, then master nodes, components fastest.
#[derive(Debug, Clone, Copy)]
pub struct State<'s> {
    /// X (length).
    pub reference: &'s [f64],
    /// u (length).
    pub displacement: &'s [f64],
    /// Where the projections start.
    pub start: Start<'s>,
    /// What each contact point remembers; empty: contact begins at all of them. Without meaning
    /// for a pair without friction.
    pub friction: &'s [FrictionHistory],
}

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
    /// Projected parameters, slave's first; on the boundary if outside; NaN if none were found.
    pub zeta: [f64; 2],
    /// Gap (length); if outside, distance to the boundary point minus `r0`; NaN if none.
    pub gap: f64,
    /// N times the factor of the angle, zero if not closed.
    pub force: f64,
    /// Unit normal; NaN if outside or none was found.
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
    /// `Σ w J W`, plus what the tangential springs hold; NaN if the law has no energy.
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

/// Checks lengths and finiteness of a state, and the pair itself.
pub fn validate(pair: &Pair, state: &State<'_>) -> Result<(), OracleError> {
    pair.validate()?;
    for (what, array) in [
        ("reference", state.reference),
        ("displacement", state.displacement),
    ] {
        if array.len() != pair.unknowns() {
            return Err(OracleError::Length {
                what,
                expected: pair.unknowns(),
                found: array.len(),
            });
        }
        if !array.iter().all(|v| v.is_finite()) {
            return Err(OracleError::NotFinite(what));
        }
    }
    if let Start::Given(start) = state.start {
        if start.len() != 1 && start.len() != pair.points() {
            let (expected, found) = (pair.points(), start.len());
            return Err(OracleError::Length {
                what: "start",
                expected,
                found,
            });
        }
        if !start.iter().flatten().all(|v| v.is_finite()) {
            return Err(OracleError::NotFinite("start"));
        }
    }
    validate_friction(pair, state)
}

fn validate_friction(pair: &Pair, state: &State<'_>) -> Result<(), OracleError> {
    let (expected, found) = (pair.points(), state.friction.len());
    if found != 0 && found != expected {
        return Err(OracleError::Length {
            what: "friction",
            expected,
            found,
        });
    }
    let finite = |h: &FrictionHistory| h.slip.is_finite() && h.anchor.iter().all(|v| v.is_finite());
    if state.friction.iter().all(finite) {
        Ok(())
    } else {
        Err(OracleError::NotFinite("friction"))
    }
}

/// The parameters among which a start is searched and random states are drawn: the region, or the
/// window of a rigid geometry where the region is unbounded.
pub fn search_window(pair: &Pair) -> [[f64; 2]; 2] {
    let region = pair.region();
    let offset = pair.slave_parameters();
    let window = match &pair.master {
        Master::Parametric { surface, .. } => surface.window(),
        _ => [[0.0; 2]; 2],
    };
    [0, 1].map(|i: usize| region.bounds[i].unwrap_or(window[i.saturating_sub(offset)]))
}

/// Projects point `q` of a validated pair and state.
fn locate<'a>(
    pair: &'a Pair,
    state: &State<'_>,
    q: usize,
) -> Result<(Frame<'a>, Option<Root>, PointReport), OracleError> {
    let frame = Frame::new(pair, q, state.reference, state.displacement);
    let start = match state.start {
        Start::Given(given) => given[if given.len() == 1 { 0 } else { q }],
        Start::Search => search(&frame, search_window(pair)),
    };
    let nan = f64::NAN;
    let mut report = PointReport {
        status: PointStatus::NotConverged,
        zeta: [nan; 2],
        gap: nan,
        force: 0.0,
        normal: [nan; 3],
        weight: frame.weight,
        conditioning: None,
        iterations: 0,
        friction: None,
    };
    match project(&frame, start) {
        Projection::Inside(root) => {
            report.zeta = root.z;
            report.conditioning = Some(root.conditioning);
            report.iterations = root.iterations;
            let root = judge(&frame, root, &mut report)?;
            friction::judge(&frame, state.friction.get(q), &mut report);
            return Ok((frame, root, report));
        }
        Projection::Outside { feature, z } => {
            report.status = PointStatus::Outside(feature);
            report.zeta = z;
            report.gap = norm(frame.relative(&frame.nodes, z).position) - pair.r0;
        }
        Projection::Degenerate { .. } => report.status = PointStatus::Degenerate,
        Projection::NotConverged => {}
    }
    Ok((frame, None, report))
}

/// Below this fraction of the problem's size an unsigned distance has no direction.
const NO_DIRECTION: f64 = 1e-14;

/// Open, closed or degenerate.
fn judge(
    frame: &Frame<'_>,
    root: Root,
    report: &mut PointReport,
) -> Result<Option<Root>, OracleError> {
    let pair = frame.pair;
    let relative = frame.relative(&frame.nodes, root.z);
    let r = relative.position;
    let normal = frame.normal(&relative);
    let unsigned = pair.gap != super::pair::GapKind::Signed;
    let vanishes = unsigned && dot(r, r).sqrt() <= NO_DIRECTION * frame.size;
    if vanishes || !normal.iter().all(|v| v.is_finite()) {
        report.status = PointStatus::Degenerate;
        return Ok(None);
    }
    report.normal = normal;
    report.gap = frame.gap(&relative);
    let factor = angle::factor(frame, &frame.nodes, &relative);
    report.status = match frame.enforced.activity(report.gap) {
        _ if factor == 0.0 => PointStatus::Open,
        Activity::Inactive => PointStatus::Open,
        Activity::Active => {
            let force = frame.enforced.force(Dual64::from_re(report.gap)).re;
            report.force = factor * force;
            PointStatus::Closed
        }
        Activity::Infeasible => return Err(OracleError::Infeasible { gap: report.gap }),
    };
    Ok(Some(root))
}

/// One contact point with the derivatives of its gap and parameters; the law plays no part
/// except in the report's status.
pub fn solve_point<'a>(
    pair: &'a Pair,
    state: &State<'_>,
    q: usize,
) -> Result<PointSolution<'a>, OracleError> {
    validate(pair, state)?;
    if q >= pair.points() {
        return Err(OracleError::Length {
            what: "points",
            expected: pair.points(),
            found: q + 1,
        });
    }
    match locate(pair, state, q)? {
        (frame, Some(root), report) => Ok(PointSolution::new(frame, root, report)),
        _ => Err(OracleError::NoProjection),
    }
}
