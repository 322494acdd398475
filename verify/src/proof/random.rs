//! Random states of every element and status against the oracle.

use contact_elements::OUTPUT_SIZE;
use contact_elements::runtime::Status;
use rayon::prelude::*;
use serde::Serialize;

use super::{Finding, Worst, points};
use crate::configurations::{Configuration, Freedom, GenerateError, Generator, Stream, Wanted};
use crate::oracle::solve::{self, Couplings, Evaluation, PointStatus};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{ENERGY, POINTS, RANDOM, relative_error};

/// Work of a full hyper-dual tangent (entries times points) above which random directions are taken.
const FULL_WORK: usize = 250;
/// Number of directions then.
const DIRECTIONS: usize = 2;

/// Results for one element and requested status.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Random {
    /// Residual.
    pub residual: Worst,
    /// Tangent; `None` for residual-only and tangent-plane elements.
    pub tangent: Worst,
    /// Energy.
    pub energy: Worst,
    /// Output and trial history of the contact points.
    pub points: Worst,
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
        self.points.merge(&other.points);
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
        Err(GenerateError::NeverOutside | GenerateError::NeverSlips)
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
        Wanted::Open => open(&mut random, subject, &configuration, &answer, index),
        // beyond an edge the unconstrained stationary point need not exist
        Wanted::Outside if !any_closed(&configuration) => {
            let allowed = [
                Status::Open,
                Status::Outside,
                Status::NotConverged,
                Status::NotUnique,
            ];
            match not_closed(&answer, &allowed) {
                None => random.finding.pass(),
                Some(wrong) => random.finding.fail(format!("state {index}: {wrong}")),
            }
        }
        Wanted::Closed | Wanted::Stick | Wanted::Slip | Wanted::Outside => {
            closed(&mut random, subject, &configuration, &answer, index);
        }
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
            history: &subject.history_of(configuration),
            slave_row: &subject.slave_row(&configuration.pair),
            multipliers: configuration.pair.multipliers.unknowns(),
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

/// Describes the error of the answer at a state without a closed point.
fn not_closed(answer: &Answer, allowed: &[Status]) -> Option<String> {
    let Some(status) = answer.status() else {
        return Some(format!("{:?}", answer.outcome));
    };
    let cut_back = !status.is_closed() && !matches!(status, Status::Open | Status::Outside);
    let silent = if cut_back {
        answer.is_untouched()
    } else {
        answer.is_zero()
    };
    let fine = allowed.contains(&status) && silent;
    (!fine).then(|| format!("status {status:?}, outputs silent: {silent}"))
}

fn open(
    random: &mut Random,
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
    index: u64,
) {
    let compared = match not_closed(answer, &[Status::Open, Status::Outside]) {
        None => unloaded_error(subject, configuration, answer),
        Some(wrong) => Err(wrong),
    };
    match compared {
        Ok(error) => {
            random.points.absorb(error, index);
            let what = format!("state {index}");
            random.finding.compare(&what, error, POINTS);
        }
        Err(wrong) => random.finding.fail(format!("state {index}: {wrong}")),
    }
}

/// Error of points and multipliers at a state without a closed point.
fn unloaded_error(
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
) -> Result<f64, String> {
    let points = points::error(subject, configuration, &configuration.points, answer)?;
    let truth = truth(configuration, &[]).map_err(|error| error.to_string())?;
    let energy = energy_error(subject, answer, &truth) * (POINTS / ENERGY);
    Ok(points
        .max(energy)
        .max(couplings_error(&answer.couplings, &truth.couplings)))
}

/// Largest error of the parts that belong to multipliers, each relative to its own largest entry.
pub(super) fn couplings_error(found: &Couplings, expected: &Couplings) -> f64 {
    let parts = found.parts().into_iter().zip(expected.parts());
    parts
        .map(|(found, expected)| relative_error(found, expected))
        .fold(0.0, f64::max)
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
    let statuses = truth.points.iter().filter_map(points::status);
    let expected = statuses.max_by_key(|status| status.rank());
    if answer.status() != expected {
        random.finding.fail(format!(
            "state {index}: {:?} instead of {expected:?}",
            answer.outcome
        ));
        return;
    }
    let points = match points::error(subject, configuration, &truth.points, answer) {
        Ok(points) => points,
        Err(wrong) => {
            random.finding.fail(format!("state {index}: {wrong}"));
            return;
        }
    };
    random.points.absorb(points, index);
    let residual = relative_error(&answer.residual, &truth.residual);
    random.residual.absorb(residual, index);
    let energy = energy_error(subject, answer, &truth);
    random.energy.absorb(energy, index);
    let tangent = tangent_error(subject, answer, &truth, &directions)
        .max(couplings_error(&answer.couplings, &truth.couplings));
    random.tangent.absorb(tangent, index);
    let worst = residual
        .max(tangent)
        .max(energy * (RANDOM / ENERGY))
        .max(points * (RANDOM / POINTS));
    random
        .finding
        .compare(&format!("state {index}"), worst, RANDOM);
}

/// Random directions for large elements; empty where the full tangent is taken.
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

fn energy_error(subject: &Subject, answer: &Answer, truth: &Evaluation) -> f64 {
    if !subject.description.descriptor.energy || truth.energy.is_nan() {
        return 0.0;
    }
    relative_energy(&answer.energy, truth.energy, truth.energy_size)
}

/// Error of an energy relative to the magnitudes that it is made of.
pub(super) fn relative_energy(found: &[f64], expected: f64, size: f64) -> f64 {
    let error = relative_error(found, &[expected]);
    if error == 0.0 {
        0.0
    } else {
        error * (expected / size).abs()
    }
}

/// Error of the tangent relative to its largest entry; or of its product with the directions, relative to the
/// largest sum of absolute terms, because the terms of a product may cancel.
pub(super) fn tangent_error(
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
