//! Beams at large and at small angles: parallel, nearly so, crossing, touching.

use super::case::{EdgeCase, Expected, pair, shape};
use crate::oracle::geometry::{Interpolation, Shape};
use crate::oracle::pair::Angle;
use crate::oracle::pair::{GapKind, IntegrationPoint, Measure, Slave};

const LINE: [[f64; 3]; 2] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
/// The same as a Hermite beam: position, tangent, position, tangent; the tangent equals the second position.
const BEAM: [[f64; 3]; 4] = [LINE[0], LINE[1], LINE[1], LINE[1]];
/// Angles at which the weight begins and ends to change.
const WINDOW: [f64; 2] = [0.1, 0.3];

/// All of this file.
pub(super) fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = large();
    cases.extend(small());
    cases.extend(curved());
    cases
}

/// A straight beam at `angle` to the master, `height` above it.
fn turned(angle: f64, height: f64) -> [[f64; 3]; 2] {
    let (s, c) = angle.sin_cos();
    [[-c, -s, height], [c, s, height]]
}

fn case(
    name: &'static str,
    slave: Slave,
    own: &[[f64; 3]],
    other: &[[f64; 3]],
    curve: Shape,
    angle: Angle,
    expected: Expected,
) -> EdgeCase {
    let mut pair = pair(3, slave, shape(curve), GapKind::Distance, 0.5);
    pair.angle = Some(angle);
    EdgeCase {
        name,
        pair,
        positions: own.iter().chain(other).flatten().copied().collect(),
        start: [[0.0; 2]],
        friction: vec![],
        expected,
    }
}

fn large() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let beams = |name, angle, height, window, expected| {
        let slave = Slave::Curve(Interpolation::new(Shape::Line2));
        let own = turned(angle, height);
        let angle = Angle {
            small: false,
            window,
        };
        case(name, slave, &own, &LINE, Shape::Line2, angle, expected)
    };
    let at = |name, angle, expected| beams(name, angle, 0.25, WINDOW, expected);
    let from_zero = |name, angle, expected| beams(name, angle, 0.25, [0.0, 0.2], expected);
    vec![
        at("large: parallel", 0.0, Open),
        at("large: anti-parallel", std::f64::consts::PI, Open),
        at("large: 1e-15 rad", 1e-15, Open),
        at("large: 1e-9 rad", 1e-9, Open),
        at("large: below the window", 0.09999999, Open),
        at("large: within the window", 0.2, Closed),
        at("large: above the window", 0.30000001, Closed),
        at("large: within, anti-parallel", -2.9, Closed),
        from_zero("large: parallel, window from zero", 0.0, Open),
        from_zero("large: 1e-6 rad, window from zero", 1e-6, Closed),
        beams("large: coincident", 0.0, 0.0, WINDOW, Open),
        beams("large: meeting", 1.0, 0.0, WINDOW, Degenerate),
    ]
}

fn small() -> Vec<EdgeCase> {
    use Expected::{Closed, Degenerate, Open};
    let beams = |name, angle, height, expected| {
        let slave = Slave::Fixed {
            geometry: Interpolation::new(Shape::Line2),
            points: vec![IntegrationPoint {
                eta: [0.25, 0.0],
                weight: 0.75,
            }],
            measure: Measure::Unit,
        };
        let own = turned(angle, height);
        let angle = Angle {
            small: true,
            window: WINDOW,
        };
        case(name, slave, &own, &LINE, Shape::Line2, angle, expected)
    };
    vec![
        beams("small: parallel", 0.0, 0.25, Closed),
        beams("small: anti-parallel", std::f64::consts::PI, 0.25, Closed),
        beams("small: 1e-15 rad", 1e-15, 0.25, Closed),
        beams("small: within the window", 0.2, 0.25, Closed),
        beams("small: above the window", 0.30000001, 0.25, Open),
        beams("small: crossing", 1.5, 0.25, Open),
        beams("small: coincident", 0.0, 0.0, Degenerate),
    ]
}

/// Hermite beams that are straight: F is as singular as of straight segments.
fn curved() -> Vec<EdgeCase> {
    use Expected::{Closed, Open};
    let beams = |name, angle: f64, expected| {
        let [first, last] = turned(angle, 0.25);
        let (s, c) = angle.sin_cos();
        let own = [first, [c, s, 0.0], last, [c, s, 0.0]];
        let slave = Slave::Curve(Interpolation::new(Shape::Hermite));
        let angle = Angle {
            small: false,
            window: WINDOW,
        };
        case(name, slave, &own, &BEAM, Shape::Hermite, angle, expected)
    };
    vec![
        beams("large: parallel Hermite beams", 0.0, Open),
        beams("large: Hermite beams at 1e-12 rad", 1e-12, Open),
        beams("large: Hermite beams at 1e-3 rad", 1e-3, Open),
        beams("large: Hermite beams within the window", 0.2, Closed),
    ]
}
