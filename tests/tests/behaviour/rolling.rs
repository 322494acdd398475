//! Moments about two curves: angles and moments known in closed form, history, what they balance.

use contact_elements::{Error, Evaluation, Status, argument, code, evaluate, request};

use crate::pair::{Pair, State};
use crate::vector::{Vector, add, cross, dot, scaled, unit};

/// Distance of the axes, sum of the radii, and laws: pressure 1, bound of the moments 0.05, reached at 0.25 rad.
const L: f64 = 0.3;
const GIVEN: [(&str, f64); 6] = [
    ("eps_n", 100.0),
    ("eps_t", 50.0),
    ("mu", 0.5),
    ("eps_phi", 0.2),
    ("mu_phi", 0.05),
    ("r0", L + 0.01),
];
const BOUND: f64 = 0.05;
const REACH: f64 = 0.25;

/// (φ_c, M_c) of the first point.
fn rolling(state: &State) -> ([f64; 2], [f64; 2]) {
    let at = |entry: usize| [state.output[entry], state.output[entry + 1]];
    (at(19), at(21))
}

fn straight() -> Pair {
    let mut pair = Pair::new("Line2Line2BeamsRolling", &GIVEN);
    pair.set("master_director_z", 2.0);
    pair
}

/// A straight beam along x above one along y, carried round it by an angle; its director goes along.
fn carried(pair: &mut Pair, angle: f64) -> Vec<f64> {
    let (s, c) = angle.sin_cos();
    let (along, e) = ([c, 0.0, -s], [s, 0.0, c]);
    for (name, component) in ["slave_director_x", "slave_director_y", "slave_director_z"]
        .into_iter()
        .zip(e)
    {
        pair.set(name, component);
    }
    let end = |side: f64| add(scaled(L, e), scaled(side, along));
    let slave = [end(-1.0), end(1.0)].concat();
    [slave, vec![0.0, -1.0, 0.0, 0.0, 1.0, 0.0]].concat()
}

/// Moment of the slave's residual about the master's axis.
fn on_slave(x: &[f64], state: &State) -> f64 {
    let pairs = x[..6].chunks(3).zip(state.residual[..6].chunks(3));
    let moments = pairs.map(|(x, f)| x[2] * f[0] - x[0] * f[2]);
    moments.sum()
}

#[test]
fn carried_round_a_straight_beam() {
    let mut pair = straight();
    let mut most = 0.0_f64;
    for step in 0..=30 {
        let angle = 0.02 * f64::from(step);
        let x = carried(&mut pair, angle);
        let state = pair.step(&x);
        let (found, moments) = rolling(&state);
        let expected = (GIVEN[3].1 * angle).min(BOUND);
        let errors = [
            found[1] - angle,
            found[0].abs() - std::f64::consts::PI,
            (moments[1] - expected) / BOUND,
            moments[0] / BOUND,
            (on_slave(&x, &state) - expected) / BOUND,
        ];
        most = errors.iter().fold(most, |m, error| m.max(error.abs()));
        let regime = if angle > REACH + 1e-9 { 2.0 } else { 0.0 };
        assert_eq!(state.history[10], regime, "at {angle}");
        assert_eq!(state.status(), Status::Stick);
    }
    let path = 0.6 - REACH;
    most = most.max((pair.history[9] - path).abs());
    println!("rolling: angle, moment, bound, path: {most:.1e}");
    assert!(most < 1e-13);
}

/// ∮ M dφ by the trapezoidal rule, which is exact for moments that are linear between the steps.
fn work(pair: &mut Pair, angles: &[f64]) -> f64 {
    let mut sum = 0.0;
    let (mut last, mut before) = (None, 0.0);
    for &angle in angles {
        let x = carried(pair, angle);
        let state = pair.step(&x);
        let moment = on_slave(&x, &state);
        if let Some(last) = last {
            sum += 0.5 * (moment + last) * (angle - before);
        }
        (last, before) = (Some(moment), angle);
    }
    sum
}

fn sweep(from: f64, to: f64, steps: i32) -> impl Iterator<Item = f64> {
    (1..=steps).map(move |step| from + (to - from) * f64::from(step) / f64::from(steps))
}

