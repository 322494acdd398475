//! Random states of every element and status against the oracle.

use contact_elements::abi::OUTPUT_SIZE;
use contact_elements::runtime::Status;
use rayon::prelude::*;
use serde::Serialize;

use super::{Finding, Worst};
use crate::configurations::{Configuration, Freedom, GenerateError, Generator, Stream, Wanted};
use crate::oracle::solve::{self, Evaluation, PointStatus};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{ENERGY, RANDOM, relative_error};

/// Work of a full hyper-dual tangent (entries times points) above which random directions are taken.
const FULL_WORK: usize = 250;
/// Directions then.
const DIRECTIONS: usize = 2;

/// What was found for one element and wanted status.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Random {
    /// Residual.
    pub residual: Worst,
    /// Tangent; nothing for residual-only and tangent-plane elements.
    pub tangent: Worst,
    /// Energy.
    pub energy: Worst,
    /// Statuses that the element gave, by number.
    pub statuses: std::collections::BTreeMap<i32, u64>,
    /// Features beyond which projections lay.
    pub features: std::collections::BTreeMap<u8, u64>,
    /// States tried and failed.
    pub finding: Finding,
}

impl Random {
    fn merge(mut self, other: Self) -> Self {
        self.residual.merge(&other.residual);
        self.tangent.merge(&other.tangent);
        self.energy.merge(&other.energy);
        for (status, count) in other.statuses {
            *self.statuses.entry(status).or_default() += count;
        }
        for (feature, count) in other.features {
            *self.features.entry(feature).or_default() += count;
        }
        self.finding.merge(other.finding);
        self
    }
}

/// The generator of a subject's states.
pub fn generator(subject: &Subject, seed: u64) -> Generator {
    Generator {
        template: subject.template.clone(),
        freedom: Freedom::ALL,
        seed,
    }
}

/// Tries `states` states built for `wanted`; `None` where the pair cannot have that status.
pub fn prove(subject: &Subject, wanted: Wanted, states: u64, seed: u64) -> Option<Random> {
    let generator = generator(subject, seed);
    if matches!(
        generator.generate(wanted, 0),
        Err(GenerateError::NeverOutside)
    ) {
        return None;
    }
    let result = (0..states)
        .into_par_iter()
        .map(|index| one(subject, &generator, wanted, index))
        .reduce(Random::default, Random::merge);
    Some(result)
}

fn one(subject: &Subject, generator: &Generator, wanted: Wanted, index: u64) -> Random {
    let mut random = Random::default();
    let configuration = match generator.generate(wanted, index) {
        Ok(configuration) => configuration,
        Err(error) => {
            random
                .finding
                .fail(format!("state {index} could not be made: {error}"));
            return random;
        }
    };
    let answer = call(subject, &configuration, subject::Wanted::BOTH);
    record(&mut random, &answer);
    match wanted {
        Wanted::Closed => closed(&mut random, subject, &configuration, &answer, index),
        Wanted::Open => not_closed(
            &mut random,
            &answer,
            index,
            &[Status::Open, Status::Outside],
        ),
        // beyond an edge the unconstrained stationary point need not exist
        Wanted::Outside if !any_closed(&configuration) => not_closed(
            &mut random,
            &answer,
            index,
            &[
                Status::Open,
                Status::Outside,
                Status::NotConverged,
                Status::NotUnique,
            ],
        ),
        Wanted::Outside => closed(&mut random, subject, &configuration, &answer, index),
    }
    random
}

fn any_closed(configuration: &Configuration) -> bool {
    let mut points = configuration.points.iter();
    points.any(|point| point.status == PointStatus::Closed)
}

/// Calls the element at a configuration.
pub fn call(subject: &Subject, configuration: &Configuration, wanted: subject::Wanted) -> Answer {
    subject.call(
        &Input {
            reference: &configuration.reference,
            displacement: &configuration.displacement,
            parameters: &subject.parameters(&configuration.pair),
            history: &subject.history(&configuration.start),
            slave_row: &subject.slave_row(&configuration.pair),
        },
        wanted,
    )
}

fn record(random: &mut Random, answer: &Answer) {
    if let Some(status) = answer.status() {
        *random.statuses.entry(status as i32).or_default() += 1;
    }
    for point in answer.output.chunks_exact(OUTPUT_SIZE) {
        if point[0] == f64::from(Status::Outside as i32) {
            *random.features.entry(point[10] as u8).or_default() += 1;
        }
    }
}

fn not_closed(random: &mut Random, answer: &Answer, index: u64, allowed: &[Status]) {
    let Some(status) = answer.status() else {
        random
            .finding
            .fail(format!("state {index}: {:?}", answer.outcome));
        return;
    };
    let cut_back = !matches!(status, Status::Open | Status::Outside | Status::Closed);
    let silent = if cut_back {
        answer.is_untouched()
    } else {
        answer.is_zero()
    };
    if allowed.contains(&status) && silent {
        random.finding.pass();
    } else {
        random.finding.fail(format!(
            "state {index}: status {status:?}, outputs silent: {silent}"
        ));
    }
}

