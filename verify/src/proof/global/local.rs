//! The projection of an evaluation: Newton's method from its start, and the search within the domain behind it.

use contact_elements::runtime::Status;
use contact_elements::{Closest, OUTPUT_SIZE};
use serde::Serialize;

use super::effort::{Effort, add};
use super::judge::Judge;
use crate::configurations::Configuration;
use crate::subject::{Answer, Input, Subject, Wanted};
use crate::tolerance::FOOT;

/// Entries of a point's output.
const PROJECTION: usize = 4;
const ITERATIONS: usize = 9;
const FEATURE: usize = 10;

/// What evaluations from one kind of start gave.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Local {
    /// By outcome: inside, outside, not converged, not unique, degenerate.
    pub outcomes: [u64; 5],
    /// Newton steps of the first two.
    pub iterations: Effort,
    /// Number of inside feet that are not the closest point of the whole domain.
    pub elsewhere: u64,
}

impl Local {
    pub(super) fn merge(&mut self, other: &Self) {
        add(&mut self.outcomes, &other.outcomes);
        self.iterations.merge(&other.iterations);
        self.elsewhere += other.elsewhere;
    }

    /// Counts the answer at the points that `counts`, and judges them: number of the point and its error.
    /// `closest` holds the closest points of the whole domain, where known.
    pub(super) fn record(
        &mut self,
        judge: &Judge<'_>,
        answer: &Answer,
        closest: Option<&[Closest]>,
        counts: impl Fn(usize) -> bool,
    ) -> Vec<(usize, Option<String>)> {
        let failed = match answer.status() {
            Some(Status::NotConverged) => Some(2),
            Some(Status::NotUnique) => Some(3),
            Some(Status::Degenerate) => Some(4),
            // refused for its gap, not for its projection
            Some(Status::Law) => return vec![],
            None => return vec![(0, Some(format!("{:?}", answer.outcome)))],
            Some(_) => None,
        };
        if let Some(failed) = failed {
            // the whole evaluation is refused, and reports nothing about its points
            self.outcomes[failed] += u64::from(counts(0));
            return vec![];
        }
        let points = answer.output.chunks_exact(OUTPUT_SIZE).enumerate();
        let mut judged = Vec::new();
        for (q, output) in points.filter(|(q, _)| counts(*q)) {
            let (feature, iterations) = (output[FEATURE] as usize, output[ITERATIONS] as u64);
            self.outcomes[usize::from(feature != 0)] += 1;
            self.iterations.add(iterations);
            let zeta = [output[PROJECTION], output[PROJECTION + 1]];
            let distance = judge.local(q, zeta, feature);
            if let (Ok(distance), 0, Some(closest)) = (&distance, feature, closest) {
                let slack = 1e3 * FOOT * judge.size(q);
                let least = closest.get(q).map_or(0.0, |closest| closest.distance);
                self.elsewhere += u64::from(*distance > least + slack);
            }
            judged.push((q, distance.err()));
        }
        judged
    }
}

/// Evaluates with a history; an empty one stands for no history.
pub(super) fn evaluate(
    subject: &Subject,
    configuration: &Configuration,
    history: &[f64],
) -> Answer {
    subject.call(
        &Input {
            reference: &configuration.reference,
            displacement: &configuration.displacement,
            parameters: &subject.parameters(&configuration.pair),
            history,
            slave_row: &subject.slave_row(&configuration.pair),
            multipliers: configuration.pair.multipliers.unknowns(),
        },
        Wanted {
            residual: false,
            tangent: false,
            bits: 0,
        },
    )
}
