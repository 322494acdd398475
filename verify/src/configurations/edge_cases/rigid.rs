//! A point against rigid bodies.

use super::case::{EdgeCase, Expected, pair};
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::pair::{GapKind, Master, Slave};

/// All of this file.
pub(super) fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = by_parameters();
    cases.extend(by_distance());
    cases
}

fn case(
    name: &'static str,
    master: Master,
    point: [f64; 3],
    start: [f64; 2],
    expected: Expected,
) -> EdgeCase {
    EdgeCase {
        name,
        pair: pair(3, Slave::Point, master, GapKind::Signed, 0.0),
        positions: point.to_vec(),
        start: [start],
        friction: vec![],
        expected,
    }
}

fn by_parameters() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let parametric = |surface| Master::Parametric {
        surface,
        placement: Placement::Identity,
    };
    let tube = |name, point, start, expected| {
        let surface = RigidParametric::Cylinder { radius: 1.0 };
        case(name, parametric(surface), point, start, expected)
    };
    let ball = |name, point, start, expected| {
        let surface = RigidParametric::Sphere { radius: 1.0 };
        case(name, parametric(surface), point, start, expected)
    };
    let axis = [0.0, 0.0, 0.5];
    vec![
        tube("on a cylinder", [1.0, 0.0, 0.5], [0.0, 0.5], Open),
        tube("far turns", [0.875, 0.0, 0.5], [40.8, 0.0], Closed),
        tube("on a cylinder's axis", axis, [0.5, 0.0], Degenerate),
        ball("a sphere's centre", [0.0; 3], [0.5, 0.25], Degenerate),
    ]
}

fn by_distance() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let distance = |name, body, point, expected| {
        let placement = Placement::Identity;
        let master = Master::Distance { body, placement };
        case(name, master, point, [0.0; 2], expected)
    };
    let tube = |name, point, expected| {
        let body = RigidDistance::Cylinder { radius: 1.0 };
        distance(name, body, point, expected)
    };
    let ball = |name, point, expected| {
        let body = RigidDistance::Sphere { radius: 1.0 };
        distance(name, body, point, expected)
    };
    let torus = |name, point, expected| {
        let (major, minor) = (2.0, 0.5);
        let body = RigidDistance::Torus { major, minor };
        distance(name, body, point, expected)
    };
    vec![
        tube("distance on a cylinder's axis", [0.0; 3], Degenerate),
        ball("distance at a sphere's centre", [0.0; 3], Degenerate),
        ball("distance in a sphere", [0.0, 0.0, 0.75], Closed),
        ball("distance on a sphere", [0.0, 0.0, 1.0], Open),
        torus("a torus' centre circle", [2.0, 0.0, 0.0], Degenerate),
        torus("a torus' axis", [0.0, 0.0, 0.125], Degenerate),
    ]
}
