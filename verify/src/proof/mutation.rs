//! Every term of every linearisation dropped, doubled and sign-flipped: the comparison must notice.

use serde::Serialize;

use super::interpreted::{self, Interpreted, Mutation, TermSite};
use super::slopes;
use super::{Finding, random};
use crate::configurations::{Configuration, Wanted};
use crate::interpret::Change;
use crate::oracle::solve::{self, Evaluation};
use crate::subject::{self, Answer, Input, Subject};
use crate::tolerance::{ENERGY, NO_CHANGE, RANDOM, relative_error};
use contact_elements::runtime::Enforcement;

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
            history: subject.history_of(&configuration),
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
            multipliers: self.configuration.pair.multipliers.unknowns(),
        };
        interpreted::evaluate(subject, &input, &self.answer, mutation)
    }

    fn energy_error(&self, found: &Interpreted) -> f64 {
        let Evaluation {
            energy,
            energy_size,
            ..
        } = self.truth;
        random::relative_energy(&[found.energy], energy, energy_size)
    }

    /// Does the comparison that judges the compiled element notice a difference?
    fn notices(&self, subject: &Subject, found: &Interpreted) -> bool {
        let differs = |found: &[f64], expected: &[f64]| relative_error(found, expected) > RANDOM;
        let descriptor = subject.description.descriptor;
        differs(&found.residual, &self.truth.residual)
            || (descriptor.energy && self.energy_error(found) > RANDOM)
            || (descriptor.tangent
                && !subject.description.tangent_plane
                && differs(&found.tangent, &self.truth.tangent))
    }
}

/// Makes and judges every mutant of an element.
pub fn prove(subject: &Subject, seed: u64) -> Mutants {
    let mut mutants = Mutants::default();
    let generator = random::generator(subject, seed);
    let wanted: &[Wanted] = match &subject.template.tangential {
        None => &[Wanted::Closed],
        Some(_) => &[Wanted::Stick, Wanted::Slip],
    };
    let states = wanted
        .iter()
        .flat_map(|&w| (0..STATES).map(move |index| (w, index)));
    let cases: Vec<Case> = states
        .filter_map(|(wanted, index)| generator.generate(wanted, index).ok())
        .filter_map(|configuration| Case::new(subject, configuration))
        .collect();
    for case in &cases {
        unchanged(&mut mutants, subject, case);
    }
    for site in TermSite::ALL {
        let Some(program) = interpreted::program(subject, site) else {
            continue;
        };
        for (term, declared) in program.terms.iter().enumerate() {
            if !declared.present {
                let entry = (declared.tag.to_string(), declared.reason.to_string());
                mutants.left_out.push(entry);
                continue;
            }
            if let Some(reason) = unused(subject, site, declared.tag) {
                let entry = (declared.tag.to_string(), reason.to_string());
                mutants.left_out.push(entry);
                continue;
            }
            let changed = |factor| (site, Change { term, factor });
            if let Some(reason) = may_vanish(declared.tag)
                && FACTORS
                    .iter()
                    .all(|&(_, factor)| !changes(subject, &cases, changed(factor)))
            {
                let entry = (declared.tag.to_string(), reason.to_string());
                mutants.left_out.push(entry);
                continue;
            }
            mutants.terms.push(declared.tag.to_string());
            for (name, factor) in FACTORS {
                mutants.made += 1;
                if noticed(subject, &cases, changed(factor), seed) {
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

fn noticed(subject: &Subject, cases: &[Case], mutation: Mutation, seed: u64) -> bool {
    cases
        .iter()
        .any(|case| case.notices(subject, &case.interpreted(subject, Some(mutation))))
        || (subject.description.tangent_plane
            && slopes::prove(subject, seed, Some(mutation)).finding.failed > 0)
}

/// Why a term may vanish for a geometry although the program, which elements share, has it. It is left out only
/// where no change of it moves any entry of R, K or the energy in any of the states.
fn may_vanish(tag: &str) -> Option<&'static str> {
    match tag {
        "Q-bending" => Some("the second derivatives of the shape functions are zero"),
        "Y-third" => Some("the third derivatives have no part along the normal"),
        "Y-second" => Some("the second derivatives have no part in the tangent plane"),
        "slip-metric" | "traction-metric" => Some("the metric of the geometry is constant"),
        "sliding-direction" => Some("with one parameter the slip has no direction to change"),
        _ => None,
    }
}

/// Whether a change of a term moves anything beyond rounding.
fn changes(subject: &Subject, cases: &[Case], mutation: Mutation) -> bool {
    cases.iter().any(|case| {
        let was = case.interpreted(subject, None);
        let is = case.interpreted(subject, Some(mutation));
        let moved = |is: &[f64], was: &[f64]| relative_error(is, was) > NO_CHANGE;
        moved(&is.residual, &was.residual)
            || moved(&is.tangent, &was.tangent)
            || moved(&[is.energy], &[was.energy])
    })
}

/// Why a term of a program that elements share does nothing in this one.
fn unused(subject: &Subject, site: TermSite, tag: &str) -> Option<&'static str> {
    const SLOPES: [&str; 6] = [
        "law-slope",
        "bound-by-pressure",
        "bound-by-slip",
        "sliding-direction",
        "sliding-path",
        "sliding-pressure",
    ];
    if !subject.description.descriptor.tangent && SLOPES.contains(&tag) {
        return Some("the element gives no tangent");
    }
    let enforcement = subject.description.descriptor.enforcement;
    if enforcement != Enforcement::Penalty && tag == "energy" {
        return Some("beside a multiplier the energy is N²/(2 N')");
    }
    let rolls = matches!(
        site,
        TermSite::RollingLaw
            | TermSite::RollingSliding
            | TermSite::RollingResidual
            | TermSite::RollingTangent
    );
    let law = match subject.description.rolling {
        Some(rolling) if rolls => rolling.law,
        _ => subject.description.tangential?,
    };
    let depends = |tag: &str| {
        let mut terms = law.friction.terms.iter();
        terms.any(|term| term.tag == tag && term.present)
    };
    match tag {
        "sliding-path" if !depends("bound-by-slip") => {
            Some("the bound does not depend on the path")
        }
        "pressure-change" | "rolling-pressure" if law.sliding.is_none() => {
            Some("the law has no bound")
        }
        _ => None,
    }
}

fn unchanged(mutants: &mut Mutants, subject: &Subject, case: &Case) {
    let found = case.interpreted(subject, None);
    let residual = relative_error(&found.residual, &case.answer.residual);
    let tangent = if subject.description.descriptor.tangent {
        relative_error(&found.tangent, &case.answer.tangent)
    } else {
        0.0
    };
    let energy = if subject.description.descriptor.energy {
        let expected = case.answer.energy.first().copied().unwrap_or(f64::NAN);
        random::relative_energy(&[found.energy], expected, case.truth.energy_size)
    } else {
        0.0
    };
    let what = format!("{}: tables against compiled element", subject.name());
    let error = residual.max(tangent).max(energy * (RANDOM / ENERGY));
    mutants.unchanged.compare(&what, error, RANDOM);
}
