//! Closed geometries: their parameters are angles, and where these jump by a turn the friction does not.

use crate::pair::Pair;
use crate::vector::{Vector, relative, turned};

const AXIS: Vector = [0.0, 0.0, 1.0];

/// Winds a point round the z axis by `turns`, once as it is and once with everything turned by 2 radians:
/// the angles jump elsewhere. Largest difference of the forces, and of the slip paths.
fn wound(name: &str, more: &[(&str, f64)], turns: f64) -> f64 {
    let mut given = vec![("eps_n", 1e3), ("eps_t", 1e3), ("mu", 0.3)];
    given.extend(more);
    let mut pair = Pair::new(name, &given);
    let mut other = pair.clone();
    let dimension = pair.element.dimension;
    if dimension == 3 {
        other.place_turned(AXIS, 2.0);
    } else {
        other.set("direction_x", 2.0_f64.cos());
        other.set("direction_y", 2.0_f64.sin());
    }
    let mut most: f64 = 0.0;
    for step in 0..=400 {
        // to and fro on the way, so that it sticks and slips on the seam
        let s = f64::from(step) / 400.0;
        let angle = turns * std::f64::consts::TAU * s + 0.1 * (40.0 * s).sin();
        let x = turned([0.95, 0.0, 0.1 * s], AXIS, angle);
        let y = turned(x, AXIS, 2.0);
        let (a, b) = (pair.step(&x[..dimension]), other.step(&y[..dimension]));
        let back: Vector = core::array::from_fn(|k| b.residual.get(k).copied().unwrap_or(0.0));
        let back = turned(back, AXIS, -2.0);
        most = most.max(relative(&back[..dimension], &a.residual));
        assert_eq!(a.outcome.status, b.outcome.status, "{name} at step {step}");
        assert!(
            (pair.path() - other.path()).abs() < 1e-11,
            "{name} at step {step}"
        );
    }
    most
}

/// Two turns and a half either way. 1e-11: angles of up to 16 against elastic parts of 0.015.
#[test]
fn friction_goes_round_closed_geometries() {
    let radius = ("radius", 1.0);
    let torus = [("major", 0.7), ("minor", 0.3)];
    for turns in [2.5, -2.5] {
        let most = [
            wound("PointCylinderCoulomb", &[radius], turns),
            wound("PointTorusCoulomb", &torus, turns),
            wound("PointCircleCoulomb2d", &[radius], turns),
        ];
        println!(
            "seam: forces round a cylinder {:.1e}, torus {:.1e}, circle {:.1e}",
            most[0], most[1], most[2]
        );
        assert!(most.iter().all(|&most| most < 1e-11));
    }
}
