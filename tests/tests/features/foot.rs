//! The foot that an evaluation finds, from far starts and beyond the corners of a triangle.

use contact_elements::{Evaluation, OUTPUT_SIZE, Registered, evaluate};
use contact_library::{Line2Line2Beams, PointLine2, PointLine3, PointTri3, PointTri6};

const PROJECTION: usize = 4;
const ITERATIONS: usize = 9;
const FEATURE: usize = 10;

/// Projection, iterations and feature of one point.
fn found(
    element: &Registered,
    x: &[f64],
    parameters: &[f64],
    history: &[f64],
) -> ([f64; 2], f64, f64) {
    let mut output = vec![0.0; OUTPUT_SIZE];
    let result = evaluate(
        element,
        &mut Evaluation {
            x,
            parameters,
            history,
            output: &mut output,
            ..Evaluation::default()
        },
    );
    result.expect("evaluated");
    let zeta = [output[PROJECTION], output[PROJECTION + 1]];
    (zeta, output[ITERATIONS], output[FEATURE])
}

fn assert_close(found: [f64; 2], expected: [f64; 2]) {
    let error = (found[0] - expected[0]).abs() + (found[1] - expected[1]).abs();
    assert!(error < 1e-13, "{found:?} instead of {expected:?}");
}

const CURVE: [f64; 2] = [100.0, 0.0];
const FACET: [f64; 3] = [100.0, 0.0, 1.0];

/// Where an affine pair begins does not matter: one linear solve, a second one after a far start.
#[test]
fn affine_pairs_from_far_starts() {
    let x = [0.3, 0.0, 0.2, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    for start in [0.0, 1.5, -7.0, 300.0, -1e5] {
        let (zeta, iterations, feature) = found(PointLine2::DESCRIPTOR, &x, &CURVE, &[4.0, start]);
        assert_close(zeta, [0.3, 0.0]);
        assert!(iterations <= 2.0, "{iterations}");
        assert_eq!(feature, 0.0);
    }
    // beyond the end: the foot on the line itself
    let x = [7.3, 0.0, 0.2, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    let (zeta, _, feature) = found(PointLine2::DESCRIPTOR, &x, &CURVE, &[]);
    assert_close(zeta, [7.3, 0.0]);
    assert_eq!(feature, 6.0);
    let beams = [-1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.4, -1.0, 0.5, 0.4, 1.0, 0.5];
    let far = [4.0, 30.0, -20.0];
    let (zeta, _, feature) = found(Line2Line2Beams::DESCRIPTOR, &beams, &CURVE, &far);
    assert_close(zeta, [0.4, 0.0]);
    assert_eq!(feature, 0.0);
}

/// A foot farther away than a history may hold: the nearest end or corner instead.
#[test]
fn feet_beyond_any_history() {
    let x = [3e9, 0.0, 0.2, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    let (zeta, _, feature) = found(PointLine2::DESCRIPTOR, &x, &CURVE, &[]);
    assert_close(zeta, [1.0, 0.0]);
    assert_eq!(feature, 6.0);
    let x = [3e9, -2e9, 0.2, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let (zeta, _, feature) = found(PointTri3::DESCRIPTOR, &x, &FACET, &[]);
    assert_close(zeta, [1.0, 0.0]);
    assert_eq!(feature, 6.0);
}

/// Both parameters of a plane triangle far beyond: the corner, not the edge that shorter steps lead to.
#[test]
fn far_beyond_a_corner_of_a_triangle() {
    let nodes = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    for (point, feature) in [([3.0, -1.9], 6.0), ([-4.0, 5.5], 7.0), ([-3.0, -8.0], 5.0)] {
        let x = [&point[..], &[0.5], &nodes].concat();
        let (zeta, _, found) = found(PointTri3::DESCRIPTOR, &x, &FACET, &[]);
        assert_close(zeta, point);
        assert_eq!(found, feature, "{point:?}");
    }
}

/// A bowl z = ξ² + η² over the triangle, the point so high that Newton's method finds no minimum: beyond a corner it is
/// held by the corner.
#[test]
fn corners_of_a_curved_triangle() {
    let mut nodes = vec![];
    for [x, y] in [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [0.5, 0.0],
        [0.5, 0.5],
        [0.0, 0.5],
    ] {
        nodes.extend([x, y, x * x + y * y]);
    }
    for (point, feature, corner) in [
        ([0.4, 1.5, 9.0], 7.0, [0.0, 1.0]),
        ([-0.6, 1.5, 9.0], 7.0, [0.0, 1.0]),
        ([1.5, 0.4, 9.0], 6.0, [1.0, 0.0]),
        ([1.5, -0.6, 9.0], 6.0, [1.0, 0.0]),
    ] {
        let x = [&point[..], &nodes].concat();
        // from beside the corner: from the middle the other one may be found
        let start = corner.map(|at| 0.9 * at + 0.02);
        let history = [4.0, start[0], start[1]];
        let (zeta, _, found) = found(PointTri6::DESCRIPTOR, &x, &FACET, &history);
        assert_close(zeta, corner);
        assert_eq!(found, feature, "{point:?}");
    }
}

/// Steps of a free attempt that ends nowhere count too.
#[test]
fn all_iterations_count() {
    // far above a parabola's focus, beside it: Newton's method meets F < 0 at its start
    let x = [0.2, 0.0, 5.0, -1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let (zeta, iterations, feature) = found(PointLine3::DESCRIPTOR, &x, &CURVE, &[]);
    assert_close(zeta, [1.0, 0.0]);
    assert_eq!(feature, 6.0);
    assert!((2.0..=123.0).contains(&iterations), "{iterations}");
}
