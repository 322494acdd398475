//! Two beams at any angle: point contact at large ones, line contact at small ones, two elements on the same nodes
//! whose sum has an energy, a force and a tangent without jumps.

use std::f64::consts::{FRAC_PI_2, PI};

use contact_elements::{Error, Evaluation, Status, Summary, code, evaluate};

use crate::beams::{Beams, HEIGHT, R0, STIFFNESS, Sum, WINDOW, curved, nodes, straight};
use crate::pair::{Pair, State};
use crate::vector::{Vector, add, cross, difference, largest, list, relative};

/// Largest change between neighbouring angles of a sweep from 90° through 0 to −90°, relative to the largest value:
/// energy, force, tangent.
fn jumps(beams: &Beams, at: fn(f64) -> Vec<f64>, steps: i32) -> [f64; 3] {
    let mut most = [0.0_f64; 3];
    let mut sizes = [0.0_f64; 3];
    let mut before: Option<Sum> = None;
    for step in 0..=steps {
        let angle = FRAC_PI_2 * (1.0 - 2.0 * f64::from(step) / f64::from(steps));
        let now = beams.at(&at(angle));
        let all = now.residual.iter().chain(&now.tangent);
        assert!(
            now.energy.is_finite() && all.clone().all(|v| v.is_finite()),
            "at {angle}"
        );
        if let Some(before) = before {
            let changes = [
                (now.energy - before.energy).abs(),
                difference(&now.residual, &before.residual),
                difference(&now.tangent, &before.tangent),
            ];
            most = [0, 1, 2].map(|k| most[k].max(changes[k]));
        }
        let own = [now.energy, largest(&now.residual), largest(&now.tangent)];
        sizes = [0, 1, 2].map(|k| sizes[k].max(own[k]));
        before = Some(now);
    }
    [0, 1, 2].map(|k| most[k] / sizes[k])
}

/// The jumps shrink with the step of the sweep, so there is no jump in the limit. The whole tangent is included: the weight
/// is twice differentiable.
fn check_sweep(name: &str, beams: &Beams, at: fn(f64) -> Vec<f64>) {
    let [coarse, fine] = [5760, 57600].map(|steps| jumps(beams, at, steps));
    println!(
        "all angles: {name}: largest change per 0.03125° and per 0.003125° of energy, force, tangent: {}; {}",
        list(&coarse),
        list(&fine)
    );
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(fine > 0.0 && fine < 0.13 * coarse, "{coarse} {fine}");
    }
}

#[test]
fn nothing_jumps_from_one_right_angle_to_the_other() {
    check_sweep("straight", &Beams::straight(), straight);
    check_sweep("Hermite", &Beams::curved(), curved);
}

/// Central difference of order eight of the residual by unknown `j`.
fn slope(beams: &Beams, x: &[f64], j: usize) -> Vec<f64> {
    const STEP: f64 = 1e-3;
    const FACTORS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = vec![0.0; x.len()];
    for (k, factor) in FACTORS.into_iter().enumerate() {
        for side in [1.0, -1.0] {
            let mut moved = vec![0.0; x.len()];
            moved[j] = side * STEP * (k + 1) as f64;
            let residual = beams.moved(x, &moved).residual;
            for (sum, value) in sum.iter_mut().zip(residual) {
                *sum += side * factor / STEP * value;
            }
        }
    }
    sum
}

/// The largest error of the tangent, relative to its largest entry.
fn tangent_error(beams: &Beams, x: &[f64]) -> f64 {
    let n = x.len();
    let mut expected = vec![0.0; n * n];
    for j in 0..n {
        for (i, value) in slope(beams, x, j).into_iter().enumerate() {
            expected[i * n + j] = value;
        }
    }
    relative(&beams.at(x).tangent, &expected)
}

/// Angles of every branch: line alone (through 0), both, point alone; no angle within a step of the window's ends, where
/// the third derivative jumps.
#[test]
fn the_tangent_is_the_derivative_of_the_force_in_every_branch() {
    for (name, beams, at) in [
        (
            "straight",
            Beams::straight(),
            straight as fn(f64) -> Vec<f64>,
        ),
        ("Hermite", Beams::curved(), curved),
    ] {
        let mut errors = vec![];
        let mut branches = [0; 3];
        for angle in [
            -1.2, -0.25, -0.04, 0.0, 0.03, 0.16, 0.2, 0.24, 0.7, FRAC_PI_2,
        ] {
            let x = at(angle);
            let [point, line] = beams.at(&x).shares;
            branches[usize::from(point > 0.0) + usize::from(point > 0.0 && line == 0.0)] += 1;
            errors.push(tangent_error(&beams, &x));
        }
        println!(
            "all angles: {name}: tangent against differences {}",
            list(&errors)
        );
        assert!(branches.iter().all(|&count| count > 0), "{branches:?}");
        assert!(errors.iter().all(|&error| error < 1e-10), "{errors:?}");
    }
}

