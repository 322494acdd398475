//! A point against facets.

use super::case::{EdgeCase, Expected, pair, shape};
use crate::oracle::geometry::{Feature, Shape};
use crate::oracle::pair::{GapKind, Slave};

const FLAT_QUAD: [[f64; 3]; 4] = [
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];
const WARPED_QUAD: [[f64; 3]; 4] = [
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.25],
    [1.0, 1.0, -0.25],
    [-1.0, 1.0, 0.125],
];
const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];

/// All of this file.
pub(super) fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = on_surfaces();
    cases.extend(at_boundaries());
    cases.extend(beyond_boundaries());
    cases.extend(degenerate_nodes());
    cases.extend(extreme_numbers());
    cases
}

/// A point against a facet, signed gap.
fn facet(
    name: &'static str,
    geometry: Shape,
    point: [f64; 3],
    nodes: &[[f64; 3]],
    expected: Expected,
) -> EdgeCase {
    let start = [geometry.region().middle()];
    let pair = pair(3, Slave::Point, shape(geometry), GapKind::Signed, 0.0);
    let positions = point
        .iter()
        .chain(nodes.iter().flatten())
        .copied()
        .collect();
    EdgeCase {
        name,
        pair,
        positions,
        start,
        friction: vec![],
        expected,
    }
}

fn on_surfaces() -> Vec<EdgeCase> {
    use Expected::{Closed, Open};
    let flat = |name, height, expected| {
        let point = [0.25, -0.5, height];
        facet(name, Shape::Quad4, point, &FLAT_QUAD, expected)
    };
    let warped = |name, point, expected| facet(name, Shape::Quad4, point, &WARPED_QUAD, expected);
    vec![
        flat("flat facet", -0.0625, Closed),
        flat("exactly on a flat facet", 0.0, Open),
        flat("on a flat facet, gap -0", -0.0, Open),
        flat("penetration 1e-12", -1e-12, Closed),
        flat("penetration 1e-100", -1e-100, Closed),
        flat("penetration 1e-300", -1e-300, Closed),
        flat("opening 1e-300", 1e-300, Open),
        warped("exactly on a warped facet", [0.0, 0.0, 0.03125], Open),
    ]
}

fn at_boundaries() -> Vec<EdgeCase> {
    use Feature::{Edge, Vertex};
    let quad = |name, x, y, feature| {
        let expected = Expected::OnBoundary(feature);
        facet(name, Shape::Quad4, [x, y, -0.125], &FLAT_QUAD, expected)
    };
    let triangle = |name, x, y, feature| {
        let expected = Expected::OnBoundary(feature);
        facet(name, Shape::Tri3, [x, y, -0.125], &TRIANGLE, expected)
    };
    vec![
        quad("quad4, exactly at edge 0", 0.25, -1.0, Edge(0)),
        quad("quad4, exactly at edge 1", 1.0, 0.25, Edge(1)),
        quad("quad4, exactly at edge 2", 0.25, 1.0, Edge(2)),
        quad("quad4, exactly at edge 3", -1.0, 0.25, Edge(3)),
        quad("quad4, exactly at vertex 0", -1.0, -1.0, Vertex(0)),
        quad("quad4, exactly at vertex 1", 1.0, -1.0, Vertex(1)),
        quad("quad4, exactly at vertex 2", 1.0, 1.0, Vertex(2)),
        quad("quad4, exactly at vertex 3", -1.0, 1.0, Vertex(3)),
        triangle("tri3, exactly at edge 0", 0.5, 0.0, Edge(0)),
        triangle("tri3, exactly at edge 1", 0.5, 1.5, Edge(1)),
        triangle("tri3, exactly at edge 2", 0.0, 0.5, Edge(2)),
        triangle("tri3, exactly at vertex 0", 0.0, 0.0, Vertex(0)),
        triangle("tri3, exactly at vertex 1", 2.0, 0.0, Vertex(1)),
        triangle("tri3, exactly at vertex 2", 0.0, 2.0, Vertex(2)),
    ]
}

fn beyond_boundaries() -> Vec<EdgeCase> {
    use Feature::{Edge, Vertex};
    let quad = |name, x, y, feature| {
        let expected = Expected::Outside(feature);
        facet(name, Shape::Quad4, [x, y, -0.125], &FLAT_QUAD, expected)
    };
    let triangle = |name, x, y, feature| {
        let expected = Expected::Outside(feature);
        facet(name, Shape::Tri3, [x, y, -0.125], &TRIANGLE, expected)
    };
    vec![
        quad("quad4, beyond edge 0", 0.25, -1.25, Edge(0)),
        quad("quad4, beyond edge 1", 1.25, 0.25, Edge(1)),
        quad("quad4, beyond edge 2", 0.25, 1.25, Edge(2)),
        quad("quad4, 1e-6 beyond edge 3", -1.0 - 1e-6, 0.25, Edge(3)),
        quad("quad4, beyond vertex 0", -1.25, -1.5, Vertex(0)),
        quad("quad4, beyond vertex 1", 1.25, -1.5, Vertex(1)),
        quad("quad4, far beyond vertex 2", 50.0, 40.0, Vertex(2)),
        quad("quad4, beyond vertex 3", -1.25, 1.5, Vertex(3)),
        triangle("tri3, beyond edge 0", 0.5, -0.25, Edge(0)),
        triangle("tri3, beyond edge 1", 1.25, 1.25, Edge(1)),
        triangle("tri3, beyond edge 2", -0.5, 1.0, Edge(2)),
        triangle("tri3, beyond vertex 0", -0.5, -0.25, Vertex(0)),
        triangle("tri3, beyond vertex 1", 2.5, -0.25, Vertex(1)),
        triangle("tri3, beyond vertex 2", -0.25, 2.5, Vertex(2)),
    ]
}

fn degenerate_nodes() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate};
    let same = [[0.5, 0.25, 0.0]; 4];
    let needle = [FLAT_QUAD[0], FLAT_QUAD[1], FLAT_QUAD[1], FLAT_QUAD[0]];
    let collapsed = [FLAT_QUAD[0], FLAT_QUAD[1], FLAT_QUAD[2], FLAT_QUAD[2]];
    let point = [0.25, -0.5, -0.125];
    vec![
        facet(
            "quad4, all nodes equal",
            Shape::Quad4,
            point,
            &same,
            Degenerate,
        ),
        facet(
            "quad4 without width",
            Shape::Quad4,
            point,
            &needle,
            Degenerate,
        ),
        facet(
            "quad4, two nodes equal",
            Shape::Quad4,
            point,
            &collapsed,
            Closed,
        ),
        facet(
            "tri3, all nodes equal",
            Shape::Tri3,
            point,
            &same[..3],
            Degenerate,
        ),
    ]
}

fn extreme_numbers() -> Vec<EdgeCase> {
    use Expected::{BadInput, Closed};
    let scaled = |name, factor: f64, shift: f64| {
        let map = |v: [f64; 3]| v.map(|c| factor * c + shift);
        let nodes = WARPED_QUAD.map(map);
        facet(name, Shape::Quad4, map([0.25, -0.5, -0.25]), &nodes, Closed)
    };
    let broken = |name, value| {
        facet(
            name,
            Shape::Quad4,
            [0.25, value, -0.25],
            &WARPED_QUAD,
            BadInput,
        )
    };
    vec![
        scaled("size 2^-40", (-40.0f64).exp2(), 0.0),
        scaled("size 2^40", 40.0f64.exp2(), 0.0),
        scaled("far from the origin", 1.0, 1_048_576.0),
        broken("NaN", f64::NAN),
        broken("infinity", f64::INFINITY),
    ]
}
