//! Output and trial history of every contact point against the oracle's report, entry by entry.

use contact_elements::OUTPUT_SIZE;
use contact_elements::runtime::Status;

use crate::configurations::Configuration;
use crate::oracle::kinematics::Frame;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{Measure, Slave};
use crate::oracle::solve::{FrictionReport, PointReport, PointStatus};
use crate::oracle::tangential::return_map::Regime;
use crate::oracle::vector::norm;
use crate::subject::{Answer, Subject};

/// Entries of a point's output.
const GAP: usize = 1;
const TRACTION: usize = 2;
const WEIGHT: usize = 3;
const PROJECTION: usize = 4;
const NORMAL: usize = 6;
const TANGENTIAL: usize = 11;
const TANGENTS: usize = 13;
/// Entries of the history that rolling adds.
const ANGULAR: usize = 5;
const ANGLES: usize = 19;
const MOMENTS: usize = 21;

/// A number found, the one expected, and what their difference is measured by.
type Entry = (f64, f64, f64);

/// The element's status of a point; `None` where the oracle has no answer.
pub(super) fn status(point: &PointReport) -> Option<Status> {
    match (point.status, point.friction) {
        (PointStatus::Open, _) => Some(Status::Open),
        (PointStatus::Closed, None) => Some(Status::Closed),
        (PointStatus::Closed, Some(friction)) => Some(match friction.regime {
            Regime::Stick => Status::Stick,
            Regime::Slip => Status::Slip,
        }),
        (PointStatus::Outside(_), _) => Some(Status::Outside),
        (PointStatus::Degenerate | PointStatus::NotConverged, _) => None,
    }
}

/// Largest error of gap, projection, normal, tangents, tractions, weight and trial history against `points`, the
/// oracle's reports; in words where a status is wrong.
pub(super) fn error(
    subject: &Subject,
    configuration: &Configuration,
    points: &[PointReport],
    answer: &Answer,
) -> Result<f64, String> {
    let forces = points.iter().flat_map(|point| {
        let along = point.friction.map_or([0.0; 2], |f| f.components);
        [point.force.abs(), along[0].abs(), along[1].abs()]
    });
    let largest = forces.fold(0.0, f64::max);
    let mut worst = 0.0_f64;
    let outputs = answer.output.chunks_exact(OUTPUT_SIZE);
    let size = subject.description.descriptor.point_history();
    let histories = answer.history.chunks_exact(size);
    for (number, ((expected, found), history)) in
        points.iter().zip(outputs).zip(histories).enumerate()
    {
        let Some(status) = status(expected) else {
            continue;
        };
        if configuration.points.len() > 1 && are_unloaded(status, found, history) {
            continue;
        }
        if [found[0], history[0]] != [f64::from(status as i32); 2] {
            return Err(format!(
                "point {number}: status {} and {} instead of {status:?}",
                found[0], history[0]
            ));
        }
        let frame = Frame::new(
            &configuration.pair,
            number,
            &configuration.reference,
            &configuration.displacement,
        );
        let mut entries = loads(&frame, expected, found, largest);
        if status != Status::Outside {
            entries.extend(place(&frame, expected, found));
        }
        entries.extend(remembered(&frame, expected, history, largest));
        entries.extend(rolled(&frame, expected, found, history));
        for (found, expected, scale) in entries {
            let error = (found - expected).abs() / scale;
            worst = worst.max(if error.is_nan() { f64::INFINITY } else { error });
        }
    }
    Ok(worst)
}

/// Whether a point of an integrated slave without traction is open in one and outside in the other. From the same start
/// Newton's method and the oracle's damped one may find different feet of a point that carries nothing.
fn are_unloaded(expected: Status, found: &[f64], history: &[f64]) -> bool {
    let unloaded = [Status::Open, Status::Outside];
    let is = |value: f64| {
        unloaded
            .iter()
            .any(|status| value == f64::from(*status as i32))
    };
    unloaded.contains(&expected)
        && found[0] != f64::from(expected as i32)
        && is(found[0])
        && history[0] == found[0]
        && [TRACTION, WEIGHT].iter().all(|&entry| found[entry] == 0.0)
}

/// Tractions, relative to the largest of the element, and weight; all zero where the point is not closed.
fn loads(frame: &Frame<'_>, expected: &PointReport, found: &[f64], largest: f64) -> Vec<Entry> {
    if expected.status != PointStatus::Closed {
        let silent = [TRACTION, WEIGHT, TANGENTIAL, TANGENTIAL + 1];
        return silent.map(|entry| (found[entry], 0.0, 1.0)).to_vec();
    }
    let weight = match frame.pair.slave {
        Slave::Fixed {
            measure: Measure::Current,
            ..
        } => frame.weight * frame.measure(&frame.nodes.slave),
        _ => frame.weight,
    };
    let along = expected.friction.map_or([0.0; 2], |f| f.components);
    vec![
        (found[TRACTION], expected.force, largest),
        (found[WEIGHT], weight, weight),
        (found[TANGENTIAL], along[0], largest),
        (found[TANGENTIAL + 1], along[1], largest),
    ]
}

