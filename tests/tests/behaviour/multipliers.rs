//! Multipliers beside the normal law: Uzawa's iteration, and multipliers as unknowns.

use contact_elements::{Status, augment};

use crate::linear::newton;
use crate::pair::{Pair, State};
use crate::vector::list;

const EPS_N: f64 = 400.0;
const EPS_T: f64 = 150.0;
const MU: f64 = 0.3;
/// Springs that hold the point, along the facet and across it.
const SPRING: [f64; 2] = [90.0, 600.0];
/// Force that presses the point against the facet.
const PRESS: f64 = 25.0;
const FACET: [f64; 12] = [
    -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
];

fn pair(name: &str) -> Pair {
    let mut pair = Pair::new(name, &[("eps_n", EPS_N)]);
    if name.contains("Coulomb") {
        pair.set("eps_t", EPS_T);
        pair.set("mu", MU);
    }
    pair
}

/// The point at (x, 0, z) above the facet; behind it the node of a multiplier where the element has one.
fn nodes(pair: &Pair, [x, z]: [f64; 2], multiplier: f64) -> Vec<f64> {
    let mut nodes = [&[x, 0.0, z], &FACET[..]].concat();
    if pair.element.multipliers() == 1 {
        nodes.extend([multiplier, 0.0, 0.0]);
    }
    nodes
}

/// Rest of a point held by both springs at the origin, pressed and pulled along the facet by `pull`; the unknowns
/// are x, z and the multiplier where that is one.
fn rest(pair: &Pair, pull: f64) -> (Vec<f64>, State) {
    let has_multiplier = pair.element.multipliers() == 1;
    let count = if has_multiplier { 3 } else { 2 };
    let at = |v: &[f64]| {
        let x = nodes(pair, [v[0], v[1]], 0.0);
        let mut u = vec![0.0; x.len()];
        if has_multiplier {
            u[15] = v[2];
        }
        pair.moved(&x, &u)
    };
    // unknowns of the element that are free
    let free = [0, 2, 15];
    let found = newton(
        vec![0.0, -1e-3, -1.0][..count].to_vec(),
        1e-13 * PRESS,
        |v| {
            let state = at(v);
            let outer = [SPRING[0] * v[0] - pull, SPRING[1] * v[1] + PRESS, 0.0];
            let residual = (0..count).map(|i| state.residual[free[i]] + outer[i]);
            let stiffness = [SPRING[0], SPRING[1], 0.0];
            let row = |i: usize| {
                let entry = |j: usize| {
                    let own = if i == j { stiffness[i] } else { 0.0 };
                    state.k(free[i], free[j]) + own
                };
                (0..count).map(entry).collect()
            };
            (residual.collect(), (0..count).map(row).collect())
        },
    )
    .expect("a rest");
    let state = at(&found);
    (found, state)
}

/// The pair with the initial history of an element.
fn fresh(name: &str) -> Pair {
    let mut pair = pair(name);
    pair.history = vec![0.0; pair.element.history()];
    pair
}

fn uzawa(pair: &mut Pair, state: &State) {
    augment(pair.element, &state.history, &mut pair.history).expect("augmented");
}

/// What is missing to a gap of zero shrinks by spring/(spring + penalty) per iteration; the multiplier tends to the
/// load. 1e-11: the smallest gap compared is 1e-4 of the first.
#[test]
fn uzawas_iteration_closes_the_gap() {
    let mut pair = fresh("PointQuad4Augmented");
    let ratio = SPRING[1] / (SPRING[1] + EPS_N);
    let mut gaps: Vec<f64> = vec![];
    for _ in 0..20 {
        let (_, state) = rest(&pair, 0.0);
        gaps.push(state.point(0).gap);
        uzawa(&mut pair, &state);
    }
    let worst = gaps
        .windows(2)
        .map(|two| (two[1] / two[0] / ratio - 1.0).abs())
        .fold(0.0, f64::max);
    let (_, last) = rest(&pair, 0.0);
    let load = last.point(0).pressure / PRESS - 1.0;
    println!(
        "multipliers: gap per iteration of Uzawa against spring/(spring + penalty) {worst:.1e}, after 20 {}, load {load:.1e}",
        list(&[gaps[19] / gaps[0]])
    );
    assert!(worst < 1e-11 && load.abs() < 1e-4);
    assert!((gaps[0] + PRESS / (SPRING[1] + EPS_N)).abs() < 1e-15);
}

/// A host that only accepts makes one iteration per step.
#[test]
fn accepting_a_step_augments_once() {
    let (mut accepts, mut augments) = (fresh("PointQuad4Augmented"), fresh("PointQuad4Augmented"));
    for _ in 0..5 {
        let (_, state) = rest(&accepts, 0.0);
        accepts.history = state.history;
        let (_, state) = rest(&augments, 0.0);
        uzawa(&mut augments, &state);
        assert_eq!(accepts.history.last(), augments.history.last());
    }
}