#[test]
fn work_of_closed_paths() {
    let mut pair = straight();
    let there: Vec<f64> = [0.0].into_iter().chain(sweep(0.0, 0.2, 7)).collect();
    let back = there.iter().rev().skip(1).copied();
    let whole: Vec<f64> = there.iter().copied().chain(back).collect();
    let sticking = work(&mut pair, &whole) / (BOUND * REACH);
    // 0.05 rad per step: the corners of the loop are steps
    let mut pair = straight();
    let x = carried(&mut pair, 0.0);
    pair.step(&x);
    work(&mut pair, &sweep(0.0, 0.6, 12).collect::<Vec<_>>());
    let turn: Vec<f64> = [0.6]
        .into_iter()
        .chain(sweep(0.6, -0.6, 24))
        .chain(sweep(-0.6, 0.6, 24))
        .collect();
    let expected = 4.0 * BOUND * (0.6 - REACH);
    let rolling = work(&mut pair, &turn) / expected - 1.0;
    println!("rolling: work of a closed path, sticking and rolling: {sticking:.1e}, {rolling:.1e}");
    assert!(sticking.abs() < 1e-13 && rolling.abs() < 1e-13);
}

/// A Hermite curve through `apex` at ξ = 0: ρ = apex + τ ξ + k ν ξ²/2 + k w β ξ³/6, curvature k, torsion w.
fn hermite(apex: Vector, [tau, nu, beta]: [Vector; 3], k: f64, torsion: f64) -> Vec<f64> {
    let combination =
        |a: f64, b: f64, c: f64| add(scaled(a, tau), add(scaled(b, nu), scaled(c, beta)));
    let position = |x: f64| {
        add(
            apex,
            combination(x, 0.5 * k * x * x, k * torsion * x * x * x / 6.0),
        )
    };
    let slope = |x: f64| combination(1.0, k * x, 0.5 * k * torsion * x * x);
    [position(-1.0), slope(-1.0), position(1.0), slope(1.0)].concat()
}

/// ν with e = ν cos φ + β sin φ for a tangent across e.
fn triad(tau: Vector, e: Vector, angle: f64) -> [Vector; 3] {
    let (s, c) = angle.sin_cos();
    let nu = add(scaled(c, e), scaled(-s, cross(tau, e)));
    [tau, nu, cross(tau, nu)]
}

/// Two curves that touch at ξ = 0 each, at given angles, crossing at an angle.
fn touching(angles: [f64; 2], crossing: f64, torsion: [f64; 2]) -> Vec<f64> {
    let tau = unit([0.3, -0.5, 0.8]);
    let e = unit(cross(tau, [0.2, 0.9, 0.1]));
    let (s, c) = crossing.sin_cos();
    let other = add(scaled(c, tau), scaled(s, cross(e, tau)));
    let slave = hermite([0.0; 3], triad(tau, e, angles[0]), 0.7, torsion[0]);
    let back = scaled(-1.0, e);
    let master = hermite(scaled(L, e), triad(other, back, angles[1]), 0.5, torsion[1]);
    [slave, master].concat()
}

#[test]
fn angles_of_curves_of_known_triads() {
    let pair = Pair::new("HermiteHermiteBeamsRolling", &GIVEN);
    let mut most = 0.0_f64;
    for (first, last) in [(0.3, -1.2), (-2.8, 2.1), (1.6, 3.0), (-0.1, -0.4)] {
        for crossing in [0.8, 2.0] {
            let state = pair.at(&touching([first, last], crossing, [0.9, -0.6]));
            let (angles, moments) = rolling(&state);
            most = most.max((angles[0] - first).abs().max((angles[1] - last).abs()));
            assert_eq!(moments, [0.0; 2], "contact begins");
        }
    }
    println!("rolling: angles in known triads: {most:.1e}");
    assert!(most < 1e-13);
}

/// The touching point moves along the slave without turning about it: φ changes by −∫κ ds.
#[test]
fn the_frame_twists_along_the_curve() {
    let pair = Pair::new("HermiteHermiteBeamsRolling", &GIVEN);
    let (k, torsion, h) = (0.7, 0.9, 1e-3);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let slave = hermite([0.0; 3], axes, k, torsion);
    let angle = |x: f64| {
        let tau = unit([1.0, k * x, 0.5 * k * torsion * x * x]);
        let at = [x, 0.5 * k * x * x, k * torsion * x * x * x / 6.0];
        let e = unit([0.0, 0.6, 0.8]);
        let e = unit(add(e, scaled(-dot(e, tau), tau)));
        let other = triad(unit(add(tau, cross(e, tau))), scaled(-1.0, e), 0.4);
        let master = hermite(add(at, scaled(L, e)), other, 0.5, 0.3);
        rolling(&pair.at(&[slave.clone(), master].concat())).0[0]
    };
    let slope = (angle(h) - angle(-h)) / (2.0 * h);
    println!("rolling: dφ/ds + κ: {:.1e}", slope + torsion);
    assert!((slope + torsion).abs() < 1e-5);
}