/// A slave that runs the other way, at the same place: energy and forces are the same.
#[test]
fn anti_parallel_is_parallel() {
    let beams = Beams::straight();
    for angle in [0.0, 0.05, 0.2, 0.8] {
        let x = straight(angle);
        let reversed: Vec<f64> = [&x[3..6], &x[..3], &x[6..]].concat();
        let (one, other) = (beams.at(&x), beams.at(&reversed));
        let back: Vec<f64> = [
            &other.residual[3..6],
            &other.residual[..3],
            &other.residual[6..],
        ]
        .concat();
        assert!(
            (one.energy - other.energy).abs() < 1e-14 * one.energy,
            "{angle}"
        );
        assert!(relative(&back, &one.residual) < 1e-13, "{angle}");
    }
}

/// Parallel segments that overlap by less and less. The element's own two points count whole or not at all; one point
/// at a time with a rule on the overlap, the force is that of the overlap.
#[test]
fn the_force_is_that_of_the_overlap() {
    let line = &Beams::straight().parts[1];
    let own = |shift: f64| -> State {
        let slave = [shift - 1.0, 0.0, HEIGHT, shift + 1.0, 0.0, HEIGHT];
        line.at(&[&slave[..], &[-1.0, 0.0, 0.0, 1.0, 0.0, 0.0]].concat())
    };
    let whole = STIFFNESS[1] * (HEIGHT - R0) * 2.0;
    let force = |state: &State| state.residual[2] + state.residual[5];
    let gauss = 1.0 / 3.0_f64.sqrt();
    for (shift, share) in [
        (0.0, 1.0),
        (1.0 - gauss - 1e-9, 1.0),
        (1.0 - gauss + 1e-9, 0.5),
    ] {
        let error = (force(&own(shift)) / (share * whole) - 1.0).abs();
        assert!(error < 1e-14, "{error} at {shift}");
    }
    assert_eq!(force(&own(1.0 + gauss + 1e-9)), 0.0);
    let mut point = Pair::new("Line2Line2LineContactSmallAngleAtPoint", &[]);
    for (name, value) in [
        ("eps_n", STIFFNESS[1]),
        ("r0", R0),
        ("angle_low", WINDOW[0]),
        ("angle_high", WINDOW[1]),
    ] {
        point.set(name, value);
    }
    for shift in [0.0, 0.3, 1.1, 1.9] {
        let half = 1.0 - 0.5 * shift;
        let slave = [shift - 1.0, 0.0, HEIGHT, shift + 1.0, 0.0, HEIGHT];
        let x = [&slave[..], &[-1.0, 0.0, 0.0, 1.0, 0.0, 0.0]].concat();
        let mut sum = 0.0;
        for side in [-gauss, gauss] {
            // the overlap in the parameter of the slave is [-1, 1 - shift]
            point.set("eta_1", -1.0 + half + side * half);
            point.set("weight", half);
            sum += force(&point.at(&x));
        }
        let error = (sum / (whole * half) - 1.0).abs();
        assert!(error < 1e-13, "{error} at {shift}");
    }
}

/// Where the closest point leaves an end, the weighted force ends with it; at an angle where the weight is one, the
/// pair of the end point and the other curve takes over the same force.
#[test]
fn an_end_hands_its_force_to_the_pair_of_the_end_point() {
    let beams = Beams::straight();
    let end = Pair::new("PointLine2", &[("eps_n", STIFFNESS[0]), ("r0", R0)]);
    let at = |angle: f64, beyond: f64| {
        let slave = [[beyond, 0.0, HEIGHT], [beyond + 2.0, 0.0, HEIGHT]];
        nodes(&slave, &[[-1.2, 0.0, 0.0], [1.3, 0.0, 0.0]], angle)
    };
    let mut jumps = vec![];
    let [low, square, high] = [WINDOW[0], 0.2, WINDOW[1]].map(|angle: f64| angle.sin().powi(2));
    let position = (square - low) / (high - low);
    let inside = position.powi(3) * (10.0 - 15.0 * position + 6.0 * position * position);
    for (angle, weighted) in [(1.0, 1.0), (0.2, inside)] {
        let inside = beams.parts[0].at(&at(angle, -1e-9));
        let outside = beams.parts[0].at(&at(angle, 1e-9));
        assert_eq!(inside.status(), Status::Closed);
        assert_eq!(outside.status(), Status::Outside);
        assert_eq!(largest(&outside.residual), 0.0);
        let force = inside.residual[8] + inside.residual[11];
        let x = at(angle, 1e-9);
        let handed = end.at(&[&x[..3], &x[6..]].concat());
        let taken = handed.residual[5] + handed.residual[8];
        jumps.push((taken - force).abs() / taken);
        let error = (force / taken - weighted).abs();
        assert!(error < 1e-8, "{error} at {angle}");
    }
    println!(
        "all angles: share of the force that jumps at an end, weight 1 and {inside:.2}: {}",
        list(&jumps)
    );
}

