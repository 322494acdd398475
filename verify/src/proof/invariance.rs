//! Symmetry, balance of force and moment, invariance under rigid motion and under change of units.

use serde::Serialize;

use super::{Finding, Worst, errors, random, units};
use crate::configurations::{Configuration, Stream, Wanted};
use crate::oracle::geometry::Placement;
use crate::oracle::pair::{Master, Pair};
use crate::oracle::solve::Couplings;
use crate::oracle::vector::{dot, unit};
use crate::subject::{self, Answer, Subject};
use crate::tolerance::{BALANCE, MOTION, SYMMETRY, UNITS, relative_error};

/// States tried.
const STATES: u64 = 40;

/// Worst deviations of one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Invariance {
    /// K − Kᵀ; `None` for the current measure.
    pub symmetry: Worst,
    /// Sum of forces; `None` for rigid masters.
    pub force: Worst,
    /// Sum of moments; `None` for rigid masters. Friction on the tangent plane leaves a moment, see the slopes.
    pub moment: Worst,
    /// Turned and shifted state against turned result.
    pub motion: Worst,
    /// Millimetres against metres.
    pub units: Worst,
    /// Outcome.
    pub finding: Finding,
}

/// Tries an element on random closed states.
pub fn prove(subject: &Subject, seed: u64) -> Invariance {
    let mut result = Invariance::default();
    let generator = random::generator(subject, seed);
    for index in 0..STATES {
        let Ok(configuration) = generator.generate(wanted(subject, index), index) else {
            result
                .finding
                .fail(format!("state {index} could not be made"));
            continue;
        };
        let answer = random::call(subject, &configuration, subject::Wanted::BOTH);
        symmetry(&mut result, subject, &answer, index);
        balance(&mut result, subject, &configuration, &answer, index);
        motion(&mut result, subject, &configuration, &answer, index);
        units(&mut result, subject, &configuration, &answer, index);
    }
    result
}

/// With friction every second state slips, where the law lets it.
fn wanted(subject: &Subject, index: u64) -> Wanted {
    match &subject.template.tangential {
        None => Wanted::Closed,
        Some(tangential) if tangential.law.is_bounded() && index % 2 == 1 => Wanted::Slip,
        Some(_) => Wanted::Stick,
    }
}

fn symmetry(result: &mut Invariance, subject: &Subject, answer: &Answer, index: u64) {
    if !subject.description.descriptor.symmetric || answer.tangent.is_empty() {
        return;
    }
    let n = answer.residual.len();
    let transposed: Vec<f64> = (0..n * n)
        .map(|at| answer.tangent[at % n * n + at / n])
        .collect();
    let Couplings { rows, columns, .. } = &answer.couplings;
    let error = relative_error(&answer.tangent, &transposed).max(relative_error(rows, columns));
    result.symmetry.absorb(error, index);
    result.finding.compare("symmetry", error, SYMMETRY);
}

/// Which nodes are positions, slave first.
fn positions(pair: &Pair) -> Vec<bool> {
    let slave = (0..pair.slave_nodes()).map(|node| pair.slave_is_position(node));
    let master = (0..pair.master_nodes()).map(|node| pair.master_is_position(node));
    slave.chain(master).collect()
}

fn point(values: &[f64], node: usize, d: usize) -> [f64; 3] {
    std::array::from_fn(|k| if k < d { values[node * d + k] } else { 0.0 })
}

fn balance(
    result: &mut Invariance,
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    index: u64,
) {
    let pair = &configuration.pair;
    if matches!(
        pair.master,
        Master::Parametric { .. } | Master::Distance { .. }
    ) {
        return;
    }
    let carried = carried(configuration, answer);
    let (force, moment) = imbalance(configuration, &answer.residual, carried);
    result.force.absorb(force, index);
    result.moment.absorb(moment, index);
    result.finding.compare("balance of force", force, BALANCE);
    if !(subject.description.tangent_plane && pair.tangential.is_some()) {
        result.finding.compare("balance of moment", moment, BALANCE);
    }
}

/// Moment that whatever carries the directors of two curves takes: M_c (τ − (c/h) f), f along the director's part
/// across the curve, h and c its parts across and along.
fn carried(configuration: &Configuration, answer: &Answer) -> [f64; 3] {
    let rolling = configuration.pair.tangential.as_ref();
    let directors = rolling.and_then(|own| own.rolling.as_ref()?.directors);
    let mut sum = [0.0; 3];
    for (c, director) in directors.iter().flatten().enumerate() {
        let entry = |at: usize| answer.output[at];
        let along: [f64; 3] = std::array::from_fn(|k| [1.0, -1.0][c] * entry(13 + 3 * c + k));
        let tau = unit(along);
        let part = dot(tau, *director);
        let across: [f64; 3] = std::array::from_fn(|k| director[k] - part * tau[k]);
        let slope = part / dot(across, across);
        for k in 0..3 {
            sum[k] += entry(21 + c) * (tau[k] - slope * across[k]);
        }
    }
    sum
}

/// Sums of forces and of moments less those carried by others, relative to the largest force and the largest
/// coordinate.
pub(super) fn imbalance(
    configuration: &Configuration,
    residual: &[f64],
    carried: [f64; 3],
) -> (f64, f64) {
    let pair = &configuration.pair;
    let d = pair.dimension;
    let x = configuration.positions();
    let (mut force, mut moment) = ([0.0; 3], carried.map(|moment| -moment));
    let (mut largest, mut arm) = (0.0_f64, 0.0_f64);
    for (node, is_position) in positions(pair).into_iter().enumerate() {
        let (x, r) = (point(&x, node, d), point(residual, node, d));
        for k in 0..3 {
            if is_position {
                force[k] += r[k];
            }
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            moment[k] += x[i] * r[j] - x[j] * r[i];
            largest = largest.max(r[k].abs());
            arm = arm.max(x[k].abs());
        }
    }
    let size = |v: [f64; 3]| v.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    (size(force) / largest, size(moment) / (largest * arm))
}

