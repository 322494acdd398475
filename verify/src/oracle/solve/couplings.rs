//! Derivatives of the potential by unknown multipliers, in hyper-dual arithmetic.

use num_dual::HyperDual64;

use super::friction::Friction;
use super::point::PointSolution;
use super::report::{Couplings, PointReport, PointStatus};
use crate::oracle::kinematics::Frame;
use crate::oracle::pair::Pair;

/// Room for a pair; `None` where its multipliers are not unknowns.
pub(super) fn empty(pair: &Pair) -> Couplings {
    if !pair.multipliers.are_unknown() {
        return Couplings::default();
    }
    let (points, unknowns) = (pair.points(), pair.unknowns());
    Couplings {
        residual: vec![0.0; points],
        columns: vec![0.0; points * unknowns],
        rows: vec![0.0; points * unknowns],
        block: vec![0.0; points * points],
    }
}

/// The potential of a point, per weight. A point that is not closed contributes through its multiplier alone.
pub(super) fn potential(frame: &Frame<'_>, report: &PointReport) -> f64 {
    let multiplier = HyperDual64::from_re(frame.enforced.multiplier.unwrap_or(0.0));
    let gap = HyperDual64::from_re(gap_for(frame, report));
    frame.enforced.potential(gap, multiplier).re
}

/// Magnitude of the two parts of a point's potential.
pub(super) fn energy_size(frame: &Frame<'_>, report: &PointReport) -> f64 {
    if !frame.pair.multipliers.are_unknown() {
        return 0.0;
    }
    let gap = HyperDual64::from_re(gap_for(frame, report));
    let value = frame.enforced.multiplier.unwrap_or(0.0);
    let whole = frame.enforced.potential(gap, HyperDual64::from_re(value));
    let constant = frame.enforced.constant(value);
    frame.weight * (constant + (whole.re + constant).abs())
}

/// The gap; beyond an edge one at which the law does not act.
fn gap_for(frame: &Frame<'_>, report: &PointReport) -> f64 {
    if report.status == PointStatus::Closed || report.status == PointStatus::Open {
        return report.gap;
    }
    let mut far = 1.0;
    while frame.enforced.force(far.into()).re <= 0.0 {
        far *= 2.0;
    }
    far
}

/// Adds a point that is not closed.
pub(super) fn open(frame: &Frame<'_>, report: &PointReport, q: usize, out: &mut Couplings) {
    let points = out.residual.len();
    if points == 0 {
        return;
    }
    let value = frame.enforced.multiplier.unwrap_or(0.0);
    let potential = frame.enforced.potential(
        HyperDual64::from_re(gap_for(frame, report)),
        HyperDual64::new(value, 1.0, 1.0, 0.0),
    );
    out.residual[q] += frame.weight * potential.eps1;
    out.block[points * q + q] += frame.weight * potential.eps1eps2;
}

/// Adds a closed point.
pub(super) fn closed(
    point: &PointSolution<'_>,
    friction: Option<&Friction>,
    q: usize,
    out: &mut Couplings,
) {
    let points = out.residual.len();
    if points == 0 {
        return;
    }
    let (law, weight) = (point.frame.enforced, point.frame.weight);
    let value = law.multiplier.unwrap_or(0.0);
    let multiplier = |first: f64, second: f64| HyperDual64::new(value, first, second, 0.0);
    let gap = |first: f64, second: f64| HyperDual64::new(point.report.gap, first, second, 0.0);
    let alone = law.potential(gap(0.0, 0.0), multiplier(1.0, 1.0));
    out.residual[q] += weight * alone.eps1;
    out.block[points * q + q] += weight * alone.eps1eps2;
    let unknowns = point.gap_gradient.len();
    for (i, &slope) in point.gap_gradient.iter().enumerate() {
        let row = law.potential(gap(0.0, slope), multiplier(1.0, 0.0));
        let column = law.potential(gap(slope, 0.0), multiplier(0.0, 1.0));
        let slid = friction.map_or(0.0, |friction| friction.coupling(i));
        out.rows[unknowns * q + i] += weight * row.eps1eps2;
        out.columns[unknowns * q + i] += weight * (column.eps1eps2 + slid);
    }
}
