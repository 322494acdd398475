//! Error orders of elements linearised on the tangent plane: D²g is off by O(L), the whole tangent by O(L²)
//! where r0 = 0. With friction, at a given tangential force, the whole tangent and the balance of moment are off by
//! O(L). A form that agrees to rounding at L ≠ 0 means that the check sees nothing.

use serde::Serialize;

use super::interpreted::{self, Mutation};
use super::{Finding, random};
use crate::configurations::{Configuration, Generator, Wanted};
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
    /// Fitted order of the error of the whole tangent with friction.
    pub friction: Option<(f64, f64)>,
    /// Fitted order of the moment that friction leaves.
    pub moment: Option<(f64, f64)>,
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
    if subject.template.tangential.is_some() {
        frictional(&mut slopes, subject, &generator, mutation);
    }
    slopes
}

/// States that stick and states that slip; all forces stay while L goes to zero.
fn frictional(
    slopes: &mut Slopes,
    subject: &Subject,
    generator: &Generator,
    mutation: Option<Mutation>,
) {
    for (wanted, index) in [(Wanted::Stick, 0), (Wanted::Slip, 0), (Wanted::Slip, 1)] {
        // the first states that remember something
        let made = (0..20).filter_map(|k| generator.generate(wanted, 20 * index + k).ok());
        let has_force = |c: &Configuration| {
            let friction = c.points[0].friction;
            friction.is_some_and(|f| f.utilisation > 0.05)
        };
        let Some(configuration) = made.into_iter().find(has_force) else {
            slopes.finding.fail(format!("no state for {wanted:?}"));
            continue;
        };
        let (mut tangent, mut moment) = (Vec::new(), Vec::new());
        for fraction in FRACTIONS {
            let moved = loaded(&configuration, fraction);
            match frictional_errors(subject, &moved, mutation) {
                Some((distance, of_tangent, of_moment)) => {
                    tangent.push((distance, of_tangent));
                    moment.push((distance, of_moment));
                }
                None => {
                    return slopes
                        .finding
                        .fail(format!("{wanted:?} not at {fraction} L"));
                }
            }
        }
        let Slopes {
            friction,
            moment: of_moment,
            finding,
            ..
        } = slopes;
        judge(
            finding,
            friction,
            "tangent with friction",
            &tangent,
            Order::AtLeast(1.0),
        );
        judge(finding, of_moment, "moment", &moment, Order::Exactly(1.0));
    }
}

/// The foot at `fraction` of its distance; r0 keeps the gap, and with it pressure, bound and slip.
fn loaded(configuration: &Configuration, fraction: f64) -> Configuration {
    let point = configuration.points[0];
    let distance = point.gap + configuration.pair.r0;
    let mut moved = moved(configuration, &point, fraction);
    moved.start = vec![point.zeta];
    moved.pair.r0 = fraction * distance - point.gap;
    moved
}

/// Distance, error of the tangent, and moment over tangential force and arm, at a state with friction.
fn frictional_errors(
    subject: &Subject,
    configuration: &Configuration,
    mutation: Option<Mutation>,
) -> Option<(f64, f64, f64)> {
    let truth = solve::evaluate(&configuration.pair, &configuration.state()).ok()?;
    let parameters = subject.parameters(&configuration.pair);
    let history = subject.history_of(configuration);
    let input = Input {
        reference: &configuration.reference,
        displacement: &configuration.displacement,
        parameters: &parameters,
        history: &history,
        slave_row: &[],
        multipliers: configuration.pair.multipliers.unknowns(),
    };
    let answer = subject.call(&input, subject::Wanted::BOTH);
    answer.status().filter(|status| status.is_closed())?;
    let tangent = match mutation {
        None => answer.tangent.clone(),
        Some(_) => interpreted::evaluate(subject, &input, &answer, mutation).tangent,
    };
    let (_, moment) = super::invariance::imbalance(configuration, &answer.residual, [0.0; 3]);
    let largest = answer.residual.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    let report = truth.points.first()?;
    let [first, second] = report.friction?.components;
    Some((
        (report.gap + configuration.pair.r0).abs(),
        relative_error(&tangent, &truth.tangent),
        moment * largest / first.hypot(second),
    ))
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
        Order::Exactly(1.0),
    );
    if signed && configuration.pair.r0 == 0.0 {
        judge(
            &mut slopes.finding,
            &mut slopes.tangent,
            "tangent",
            &tangent,
            Order::Exactly(2.0),
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
    if pair.gap != GapKind::Signed {
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
        friction: &[],
    };
    let truth = solve::evaluate(&configuration.pair, &state).ok()?;
    let exact = solve::solve_point(&configuration.pair, &state, 0)
        .ok()?
        .gap_hessian();
    let parameters = subject.parameters(&configuration.pair);
    let history = subject.history(
        std::slice::from_ref(&point.zeta),
        &[],
        &configuration.pair.multipliers,
    );
    let row = subject.slave_row(&configuration.pair);
    let input = Input {
        reference: &configuration.reference,
        displacement: &configuration.displacement,
        parameters: &parameters,
        history: &history,
        slave_row: &row,
        multipliers: configuration.pair.multipliers.unknowns(),
    };
    let answer = subject.call(&input, subject::Wanted::BOTH);
    answer.status().filter(|status| status.is_closed())?;
    let (residual, tangent) = match mutation {
        None => (answer.residual.clone(), answer.tangent.clone()),
        Some(_) => {
            let changed = interpreted::evaluate(subject, &input, &answer, mutation);
            (changed.residual, changed.tangent)
        }
    };
    let hessian = gap_hessian(truth.points.first()?, &residual, &tangent);
    let distance = match configuration.pair.gap {
        GapKind::Signed => point.gap * fraction,
        GapKind::Distance | GapKind::Oriented => {
            (point.gap + configuration.pair.r0 / fraction) * fraction
        }
    };
    Some((
        distance.abs(),
        relative_error(&hessian, &exact),
        relative_error(&tangent, &truth.tangent),
    ))
}

/// D²g = (K/w − N' δg δg)/N with δg = R/(w N), for the linear law N = N' g.
fn gap_hessian(report: &PointReport, residual: &[f64], tangent: &[f64]) -> Vec<f64> {
    let scale = report.force * report.weight;
    let slope = report.force / report.gap;
    let n = residual.len();
    let entry = |at: usize| {
        let (i, j) = (at / n, at % n);
        let main = slope * report.weight * (residual[i] / scale) * (residual[j] / scale);
        (tangent[at] - main) / scale
    };
    (0..n * n).map(entry).collect()
}

/// What the order of an error must be.
#[derive(Clone, Copy)]
enum Order {
    Exactly(f64),
    AtLeast(f64),
}

fn judge(
    finding: &mut Finding,
    range: &mut Option<(f64, f64)>,
    what: &str,
    series: &[(f64, f64)],
    order: Order,
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
    let (fits, order) = match order {
        Order::Exactly(order) => ((slope - order).abs() <= SLOPE * order, order),
        Order::AtLeast(order) => (slope >= (1.0 - SLOPE) * order, order),
    };
    if fits {
        finding.pass();
    } else {
        finding.fail(format!("{what}: order {slope:.3} instead of {order}"));
    }
}