/// Rotation matrix of the motion tried: about z in the plane.
fn rotation(stream: &mut Stream, d: usize) -> ([f64; 4], [[f64; 3]; 3]) {
    let quaternion = if d == 2 {
        let half = stream.uniform(-1.5, 1.5);
        [half.cos(), 0.0, 0.0, half.sin()]
    } else {
        stream.quaternion()
    };
    let frame = Placement::Spatial {
        origin: [0.0; 3],
        quaternion,
    };
    (quaternion, frame.rotation())
}

fn turned(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn motion(
    result: &mut Invariance,
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    index: u64,
) {
    let pair = &configuration.pair;
    let rigid = matches!(
        pair.master,
        Master::Parametric { .. } | Master::Distance { .. }
    );
    if rigid && !subject.description.placed {
        return;
    }
    let d = subject.description.descriptor.dimension;
    let mut stream = Stream::new(index, 1, 55);
    let (quaternion, matrix) = rotation(&mut stream, d);
    let mut shift = stream.cube(10.0 * configuration.size);
    if d == 2 {
        shift[2] = 0.0;
    }
    let mut moved = configuration.clone();
    for (node, is_position) in positions(pair).into_iter().enumerate() {
        let x = turned(&matrix, point(&configuration.reference, node, d));
        let u = turned(&matrix, point(&configuration.displacement, node, d));
        for k in 0..d {
            let along = if is_position { shift[k] } else { 0.0 };
            moved.reference[node * d + k] = x[k] + along;
            moved.displacement[node * d + k] = u[k];
        }
    }
    if let Master::Parametric { placement, .. } | Master::Distance { placement, .. } =
        &mut moved.pair.master
    {
        *placement = moved_placement(placement, quaternion, &matrix, shift);
    }
    if let Some(directors) = directors(&mut moved.pair) {
        *directors = directors.map(|director| turned(&matrix, director));
    }
    let found = random::call(subject, &moved, subject::Wanted::BOTH);
    let n = answer.residual.len();
    let turn = |values: &[f64]| -> Vec<f64> {
        (0..n / d)
            .flat_map(|node| turned(&matrix, point(values, node, d)).into_iter().take(d))
            .collect()
    };
    let mut error = relative_error(&found.residual, &turn(&answer.residual));
    if !answer.tangent.is_empty() {
        error = error.max(relative_error(
            &found.tangent,
            &turn_tensor(&answer.tangent, n, &turn),
        ));
    }
    let expected = turned_couplings(&answer.couplings, n, &turn);
    error = error.max(errors::couplings_error(&found.couplings, &expected));
    result.motion.absorb(error, index);
    result.finding.compare("rigid motion", error, MOTION);
}

/// Entries of multipliers, turned: they are not vectors themselves.
fn turned_couplings(
    couplings: &Couplings,
    n: usize,
    turn: &impl Fn(&[f64]) -> Vec<f64>,
) -> Couplings {
    let all = |values: &[f64]| values.chunks_exact(n).flat_map(turn).collect();
    Couplings {
        columns: all(&couplings.columns),
        rows: all(&couplings.rows),
        ..couplings.clone()
    }
}

/// Directors given with two curves: the host turns them with the curves.
fn directors(pair: &mut Pair) -> Option<&mut [[f64; 3]; 2]> {
    let rolling = pair.tangential.as_mut()?.rolling.as_mut()?;
    rolling.directors.as_mut()
}

/// Q K Qᵀ by turning rows, then columns.
fn turn_tensor(tangent: &[f64], n: usize, turn: &impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let rows: Vec<f64> = tangent.chunks_exact(n).flat_map(turn).collect();
    let mut whole = vec![0.0; n * n];
    for j in 0..n {
        let column: Vec<f64> = (0..n).map(|i| rows[i * n + j]).collect();
        for (i, value) in turn(&column).into_iter().enumerate() {
            whole[i * n + j] = value;
        }
    }
    whole
}

fn moved_placement(
    placement: &Placement,
    [w, x, y, z]: [f64; 4],
    matrix: &[[f64; 3]; 3],
    shift: [f64; 3],
) -> Placement {
    let origin = turned(matrix, placement.origin());
    let origin: [f64; 3] = std::array::from_fn(|k| origin[k] + shift[k]);
    match *placement {
        Placement::Identity => Placement::Identity,
        Placement::Spatial {
            quaternion: [a, b, c, e],
            ..
        } => Placement::Spatial {
            origin,
            quaternion: [
                w * a - x * b - y * c - z * e,
                w * b + x * a + y * e - z * c,
                w * c - x * e + y * a + z * b,
                w * e + x * c - y * b + z * a,
            ],
        },
        Placement::Planar {
            direction: [c, s], ..
        } => {
            let direction = turned(matrix, [c, s, 0.0]);
            Placement::Planar {
                origin: [origin[0], origin[1]],
                direction: [direction[0], direction[1]],
            }
        }
    }
}

fn units(
    result: &mut Invariance,
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    index: u64,
) {
    match units::error(subject, configuration, answer) {
        Ok(error) => {
            result.units.absorb(error, index);
            result.finding.compare("change of units", error, UNITS);
        }
        Err(what) => result.finding.fail(format!("change of units: {what}")),
    }
}
