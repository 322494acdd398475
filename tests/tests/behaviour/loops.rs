//! Closed paths: sticking returns its work, sliding dissipates the bound times the path slid.

use contact_elements::runtime::Status;

use crate::pair::Pair;
use crate::vector::{largest, list};

const EPS_N: f64 = 1e4;
const EPS_T: f64 = 3e3;
const MU: f64 = 0.4;

fn given(mu: f64) -> [(&'static str, f64); 3] {
    [("eps_n", EPS_N), ("eps_t", EPS_T), ("mu", mu)]
}

/// Work done on the node through the path `x`, force and step by the trapezoidal rule.
fn work(pair: &mut Pair, path: impl Iterator<Item = Vec<f64>>) -> f64 {
    let mut last: Option<(Vec<f64>, Vec<f64>)> = None;
    let mut sum = 0.0;
    for x in path {
        let f = pair.step(&x).residual;
        if let Some((x0, f0)) = last {
            for (k, x) in x.iter().enumerate() {
                sum += 0.5 * (f0[k] + f[k]) * (x - x0[k]);
            }
        }
        last = Some((x, f));
    }
    sum
}

/// On a plane both springs are linear, and the trapezoidal rule is exact: rounding of 400 terms remains.
#[test]
fn sticking_on_a_plane_returns_the_work() {
    let mut pair = Pair::new("PointPlaneCoulomb", &given(1e6));
    let at = |k: usize| {
        let s = std::f64::consts::TAU * k as f64 / 200.0;
        vec![
            1e-2 * s.sin(),
            2e-2 * (1.0 - s.cos()),
            -1e-2 - 5e-3 * (2.0 * s).sin(),
        ]
    };
    let loop_work = work(&mut pair, (0..=200).map(at));
    let stored = pair.at(&at(100)).energy;
    assert_eq!(pair.at(&at(100)).status(), Status::Stick);
    println!(
        "loops: work of a stick loop on a plane over the energy stored within it {:.1e}",
        loop_work / stored
    );
    assert!(loop_work.abs() < 1e-13 * stored);
}

/// On a cylinder the force turns with the point: the work of the trapezoidal rule vanishes with the square
/// of the step, so the force has a potential.
#[test]
fn sticking_on_a_cylinder_returns_the_work() {
    let loop_work = |steps: usize| {
        let mut pair = Pair::new("PointCylinderCoulomb", &given(1e6));
        pair.set("radius", 1.5);
        let path = (0..=steps).map(|k| {
            let s = std::f64::consts::TAU * k as f64 / steps as f64;
            let (angle, height) = (0.4 + 0.3 * s.cos(), 0.2 * s.sin());
            let radius = 1.5 - 0.1 * (1.2 + (s + 0.5).sin());
            vec![radius * angle.cos(), radius * angle.sin(), height]
        });
        work(&mut pair, path)
    };
    let works = [100, 200, 400].map(loop_work);
    let order = (works[1] / works[2]).log2();
    println!(
        "loops: work of a stick loop on a cylinder {}, order {order:.3}",
        list(&works)
    );
    assert!((order - 2.0).abs() < 0.05, "{works:?}");
}

/// Where the metric varies, s = b_i (ζ − ζ_st)^i is no gradient: on a trapezoid a stick loop does not quite
/// close. What is lost, relative to the energy stored, vanishes with the size of the loop.
#[test]
fn sticking_on_a_trapezoid_returns_the_work_of_small_slips() {
    let facet = [
        -1.0, -1.0, 0.0, 1.2, -0.9, 0.0, 0.9, 1.1, 0.0, -1.1, 1.0, 0.0,
    ];
    let lost = |size: f64| {
        let mut pair = Pair::new("PointQuad4Coulomb", &given(1e6));
        let path = (0..=400).map(|k| {
            let (s, c) = (std::f64::consts::TAU * f64::from(k) / 400.0).sin_cos();
            let point = [0.2 + size * c, 0.1 + size * s, -0.1];
            [&point[..], &facet].concat()
        });
        // stored where the loop is farthest from its anchor
        work(&mut pair, path) / (2.0 * EPS_T * size * size)
    };
    let lost = [0.1, 0.05, 0.025].map(lost);
    let order = (lost[1] / lost[2]).log2();
    println!(
        "loops: work of stick loops of 0.1, 0.05, 0.025 on a trapezoid of 2 over the energy stored {}, order {order:.3}",
        list(&lost)
    );
    assert!(lost[0].abs() < 1e-2 && (order - 1.0).abs() < 0.05);
}

/// To and fro on a plane by ± a: a loop dissipates 4 B (a − B/e), B = μ p. Steps meet the corners of the
/// loop, so the sum is exact to rounding; the slip path grows by dissipation/B.
#[test]
fn to_and_fro_dissipates_its_hysteresis() {
    let mut pair = Pair::new("PointPlaneCoulomb", &given(MU));
    let bound = MU * 30.0;
    let elastic = bound / EPS_T;
    let (steps, amplitude) = (8, 4.0 * elastic);
    let z = -30.0 / EPS_N;
    // from -a to a and back, in steps of B/e
    let swing = |sign: f64| {
        (0..=steps).map(move |k| vec![sign * (elastic * f64::from(k) - amplitude), 0.0, z])
    };
    work(&mut pair, swing(1.0));
    work(&mut pair, swing(-1.0));
    let before = pair.path();
    let dissipated = work(&mut pair, swing(1.0)) + work(&mut pair, swing(-1.0));
    let expected = 4.0 * bound * (amplitude - elastic);
    let path = pair.path() - before;
    println!(
        "loops: to and fro, relative error of the work {:.1e}, of the path {:.1e}",
        dissipated / expected - 1.0,
        path * bound / expected - 1.0
    );
    assert!((dissipated / expected - 1.0).abs() < 1e-13);
    assert!((path * bound / expected - 1.0).abs() < 1e-13);
}

/// Round and round on a circle of radius ρ the anchor follows at the distance B/e: it runs on the circle of
/// radius √(ρ² − (B/e)²), so a round dissipates B 2π √(ρ² − (B/e)²). Steps of finite length: order measured.
#[test]
fn a_round_dissipates_along_the_path_of_the_anchor() {
    let bound = MU * 30.0;
    let elastic = bound / EPS_T;
    let radius = 2.0 * elastic;
    let expected = std::f64::consts::TAU * (radius * radius - elastic * elastic).sqrt();
    let errors = [100_u32, 200, 400].map(|steps| {
        let mut pair = Pair::new("PointPlaneCoulomb", &given(MU));
        let round = || {
            (0..=steps).map(|k| {
                let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(steps)).sin_cos();
                vec![radius * c, radius * s, -30.0 / EPS_N]
            })
        };
        // two rounds to forget the start
        work(&mut pair, round());
        work(&mut pair, round());
        let before = pair.path();
        let dissipated = work(&mut pair, round());
        let path = pair.path() - before;
        [dissipated / (bound * expected) - 1.0, path / expected - 1.0]
    });
    let order = [0, 1].map(|q| (errors[1][q] / errors[2][q]).log2());
    println!(
        "loops: a round, relative errors (work, path) {} in 400 steps, orders {:.3} {:.3}",
        list(&errors[2]),
        order[0],
        order[1]
    );
    assert!(largest(&errors[2]) < 1e-2);
    assert!(order.iter().all(|&order| order > 0.95), "{order:?}");
}
