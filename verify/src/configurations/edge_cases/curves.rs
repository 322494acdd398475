//! Points, and points against curves, and curves against curves.

use super::case::{EdgeCase, Expected, pair, shape};
use crate::oracle::geometry::{Feature, Interpolation, Shape};
use crate::oracle::pair::{GapKind, Master, Slave};

const LINE: [[f64; 3]; 2] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];

/// All of this file.
pub(super) fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = distances();
    cases.extend(crossings());
    cases.extend(ends());
    cases.extend(centres());
    cases
}

/// A point against a straight line, unsigned.
fn curve(name: &'static str, point: [f64; 3], nodes: &[[f64; 3]], expected: Expected) -> EdgeCase {
    let pair = pair(3, Slave::Point, shape(Shape::Line2), GapKind::Distance, 0.5);
    let all = point.iter().chain(nodes.iter().flatten());
    EdgeCase {
        name,
        pair,
        positions: all.copied().collect(),
        start: [[0.0; 2]],
        friction: vec![],
        expected,
    }
}

/// Two points, unsigned.
fn points(name: &'static str, slave: &[f64], master: &[f64], expected: Expected) -> EdgeCase {
    let gap = GapKind::Distance;
    EdgeCase {
        name,
        pair: pair(slave.len(), Slave::Point, Master::Point, gap, 0.5),
        positions: slave.iter().chain(master).copied().collect(),
        start: [[0.0; 2]],
        friction: vec![],
        expected,
    }
}

fn distances() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let (zero, here) = ([0.0; 3], [0.75; 3]);
    let line = |name, point, expected| curve(name, point, &LINE, expected);
    vec![
        points("equal points in space", &here, &here, Degenerate),
        points(
            "equal points in the plane",
            &[0.5; 2],
            &[0.5; 2],
            Degenerate,
        ),
        points("points at r0 exactly", &[0.5, 0.0, 0.0], &zero, Open),
        points("points at 1e-9", &[0.0, 1e-9, 0.0], &zero, Closed),
        curve("line2 of no length", here, &[[0.25; 3]; 2], Degenerate),
        line("on a straight line", [0.25, 0.0, 0.0], Degenerate),
        line("1e-9 from a line", [0.25, 1e-9, 0.0], Closed),
        line("r0 from a line", [0.25, 0.0, 0.5], Open),
    ]
}

/// Two straight lines.
fn crossing(
    name: &'static str,
    gap: GapKind,
    slave: [[f64; 3]; 2],
    expected: Expected,
) -> EdgeCase {
    let line = Interpolation::new(Shape::Line2);
    let r0 = match gap {
        GapKind::Distance | GapKind::Oriented => 0.5,
        GapKind::Signed => 0.0,
    };
    EdgeCase {
        name,
        pair: pair(3, Slave::Curve(line), shape(Shape::Line2), gap, r0),
        positions: slave.iter().chain(&LINE).flatten().copied().collect(),
        start: [[0.0; 2]],
        friction: vec![],
        expected,
    }
}

/// A straight line across the master at `x`, from `low` to `high`, lifted by `z`.
fn across(x: f64, low: f64, high: f64, z: f64) -> [[f64; 3]; 2] {
    [[x, low, z], [x, high, z]]
}

fn crossings() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let slanted = |angle: f64| [[-1.0, -angle, 0.25], [1.0, angle, 0.25]];
    let beams = |name, slave, expected| crossing(name, GapKind::Distance, slave, expected);
    let edges = |name, height, expected| {
        let slave = across(0.25, -1.0, 1.0, height);
        crossing(name, GapKind::Signed, slave, expected)
    };
    vec![
        beams("crossing", across(0.25, -1.0, 1.0, 0.25), Closed),
        beams("meeting", across(0.25, -1.0, 1.0, 0.0), Degenerate),
        beams("beams at an angle of 1e-3", slanted(1e-3), Closed),
        beams("parallel beams", slanted(0.0), Degenerate),
        edges("edges meeting", 0.0, Open),
        edges("edges 1e-12 deep", -1e-12, Closed),
        edges("edges 1e-300 deep", -1e-300, Closed),
        edges("edges apart", 0.25, Open),
    ]
}

fn ends() -> Vec<EdgeCase> {
    use Expected::{OnBoundary, Outside};
    use Feature::{BothEnds, MasterEnd, SlaveEnd, Vertex};
    let beams = |name, x, low, high, expected| {
        let slave = across(x, low, high, 0.25);
        crossing(name, GapKind::Distance, slave, expected)
    };
    let beyond = |name, x, low, high, feature| beams(name, x, low, high, Outside(feature));
    let line = |name, x, expected| curve(name, [x, 0.25, 0.0], &LINE, expected);
    vec![
        beams("at slave end 0", 0.25, 0.0, 1.0, OnBoundary(SlaveEnd(0))),
        beams("at master end 1", 1.0, -1.0, 1.0, OnBoundary(MasterEnd(1))),
        beyond("beyond slave end 0", 0.25, 0.125, 1.0, SlaveEnd(0)),
        beyond("beyond slave end 1", 0.25, -1.0, -0.125, SlaveEnd(1)),
        beyond("beyond master end 0", -1.25, -1.0, 1.0, MasterEnd(0)),
        beyond("beyond master end 1", 1.25, -1.0, 1.0, MasterEnd(1)),
        beyond("beyond ends 0 and 0", -1.25, 0.125, 1.0, BothEnds(0, 0)),
        beyond("beyond ends 1 and 0", -1.25, -1.0, -0.125, BothEnds(1, 0)),
        beyond("beyond ends 0 and 1", 1.25, 0.125, 1.0, BothEnds(0, 1)),
        beyond("beyond ends 1 and 1", 1.25, -1.0, -0.125, BothEnds(1, 1)),
        line("beyond end 0", -1.25, Outside(Vertex(0))),
        line("beyond end 1", 1.25, Outside(Vertex(1))),
        line("at end 1", 1.0, OnBoundary(Vertex(1))),
    ]
}

fn centres() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    vec![
        focal("at the centre of curvature", 1.25, Degenerate),
        focal("near the centre of curvature", 1.24875, Closed),
        focal("on a curve in the plane", 0.0, Open),
    ]
}

/// A point above the apex of a parabola in the plane, radius of curvature 1.25 there.
fn focal(name: &'static str, height: f64, expected: Expected) -> EdgeCase {
    let mut pair = pair(2, Slave::Point, shape(Shape::Line3), GapKind::Signed, 0.0);
    pair.orientation = -1.0;
    let positions = vec![0.0, height, -1.0, 0.4, 1.0, 0.4, 0.0, 0.0];
    EdgeCase {
        name,
        pair,
        positions,
        start: [[0.0; 2]],
        friction: vec![],
        expected,
    }
}