/// Sticking: the slip of the step shrinks by spring/(spring + stiffness) per iteration, the friction tends to the
/// pull and the slip path stays; the normal multiplier converges beside it.
#[test]
fn uzawas_iteration_ends_the_slip_of_a_sticking_point() {
    let mut pair = fresh("PointQuad4CoulombAugmented");
    let (_, state) = rest(&pair, 0.0);
    pair.history = state.history; // in contact
    let (pull, ratio) = (0.5 * MU * PRESS, SPRING[0] / (SPRING[0] + EPS_T));
    let mut slips: Vec<f64> = vec![];
    for _ in 0..12 {
        let (x, state) = rest(&pair, pull);
        assert_eq!(state.status(), Status::Stick);
        assert_eq!(state.history[5], 0.0);
        slips.push(x[0]);
        uzawa(&mut pair, &state);
    }
    let worst = slips
        .windows(2)
        .map(|two| (two[1] / two[0] / ratio - 1.0).abs())
        .fold(0.0, f64::max);
    let (_, last) = rest(&pair, pull);
    println!(
        "multipliers: slip per iteration of Uzawa against spring/(spring + stiffness) {worst:.1e}, friction against the pull {:.1e}",
        last.point(0).friction() / pull - 1.0
    );
    assert!(worst < 1e-9);
    assert!((last.point(0).friction() / pull - 1.0).abs() < 1e-4);
}

/// Sliding: the friction is μ|N| of the whole traction, the springs carry the rest, and the slip path is the way of
/// the point.
#[test]
fn uzawas_iteration_slides_at_the_bound() {
    let mut pair = fresh("PointQuad4CoulombAugmented");
    let (_, state) = rest(&pair, 0.0);
    pair.history = state.history;
    let pull = 2.0 * MU * PRESS;
    for _ in 0..40 {
        let (_, state) = rest(&pair, pull);
        uzawa(&mut pair, &state);
    }
    let (x, state) = rest(&pair, pull);
    let way = (pull - MU * PRESS) / SPRING[0];
    let path = state.history[5];
    println!(
        "multipliers: sliding with Uzawa's iteration, way {:.1e}, slip path {:.1e}",
        x[0] / way - 1.0,
        path / way - 1.0
    );
    assert_eq!(state.status(), Status::Slip);
    assert!((x[0] / way - 1.0).abs() < 1e-7 && (path / way - 1.0).abs() < 1e-6);
}

/// As an unknown the multiplier is the load and the gap zero, from the first step on; friction is μ times the load.
#[test]
fn a_multiplier_holds_the_point_on_the_facet() {
    let (x, state) = rest(&pair("PointQuad4Multiplier"), 0.0);
    assert!(x[1].abs() < 1e-16 * 1e2 && (x[2] / -PRESS - 1.0).abs() < 1e-14);
    assert_eq!(state.status(), Status::Closed);
    let mut frictional = pair("PointQuad4CoulombMultiplier");
    let (_, state) = rest(&frictional, 0.0);
    frictional.history = state.history;
    for (pull, expected) in [(0.5, Status::Stick), (2.0, Status::Slip)] {
        let pull = pull * MU * PRESS;
        let (x, state) = rest(&frictional, pull);
        let friction = match expected {
            Status::Stick => EPS_T * x[0],
            _ => MU * PRESS,
        };
        assert_eq!(state.status(), expected);
        assert!(x[1].abs() < 1e-13 && (x[2] / -PRESS - 1.0).abs() < 1e-12);
        assert!((SPRING[0] * x[0] + friction - pull).abs() < 1e-12 * pull);
    }
}

/// Where contact begins or ends, residual and energy are continuous, also in the multiplier.
#[test]
fn nothing_jumps_where_contact_begins() {
    let pair = pair("PointQuad4Multiplier");
    for gap in [-0.02_f64, -1e-9, 0.0, 1e-9, 0.03] {
        let states = [-1e-9, 1e-9].map(|beyond: f64| {
            let x = nodes(&pair, [0.2, gap], 0.0);
            let mut u = vec![0.0; x.len()];
            u[15] = -EPS_N * gap + beyond;
            pair.moved(&x, &u)
        });
        assert_eq!(states[0].status(), Status::Closed);
        assert_eq!(states[1].status(), Status::Open);
        for i in 0..16 {
            assert!((states[0].residual[i] - states[1].residual[i]).abs() < 2e-9);
        }
        assert!((states[0].energy - states[1].energy).abs() < 1e-9);
    }
}
