//! Global projection: known answers where Newton's method from the centre finds another point, and what is refused.

use contact_elements::{Closest, Descriptor, Error, Query, Verdict, argument, code, project};
use contact_library::{
    HermiteHermiteBeams, Line2Line2Beams, PointCircle2d, PointHelix, PointLine3In2d, PointQuad4,
    PointQuad4Coulomb, PointQuad9, PointSphere, PointTri3,
};

fn found(element: &Descriptor, query: &Query<'_>) -> (Result<(), Error>, Closest) {
    let mut result = [Closest::default()];
    let outcome = project(element, query, &mut result, &mut []);
    (outcome, result[0])
}

fn at(element: &Descriptor, x: &[f64], parameters: &[f64], reach: f64) -> Closest {
    let query = Query {
        x,
        parameters,
        reach,
        ..Query::default()
    };
    let (outcome, result) = found(element, &query);
    outcome.expect("projected");
    result
}

/// A point above the unit square [-1, 1]².
fn above([x, y, z]: [f64; 3]) -> Vec<f64> {
    let square = [
        -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
    ];
    [&[x, y, z], &square[..]].concat()
}

const FACET: [f64; 3] = [100.0, 0.0, 1.0];

/// Inside, beyond each edge and each corner of a square.
#[test]
fn features_of_a_square() {
    let facet = PointQuad4::DESCRIPTOR;
    let expected = [[8, 3, 7], [4, 0, 2], [5, 1, 6]];
    for (row, y) in [1.7, 0.2, -1.3].into_iter().enumerate() {
        for (column, x) in [-2.0, 0.3, 1.4].into_iter().enumerate() {
            let result = at(facet, &above([x, y, 0.5]), &FACET, 0.0);
            assert_eq!(result.feature, expected[row][column], "{x} {y}: {result:?}");
            let foot: [f64; 2] = [x, y].map(|v: f64| v.clamp(-1.0, 1.0));
            let distance = (x - foot[0]).hypot(y - foot[1]).hypot(0.5);
            assert!((result.distance - distance).abs() < 1e-15 * 8.0);
            assert!((result.zeta[0] - foot[0]).abs() + (result.zeta[1] - foot[1]).abs() < 1e-14);
            let verdict = if result.feature == 0 {
                Verdict::Inside
            } else {
                Verdict::Boundary
            };
            assert_eq!(result.verdict, verdict);
            assert!((result.definiteness - 1.0).abs() < 1e-14);
        }
    }
}

