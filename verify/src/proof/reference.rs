//! Frictionless cases of 25 digits from a third program, through the C interface.

use serde::{Deserialize, Serialize};

use super::Finding;
use crate::oracle::geometry::{Interpolation, Shape};
use crate::oracle::law::Law;
use crate::oracle::pair::{GapKind, IntegrationPoint, Master, Measure, Pair, Slave};
use crate::subject::{Input, Subject, Wanted};
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS, relative_error};

/// The file of cases.
#[derive(Debug, Deserialize)]
struct File {
    cases: Vec<Case>,
}

/// One case of 25 digits.
#[derive(Debug, Deserialize)]
pub struct Case {
    /// Name.
    pub id: String,
    dim: usize,
    slave: Side,
    master: Side,
    law: LawData,
    start: Vec<f64>,
    normal_sign: f64,
    /// What half an ulp of noise in the data does.
    pub spread: Spread,
    expected: Expected,
    history: Option<serde_json::Value>,
}

#[derive(Debug, Deserialize)]
struct Side {
    geometry: String,
    nodes: Vec<Vec<f64>>,
    eta: Option<Vec<f64>>,
    weights: Option<Vec<f64>>,
}

#[derive(Debug, Deserialize)]
struct LawData {
    eps_n: f64,
    r0: f64,
}

/// Relative change of residual and tangent under noise.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Spread {
    /// Of the residual.
    pub residual: f64,
    /// Of the tangent.
    pub tangent: f64,
}

#[derive(Debug, Deserialize)]
struct Expected {
    zeta: Vec<String>,
    gap: String,
    residual: Vec<String>,
    tangent: Vec<Vec<String>>,
}

/// Expected values of a case as numbers.
#[derive(Clone, Debug)]
pub struct Values {
    /// Projected parameters.
    pub zeta: Vec<f64>,
    /// Gap (length).
    pub gap: f64,
    /// R
    pub residual: Vec<f64>,
    /// K by rows.
    pub tangent: Vec<f64>,
}

/// The frictionless cases.
///
/// # Errors
/// Where the file does not have the expected form.
pub fn cases() -> Result<Vec<Case>, serde_json::Error> {
    let file: File = serde_json::from_str(include_str!("../../data/reference_cases.json"))?;
    let frictionless = file.cases.into_iter().filter(|case| case.history.is_none());
    Ok(frictionless.collect())
}

impl Case {
    /// The case as a pair.
    pub fn pair(&self) -> Option<Pair> {
        let slave = match (&self.slave.eta, self.slave.geometry.as_str()) {
            (_, "point") => Slave::Point,
            (None, _) => Slave::Curve(self.slave.interpolation()?),
            (Some(eta), _) => Slave::Fixed {
                geometry: self.slave.interpolation()?,
                points: vec![IntegrationPoint {
                    eta: pad(eta),
                    weight: 1.0,
                }],
                measure: Measure::Unit,
            },
        };
        let master = match self.master.geometry.as_str() {
            "point" => Master::Point,
            _ => Master::Shape(self.master.interpolation()?),
        };
        let mut pair = Pair {
            dimension: self.dim,
            slave,
            master,
            gap: GapKind::Distance,
            orientation: self.normal_sign,
            r0: self.law.r0,
            law: Law::Penalty {
                eps_n: self.law.eps_n,
            },
        };
        if self.dim == pair.parameters() + 1 && !self.id.contains("beams") {
            pair.gap = GapKind::Signed;
        }
        Some(pair)
    }

    /// All coordinates, slave nodes first.
    pub fn positions(&self) -> Vec<f64> {
        let nodes = self.slave.nodes.iter().chain(&self.master.nodes);
        nodes.flatten().copied().collect()
    }

    /// Start of the projection.
    pub fn start(&self) -> [f64; 2] {
        pad(&self.start)
    }

    /// Expected values; `None` where a number cannot be read.
    pub fn expected(&self) -> Option<Values> {
        let numbers = |list: &[String]| -> Option<Vec<f64>> {
            list.iter().map(|text| text.parse().ok()).collect()
        };
        let rows: Option<Vec<Vec<f64>>> = self
            .expected
            .tangent
            .iter()
            .map(|row| numbers(row))
            .collect();
        Some(Values {
            zeta: numbers(&self.expected.zeta)?,
            gap: self.expected.gap.parse().ok()?,
            residual: numbers(&self.expected.residual)?,
            tangent: rows?.concat(),
        })
    }
}

impl Side {
    fn interpolation(&self) -> Option<Interpolation> {
        let shape = match self.geometry.as_str() {
            "line2" => Shape::Line2,
            "line3" => Shape::Line3,
            "hermite" => Shape::Hermite,
            "tri3" => Shape::Tri3,
            "tri6" => Shape::Tri6,
            "quad4" => Shape::Quad4,
            "quad9" => Shape::Quad9,
            "beziercurve2" => Shape::BezierCurve(2),
            "beziercurve3" => Shape::BezierCurve(3),
            "beziersurface2" => Shape::BezierSurface(2),
            _ => return None,
        };
        let weights = self.weights.clone().filter(|weights| !weights.is_empty());
        Some(Interpolation { shape, weights })
    }
}

fn pad(values: &[f64]) -> [f64; 2] {
    let at = |i: usize| values.get(i).copied().unwrap_or(0.0);
    [at(0), at(1)]
}

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
    let cases = match cases() {
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
            history: &subject.history(&[case.start()]),
            slave_row: &[],
        },
        Wanted::BOTH,
    );
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
