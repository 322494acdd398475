//! Rigid rotation of a whole pair, by 90° in ten accepted steps: T stays what it was.

use crate::pair::{Pair, Point, State};
use crate::vector::{Vector, list, relative, turned, unit};

/// Largest relative change of T_q, of T_i, of the energy, and of R turned back.
type Change = [f64; 4];

/// Turns `x` by 90° in ten steps about an axis through the origin; `place` turns what is no node.
fn turn(mut pair: Pair, x: &[f64], axis: Vector, place: bool) -> Change {
    let dimension = pair.element.dimension;
    let turned_by = |values: &[f64], angle: f64| -> Vec<f64> {
        let vectors = values.chunks(dimension);
        let vectors = vectors.flat_map(|v| {
            let v = [v[0], v[1], v.get(2).copied().unwrap_or(0.0)];
            turned(v, axis, angle).into_iter().take(dimension)
        });
        vectors.collect()
    };
    let before = pair.at(x);
    let mut most = [0.0_f64; 4];
    for step in 1..=10 {
        let angle = f64::from(step) * 9.0_f64.to_radians();
        if place {
            pair.place_turned(axis, angle);
        }
        let state = pair.step(&turned_by(x, angle));
        assert_eq!(state.outcome.closed, before.outcome.closed);
        let back = turned_by(&state.residual, -angle);
        let points = |of: fn(&Point) -> [f64; 2], state: &State| -> Vec<f64> {
            let points = 0..pair.element.points;
            points.flat_map(|q| of(&state.point(q))).collect()
        };
        let changes = [
            relative(&points(|p| p.t, &state), &points(|p| p.t, &before)),
            relative(
                &points(Point::covariant, &state),
                &points(Point::covariant, &before),
            ),
            (state.energy / before.energy - 1.0).abs(),
            relative(&back, &before.residual),
        ];
        for (most, change) in most.iter_mut().zip(changes) {
            *most = most.max(change);
        }
    }
    most
}

/// Begins contact at `x`, moves the first node by `slide`, accepts that, and turns the pair; sticking
/// with `mu` = 10, slipping with 0.4. 1e-13: coordinates of 1 carry the slip of 0.1 with 1e-15.
fn check(name: &str, more: &[(&str, f64)], x: &[f64], slide: &[f64], axis: Vector, place: bool) {
    for mu in [10.0, 0.4] {
        let mut given = vec![("eps_n", 1e3), ("eps_t", 1e3), ("mu", mu)];
        if name.contains("Orthotropic") {
            given = vec![
                ("eps_n", 1e3),
                ("eps_1", 1e3),
                ("eps_2", 2e3),
                ("mu_1", mu),
                ("mu_2", 0.5 * mu),
            ];
        }
        given.extend(more);
        let mut pair = Pair::new(name, &given);
        if place {
            pair.place_turned(axis, 0.0);
        }
        pair.step(x);
        let mut x = x.to_vec();
        for (x, slide) in x.iter_mut().zip(slide) {
            *x += slide;
        }
        pair.step(&x);
        let change = turn(pair, &x, axis, place);
        println!(
            "rotation: {name}, μ = {mu}: change of T_q, T_i, energy, R {}",
            list(&change)
        );
        assert!(
            change.iter().all(|&change| change < 1e-13),
            "{name}: {change:?}"
        );
    }
}

fn oblique() -> Vector {
    unit([1.0, -2.0, 0.7])
}

#[test]
fn point_and_facet() {
    let x = [
        0.2, 0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.1, 1.0, 1.0, 0.0, -1.0, 1.0, 0.1,
    ];
    check(
        "PointQuad4Coulomb",
        &[],
        &x,
        &[0.1, -0.06, 0.0],
        oblique(),
        false,
    );
}

#[test]
fn point_and_placed_cylinder() {
    let x = [0.6, 0.7, 0.1];
    let radius = [("radius", 1.0)];
    check(
        "PointCylinderCoulomb",
        &radius,
        &x,
        &[-0.07, 0.06, 0.05],
        oblique(),
        true,
    );
}

#[test]
fn two_curves() {
    let x = [
        -1.0, 0.1, 0.17, 2.0, 0.0, 0.2, 1.0, -0.1, 0.2, 2.0, 0.3, -0.1, // slave
        0.1, -1.0, 0.0, 0.2, 2.0, 0.1, 0.0, 1.0, 0.1, -0.1, 2.0, 0.0,
    ];
    let slide = [0.08, 0.06, 0.0, 0.0, 0.0, 0.0, 0.08, 0.06, 0.0];
    check(
        "HermiteHermiteBeamsCoulomb",
        &[("r0", 0.3)],
        &x,
        &slide,
        oblique(),
        false,
    );
}

#[test]
fn curve_and_facet() {
    let x = [
        -0.5, -0.2, -0.04, 1.0, 0.1, 0.0, 0.5, 0.3, -0.05, 1.0, 0.3, 0.02, // slave
        -1.0, -1.0, 0.0, 1.0, -1.0, 0.03, 1.0, 1.0, 0.0, -1.0, 1.0, 0.03,
    ];
    let slide = [0.08, 0.06, 0.0, 0.0, 0.0, 0.0, 0.08, 0.06, 0.0];
    check("HermiteQuad4Orthotropic", &[], &x, &slide, oblique(), false);
}

#[test]
fn point_and_line_in_the_plane() {
    let x = [0.2, -0.05, -1.0, 0.0, 1.0, 0.1];
    check(
        "PointLine2Coulomb2d",
        &[],
        &x,
        &[0.1, 0.0],
        [0.0, 0.0, 1.0],
        false,
    );
}
