//! Cases of 25 digits from a third program, as data.

use serde::Deserialize;

use crate::oracle::geometry::{Interpolation, Shape};
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::pair::{GapKind, IntegrationPoint, Master, Measure, Pair, Slave};
use crate::oracle::tangential::TangentialLaw;

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
    /// Spread of the results under half an ulp of noise in the data.
    pub spread: Spread,
    expected: Expected,
    history: Option<HistoryData>,
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
    eps_t: Option<PerAxis>,
    mu: Option<PerAxis>,
    axis: Option<AxisData>,
}

/// One value, or one for each axis.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
enum PerAxis {
    Isotropic(f64),
    Orthotropic([f64; 2]),
}

/// The word `slave`, or a convected direction.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum AxisData {
    Named(String),
    Convected([f64; 2]),
}

/// The stick anchor.
#[derive(Debug, Deserialize)]
struct HistoryData {
    z_stick: Vec<f64>,
}

/// Relative change of residual and tangent under noise.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Spread {
    /// Relative change of the residual.
    pub residual: f64,
    /// Relative change of the tangent.
    pub tangent: f64,
}

#[derive(Debug, Deserialize)]
struct Expected {
    zeta: Vec<String>,
    gap: String,
    residual: Vec<String>,
    tangent: Vec<Vec<String>>,
    slip: Option<bool>,
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
    /// Whether the point slips; `None` without friction.
    pub slips: Option<bool>,
}

/// All cases.
///
/// # Errors
/// The file does not have the expected form.
pub fn cases() -> Result<Vec<Case>, serde_json::Error> {
    let file: File = serde_json::from_str(include_str!("../../data/reference_cases.json"))?;
    Ok(file.cases)
}

/// The frictionless cases.
///
/// # Errors
/// See [`cases`].
pub fn frictionless() -> Result<Vec<Case>, serde_json::Error> {
    let all = cases()?.into_iter();
    Ok(all.filter(|case| case.history.is_none()).collect())
}

/// The cases with friction.
///
/// # Errors
/// See [`cases`].
pub fn frictional() -> Result<Vec<Case>, serde_json::Error> {
    let all = cases()?.into_iter();
    Ok(all.filter(|case| case.history.is_some()).collect())
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
            tangential: match self.history {
                Some(_) => Some(self.law.tangential()?),
                None => None,
            },
            angle: None,
            multipliers: Multipliers::None,
        };
        if self.dim == pair.parameters() + 1 && !self.id.contains("beams") {
            pair.gap = GapKind::Signed;
        }
        Some(pair)
    }

    /// What the contact point remembers; empty without friction.
    pub fn friction(&self) -> Vec<FrictionHistory> {
        let remembered = |history: &HistoryData| FrictionHistory {
            status: Accepted::Stick,
            anchor: pad(&history.z_stick),
            slip: 0.0,
            rolling: RollingHistory::default(),
        };
        self.history.iter().map(remembered).collect()
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

    /// Residual and tangent by rows, all digits.
    pub fn digits(&self) -> (Vec<&str>, Vec<&str>) {
        let residual = self.expected.residual.iter().map(String::as_str);
        let tangent = self.expected.tangent.iter().flatten().map(String::as_str);
        (residual.collect(), tangent.collect())
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
            slips: self.expected.slip,
        })
    }
}

impl LawData {
    fn tangential(&self) -> Option<Tangential> {
        let axis = match &self.axis {
            None => None,
            Some(AxisData::Named(name)) if name == "slave" => Some(Axis::SlaveCurve),
            Some(AxisData::Named(_)) => return None,
            Some(AxisData::Convected(w)) => Some(Axis::Convected(*w)),
        };
        let law = match (self.eps_t?, self.mu?) {
            (PerAxis::Isotropic(eps_t), PerAxis::Isotropic(mu)) => {
                TangentialLaw::Coulomb { eps_t, mu }
            }
            (PerAxis::Orthotropic(eps_t), PerAxis::Orthotropic(mu)) => {
                TangentialLaw::Orthotropic { eps_t, mu }
            }
            _ => return None,
        };
        Some(Tangential {
            law,
            axis,
            tangent_plane: false,
            rolling: None,
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