/// The part that has no weight is open, whatever its projection: parallel curves for the point, meeting ones for the
/// line.
#[test]
fn a_part_without_weight_is_open() {
    for (beams, at) in [
        (Beams::straight(), straight as fn(f64) -> Vec<f64>),
        (Beams::curved(), curved),
    ] {
        for angle in [0.0, 1e-16, 1e-12, 1e-6, PI] {
            let [point, line] = beams.parts.each_ref().map(|part| part.at(&at(angle)));
            assert_eq!(point.status(), Status::Open, "at {angle}");
            assert_eq!(largest(&point.residual), 0.0);
            assert_eq!(line.status(), Status::Closed);
        }
    }
    let line = &Beams::straight().parts[1];
    let meeting: Vec<f64> = nodes(
        &[[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
        &[[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
        1.0,
    );
    assert_eq!(line.at(&meeting).status(), Status::Open);
}

/// What an evaluation of the residual says, whatever it is, and the residual.
fn outcome(pair: &Pair, x: &[f64]) -> (Result<Summary, Error>, Vec<f64>) {
    const UNTOUCHED: f64 = -1.0;
    let mut residual = vec![UNTOUCHED; x.len()];
    let outcome = evaluate(
        pair.element,
        &mut Evaluation {
            x,
            parameters: &pair.parameters,
            residual: &mut residual,
            ..Evaluation::default()
        },
    );
    (outcome, residual)
}

/// Coincident beams have no normal: a status, and nothing written. The part without weight does not mind.
#[test]
fn coincident_beams_are_degenerate() {
    let line = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let x = nodes(&line, &line, 0.0);
    let [point, line] = Beams::straight().parts;
    let (found, residual) = outcome(&line, &x);
    let error = found.expect_err("coincident");
    assert!(error.is_cut_back());
    assert_eq!(error.status, Some(Status::Degenerate));
    assert!(residual.iter().all(|&value| value == -1.0));
    let (found, residual) = outcome(&point, &x);
    assert_eq!(found.map(|summary| summary.status), Ok(Status::Open));
    assert!(residual.iter().all(|&value| value == 0.0));
}

#[test]
fn a_window_has_a_width() {
    let mut pair = Beams::straight().parts[0].clone();
    for high in [WINDOW[0], WINDOW[0] + 1e-7, 0.05] {
        pair.set("angle_high", high);
        let (found, _) = outcome(&pair, &straight(0.2));
        let error = found.expect_err("a window without width");
        assert_eq!((error.code, error.index), (code::PARAMETER, 3));
    }
}

/// The couple W w' δq included, rigid motion finds no resistance.
#[test]
fn forces_and_moments_balance_within_the_window() {
    for (beams, at) in [
        (Beams::straight(), straight as fn(f64) -> Vec<f64>),
        (Beams::curved(), curved),
    ] {
        let x = at(0.2);
        for part in &beams.parts {
            let state = part.at(&x);
            let (force, moment) = resultant(&x, &state.residual);
            let scale = largest(&state.residual);
            assert!(largest(&force) < 1e-14 * scale, "{force:?}");
            assert!(largest(&moment) < 1e-13 * scale, "{moment:?}");
        }
    }
}

/// Force and moment about the origin; every other control of a Hermite beam is a tangent, which carries a couple and
/// no force.
fn resultant(x: &[f64], residual: &[f64]) -> (Vector, Vector) {
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    let is_curved = x.len() == 24;
    for (node, (x, f)) in x.chunks(3).zip(residual.chunks(3)).enumerate() {
        let (x, f) = ([x[0], x[1], x[2]], [f[0], f[1], f[2]]);
        if !is_curved || node % 2 == 0 {
            force = add(force, f);
        }
        moment = add(moment, cross(x, f));
    }
    (force, moment)
}
