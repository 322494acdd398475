//! Sequences of steps of frictional contact: element and oracle each continue from their own trial history.
//!
//! The slave moves along the master, back and forth, deeper and less deep; residual, tangent and every contact
//! point are compared at each step. A sequence ends where a state is not well conditioned any more.

use serde::Serialize;

use super::errors;
use super::random;
use super::{Finding, Worst, points};
use crate::configurations::{Configuration, Generator, Stream, Wanted};
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::kinematics::Frame;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::Slave;
use crate::oracle::solve::{self, Evaluation, PointReport, PointStatus};
use crate::oracle::vector::{cross, dot, scale, sub, unit};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{SEQUENCES, relative_error};

/// Sequences tried, and steps of each.
const SEQUENCES_TRIED: u64 = 25;
const STEPS: usize = 8;
/// Longest step along the master and along the normal, in sizes.
const STRIDE: f64 = 0.04;
const LIFT: f64 = 0.01;
/// Largest turn of a curve that rolls (rad).
const TURN: f64 = 0.3;

/// What was found for one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Sequences {
    /// Residual, tangent or contact points.
    pub worst: Worst,
    /// Steps tried and failed.
    pub finding: Finding,
}

/// Tries an element with friction.
pub fn prove(subject: &Subject, seed: u64) -> Sequences {
    let mut result = Sequences::default();
    let generator = random::generator(subject, seed);
    for index in 0..SEQUENCES_TRIED {
        match generator.generate(Wanted::Stick, index) {
            Ok(configuration) => sequence(&mut result, subject, configuration, index),
            Err(error) => result.finding.fail(format!("sequence {index}: {error}")),
        }
    }
    let least = SEQUENCES_TRIED * 2;
    if result.finding.tried < least {
        let tried = result.finding.tried;
        result
            .finding
            .fail(format!("only {tried} steps could be made"));
    }
    result
}

fn sequence(
    result: &mut Sequences,
    subject: &Subject,
    mut configuration: Configuration,
    index: u64,
) {
    let mut stream = Stream::new(index, 0, 66);
    let parameters = subject.parameters(&configuration.pair);
    let row = subject.slave_row(&configuration.pair);
    let mut history = subject.history_of(&configuration);
    for step in 0..STEPS {
        let answer = subject.call(
            &Input {
                reference: &configuration.reference,
                displacement: &configuration.displacement,
                parameters: &parameters,
                history: &history,
                slave_row: &row,
                multipliers: configuration.pair.multipliers.unknowns(),
            },
            subject::Wanted::BOTH,
        );
        let Ok(truth) = solve::evaluate(&configuration.pair, &configuration.state()) else {
            return;
        };
        configuration.points.clone_from(&truth.points);
        if !Generator::is_sound(&configuration) {
            return;
        }
        let what = format!("sequence {index}, step {step}");
        match compare(subject, &configuration, &answer, &truth) {
            Ok(error) => {
                result.worst.absorb(error, index);
                result.finding.compare(&what, error, SEQUENCES);
            }
            Err(wrong) => return result.finding.fail(format!("{what}: {wrong}")),
        }
        history.clone_from(&answer.history);
        accept(&mut configuration, &truth.points);
        advance(&mut configuration, &mut stream);
    }
}

fn compare(
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    truth: &Evaluation,
) -> Result<f64, String> {
    let points = points::error(subject, configuration, &truth.points, answer)?;
    let residual = relative_error(&answer.residual, &truth.residual);
    let tangent = errors::tangent_error(subject, answer, truth, &[]);
    let couplings = errors::couplings_error(&answer.couplings, &truth.couplings);
    Ok(points.max(residual).max(tangent).max(couplings))
}

/// The oracle's own history of the step that was made.
fn accept(configuration: &mut Configuration, points: &[PointReport]) {
    let history = |point: &PointReport| match point.friction {
        Some(friction) => friction.history,
        None => FrictionHistory {
            status: Accepted::Open,
            anchor: [0.0; 2],
            slip: 0.0,
            rolling: RollingHistory::default(),
        },
    };
    configuration.friction = points.iter().map(history).collect();
    if let Multipliers::Held(values) = &mut configuration.pair.multipliers {
        *values = points.iter().map(|point| point.force).collect();
    }
    configuration.start = points.iter().map(|point| point.zeta).collect();
}

/// Turns the slave curve about the master's tangent, or about its own, so that the curves roll on one another.
fn turn(configuration: &mut Configuration, point: &PointReport, stream: &mut Stream) {
    let pair = configuration.pair.clone();
    let Slave::Curve(curve) = &pair.slave else {
        return;
    };
    let frame = Frame::new(
        &pair,
        0,
        &configuration.reference,
        &configuration.displacement,
    );
    let relative = frame.relative(&frame.nodes, point.zeta);
    let (own, _) = curve.evaluate([point.zeta[0], 0.0], &frame.nodes.slave);
    let (axis, pivot) = match stream.index(2) {
        0 => (unit(relative.tangents[0]), own),
        _ => (unit(relative.tangents[1]), sub(own, relative.position)),
    };
    let (sine, cosine) = (TURN * stream.uniform(-1.0, 1.0)).sin_cos();
    let moved = |v: [f64; 3]| {
        let across = sub(v, scale(axis, dot(axis, v)));
        let turned = cross(axis, v);
        [0, 1, 2].map(|k| (cosine - 1.0) * across[k] + sine * turned[k])
    };
    for node in 0..pair.slave_nodes() {
        let arm = match pair.slave_is_position(node) {
            true => sub(frame.nodes.slave[node], pivot),
            false => frame.nodes.slave[node],
        };
        for (k, way) in moved(arm).into_iter().enumerate() {
            configuration.displacement[3 * node + k] += way;
        }
    }
}

/// Moves the slave along the tangent plane of a closed point, and a little along its normal.
fn advance(configuration: &mut Configuration, stream: &mut Stream) {
    let closed = |point: &&PointReport| point.status == PointStatus::Closed;
    let Some(point) = configuration.points.iter().find(closed).copied() else {
        return;
    };
    let Some(friction) = point.friction else {
        return;
    };
    if friction.rolling.is_some() {
        turn(configuration, &point, stream);
    }
    let size = configuration.size;
    let along = [0; 2].map(|_| size * STRIDE * stream.uniform(-1.0, 1.0));
    let away = size * LIFT * stream.uniform(-1.0, 1.0);
    let pair = &configuration.pair;
    let [first, second] = friction.axes;
    // the second axis of a single parameter lies across the master, so a foot there would not be a foot of the pair
    let across = if pair.parameters() == 2 {
        along[1]
    } else {
        0.0
    };
    for node in (0..pair.slave_nodes()).filter(|&node| pair.slave_is_position(node)) {
        for k in 0..pair.dimension {
            configuration.displacement[pair.dimension * node + k] +=
                along[0] * first[k] + across * second[k] + away * point.normal[k];
        }
    }
}
