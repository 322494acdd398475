//! Projection of random points and curves onto strongly deformed geometries: globally, from the centre of the domain,
//! and from the foot of a neighbouring state; every answer is judged by the oracle's positions alone.

mod effort;
mod judge;
mod local;
mod states;

use contact_elements::{Closest, Error, Query, Verdict, project};
use rayon::prelude::*;
use serde::Serialize;

use super::Finding;
use crate::configurations::Configuration;
use crate::subject::Subject;
use effort::add;
pub use effort::{Effort, Extent};
use judge::Judge;
pub use local::Local;
use states::{States, neighbour};

/// What was found for one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Global {
    /// Contact points projected globally, by verdict: inside, held by the boundary, not unique, beyond, undecided.
    pub verdicts: [u64; 5],
    /// The same by feature: 0 no feature, 1 to 4 an edge, 5 to 8 a vertex; ends of two curves as the interface numbers them.
    pub features: [u64; 9],
    /// Boxes looked at.
    pub boxes: Effort,
    /// Newton steps in them.
    pub steps: Effort,
    /// From the centre of the domain.
    pub cold: Local,
    /// From the closest point of a neighbouring state, where that is inside.
    pub warm: Local,
    /// Answers of the three, judged.
    pub finding: Finding,
}

impl Global {
    /// Both together.
    pub fn merge(mut self, other: Self) -> Self {
        add(&mut self.verdicts, &other.verdicts);
        add(&mut self.features, &other.features);
        self.boxes.merge(&other.boxes);
        self.steps.merge(&other.steps);
        self.cold.merge(&other.cold);
        self.warm.merge(&other.warm);
        self.finding.merge(other.finding);
        self
    }
}

/// Projects in many states; `None` where nothing is projected.
pub fn prove(subject: &Subject, extent: Extent) -> Option<Global> {
    if subject.template.parameters() == 0 {
        return None;
    }
    let states = States::new(subject, extent);
    let family = |number: u64| {
        let mut global = Global::default();
        match states.family(number) {
            Err(wrong) => global.finding.fail(wrong),
            Ok(members) => {
                for (index, configuration) in members {
                    one(subject, &configuration, extent, index, &mut global);
                }
            }
        }
        global
    };
    let numbers = extent.first..extent.first + extent.families;
    let all = numbers.into_par_iter().map(family);
    Some(all.reduce(Global::default, Global::merge))
}

/// Projects in one state and beside it.
fn one(
    subject: &Subject,
    configuration: &Configuration,
    extent: Extent,
    index: u64,
    global: &mut Global,
) {
    let descriptor = subject.description.descriptor;
    let mut results = vec![Closest::default(); descriptor.points];
    let mut history = vec![0.0; descriptor.history()];
    if let Err(error) = project_all(subject, configuration, &mut results, &mut history) {
        let failure = format!("state {index}: {error}");
        return global.finding.fail(failure);
    }
    let judge = Judge::new(subject, configuration, extent.seed, index);
    let is_compared = index.is_multiple_of(extent.compared);
    for (q, found) in results.iter().enumerate() {
        count(global, found);
        let wrong = judge.global(q, found, is_compared).err();
        note(&mut global.finding, index, "global", q, wrong);
    }
    if subject.description.angle.is_some() {
        // beyond its angles an evaluation reports nothing about the projection
        return;
    }
    let cold = local::evaluate(subject, configuration, &[]);
    let all = |_: usize| true;
    for (q, wrong) in global.cold.record(&judge, &cold, Some(&results), all) {
        note(&mut global.finding, index, "cold", q, wrong);
    }
    let beside = neighbour(configuration, extent.seed, index);
    let warm = local::evaluate(subject, &beside, &history);
    let judge = Judge::new(subject, &beside, extent.seed, index);
    let was_inside = |q: usize| {
        results
            .get(q)
            .is_some_and(|found| found.verdict == Verdict::Inside)
    };
    for (q, wrong) in global.warm.record(&judge, &warm, None, was_inside) {
        note(&mut global.finding, index, "warm", q, wrong);
    }
}

fn count(global: &mut Global, found: &Closest) {
    let verdict = global.verdicts.get_mut(found.verdict as usize);
    let feature = global.features.get_mut(found.feature as usize);
    for counter in [verdict, feature].into_iter().flatten() {
        *counter += 1;
    }
    global.boxes.add(u64::from(found.boxes));
    global.steps.add(u64::from(found.steps));
}

fn note(finding: &mut Finding, index: u64, start: &str, q: usize, wrong: Option<String>) {
    match wrong {
        None => finding.pass(),
        Some(wrong) => finding.fail(format!("state {index}, {start}, point {q}: {wrong}")),
    }
}

/// The global projection of all points.
fn project_all(
    subject: &Subject,
    configuration: &Configuration,
    results: &mut [Closest],
    history: &mut [f64],
) -> Result<(), Error> {
    let descriptor = subject.description.descriptor;
    let mut x = configuration.reference.clone();
    let mut u = configuration.displacement.clone();
    for list in [&mut x, &mut u] {
        let others = descriptor.dimension * descriptor.multipliers();
        list.resize(list.len() + others, 0.0);
    }
    let query = Query {
        x: &x,
        u: &u,
        parameters: &subject.parameters(&configuration.pair),
        slave_row: &subject.slave_row(&configuration.pair),
        reach: 0.0,
    };
    project(descriptor, &query, results, history)
}
