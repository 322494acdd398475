//! Straight beams that cross at an angle, down to 1e-6: the closest points, and the friction of a slide.

use crate::pair::Pair;
use crate::vector::{difference, list};

const EPS_T: f64 = 7.0;

/// Exact closest points t1 = 0.3 on (t, 0, 0), t2 = −0.7 on `point` + t `direction`, distance 0.05.
struct Crossing {
    angle: f64,
    point: [f64; 3],
    direction: [f64; 3],
}

const CROSSINGS: [Crossing; 4] = [
    Crossing {
        angle: 0.5,
        point: [0.914307793323260901, 0.335597877022942100, 0.05],
        direction: [0.877582561890372716, 0.479425538604203000, 0.0],
    },
    Crossing {
        angle: 1e-2,
        point: [0.999965000291665694, 0.006999883333916665, 0.05],
        direction: [0.999950000416665278, 0.009999833334166665, 0.0],
    },
    Crossing {
        angle: 1e-4,
        point: [0.999999996500000003, 0.000069999999883333, 0.05],
        direction: [0.999999995000000004, 0.000099999999833333, 0.0],
    },
    Crossing {
        angle: 1e-6,
        point: [0.999999999999650000, 0.000000699999999999883333, 0.05],
        direction: [0.999999999999500000, 0.000000999999999999833333, 0.0],
    },
];

fn nodes(crossing: &Crossing, slide: [f64; 2]) -> Vec<f64> {
    let [x, y, z] = crossing.point;
    let [a, b, c] = crossing.direction;
    let first = [-1.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    let second = [x - a, y - b, z - c, x + a, y + b, z + c];
    let second = second.chunks(3).flat_map(|node| {
        // the second beam is the slave
        [node[0] + slide[0], node[1] + slide[1], node[2]]
    });
    second.chain(first).collect()
}

fn pair() -> Pair {
    let given = [("eps_n", 1e3), ("eps_t", EPS_T), ("mu", 1e3), ("r0", 0.06)];
    Pair::new("Line2Line2BeamsCoulomb", &given)
}

/// Parameters and distance. The solve is repeated where the angle is small, so that what remains is the rounding of
/// the nodes: θ⁻¹ ulps, times 10; the distance changes by the error times sin θ.
#[test]
fn closest_points_are_found() {
    let mut errors = vec![];
    for crossing in &CROSSINGS {
        let sine = crossing.angle.sin();
        let point = pair().at(&nodes(crossing, [0.0; 2])).point(0);
        let error = difference(&point.zeta, &[-0.7, 0.3]);
        assert!(error * sine < 2e-15, "{error} at {}", crossing.angle);
        assert!((point.gap + 0.01).abs() < 1e-14);
        errors.push(error);
    }
    println!(
        "crossing: closest points at 0.5, 1e-2, 1e-4, 1e-6 rad: {}",
        list(&errors)
    );
}

/// The slave beam is shifted by d in the plane of both: sticking gives the force e d whatever the angle,
/// although the parameters move by d/sin θ. The shift is of order θ to stay on the beams, and the
/// parameters carry θ⁻¹ ulps: θ⁻² ulps of it, times 10.
#[test]
fn friction_of_a_shift_does_not_depend_on_the_angle() {
    let mut errors = vec![];
    for crossing in &CROSSINGS[..3] {
        let sine = crossing.angle.sin();
        let shift = [0.03 * sine, 0.04 * sine];
        let mut pair = pair();
        pair.step(&nodes(crossing, [0.0; 2]));
        let state = pair.at(&nodes(crossing, shift));
        let f = [0, 1].map(|k| state.residual[k] + state.residual[3 + k]);
        let expected = shift.map(|d| EPS_T * d);
        let error = difference(&f, &expected) / (EPS_T * 0.05 * sine);
        assert!(
            error * sine.powi(2) < 2e-15 / 0.05,
            "{error} at {}",
            crossing.angle
        );
        errors.push(error);
    }
    println!(
        "crossing: force of a shift at 0.5, 1e-2, 1e-4 rad: {}",
        list(&errors)
    );
}
