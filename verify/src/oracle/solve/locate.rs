//! Projection and status of one contact point.

use num_dual::Dual64;

use super::friction;
use super::report::{PointReport, PointStatus};
use super::state::{Start, State};
use crate::oracle::angle;
use crate::oracle::error::OracleError;
use crate::oracle::kinematics::Frame;
use crate::oracle::law::Activity;
use crate::oracle::pair::{GapKind, Master, Pair};
use crate::oracle::projection::{Projection, Root, project, search};
use crate::oracle::vector::{dot, norm};

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
pub(super) fn locate<'a>(
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
    let unsigned = pair.gap != GapKind::Signed;
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
