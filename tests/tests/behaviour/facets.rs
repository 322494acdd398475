//! One plane, many elements: a flat facet of any kind is the rigid plane, whichever side is touched.

use crate::pair::Pair;
use crate::vector::{difference, largest};

const GIVEN: [(&str, f64); 3] = [("eps_n", 1e4), ("eps_t", 3e3), ("mu", 0.4)];

/// Nodes at these parameters of the parallelogram with corners 0, a, a + b, b.
fn nodes(parameters: &[[f64; 2]]) -> Vec<f64> {
    let (a, b) = ([3.0, 0.3], [-0.4, 2.5]);
    let node = |&[s, t]: &[f64; 2]| [s * a[0] + t * b[0] - 1.0, s * a[1] + t * b[1] - 1.0, 0.0];
    parameters.iter().flat_map(node).collect()
}

/// The elements with their nodes. Weights of one make a rational surface a polynomial.
fn facets() -> Vec<(Pair, Vec<f64>)> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let middles = [[0.5, 0.0], [1.0, 0.5], [0.5, 1.0], [0.0, 0.5], [0.5, 0.5]];
    let quad9 = [&corners[..], &middles].concat();
    let half = |k: usize| 0.5 * k as f64;
    let grid: Vec<_> = (0..9).map(|k| [half(k % 3), half(k / 3)]).collect();
    let mut rational = GIVEN
        .map(|(name, value)| (name.to_string(), value))
        .to_vec();
    rational.extend((0..9).map(|k| (format!("master_weight_{k}"), 1.0)));
    let rational: Vec<_> = rational
        .iter()
        .map(|(name, value)| (name.as_str(), *value))
        .collect();
    vec![
        (
            Pair::new("PointTri3Coulomb", &GIVEN),
            nodes(&[[-1.0, -1.0], [2.0, 0.0], [0.0, 2.0]]),
        ),
        (Pair::new("PointQuad4Coulomb", &GIVEN), nodes(&corners)),
        (Pair::new("PointQuad9Coulomb", &GIVEN), nodes(&quad9)),
        (
            Pair::new("PointBezierSurface2Coulomb", &GIVEN),
            nodes(&grid),
        ),
        (
            Pair::new("PointRationalSurface2Coulomb", &rational),
            nodes(&grid),
        ),
    ]
}

/// Force, tangent at the point and slip path on a path that sticks and slips, against the plane; from below
/// with the orientation turned round. 1e-12: forces are differences of coordinates of 1 times the stiffness,
/// relative to forces of 4.
#[test]
fn a_flat_facet_is_a_plane() {
    let mut most = [0.0_f64; 2];
    for (mut pair, nodes) in facets() {
        for side in [1.0, -1.0] {
            let mut plane = Pair::new("PointPlaneCoulomb", &GIVEN);
            pair.history.clear();
            pair.set("orientation", side);
            plane.set("orientation", side);
            for step in 0..=100 {
                let s = f64::from(step) / 100.0;
                let point = [0.4 * (7.0 * s).sin(), 0.3 * s * s, -1e-3 * side];
                let expected = plane.step(&point);
                let state = pair.step(&[&point[..], &nodes].concat());
                assert_eq!(state.outcome.status, expected.outcome.status);
                let size = largest(&expected.residual);
                let force = difference(&state.residual[..3], &expected.residual) / size;
                let entries = (0..9).map(|at| (at / 3, at % 3));
                let tangent = entries
                    .map(|(i, j)| (state.k(i, j) - expected.k(i, j)).abs())
                    .fold(0.0, f64::max);
                most[0] = most[0].max(force);
                most[1] = most[1].max(tangent / largest(&expected.tangent));
                assert!((pair.path() - plane.path()).abs() < 1e-12);
            }
        }
    }
    println!(
        "facets: five kinds against the plane, forces {:.1e}, tangents {:.1e}",
        most[0], most[1]
    );
    assert!(most[0] < 1e-12 && most[1] < 1e-12);
}
