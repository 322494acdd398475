//! Every term of every linearisation dropped, doubled and sign-flipped: the comparison must notice.

use serde::Serialize;

use super::interpreted::{self, Interpreted, Mutation, Place};
use super::slopes;
use super::{Finding, random};
use crate::configurations::{Configuration, Wanted};
use crate::interpret::Change;
use crate::oracle::solve::{self, Evaluation};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{RANDOM, relative_error};

/// States on which a mutant may be noticed.
const STATES: u64 = 6;
/// What is done to a coefficient.
const FACTORS: [(&str, f64); 3] = [("dropped", 0.0), ("doubled", 2.0), ("flipped", -1.0)];

/// What became of the terms of one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Mutants {
    /// Mutants made.
    pub made: u64,
    /// Mutants that the comparison noticed.
    pub killed: u64,
    /// Mutants that lived.
    pub survivors: Vec<String>,
    /// Terms present, by equation tag.
    pub terms: Vec<String>,
    /// Terms that vanish identically: tag and reason.
    pub left_out: Vec<(String, String)>,
    /// The unchanged tables against the compiled element.
    pub unchanged: Finding,
}

/// A state with the truth and the compiled answer.
struct Case {
    configuration: Configuration,
    parameters: Vec<f64>,
    history: Vec<f64>,
    row: Vec<f64>,
    truth: Evaluation,
    answer: Answer,
}

impl Case {
    fn new(subject: &Subject, configuration: Configuration) -> Option<Self> {
        let truth = solve::evaluate(&configuration.pair, &configuration.state()).ok()?;
        let answer = random::call(subject, &configuration, subject::Wanted::BOTH);
        Some(Self {
            parameters: subject.parameters(&configuration.pair),
            history: subject.history(&configuration.start),
            row: subject.slave_row(&configuration.pair),
            configuration,
            truth,
            answer,
        })
    }

    fn interpreted(&self, subject: &Subject, mutation: Option<Mutation>) -> Interpreted {
        let input = Input {
            reference: &self.configuration.reference,
            displacement: &self.configuration.displacement,
            parameters: &self.parameters,
            history: &self.history,
            slave_row: &self.row,
        };
        interpreted::evaluate(subject, &input, &self.answer, mutation)
    }

    /// Does the comparison that judges the compiled element notice a difference?
    fn notices(&self, subject: &Subject, found: &Interpreted) -> bool {
        let differs = |found: &[f64], expected: &[f64]| relative_error(found, expected) > RANDOM;
        let descriptor = subject.description.descriptor;
        differs(&found.residual, &self.truth.residual)
            || (descriptor.energy && differs(&[found.energy], &[self.truth.energy]))
            || (descriptor.tangent
                && !subject.description.tangent_plane
                && differs(&found.tangent, &self.truth.tangent))
    }
}

/// Makes and judges every mutant of an element.
pub fn prove(subject: &Subject, seed: u64) -> Mutants {
    let mut mutants = Mutants::default();
    let generator = random::generator(subject, seed);
    let cases: Vec<Case> = (0..STATES)
        .filter_map(|index| generator.generate(Wanted::Closed, index).ok())
        .filter_map(|configuration| Case::new(subject, configuration))
        .collect();
    for case in &cases {
        unchanged(&mut mutants, subject, case);
    }
    for place in [Place::Law, Place::Tangent, Place::Measure] {
        let Some(program) = interpreted::program(subject, place) else {
            continue;
        };
        for (term, declared) in program.terms.iter().enumerate() {
            if !declared.present {
                let entry = (declared.tag.to_string(), declared.reason.to_string());
                mutants.left_out.push(entry);
                continue;
            }
            if !reaches_an_output(subject, declared.tag) {
                let reason = "the element gives no tangent".to_string();
                mutants.left_out.push((declared.tag.to_string(), reason));
                continue;
            }
            mutants.terms.push(declared.tag.to_string());
            for (name, factor) in FACTORS {
                let mutation = (place, Change { term, factor });
                let killed = cases
                    .iter()
                    .any(|case| case.notices(subject, &case.interpreted(subject, Some(mutation))))
                    || (subject.description.tangent_plane
                        && slopes::prove(subject, seed, Some(mutation)).finding.failed > 0);
                mutants.made += 1;
                if killed {
                    mutants.killed += 1;
                } else {
                    let line = format!("{}: {} {name}", subject.name(), declared.tag);
                    mutants.survivors.push(line);
                }
            }
        }
    }
    mutants
}

/// The slope of the law reaches an output only through the tangent.
fn reaches_an_output(subject: &Subject, tag: &str) -> bool {
    tag != "law-slope" || subject.description.descriptor.tangent
}

fn unchanged(mutants: &mut Mutants, subject: &Subject, case: &Case) {
    let found = case.interpreted(subject, None);
    let residual = relative_error(&found.residual, &case.answer.residual);
    let tangent = if subject.description.descriptor.tangent {
        relative_error(&found.tangent, &case.answer.tangent)
    } else {
        0.0
    };
    let what = format!("{}: tables against compiled element", subject.name());
    mutants
        .unchanged
        .compare(&what, residual.max(tangent), RANDOM);
}