/// Gap, normal and projection. Parameters on closed geometries are the same up to whole turns, so the
/// relative positions that they give are compared; parameters that the pair does not have are zero.
fn place(frame: &Frame<'_>, expected: &PointReport, found: &[f64]) -> Vec<Entry> {
    let zeta = [found[PROJECTION], found[PROJECTION + 1]];
    let mut entries = vec![(found[GAP], expected.gap, frame.size)];
    let at = |zeta| frame.relative(&frame.nodes, zeta);
    let (here, foot) = (at(zeta), at(expected.zeta));
    for k in 0..3 {
        entries.push((here.position[k], foot.position[k], frame.size));
        entries.push((found[NORMAL + k], expected.normal[k], 1.0));
        for i in 0..2 {
            let scale = if i < frame.parameters {
                norm(foot.tangents[i])
            } else {
                1.0
            };
            entries.push((found[TANGENTS + 3 * i + k], foot.tangents[i][k], scale));
        }
    }
    let unused = zeta.iter().skip(frame.parameters);
    entries.extend(unused.map(|&zeta| (zeta, 0.0, 1.0)));
    entries
}

/// With friction the slip since the new anchor, as a vector, and the path, both zero where the point is not
/// closed; the multiplier that the history carries.
fn remembered(
    frame: &Frame<'_>,
    expected: &PointReport,
    history: &[f64],
    largest: f64,
) -> Vec<Entry> {
    let mut entries = slid(frame, expected, history);
    if let Multipliers::Held(_) = frame.pair.multipliers {
        let found = history.last().copied().unwrap_or(f64::NAN);
        entries.push(match expected.status {
            PointStatus::Closed => (found, expected.force, largest),
            _ => (found, 0.0, 1.0),
        });
    }
    entries
}

/// Slip and path.
fn slid(frame: &Frame<'_>, expected: &PointReport, history: &[f64]) -> Vec<Entry> {
    let p = frame.parameters;
    if frame.pair.tangential.is_none() {
        return vec![];
    }
    let pair = |from: usize| [0, 1].map(|i| if i < p { history[from + i] } else { 0.0 });
    let (zeta, anchor, path) = (pair(1), pair(1 + p), history[1 + 2 * p]);
    let Some(FrictionReport { history: next, .. }) = expected.friction else {
        let silent = anchor.into_iter().chain([path]);
        return silent.map(|entry| (entry, 0.0, 1.0)).collect();
    };
    let slip = |zeta: [f64; 2], anchor: [f64; 2]| -> [f64; 3] {
        let tangents = frame.relative(&frame.nodes, zeta).tangents;
        let way = |k: usize| (0..p).map(|i| tangents[i][k] * (zeta[i] - anchor[i])).sum();
        [0, 1, 2].map(way)
    };
    let (found, exact) = (slip(zeta, anchor), slip(expected.zeta, next.anchor));
    let mut entries = vec![(path, next.slip, frame.size.max(next.slip))];
    entries.extend((0..3).map(|k| (found[k], exact[k], frame.size)));
    entries
}

/// Angles, moments relative to the largest of the point's moments and arms, and what the angles remember; all zero
/// where the point is not closed. Angles count up to whole turns.
fn rolled(frame: &Frame<'_>, expected: &PointReport, found: &[f64], history: &[f64]) -> Vec<Entry> {
    let tangential = frame.pair.tangential.as_ref();
    let rolls = tangential.is_some_and(|tangential| tangential.rolling.is_some());
    let entries = if rolls { ANGULAR } else { 0 };
    let own = history.iter().skip(2 + 2 * frame.parameters).take(entries);
    let own: Vec<f64> = own.copied().collect();
    let friction = expected.friction;
    let Some((friction, rolling)) = friction.and_then(|f| Some((f, f.rolling?))) else {
        let silent = found[ANGLES..].iter().chain(&own);
        return silent.map(|&entry| (entry, 0.0, 1.0)).collect();
    };
    let arm = expected.force.abs() * frame.size;
    let largest = rolling.moment.iter().fold(arm, |m, v| m.max(v.abs()));
    let mut entries = Vec::new();
    let whole = |found: f64, expected: f64| {
        let apart = found - expected;
        apart - std::f64::consts::TAU * (apart / std::f64::consts::TAU).round()
    };
    let next = friction.history.rolling;
    let mut regime = 0.0;
    for c in 0..2 {
        entries.push((whole(found[ANGLES + c], rolling.angle[c]), 0.0, 1.0));
        entries.push((found[MOMENTS + c], rolling.moment[c], largest));
        entries.push((whole(own[c], next.anchor[c]), 0.0, 1.0));
        entries.push((own[2 + c], next.path[c], 1.0));
        if rolling.regime[c] == Regime::Slip {
            regime += [1.0, 2.0][c];
        }
    }
    entries.push((own[4], regime, 1.0));
    entries
}
