//! Random states of every element and status against the oracle.

use contact_elements::OUTPUT_SIZE;
use contact_elements::runtime::Status;
use rayon::prelude::*;
use serde::Serialize;

use super::errors::{couplings_error, has_tangent, relative_energy, tangent_error};
use super::hardest::Hardest;
use super::statistics::{Histogram, Reached, Worst, milestones};
use super::{Finding, points};
use crate::configurations::{Configuration, Freedom, GenerateError, Generator, Stream, Wanted};
use crate::oracle::solve::{self, Evaluation, PointStatus};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{ENERGY, POINTS, RANDOM, relative_error};

/// Work of a full hyper-dual tangent (entries times points) above which random directions are taken.
const FULL_WORK: usize = 250;
/// Number of directions then.
const DIRECTIONS: usize = 2;

/// Results for one element and requested status.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Random {
    /// Worst error of the residual.
    pub residual: Worst,
    /// Worst error of the tangent; zero for residual-only and tangent-plane elements.
    pub tangent: Worst,
    /// Worst error of the energy.
    pub energy: Worst,
    /// Worst error of output and trial history of the contact points.
    pub points: Worst,
    /// Distribution of the errors of the residual.
    pub residuals: Histogram,
    /// Distribution of the errors of the tangent.
    pub tangents: Histogram,
    /// How the worst errors grew with the number of states.
    pub growth: Vec<Reached>,
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
        self.residuals.merge(&other.residuals);
        self.tangents.merge(&other.tangents);
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

/// The random states of an element, by the status they were built for.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RandomStates {
    /// Closed; without friction.
    pub closed: Option<Random>,
    /// Sticking; with friction.
    pub stick: Option<Random>,
    /// Slipping; with friction and a bound.
    pub slip: Option<Random>,
    /// Open.
    pub open: Option<Random>,
    /// Outside; `None` where there is no boundary.
    pub outside: Option<Random>,
}

impl RandomStates {
    /// Name of the status and its states.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &Random)> {
        let all = [
            ("closed", &self.closed),
            ("stick", &self.stick),
            ("slip", &self.slip),
            ("open", &self.open),
            ("outside", &self.outside),
        ];
        all.into_iter()
            .filter_map(|(status, random)| Some((status, random.as_ref()?)))
    }
}

/// How many states are tried.
#[derive(Clone, Copy, Debug)]
pub struct Choice<'a> {
    /// States of each status, from number 0 on.
    pub states: u64,
    /// States beyond these.
    pub hardest: &'a Hardest,
    /// Seed of the states.
    pub seed: u64,
}

/// Tries the chosen states of every status that the pair can have.
pub fn prove(subject: &Subject, choice: Choice<'_>) -> RandomStates {
    let of = |wanted, status| one_status(subject, wanted, status, choice);
    let has_friction = subject.template.tangential.is_some();
    RandomStates {
        closed: if has_friction {
            None
        } else {
            of(Wanted::Closed, "closed")
        },
        stick: of(Wanted::Stick, "stick"),
        slip: of(Wanted::Slip, "slip"),
        open: of(Wanted::Open, "open"),
        outside: of(Wanted::Outside, "outside"),
    }
}

/// Tries the states built for `wanted`; `None` where the pair cannot have that status.
fn one_status(
    subject: &Subject,
    wanted: Wanted,
    status: &str,
    choice: Choice<'_>,
) -> Option<Random> {
    let generator = generator(subject, choice.seed);
    if matches!(
        generator.generate(wanted, 0),
        Err(GenerateError::NeverOutside | GenerateError::NeverSlips)
    ) {
        return None;
    }
    let one = |index| one(subject, &generator, wanted, index);
    let mut random = Random::default();
    let mut first = 0;
    for states in milestones(choice.states) {
        let found = (first..states).into_par_iter().map(one);
        random = random.merge(found.reduce(Random::default, Random::merge));
        random.growth.push(Reached {
            states,
            residual: random.residual.error,
            tangent: random.tangent.error,
        });
        first = states;
    }
    let hardest = choice.hardest.states(subject.name(), status, first);
    let found = hardest.into_par_iter().map(one);
    Some(random.merge(found.reduce(Random::default, Random::merge)))
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
    random.residuals.add(residual);
    let energy = energy_error(subject, answer, &truth);
    random.energy.absorb(energy, index);
    let tangent = tangent_error(subject, answer, &truth, &directions)
        .max(couplings_error(&answer.couplings, &truth.couplings));
    random.tangent.absorb(tangent, index);
    if has_tangent(subject) {
        random.tangents.add(tangent);
    }
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
