//! A rope segment on a cylinder: pulling friction along it, dragging friction across.

use crate::linear::bisect;
use crate::pair::Pair;
use crate::vector::{Vector, difference, turned};

const EPS_N: f64 = 1e3;
const EPS: [f64; 2] = [2e3, 5e2];
const MU: [f64; 2] = [0.5, 0.2];
const RADIUS: f64 = 2.0;
const DEPTH: f64 = 0.1;
const LENGTH: f64 = 1.5;

/// Force along the axis and moment about it on a segment that lies along the axis of the cylinder, after a
/// slide in small steps by `slide` along the axis and, on the surface, across it.
fn slid(slide: [f64; 2]) -> [f64; 2] {
    let given = [
        ("eps_n", EPS_N),
        ("eps_1", EPS[0]),
        ("eps_2", EPS[1]),
        ("mu_1", MU[0]),
        ("mu_2", MU[1]),
        ("radius", RADIUS),
    ];
    let mut pair = Pair::new("Line2CylinderOrthotropic", &given);
    let steps = 200;
    let mut last = [0.0; 2];
    for step in 0..=steps {
        let share = f64::from(step) / f64::from(steps);
        let angle = 0.4 + share * slide[1] / RADIUS;
        let node = |height: f64| -> Vector {
            let at = turned([RADIUS - DEPTH, 0.0, 0.0], [0.0, 0.0, 1.0], angle);
            [at[0], at[1], height + share * slide[0]]
        };
        let x = [node(0.0), node(LENGTH)].concat();
        let (force, moment) = pair.step(&x).resultant(&x);
        last = [force[2], moment[2]];
    }
    last
}

/// p = eps_n depth per length; along: μ_1 p, across: μ_2 p, in between the point of the ellipse whose normal
/// is the direction of the slide, all times the length. Friction acts on the surface: its arm is the radius.
#[test]
fn a_segment_is_pulled_and_dragged() {
    let load = EPS_N * DEPTH * LENGTH;
    let mut most: f64 = 0.0;
    for angle in [0.0_f64, 0.5, 1.0, 1.5] {
        let d = [angle.cos(), angle.sin()];
        let size = (MU[0] * d[0]).hypot(MU[1] * d[1]);
        let expected = [0, 1].map(|q| MU[q] * MU[q] * d[q] / size);
        let [force, moment] = slid(d.map(|d| 3.0 * d));
        let found = [force / load, moment / (load * RADIUS)];
        most = most.max(difference(&found, &expected));
    }
    println!("dragging: steady pulling and dragging friction {most:.1e}");
    // the steady state is met but for a factor of the elastic range over the path, to the power of steps
    assert!(most < 1e-10);
}

/// From rest: the force grows with its stiffness up to the bound, along and across.
#[test]
fn a_segment_sticks_with_two_stiffnesses() {
    let load = EPS_N * DEPTH * LENGTH;
    for q in 0..2 {
        let slide = |d: f64| if q == 0 { [d, 0.0] } else { [0.0, d] };
        let arm = [1.0, RADIUS][q];
        let (d, _) = bisect(0.0, 1.0, |d| {
            slid(slide(d))[q] / arm < MU[q] * load * (1.0 - 1e-9)
        });
        let expected = MU[q] * EPS_N * DEPTH / EPS[q];
        assert!((d / expected - 1.0).abs() < 1e-8, "{d} against {expected}");
    }
}