fn closed(
    random: &mut Random,
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    index: u64,
) {
    let directions = directions(subject, index);
    let truth = truth(configuration, &directions);
    let truth = match truth {
        Ok(truth) => truth,
        Err(error) => {
            random
                .finding
                .fail(format!("state {index}: the oracle gave no answer: {error}"));
            return;
        }
    };
    if answer.status() != Some(Status::Closed) {
        random.finding.fail(format!(
            "state {index}: {:?} instead of closed",
            answer.outcome
        ));
        return;
    }
    if let Some(wrong) = wrong_point(&truth, answer) {
        random.finding.fail(format!("state {index}: {wrong}"));
        return;
    }
    let residual = relative_error(&answer.residual, &truth.residual);
    random.residual.absorb(residual, index);
    let energy = energy_error(subject, answer, &truth);
    random.energy.absorb(energy, index);
    let tangent = tangent_error(subject, answer, &truth, &directions);
    random.tangent.absorb(tangent, index);
    let worst = residual.max(tangent).max(energy * (RANDOM / ENERGY));
    random
        .finding
        .compare(&format!("state {index}"), worst, RANDOM);
}

/// Random directions for large elements; none where the full tangent is taken.
fn directions(subject: &Subject, index: u64) -> Vec<Vec<f64>> {
    let unknowns = subject.template.unknowns();
    let work = unknowns * (unknowns + 1) / 2 * subject.template.points();
    if work <= FULL_WORK {
        return vec![];
    }
    let mut stream = Stream::new(index, 0, 99);
    let mut one = || (0..unknowns).map(|_| stream.uniform(-1.0, 1.0)).collect();
    (0..DIRECTIONS).map(|_| one()).collect()
}

fn truth(
    configuration: &Configuration,
    directions: &[Vec<f64>],
) -> Result<Evaluation, crate::oracle::OracleError> {
    if directions.is_empty() {
        solve::evaluate(&configuration.pair, &configuration.state())
    } else {
        solve::tangent_times(&configuration.pair, &configuration.state(), directions)
    }
}

/// A contact point whose status or gap differs from the oracle's.
fn wrong_point(truth: &Evaluation, answer: &Answer) -> Option<String> {
    let points = answer.output.chunks_exact(OUTPUT_SIZE);
    for (number, (expected, found)) in truth.points.iter().zip(points).enumerate() {
        let status = match expected.status {
            PointStatus::Open => Status::Open,
            PointStatus::Closed => Status::Closed,
            PointStatus::Outside(_) => Status::Outside,
            PointStatus::Degenerate | PointStatus::NotConverged => continue,
        };
        if found[0] != f64::from(status as i32) {
            return Some(format!(
                "point {number}: status {} instead of {status:?}",
                found[0]
            ));
        }
        let wrong_gap = (found[1] - expected.gap).abs() > 1e-10 * (1.0 + expected.gap.abs());
        if status == Status::Closed && wrong_gap {
            return Some(format!(
                "point {number}: gap {} instead of {}",
                found[1], expected.gap
            ));
        }
    }
    None
}

fn energy_error(subject: &Subject, answer: &Answer, truth: &Evaluation) -> f64 {
    if !subject.description.descriptor.energy || truth.energy.is_nan() {
        return 0.0;
    }
    relative_error(&answer.energy, &[truth.energy])
}

/// Error of the tangent relative to its largest entry; or of its product with the directions, relative to the
/// largest sum of absolute terms, because the terms of a product may cancel.
fn tangent_error(
    subject: &Subject,
    answer: &Answer,
    truth: &Evaluation,
    directions: &[Vec<f64>],
) -> f64 {
    if !subject.description.descriptor.tangent || subject.description.tangent_plane {
        return 0.0;
    }
    if directions.is_empty() {
        return relative_error(&answer.tangent, &truth.tangent);
    }
    let unknowns = answer.residual.len();
    let mut worst: f64 = 0.0;
    for (direction, expected) in directions.iter().zip(&truth.products) {
        let (mut difference, mut scale) = (0.0_f64, 0.0_f64);
        for (row, expected) in answer.tangent.chunks_exact(unknowns).zip(expected) {
            let terms = || row.iter().zip(direction).map(|(k, d)| k * d);
            let error = (terms().sum::<f64>() - expected).abs();
            difference = if error.is_nan() {
                f64::INFINITY
            } else {
                difference.max(error)
            };
            scale = scale.max(terms().map(f64::abs).sum());
        }
        worst = worst.max(difference / scale);
    }
    worst
}
