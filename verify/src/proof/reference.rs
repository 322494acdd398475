//! Cases of 25 digits from a third program, with and without friction, through the C interface.

use contact_elements::runtime::Status;
use serde::Serialize;

use super::Finding;
use super::cases::{self, Case};
use crate::subject::{Input, Subject, Wanted};
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS, relative_error};

/// Errors of one case in units of what is allowed.
#[derive(Clone, Debug, Serialize)]
pub struct CaseResult {
    /// Case.
    pub id: String,
    /// Element.
    pub element: String,
    /// Relative error of the residual, and what is allowed.
    pub residual: (f64, f64),
    /// Relative error of the tangent, and what is allowed.
    pub tangent: (f64, f64),
}

/// Runs every case through the element of its kind.
pub fn prove(subjects: &[Subject]) -> (Finding, Vec<CaseResult>) {
    let mut finding = Finding::default();
    let mut results = Vec::new();
    let cases = match cases::cases() {
        Ok(cases) => cases,
        Err(error) => {
            finding.fail(format!("reference cases cannot be read: {error}"));
            return (finding, results);
        }
    };
    for case in &cases {
        let subject = case.pair().and_then(|pair| {
            subjects
                .iter()
                .find(|subject| super::edges::fits(subject, &pair))
        });
        match subject {
            Some(subject) => one(&mut finding, &mut results, subject, case),
            None => finding.fail(format!("{}: no element of this kind", case.id)),
        }
    }
    (finding, results)
}

fn one(finding: &mut Finding, results: &mut Vec<CaseResult>, subject: &Subject, case: &Case) {
    let (Some(pair), Some(expected)) = (case.pair(), case.expected()) else {
        finding.fail(format!("{}: cannot be read", case.id));
        return;
    };
    let positions = case.positions();
    let answer = subject.call(
        &Input {
            reference: &positions,
            displacement: &vec![0.0; positions.len()],
            parameters: &subject.parameters(&pair),
            history: &subject.history(&[case.start()], &case.friction(), &pair.multipliers),
            slave_row: &[],
            multipliers: &[],
        },
        Wanted::BOTH,
    );
    let slips = answer.status() == Some(Status::Slip);
    if slips != expected.slips.unwrap_or(false) || !answer.status().is_some_and(Status::is_closed) {
        finding.fail(format!("{}: {:?}", case.id, answer.outcome));
    }
    let allowed = |spread: f64| (REFERENCE_SPREADS * spread).max(REFERENCE);
    let result = CaseResult {
        id: case.id.clone(),
        element: subject.name().to_string(),
        residual: (
            relative_error(&answer.residual, &expected.residual),
            allowed(case.spread.residual),
        ),
        tangent: (
            relative_error(&answer.tangent, &expected.tangent),
            allowed(case.spread.tangent),
        ),
    };
    for (what, (error, limit)) in [("residual", result.residual), ("tangent", result.tangent)] {
        finding.compare(&format!("{}: {what}", case.id), error, limit);
    }
    results.push(result);
}
