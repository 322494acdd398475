//! Every term of every linearisation dropped, doubled and sign-flipped: the comparison must notice.

use serde::Serialize;

use super::interpreted::{self, Interpreted, Mutation, TermSite};
use super::slopes;
use super::{Finding, errors, random};
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
    /// Every term of every program.
    pub terms: Vec<TermResult>,
    /// Mutants noticed by the first state, by the second one that was looked at, and so on.
    pub killed_by_state: Vec<u64>,
    /// The unchanged tables against the compiled element.
    pub unchanged: Finding,
}

/// What became of one term.
#[derive(Clone, Debug, Serialize)]
pub struct TermResult {
    /// Program that holds the term.
    pub program: &'static str,
    /// Equation tag.
    pub tag: &'static str,
    /// Why the term is left out; `None` where it is present.
    pub left_out: Option<&'static str>,
    /// Mutants made.
    pub made: u64,
    /// Mutants that the comparison noticed.
    pub killed: u64,
}

impl Mutants {
    /// Tags of the terms that are left out.
    pub fn left_out(&self) -> impl Iterator<Item = &'static str> {
        let terms = self.terms.iter().filter(|term| term.left_out.is_some());
        terms.map(|term| term.tag)
    }

    /// Judges the three mutants of a term that is present.
    fn judge(
        &mut self,
        subject: &Subject,
        cases: &[Case],
        mutated: &Site,
        seed: u64,
    ) -> TermResult {
        let mut result = mutated.result(None);
        for (name, factor) in FACTORS {
            result.made += 1;
            match noticed(subject, cases, mutated.mutation(factor), seed) {
                Noticed::By(state) => {
                    result.killed += 1;
                    let length = self.killed_by_state.len().max(state + 1);
                    self.killed_by_state.resize(length, 0);
                    self.killed_by_state[state] += 1;
                }
                Noticed::BySlopes => result.killed += 1,
                Noticed::Never => {
                    let line = format!("{}: {} {name}", subject.name(), mutated.tag);
                    self.survivors.push(line);
                }
            }
        }
        self.made += result.made;
        self.killed += result.killed;
        result
    }
}

/// A term in its program.
struct Site {
    site: TermSite,
    term: usize,
    program: &'static str,
    tag: &'static str,
}

impl Site {
    fn mutation(&self, factor: f64) -> Mutation {
        let change = Change {
            term: self.term,
            factor,
        };
        (self.site, change)
    }

    fn result(&self, left_out: Option<&'static str>) -> TermResult {
        TermResult {
            program: self.program,
            tag: self.tag,
            left_out,
            made: 0,
            killed: 0,
        }
    }
}

/// What noticed a mutant.
enum Noticed {
    /// The state with this number.
    By(usize),
    /// The error orders of a tangent-plane element.
    BySlopes,
    /// Nothing: it lives.
    Never,
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
        errors::relative_energy(&[found.energy], energy, energy_size)
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
    let cases = cases(subject, seed);
    for case in &cases {
        unchanged(&mut mutants, subject, case);
    }
    for site in TermSite::ALL {
        let Some(program) = interpreted::program(subject, site) else {
            continue;
        };
        for (term, declared) in program.terms.iter().enumerate() {
            let mutated = Site {
                site,
                term,
                program: program.name,
                tag: declared.tag,
            };
            let left_out = if declared.present {
                idle(subject, &cases, &mutated)
            } else {
                Some(declared.reason)
            };
            let result = match left_out {
                Some(reason) => mutated.result(Some(reason)),
                None => mutants.judge(subject, &cases, &mutated, seed),
            };
            mutants.terms.push(result);
        }
    }
    mutants
}

/// The states on which the mutants of an element may be noticed.
fn cases(subject: &Subject, seed: u64) -> Vec<Case> {
    let generator = random::generator(subject, seed);
    let wanted: &[Wanted] = match &subject.template.tangential {
        None => &[Wanted::Closed],
        Some(_) => &[Wanted::Stick, Wanted::Slip],
    };
    let states = wanted
        .iter()
        .flat_map(|&w| (0..STATES).map(move |index| (w, index)));
    states
        .filter_map(|(wanted, index)| generator.generate(wanted, index).ok())
        .filter_map(|configuration| Case::new(subject, configuration))
        .collect()
}

/// Why a term of a program does nothing in this element, if it does nothing.
fn idle(subject: &Subject, cases: &[Case], mutated: &Site) -> Option<&'static str> {
    let vanishes = || {
        let reason = may_vanish(mutated.tag)?;
        let moves = |&(_, factor): &(_, f64)| changes(subject, cases, mutated.mutation(factor));
        (!FACTORS.iter().any(moves)).then_some(reason)
    };
    unused(subject, mutated.site, mutated.tag).or_else(vanishes)
}

fn noticed(subject: &Subject, cases: &[Case], mutation: Mutation, seed: u64) -> Noticed {
    let notices = |case: &Case| case.notices(subject, &case.interpreted(subject, Some(mutation)));
    if let Some(state) = cases.iter().position(notices) {
        return Noticed::By(state);
    }
    let judged_by_slopes = subject.description.tangent_plane;
    if judged_by_slopes && slopes::prove(subject, seed, Some(mutation)).finding.failed > 0 {
        return Noticed::BySlopes;
    }
    Noticed::Never
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
        errors::relative_energy(&[found.energy], expected, case.truth.energy_size)
    } else {
        0.0
    };
    let what = format!("{}: tables against compiled element", subject.name());
    let error = residual.max(tangent).max(energy * (RANDOM / ENERGY));
    mutants.unchanged.compare(&what, error, RANDOM);
}
