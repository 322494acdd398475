//! Balance of forces and moments with friction at large penetration.

use crate::pair::{Pair, State};
use crate::vector::{Vector, add, length, scaled, subtract};

const EPS_T: f64 = 3e3;

/// A point at the depth `depth` below a twisted facet, moved along it since contact began.
fn state(name: &str, depth: f64) -> (State, Vec<f64>) {
    let given = [("eps_n", 1e3), ("eps_t", EPS_T), ("mu", 0.5)];
    let mut pair = Pair::new(name, &given);
    let facet = [
        -1.0, -1.0, 0.1, 1.2, -0.9, -0.2, 0.9, 1.1, 0.15, -1.1, 1.0, -0.1,
    ];
    // feet on the facet and their normals, from the element itself
    let feet = [[0.1, -0.2], [0.15, -0.12]].map(|[x, y]| foot(&pair, &facet, x, y));
    let mut last = None;
    for (foot, normal) in feet {
        let point = subtract(foot, scaled(depth, normal));
        let x = [&point[..], &facet].concat();
        last = Some((pair.step(&x), x));
    }
    last.expect("two steps")
}

/// The foot of a point above (x, y), and the normal there.
fn foot(pair: &Pair, facet: &[f64], x: f64, y: f64) -> (Vector, Vector) {
    let point = [x, y, 0.0];
    let on = pair.at(&[&point[..], facet].concat()).point(0);
    (subtract(point, scaled(on.gap, on.normal)), on.normal)
}

/// Sum of the forces over the largest, sum of the moments over the largest part of one: largest tangential
/// force times the size of the facet.
fn errors(name: &str, depth: f64) -> [f64; 2] {
    let (state, x) = state(name, depth);
    let (force, moment) = state.resultant(&x);
    let point = state.point(0);
    assert!(
        (point.gap + depth).abs() < 1e-9 * depth.max(1e-3),
        "{}",
        point.gap
    );
    let size = length(add(point.traction(), scaled(point.pressure, point.normal)));
    [
        length(force) / size,
        length(moment) / (point.friction() * 2.0),
    ]
}

/// To rounding at a penetration of up to half the facet's size: nine sums of rounded products.
#[test]
fn exact_friction_balances_at_any_depth() {
    let mut most = [0.0_f64; 2];
    for depth in [1e-3, 0.1, 0.5, 1.0] {
        let errors = errors("PointQuad4Coulomb", depth);
        most = [most[0].max(errors[0]), most[1].max(errors[1])];
    }
    println!(
        "balance: exact, depth up to 1 on a facet of 2: forces {:.1e}, moments {:.1e}",
        most[0], most[1]
    );
    assert!(most[0] < 1e-14 && most[1] < 1e-14);
}

/// On the tangent plane δζ leaves out what grows with L: forces balance, moments with an error of order L.
#[test]
fn on_the_tangent_plane_the_moment_is_off_by_order_l() {
    let depths = [0.4, 0.1, 0.025, 0.00625];
    let rows = depths.map(|depth| (depth, errors("PointQuad4CoulombTangentPlane", depth)));
    for (depth, [force, moment]) in rows {
        println!(
            "balance: tangent plane, L = -{depth:<8} moment error {moment:.3e}, forces {force:.1e}"
        );
        assert!(force < 1e-14);
        // friction at arm L: a check that sees less sees nothing
        assert!(moment > 0.1 * depth);
    }
    let [.., (_, [_, a]), (_, [_, b])] = rows;
    let slope = (a / b).log(4.0);
    println!("balance: tangent plane, slope in L {slope:.4}");
    assert!((slope - 1.0).abs() < 0.02);
}