/// Moments, forces and what the directors' carriers take balance; with principal normals nothing is left.
#[test]
fn balance_of_moments() {
    let touched = touching([0.5, -0.9], 1.1, [0.4, 0.2]);
    let mut pair = Pair::new("HermiteHermiteBeamsRolling", &GIVEN);
    pair.step(&touched);
    let turned = touching([0.4, -0.8], 1.1, [0.4, 0.2]);
    let state = pair.step(&turned);
    let (_, moments) = rolling(&state);
    assert!(moments.iter().all(|moment| moment.abs() > 1e-3));
    let (_, moment) = state.resultant(&turned);
    // every second node is a tangent vector
    let places = state.residual.chunks(3).step_by(2);
    let force = places.fold([0.0; 3], |sum, f| add(sum, [f[0], f[1], f[2]]));
    let most = force
        .iter()
        .chain(&moment)
        .fold(0.0, |m: f64, v| m.max(v.abs()));
    println!("rolling: force and moment left: {most:.1e}");
    assert!(most < 1e-14);
}

#[test]
fn frozen_regimes() {
    let mut pair = straight();
    for angle in [0.0, 0.3] {
        let x = carried(&mut pair, angle);
        pair.step(&x);
    }
    assert_eq!(pair.history[10], 2.0);
    pair.bits = request::FREEZE_STATE;
    // on the way back it would stick
    let x = carried(&mut pair, 0.25);
    let rolls = rolling(&pair.at(&x)).1[1];
    assert!((rolls - BOUND).abs() < 1e-14, "{rolls}");
    pair.history[10] = 0.0;
    let x = carried(&mut pair, 0.6);
    let sticks = rolling(&pair.at(&x)).1[1];
    let expected = BOUND + GIVEN[3].1 * 0.3;
    assert!((sticks - expected).abs() < 1e-14, "{sticks}");
}

/// Error with a history or parameters that cannot be used, or a curve that has no reference direction.
fn refused(pair: &Pair, x: &[f64]) -> Error {
    let result = evaluate(
        pair.element,
        &mut Evaluation {
            x,
            parameters: &pair.parameters,
            history: &pair.history,
            ..Evaluation::default()
        },
    );
    result.expect_err("refused")
}

#[test]
fn histories_and_curves_that_cannot_be() {
    let mut pair = straight();
    let x = carried(&mut pair, 0.1);
    pair.step(&x);
    let whole = pair.history.clone();
    for (entry, value, wrong) in [
        (6, f64::NAN, code::NOT_FINITE),
        (10, f64::NAN, code::NOT_FINITE),
        (7, 2e3, code::HISTORY),
        (8, -1e-3, code::HISTORY),
        (10, 4.0, code::HISTORY),
        (10, 0.5, code::HISTORY),
    ] {
        pair.history.clone_from(&whole);
        pair.history[entry] = value;
        let error = refused(&pair, &x);
        assert_eq!(
            (error.code, error.argument, error.index),
            (wrong, argument::HISTORY_ACCEPTED, entry)
        );
    }
    pair.history = whole;
    for component in ["slave_director_x", "slave_director_y", "slave_director_z"] {
        pair.set(component, 0.0);
    }
    let degenerate = (code::CUT_BACK, Some(Status::Degenerate));
    let error = refused(&pair, &x);
    assert_eq!((error.code, error.status), degenerate);
    pair.set("slave_director_x", 0.1_f64.cos());
    pair.set("slave_director_z", -0.1_f64.sin());
    let error = refused(&pair, &x);
    assert_eq!((error.code, error.status), degenerate);
    // a straight Hermite curve has no principal normal
    let pair = Pair::new("HermiteHermiteBeamsRolling", &GIVEN);
    let mut x = touching([0.3, 0.4], 1.0, [0.0; 2]);
    let axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let straight = hermite([0.0, 0.0, 0.0], axes, 0.0, 0.0);
    x[12..].copy_from_slice(&straight);
    let slave = hermite([0.0, 0.0, L], [axes[2], axes[1], axes[0]], 0.5, 0.0);
    x[..12].copy_from_slice(&slave);
    let error = refused(&pair, &x);
    assert_eq!((error.code, error.status), degenerate);
}
