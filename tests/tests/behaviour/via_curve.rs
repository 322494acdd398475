//! Curve on surface in both forms of the paper: via the curve (17), (18) and via the surface (19), (20).
//!
//! Via the curve the friction does work on the relative displacement along the curve's tangent τ and along
//! g = n×τ: `T τ·δr + G g·δr`. Via the surface it does work on the projected parameters: `T_i δζ^i`. The test
//! writes the first out with its own shape functions.

use contact_elements::runtime::Status;

use crate::pair::{Pair, State};
use crate::vector::{Vector, add, cross, difference, dot, largest, scaled, subtract, unit};

const CURVE: [Vector; 4] = [
    [-0.6, -0.2, 0.1],
    [1.1, 0.3, -0.2],
    [0.5, 0.2, 0.05],
    [0.9, -0.4, 0.3],
];
const FACET: [Vector; 4] = [
    [-1.0, -1.0, 0.1],
    [1.2, -0.9, -0.2],
    [0.9, 1.1, 0.15],
    [-1.1, 1.0, -0.1],
];
/// Point of the curve and its weight.
const ETA: f64 = 0.35;
const WEIGHT: f64 = 0.7;

/// Hermite functions of the curve's point and their slopes, bilinear functions of the facet.
fn shape(zeta: [f64; 2]) -> ([f64; 4], [f64; 4], [f64; 4]) {
    let (t, a, b) = (ETA, 1.0 - ETA, 1.0 + ETA);
    let values = [
        a * a * (2.0 + t) / 4.0,
        a * a * b / 4.0,
        b * b * (2.0 - t) / 4.0,
        -b * b * a / 4.0,
    ];
    let slopes = [
        -3.0 * a * b / 4.0,
        a * (a - 2.0 * b) / 4.0,
        3.0 * a * b / 4.0,
        b * (b - 2.0 * a) / 4.0,
    ];
    let [x, y] = zeta;
    let corner = |a: f64, b: f64| 0.25 * (1.0 + a * x) * (1.0 + b * y);
    let facet = [
        corner(-1.0, -1.0),
        corner(1.0, -1.0),
        corner(1.0, 1.0),
        corner(-1.0, 1.0),
    ];
    (values, slopes, facet)
}

fn at_point(factors: [f64; 4], nodes: &[Vector]) -> Vector {
    factors
        .into_iter()
        .zip(nodes)
        .fold([0.0; 3], |sum, (factor, &node)| {
            add(sum, scaled(factor, node))
        })
}

/// The curve `depth` below the facet, its foot at `foot` on it.
fn nodes(depth: f64, foot: [f64; 2]) -> Vec<f64> {
    let (values, _, facet) = shape(foot);
    let [x, y] = foot;
    let part = |a: [f64; 4]| at_point(a.map(|v| 0.25 * v), &FACET);
    let b = [
        part([y - 1.0, 1.0 - y, 1.0 + y, -1.0 - y]),
        part([x - 1.0, -1.0 - x, 1.0 + x, 1.0 - x]),
    ];
    let normal = unit(cross(b[0], b[1]));
    let wanted = subtract(at_point(facet, &FACET), scaled(depth, normal));
    let shift = subtract(wanted, at_point(values, &CURVE));
    let mut curve = CURVE;
    for node in [0, 2] {
        curve[node] = add(curve[node], shift); // 1 and 3 are tangent vectors
    }
    curve.iter().chain(&FACET).flatten().copied().collect()
}

/// Friction's part of residual and tangent after a step along the facet, at a distance L; r0 makes the gap -0.05.
fn friction(name: &str, depth: f64, mu: f64) -> (Vec<f64>, State, Vec<f64>) {
    let given = [
        ("eps_n", 1e3),
        ("eps_1", 4e2),
        ("eps_2", 2e2),
        ("mu_1", mu),
        ("mu_2", 0.6 * mu),
        ("r0", 0.05 - depth),
        ("eta_1", ETA),
        ("weight", WEIGHT),
    ];
    let mut pair = Pair::new(name, &given);
    pair.step(&nodes(depth, [0.1, -0.2]));
    let x = nodes(depth, [0.17, -0.11]);
    let with = pair.at(&x);
    pair.history.clear(); // contact that begins has no friction
    let without = pair.at(&x);
    let minus = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<f64>>();
    let residual = minus(&with.residual, &without.residual);
    let tangent = minus(&with.tangent, &without.tangent);
    (residual, with, tangent)
}

/// −w s_A (T τ + G g), with the tangent of the curve laid into the tangent plane.
fn via_curve(state: &State) -> Vec<f64> {
    let point = state.point(0);
    let (values, slopes, facet) = shape(point.zeta);
    let tangent = at_point(slopes, &CURVE);
    let across = dot(tangent, point.normal);
    let tau = unit(subtract(tangent, scaled(across, point.normal)));
    let g = cross(point.normal, tau);
    let traction = add(scaled(point.t[0], tau), scaled(point.t[1], g));
    let own = values.into_iter().map(|s| scaled(-WEIGHT * s, traction));
    let other = facet.into_iter().map(|s| scaled(WEIGHT * s, traction));
    own.chain(other).flatten().collect()
}

const VIA_CURVE: &str = "HermiteQuad4OrthotropicAtPointTangentPlane";
const VIA_SURFACE: &str = "HermiteQuad4OrthotropicAtPoint";

/// The form on the tangent plane is the curve's, at any distance, sticking and sliding. Differences of residuals
/// that are 20 times as large: 1e-13.
#[test]
fn the_form_on_the_tangent_plane_is_the_curves() {
    let mut most: f64 = 0.0;
    for (mu, status) in [(0.1, Status::Slip), (5.0, Status::Stick)] {
        for depth in [0.0, 0.05, 0.3] {
            let (found, state, _) = friction(VIA_CURVE, depth, mu);
            assert_eq!(state.status(), status);
            let expected = via_curve(&state);
            most = most.max(difference(&found, &expected) / largest(&expected));
        }
    }
    println!("via the curve: T τ·δr + G g·δr against the form on the tangent plane {most:.1e}");
    assert!(most < 1e-12);
}

/// On the surface both forms agree, with their tangents; off it they differ with the distance.
#[test]
fn both_forms_agree_on_the_surface() {
    let apart = |depth: f64, mu: f64| {
        let (first, _, k) = friction(VIA_CURVE, depth, mu);
        let (last, _, l) = friction(VIA_SURFACE, depth, mu);
        [
            difference(&first, &last) / largest(&last),
            difference(&k, &l) / largest(&l),
        ]
    };
    for mu in [0.1, 5.0] {
        let on = apart(0.0, mu);
        let off: Vec<[f64; 2]> = [0.04, 0.02, 0.01]
            .into_iter()
            .map(|d| apart(d, mu))
            .collect();
        let order = |k: usize| (off[1][k] / off[2][k]).log2();
        println!(
            "via the curve: μ {mu}: forms on the surface {:.1e}, tangents {:.1e}; at L = 0.01 {:.1e}, {:.1e}, orders {:.2}, {:.2}",
            on[0],
            on[1],
            off[2][0],
            off[2][1],
            order(0),
            order(1)
        );
        assert!(on[0] < 1e-12 && on[1] < 1e-12);
        assert!(off[2][0] > 1e-4 && (order(0) - 1.0).abs() < 0.1 && (order(1) - 1.0).abs() < 0.1);
    }
}
