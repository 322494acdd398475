//! Error orders of elements linearised on the tangent plane: D²g is off by O(L), the whole tangent by O(L²)
//! where r0 = 0. A form that agrees to rounding at L ≠ 0 means that the check sees nothing.

use serde::Serialize;

use super::interpreted::{self, Mutation};
use super::{Finding, random};
use crate::configurations::{Configuration, Wanted};
use crate::oracle::pair::GapKind;
use crate::oracle::solve::{self, PointReport, Start, State};
use crate::subject::{self, Input, Subject};
use crate::tolerance::{SLOPE, SLOPE_FLOOR, relative_error};

/// Distances at which the error is taken, as fractions of the state's: the foot point stays.
const FRACTIONS: [f64; 4] = [1.0, 0.25, 0.0625, 0.015_625];
/// States tried.
const STATES: u64 = 4;

/// Error orders of one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Slopes {
    /// Fitted order of the error of D²g, smallest and largest over the states.
    pub hessian: Option<(f64, f64)>,
    /// Fitted order of the error of the whole tangent where r0 = 0.
    pub tangent: Option<(f64, f64)>,
    /// L and error of D²g of the first state.
    pub series: Vec<(f64, f64)>,
    /// Outcome.
    pub finding: Finding,
}

/// Fits the orders of an element with one contact point, or of a mutant of it.
pub fn prove(subject: &Subject, seed: u64, mutation: Option<Mutation>) -> Slopes {
    let mut slopes = Slopes::default();
    let generator = random::generator(subject, seed);
    for index in 0..STATES {
        match generator.generate(Wanted::Closed, index) {
            Ok(configuration) => state(&mut slopes, subject, &configuration, mutation),
            Err(error) => slopes.finding.fail(format!("state {index}: {error}")),
        }
    }
    slopes
}

fn state(
    slopes: &mut Slopes,
    subject: &Subject,
    configuration: &Configuration,
    mutation: Option<Mutation>,
) {
    let point = configuration.points[0];
    let mut hessian = Vec::new();
    let mut tangent = Vec::new();
    for fraction in FRACTIONS {
        let moved = moved(configuration, &point, fraction);
        match errors(subject, &moved, &point, fraction, mutation) {
            Some((distance, of_hessian, of_tangent)) => {
                hessian.push((distance, of_hessian));
                tangent.push((distance, of_tangent));
            }
            None => slopes
                .finding
                .fail(format!("no evaluation at {fraction} of the distance")),
        }
    }
    if hessian.len() < FRACTIONS.len() {
        return;
    }
    let signed = configuration.pair.gap == GapKind::Signed;
    judge(
        &mut slopes.finding,
        &mut slopes.hessian,
        "D²g",
        &hessian,
        1.0,
    );
    if signed && configuration.pair.r0 == 0.0 {
        judge(
            &mut slopes.finding,
            &mut slopes.tangent,
            "tangent",
            &tangent,
            2.0,
        );
    }
    if slopes.series.is_empty() {
        slopes.series = hessian;
    }
}

/// The slave moved along the normal, so that L becomes `fraction` of what it was and the foot stays.
/// Keeps g = L − r0 negative for distances by scaling r0 alike.
fn moved(configuration: &Configuration, point: &PointReport, fraction: f64) -> Configuration {
    let mut moved = configuration.clone();
    let pair = &mut moved.pair;
    let distance = point.gap + pair.r0;
    let shift = (fraction - 1.0) * distance;
    if pair.gap == GapKind::Distance {
        pair.r0 *= fraction;
    }
    let d = pair.dimension;
    for node in 0..pair.slave_nodes() {
        if pair.slave_is_position(node) {
            for k in 0..d {
                moved.displacement[node * d + k] += shift * point.normal[k];
            }
        }
    }
    moved
}

/// Distance, error of D²g and error of the tangent at a state.
fn errors(
    subject: &Subject,
    configuration: &Configuration,
    point: &PointReport,
    fraction: f64,
    mutation: Option<Mutation>,
) -> Option<(f64, f64, f64)> {
    let state = State {
        reference: &configuration.reference,
        displacement: &configuration.displacement,
        start: Start::Given(std::slice::from_ref(&point.zeta)),
    };
    let truth = solve::evaluate(&configuration.pair, &state).ok()?;
    let exact = solve::solve_point(&configuration.pair, &state, 0)
        .ok()?
        .gap_hessian();
    let parameters = subject.parameters(&configuration.pair);
    let history = subject.history(std::slice::from_ref(&point.zeta));
    let row = subject.slave_row(&configuration.pair);
    let input = Input {
        reference: &configuration.reference,
        displacement: &configuration.displacement,
        parameters: &parameters,
        history: &history,
        slave_row: &row,
    };
    let answer = subject.call(&input, subject::Wanted::BOTH);
    answer.status().filter(|status| *status as i32 == 1)?;
    let (residual, tangent) = match mutation {
        None => (answer.residual.clone(), answer.tangent.clone()),
        Some(_) => {
            let changed = interpreted::evaluate(subject, &input, &answer, mutation);
            (changed.residual, changed.tangent)
        }
    };
    // D²g = (K/w − N' δg δg)/N with δg = R/(w N), for the linear law N = N' g
    let report = truth.points.first()?;
    let scale = report.force * report.weight;
    let slope = report.force / report.gap;
    let n = residual.len();
    let hessian: Vec<f64> = (0..n * n)
        .map(|at| {
            let (i, j) = (at / n, at % n);
            let main = slope * report.weight * (residual[i] / scale) * (residual[j] / scale);
            (tangent[at] - main) / scale
        })
        .collect();
    let distance = (point.gap + configuration.pair.r0 / fraction) * fraction;
    let distance = if configuration.pair.gap == GapKind::Signed {
        point.gap * fraction
    } else {
        distance
    };
    Some((
        distance.abs(),
        relative_error(&hessian, &exact),
        relative_error(&tangent, &truth.tangent),
    ))
}

fn judge(
    finding: &mut Finding,
    range: &mut Option<(f64, f64)>,
    what: &str,
    series: &[(f64, f64)],
    order: f64,
) {
    let largest = series.first().map_or(0.0, |first| first.1);
    if largest < SLOPE_FLOOR {
        finding.fail(format!(
            "{what}: agrees to {largest:.1e} at L ≠ 0: the check sees nothing"
        ));
        return;
    }
    let (coarse, fine) = (series[series.len() - 2], series[series.len() - 1]);
    let slope = (coarse.1 / fine.1).ln() / (coarse.0 / fine.0).ln();
    *range = Some(match *range {
        None => (slope, slope),
        Some((low, high)) => (low.min(slope), high.max(slope)),
    });
    if (slope - order).abs() <= SLOPE * order {
        finding.pass();
    } else {
        finding.fail(format!("{what}: order {slope:.3} instead of {order}"));
    }
}