/// A trough of a biquadratic facet, z = x²: below its focal line there is one foot, above it two that are as near,
/// and a little to one side the nearer one.
#[test]
fn two_feet_in_a_trough() {
    let mut nodes = vec![];
    for [x, y] in [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [0.0, -1.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
        [0.0, 0.0],
    ] {
        nodes.extend([x, y, x * x]);
    }
    let foot = |x: f64, z: f64| {
        let x = [&[x, 0.1, z], &nodes[..]].concat();
        at(PointQuad9::DESCRIPTOR, &x, &FACET, 0.0)
    };
    let low = foot(0.0, 0.3);
    assert_eq!(low.verdict, Verdict::Inside);
    // F/a = 1 − 2 z
    assert!((low.definiteness - 0.4).abs() < 1e-14, "{low:?}");
    let high = foot(0.0, 1.0);
    assert_eq!(high.verdict, Verdict::NotUnique);
    assert!(
        (high.zeta[0].abs() - 0.5_f64.sqrt()).abs() < 1e-12,
        "{high:?}"
    );
    for side in [-1.0, 1.0] {
        let near = foot(1e-3 * side, 1.0);
        assert_eq!(near.verdict, Verdict::Inside);
        assert!(near.zeta[0] * side > 0.7, "{near:?}");
    }
    // on the focal line F vanishes at the foot, which is known to the root of the root of rounding
    assert!(foot(0.0, 0.5).definiteness.abs() < 1e-6);
}

/// A foot a few millionths beside -1/2, where the search cuts its boxes, on the parabola y = x²: what the box beside it
/// ends with is no second foot.
#[test]
fn a_foot_beside_a_cut() {
    for beside in [-5.5e-6, -4e-6, -2.5e-6, 0.0, 2.5e-6, 4e-6, 5.5e-6] {
        let foot: f64 = -0.5 + beside;
        let (x, y) = (foot + 2.0 * foot * (foot * foot - 0.7), 0.7);
        let nodes = [x, y, -1.0, 1.0, 1.0, 1.0, 0.0, 0.0];
        let result = at(PointLine3In2d::DESCRIPTOR, &nodes, &FACET, 0.0);
        assert_eq!(result.verdict, Verdict::Inside, "{beside}: {result:?}");
        assert!((result.zeta[0] - foot).abs() < 1e-13, "{result:?}");
    }
}

/// The nearest turn of a helix, found among all of them.
#[test]
fn the_nearest_turn() {
    // eps_n, r0, radius, rise, placement
    let parameters = [1e3, 0.1, 1.0, 0.05, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    for turn in [-40.0, 0.0, 7.0, 300.0] {
        let angle: f64 = std::f64::consts::TAU * turn + 0.3;
        let x = [1.2 * 0.3_f64.cos(), 1.2 * 0.3_f64.sin(), 0.05 * angle];
        let result = at(PointHelix::DESCRIPTOR, &x, &parameters, 0.0);
        assert_eq!(result.verdict, Verdict::Inside, "{result:?}");
        assert!(
            (result.zeta[0] - angle).abs() < 1e-10 * angle.abs().max(1.0),
            "{result:?}"
        );
        assert!((result.distance - 0.2).abs() < 1e-12);
    }
}

/// Closed projections: taken as declared; every point of a circle is as near to its centre.
#[test]
fn closed_projections() {
    let placed = |radius: f64| [1e3, 0.0, 1.0, radius, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let result = at(PointSphere::DESCRIPTOR, &[0.0, 3.0, 0.0], &placed(1.0), 0.0);
    assert_eq!((result.verdict, result.boxes), (Verdict::Inside, 0));
    assert!((result.distance - 2.0).abs() < 1e-15);
    assert!((result.definiteness - 3.0).abs() < 1e-14);
    let plane = [1e3, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let centre = at(PointCircle2d::DESCRIPTOR, &[0.0, 0.0], &plane, 0.0);
    assert_eq!(centre.verdict, Verdict::NotUnique, "{centre:?}");
}

/// Nothing is farther than the reach.
#[test]
fn reach() {
    let point = above([0.3, 0.2, 0.5]);
    for (reach, verdict) in [
        (0.49, Verdict::Beyond),
        (0.51, Verdict::Inside),
        (1e30, Verdict::Inside),
    ] {
        let result = at(PointQuad4::DESCRIPTOR, &point, &FACET, reach);
        assert_eq!(result.verdict, verdict, "{reach}");
    }
}

/// Straight Hermite beams that cross, and parallel ones: a line of closest points.
#[test]
fn crossing_and_parallel_beams() {
    let beam = |p: [f64; 3], t: [f64; 3]| {
        let end = [0, 1, 2].map(|k| p[k] + 2.0 * t[k]);
        [p, t, end, t].concat()
    };
    let first = beam([-1.0, 0.2, 0.0], [1.0, 0.0, 0.0]);
    let parameters = [1e3, 0.1];
    let crossing = beam([0.3, -1.0, 0.4], [0.0, 1.0, 0.0]);
    let x = [&first[..], &crossing].concat();
    let result = at(HermiteHermiteBeams::DESCRIPTOR, &x, &parameters, 0.0);
    assert_eq!(result.verdict, Verdict::Inside);
    assert!((result.zeta[0] - 0.3).abs() + (result.zeta[1] - 0.2).abs() < 1e-14);
    assert!((result.distance - 0.4).abs() < 1e-15);
    let parallel = beam([-0.5, 0.2, 0.4], [1.0, 0.0, 0.0]);
    let x = [&first[..], &parallel].concat();
    let result = at(HermiteHermiteBeams::DESCRIPTOR, &x, &parameters, 0.0);
    assert!(
        result.verdict == Verdict::NotUnique || result.verdict == Verdict::Undecided,
        "{result:?}"
    );
}

/// Lines that all but meet: of such a distance the rounding is a large part.
#[test]
fn beams_that_meet_to_rounding() {
    for gap in [0.0, 1e-15, 1e-12, 3e-9, 1e-7, 2e-6, 1e-5] {
        for turn in 0..200 {
            let angle = 0.1 + 0.015 * f64::from(turn);
            let (sin, cos) = angle.sin_cos();
            let middle = [0.31 + 0.07 * sin, -0.17 + 0.05 * cos, 0.6];
            let end = |along: f64, way: [f64; 3], lift: f64| {
                [0, 1, 2].map(|k| middle[k] + along * way[k] + if k == 2 { lift } else { 0.0 })
            };
            let (first, last) = ([1.0, 0.2 * sin, 0.0], [cos, sin, 0.0]);
            let x = [
                end(-0.7, first, 0.0),
                end(0.9, first, 0.0),
                end(-1.1, last, gap),
                end(0.8, last, gap),
            ]
            .concat();
            let result = at(Line2Line2Beams::DESCRIPTOR, &x, &[1e3, 0.1], 0.0);
            let error = (result.distance - gap).abs();
            assert!(
                result.verdict != Verdict::Beyond && error < 4e-15,
                "{gap} {turn}: {result:?}"
            );
        }
    }
}

/// The least distance of two segments: between an end and the other segment, or between their lines.
fn between_segments([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|k| p[k] - q[k]);
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let at = |p: [f64; 3], way: [f64; 3], s: f64| [0, 1, 2].map(|k| p[k] + s * way[k]);
    let length = |v: [f64; 3]| dot(v, v).sqrt();
    let from = |p: [f64; 3], [a, b]: [[f64; 3]; 2]| {
        let way = minus(b, a);
        let s = (dot(minus(p, a), way) / dot(way, way)).clamp(0.0, 1.0);
        length(minus(p, at(a, way, s)))
    };
    let ends = [
        from(a, [c, d]),
        from(b, [c, d]),
        from(c, [a, b]),
        from(d, [a, b]),
    ];
    let (u, v, w) = (minus(b, a), minus(d, c), minus(a, c));
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    let (s, t) = (
        (uv * vw - vv * uw) / determinant,
        (uu * vw - uv * uw) / determinant,
    );
    let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    let crossing = match inside {
        true => length(minus(at(a, u, s), at(c, v, t))),
        false => f64::MAX,
    };
    ends.into_iter().fold(crossing, f64::min)
}

/// Segments at all angles down to 0.01 rad: the minimum is often at an end, near a corner of the domain.
#[test]
fn segments_of_any_angle() {
    let mut seed = 1_u64;
    let mut number = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for state in 0..60_000 {
        let spread = [1.0, 0.1, 0.01][state % 3];
        let mut vector = |size: f64| [0; 3].map(|_| size * number());
        let (a, way, start, turn) = (vector(1.0), vector(1.5), vector(1.0), vector(spread));
        let plus = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|k| p[k] + q[k]);
        let (b, d) = (plus(a, way), plus(start, plus(way, turn)));
        let x = [a, b, start, d].concat();
        let result = at(Line2Line2Beams::DESCRIPTOR, &x, &[1e3, 0.1], 0.0);
        let expected = between_segments([a, b], [start, d]);
        let error = (result.distance - expected).abs();
        assert!(error < 1e-11, "{state}: {expected} {result:?}");
    }
}

/// The history begins at the foot: projection and anchor.
#[test]
fn history_begins_at_the_foot() {
    let element = PointQuad4Coulomb::DESCRIPTOR;
    let (x, parameters) = (above([0.3, -0.6, -0.1]), [100.0, 50.0, 0.3, 0.0, 1.0]);
    let mut history = [7.0; 6];
    let query = Query {
        x: &x,
        parameters: &parameters,
        ..Query::default()
    };
    project(element, &query, &mut [Closest::default()], &mut history).expect("projected");
    let expected = [0.0, 0.3, -0.6, 0.3, -0.6, 0.0];
    for (found, expected) in history.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{history:?}");
    }
}

#[test]
fn bad_input() {
    let element = PointQuad4::DESCRIPTOR;
    let x = above([0.0, 0.0, 0.5]);
    let good = Query {
        x: &x,
        parameters: &FACET,
        ..Query::default()
    };
    let fault = |query: &Query<'_>| {
        let (outcome, result) = found(element, query);
        assert_eq!(result, Closest::default());
        let error = outcome.expect_err("refused");
        (error.code, error.argument, error.index)
    };
    for reach in [f64::NAN, -1.0, f64::INFINITY] {
        let query = Query { reach, ..good };
        assert_eq!(fault(&query), (code::NOT_FINITE, argument::REACH, 0));
    }
    let mut broken = x.clone();
    broken[7] = f64::NAN;
    let query = Query { x: &broken, ..good };
    assert_eq!(fault(&query), (code::NOT_FINITE, argument::X, 2));
    let query = Query { u: &broken, ..good };
    assert_eq!(fault(&query), (code::NOT_FINITE, argument::U, 2));
    let query = Query {
        x: &x[..14],
        ..good
    };
    assert_eq!(fault(&query), (code::NULL, argument::X, 0));
    let query = Query {
        parameters: &[-1.0, 0.0, 1.0],
        ..good
    };
    assert_eq!(fault(&query), (code::PARAMETER, argument::PARAMETERS, 0));
    let error = project(element, &good, &mut [], &mut []).expect_err("refused");
    assert_eq!((error.code, error.argument), (code::NULL, argument::RESULT));
    let short = project(element, &good, &mut [Closest::default()], &mut [0.0; 2]);
    let error = short.expect_err("refused");
    assert_eq!(
        (error.code, error.argument),
        (code::NULL, argument::HISTORY_TRIAL)
    );
}

/// Beyond the edges and corners of a triangle.
#[test]
fn features_of_a_triangle() {
    let nodes = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    for (point, feature, zeta) in [
        ([0.3, -0.2], 1, [0.3, 0.0]),
        ([0.8, 0.8], 2, [0.5, 0.5]),
        ([-0.2, 0.4], 3, [0.0, 0.4]),
        ([-0.2, -0.1], 5, [0.0, 0.0]),
        ([1.4, 0.1], 6, [1.0, 0.0]),
        ([1.1, -0.3], 6, [1.0, 0.0]),
        ([0.1, 1.4], 7, [0.0, 1.0]),
        ([-0.3, 1.1], 7, [0.0, 1.0]),
    ] {
        let x = [&point[..], &[0.5], &nodes].concat();
        let result = at(PointTri3::DESCRIPTOR, &x, &FACET, 0.0);
        assert_eq!(result.feature, feature, "{point:?}: {result:?}");
        let error = (result.zeta[0] - zeta[0]).abs() + (result.zeta[1] - zeta[1]).abs();
        assert!(error < 1e-14, "{point:?}: {result:?}");
    }
}
