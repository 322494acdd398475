//! Friction where it tends to fail: tiny and zero tractions, no bound, long ways, closed surfaces.

use super::case::{EdgeCase, Expected, pair, shape};
use crate::oracle::geometry::{Interpolation, Placement, RigidParametric, Shape};
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::pair::{GapKind, IntegrationPoint, Master, Measure, Slave};
use crate::oracle::tangential::TangentialLaw;

/// All of this file.
pub(super) fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = isotropic();
    cases.extend(orthotropic());
    cases.extend(closed_surfaces());
    cases.push(upright_slave());
    cases
}

/// A square in the plane z = 0 whose parameters are its coordinates.
const SQUARE: [f64; 12] = [
    -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
];
/// Middles of its edges, and of itself.
const MIDDLES: [f64; 15] = [
    0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
];
/// Where the point is on it.
const FOOT: [f64; 2] = [0.25, -0.125];

fn coulomb(eps_t: f64, mu: f64) -> Tangential {
    Tangential::isotropic(TangentialLaw::Coulomb { eps_t, mu })
}

fn ellipse(eps_t: [f64; 2], mu: [f64; 2]) -> Tangential {
    let law = TangentialLaw::Orthotropic { eps_t, mu };
    Tangential::orthotropic(law, Axis::Convected([1.0, 0.5]))
}

/// History with the anchor at a place.
fn anchored(status: Accepted, anchor: [f64; 2]) -> Vec<FrictionHistory> {
    let slip = 0.0;
    vec![FrictionHistory {
        status,
        anchor,
        slip,
        rolling: RollingHistory::default(),
    }]
}

/// A point `depth` below the square that has moved by `way` since its anchor.
fn moved(
    name: &'static str,
    law: Tangential,
    depth: f64,
    way: [f64; 2],
    expected: Expected,
) -> EdgeCase {
    let mut pair = pair(3, Slave::Point, shape(Shape::Quad4), GapKind::Signed, 0.0);
    pair.tangential = Some(law);
    let mut positions = vec![FOOT[0], FOOT[1], -depth];
    positions.extend(SQUARE);
    EdgeCase {
        name,
        pair,
        positions,
        start: [[0.0; 2]],
        friction: anchored(Accepted::Stick, [FOOT[0] - way[0], FOOT[1] - way[1]]),
        expected,
    }
}

/// Pressure 62.5 at a depth of 1/16.
fn isotropic() -> Vec<EdgeCase> {
    use Expected::{BadInput, Slip, Stick};
    let depth = 0.0625;
    let case = |name, law, way, expected| moved(name, law, depth, way, expected);
    let usual = || coulomb(500.0, 0.25);
    let mut begins = case("contact begins", usual(), [0.0; 2], Stick);
    begins.friction = vec![];
    let mut again = case("contact begins again", usual(), [0.5, 0.5], Stick);
    again.friction[0].status = Accepted::Open;
    let mut broken = case("anchor is NaN", usual(), [0.0; 2], BadInput);
    broken.friction[0].anchor[1] = f64::NAN;
    vec![
        begins,
        again,
        broken,
        case("no way from the anchor", usual(), [0.0; 2], Stick),
        case("a way of 1e-14", usual(), [0.0, 1e-14], Stick),
        case("a way of 1e-100", usual(), [1e-100, 0.0], Stick),
        case("slip after 1e-9", coulomb(1e12, 0.25), [6e-10, 8e-10], Slip),
        // so little of it that its direction, of which two digits are left, does not matter
        case("slip after 1e-14", coulomb(1.0, 1e-18), [0.0, 1e-14], Slip),
        case(
            "no coefficient of friction",
            coulomb(500.0, 0.0),
            [0.1, 0.0],
            Slip,
        ),
        case("a way of 1e3", usual(), [600.0, -800.0], Slip),
        moved(
            "friction at a depth of 1e-9",
            usual(),
            1e-9,
            [0.1, 0.0],
            Slip,
        ),
    ]
}

fn orthotropic() -> Vec<EdgeCase> {
    use Expected::{Slip, Stick};
    let case = |name, law, way, expected| moved(name, law, 0.0625, way, expected);
    let usual = || ellipse([500.0, 300.0], [0.25, 0.125]);
    let thin = || ellipse([500.0, 300.0], [1e-6, 1.0]);
    let uneven = || ellipse([5e-3, 3e6], [0.25, 0.125]);
    vec![
        case("two axes, no way", usual(), [0.0; 2], Stick),
        case("two axes, a way of 1e-14", usual(), [1e-14, 0.0], Stick),
        case("two axes, a way of 1e3", usual(), [600.0, 800.0], Slip),
        case("a thin ellipse", thin(), [0.1, 0.2], Slip),
        case("uneven stiffnesses", uneven(), [0.1, -0.05], Slip),
    ]
}

/// Points that have passed the seam of a closed surface since their anchor.
fn closed_surfaces() -> Vec<EdgeCase> {
    use Expected::{Slip, Stick};
    let case = |name, surface, position: [f64; 3], anchor, expected| {
        let placement = Placement::Identity;
        let master = Master::Parametric { surface, placement };
        let mut pair = pair(3, Slave::Point, master, GapKind::Signed, 0.0);
        pair.tangential = Some(coulomb(500.0, 0.25));
        EdgeCase {
            name,
            pair,
            positions: position.to_vec(),
            start: [anchor],
            friction: anchored(Accepted::Stick, anchor),
            expected,
        }
    };
    // 0.01 or 0.1 beyond half a turn, the anchor a little before it
    let behind = |radius: f64, way: f64| [-radius * way.cos(), -radius * way.sin(), 0.25];
    let tube = || RigidParametric::Cylinder { radius: 1.0 };
    let seam = [3.125, 0.25];
    vec![
        case(
            "stick over a seam",
            tube(),
            behind(0.9375, 0.01),
            seam,
            Stick,
        ),
        case("slip over a seam", tube(), behind(0.9375, 0.1), seam, Slip),
        case(
            "slip after six turns",
            tube(),
            behind(0.9375, 0.1),
            [40.824, 0.25],
            Slip,
        ),
    ]
}

/// A slave curve along the normal gives no axis.
fn upright_slave() -> EdgeCase {
    let slave = Slave::Fixed {
        geometry: Interpolation::new(Shape::Line2),
        points: vec![IntegrationPoint {
            eta: [0.0; 2],
            weight: 1.0,
        }],
        measure: Measure::Unit,
    };
    let mut pair = pair(3, slave, shape(Shape::Quad9), GapKind::Signed, 0.0);
    let law = TangentialLaw::Orthotropic {
        eps_t: [500.0; 2],
        mu: [0.25; 2],
    };
    pair.tangential = Some(Tangential::orthotropic(law, Axis::SlaveCurve));
    let mut positions = vec![0.0, 0.0, -0.5, 0.0, 0.0, 0.25];
    positions.extend(SQUARE);
    positions.extend(MIDDLES);
    EdgeCase {
        name: "slave upright on its axes",
        pair,
        positions,
        start: [[0.0; 2]],
        friction: anchored(Accepted::Stick, [0.1, 0.0]),
        expected: Expected::Degenerate,
    }
}
