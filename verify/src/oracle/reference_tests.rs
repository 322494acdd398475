//! Residual and tangent against frictionless reference cases of 25 digits.

use serde::Deserialize;

use super::geometry::{Interpolation, Shape};
use super::law::Law;
use super::pair::{GapKind, IntegrationPoint, Master, Measure, Pair, Slave};
use super::solve::{self, PointStatus, Start, State};

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    id: String,
    dim: usize,
    slave: Side,
    master: Side,
    law: LawData,
    start: Vec<f64>,
    normal_sign: f64,
    spread: Spread,
    expected: Expected,
    history: Option<serde_json::Value>,
}

#[derive(Deserialize)]
struct Side {
    geometry: String,
    nodes: Vec<Vec<f64>>,
    eta: Option<Vec<f64>>,
    weights: Option<Vec<f64>>,
}

#[derive(Deserialize)]
struct LawData {
    eps_n: f64,
    r0: f64,
}

#[derive(Deserialize)]
struct Spread {
    residual: f64,
    tangent: f64,
}

#[derive(Deserialize)]
struct Expected {
    zeta: Vec<String>,
    gap: String,
    residual: Vec<String>,
    tangent: Vec<Vec<String>>,
}

fn shape(name: &str) -> Shape {
    match name {
        "point" => Shape::Point,
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
        other => panic!("unknown geometry {other}"),
    }
}

fn interpolation(side: &Side) -> Interpolation {
    let weights = side.weights.clone().filter(|w| !w.is_empty());
    Interpolation {
        shape: shape(&side.geometry),
        weights,
    }
}

fn pad(values: &[f64]) -> [f64; 2] {
    [
        values.first().copied().unwrap_or(0.0),
        values.get(1).copied().unwrap_or(0.0),
    ]
}

fn pair(case: &Case) -> Pair {
    let slave = match (&case.slave.eta, case.slave.geometry.as_str()) {
        (_, "point") => Slave::Point,
        (None, _) => Slave::Curve(interpolation(&case.slave)),
        (Some(eta), _) => Slave::Fixed {
            geometry: interpolation(&case.slave),
            points: vec![IntegrationPoint {
                eta: pad(eta),
                weight: 1.0,
            }],
            measure: Measure::Unit,
        },
    };
    let master = match case.master.geometry.as_str() {
        "point" => Master::Point,
        _ => Master::Shape(interpolation(&case.master)),
    };
    let mut pair = Pair {
        dimension: case.dim,
        slave,
        master,
        gap: GapKind::Distance,
        orientation: case.normal_sign,
        r0: case.law.r0,
        law: Law::Penalty {
            eps_n: case.law.eps_n,
        },
    };
    if case.dim == pair.parameters() + 1 && !case.id.contains("beams") {
        pair.gap = GapKind::Signed;
    }
    pair
}

/// Largest difference relative to the largest expected entry; NaN counts as infinite.
fn error(found: &[f64], expected: &[f64]) -> f64 {
    let top = expected.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let worst = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    let worst = worst.fold(
        0.0,
        |m: f64, d| if d.is_nan() { f64::INFINITY } else { m.max(d) },
    );
    worst / top
}

fn parse(values: &[String]) -> Vec<f64> {
    values.iter().map(|v| v.parse().unwrap()).collect()
}

#[test]
fn frictionless_reference_cases() {
    let text = include_str!("../../data/reference_cases.json");
    let file: File = serde_json::from_str(text).unwrap();
    let mut tried = 0;
    for case in file.cases.iter().filter(|case| case.history.is_none()) {
        let pair = pair(case);
        let x: Vec<f64> = case
            .slave
            .nodes
            .iter()
            .chain(&case.master.nodes)
            .flatten()
            .copied()
            .collect();
        let state = State {
            reference: &x,
            displacement: &vec![0.0; x.len()],
            start: Start::Given(&[pad(&case.start)]),
        };
        let found = solve::evaluate(&pair, &state).unwrap();
        let point = found.points[0];
        assert_eq!(point.status, PointStatus::Closed, "{}", case.id);
        let (zeta, gap) = (
            parse(&case.expected.zeta),
            case.expected.gap.parse::<f64>().unwrap(),
        );
        assert!(
            (point.gap - gap).abs() <= 1e-9 * (1.0 + gap.abs()),
            "{}",
            case.id
        );
        for (found, expected) in point.zeta.iter().zip(&zeta) {
            assert!((found - expected).abs() <= 1e-3, "{}", case.id);
        }
        let residual = error(&found.residual, &parse(&case.expected.residual));
        let flat: Vec<f64> = case
            .expected
            .tangent
            .iter()
            .flat_map(|row| parse(row))
            .collect();
        let tangent = error(&found.tangent, &flat);
        let limit_r = (8.0 * case.spread.residual).max(1e-13);
        let limit_k = (8.0 * case.spread.tangent).max(1e-13);
        assert!(
            residual <= limit_r,
            "{}: residual {residual:e} of {limit_r:e}",
            case.id
        );
        assert!(
            tangent <= limit_k,
            "{}: tangent {tangent:e} of {limit_k:e}",
            case.id
        );
        tried += 1;
    }
    assert_eq!(tried, 52);
}
