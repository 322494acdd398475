//! The accepted history: what is kept, what begins, what is forced.

use contact_elements::abi::{Arguments, element_evaluate};
use contact_elements::{Evaluation, Status, code, evaluate, request};

use crate::pair::Pair;
use crate::vector::{difference, largest};

const EPS_N: f64 = 1e4;
const EPS_T: f64 = 3e3;
const MU: f64 = 0.4;
const FACET: [f64; 12] = [
    -1.0, -1.0, 0.1, 1.2, -0.9, -0.2, 0.9, 1.1, 0.15, -1.1, 1.0, -0.1,
];
/// Displacement in which the bound is reached at a pressure of 10.
const ELASTIC: f64 = MU * 10.0 / EPS_T;

fn facet() -> Pair {
    let given = [("eps_n", EPS_N), ("eps_t", EPS_T), ("mu", MU)];
    Pair::new("PointQuad4Coulomb", &given)
}

fn at(x: f64, y: f64, z: f64) -> Vec<f64> {
    [&[x, y, z][..], &FACET].concat()
}

fn plane() -> Pair {
    let given = [("eps_n", EPS_N), ("eps_t", EPS_T), ("mu", MU)];
    Pair::new("PointPlaneCoulomb", &given)
}

/// Position along the plane at a pressure of 10.
fn along(x: f64) -> [f64; 3] {
    [x, 0.0, -10.0 / EPS_N]
}

/// The accepted history is only read: a step may be tried as often as the host likes.
#[test]
fn a_trial_changes_nothing_that_is_accepted() {
    let mut pair = facet();
    pair.step(&at(0.1, 0.2, -0.05));
    let accepted = pair.history.clone();
    let first = pair.at(&at(0.3, 0.1, -0.05));
    let again = pair.at(&at(0.3, 0.1, -0.05));
    assert_eq!(pair.history, accepted);
    assert_ne!(first.history, accepted);
    assert_eq!(first.residual, again.residual);
    assert_eq!(first.history, again.history);
}

/// One array for the old and the new history gives the same bits as two. Two slices of safe Rust cannot be
/// one, so the array goes through the C door.
#[test]
fn one_array_may_hold_both_histories() {
    let mut pair = facet();
    pair.step(&at(0.1, 0.2, -0.05));
    let x = at(0.3, 0.1, -0.05);
    let expected = pair.at(&x);
    let (mut history, mut residual) = (pair.history.clone(), vec![0.0; x.len()]);
    let both = history.as_mut_ptr();
    let mut arguments = Arguments {
        request: request::RESIDUAL | request::HISTORY,
        x: x.as_ptr(),
        parameters: pair.parameters.as_ptr(),
        parameter_count: pair.parameters.len() as i32,
        history_accepted: both,
        history_trial: both,
        f: residual.as_mut_ptr(),
        ..Arguments::EMPTY
    };
    // SAFETY: every array has the length that the header gives.
    let result = unsafe { element_evaluate(pair.element, &mut arguments) };
    assert_eq!(result, code::SUCCESS);
    assert_eq!(residual, expected.residual);
    assert_eq!(history, expected.history);
}

/// Contact begins without friction, from an open history or without one, wherever the point was before.
#[test]
fn contact_begins_without_friction() {
    let mut pair = facet();
    let fresh = pair.at(&at(0.3, 0.1, -0.05));
    pair.step(&at(0.1, 0.2, -0.05));
    pair.step(&at(0.2, 0.2, -0.05));
    assert!(pair.path() > 0.0);
    let open = pair.step(&at(0.2, 0.2, 0.5));
    assert_eq!(open.status(), Status::Open);
    assert_eq!(largest(&open.residual), 0.0);
    let closed = pair.step(&at(0.3, 0.1, -0.05));
    for state in [&fresh, &closed] {
        assert_eq!(state.status(), Status::Stick);
        assert_eq!(state.point(0).t, [0.0; 2]);
    }
    assert_eq!(pair.path(), 0.0);
    assert_eq!(difference(pair.anchor(), &closed.point(0).zeta), 0.0);
    // the projection of the two began elsewhere
    assert!(difference(&closed.residual, &fresh.residual) < 1e-13 * largest(&fresh.residual));
}

/// To 5 elastic displacements, back, and on: the branches of the hysteresis, in closed form.
#[test]
fn reversal_gives_hysteresis() {
    let mut pair = plane();
    let bound = MU * 10.0;
    let force = |pair: &mut Pair, x: f64| {
        let state = pair.step(&along(x * ELASTIC));
        (state.residual[0] / bound, state.status())
    };
    let mut most: f64 = 0.0;
    let stations = [
        (0.0, 0.0, Status::Stick),
        (0.5, 0.5, Status::Stick),
        (3.0, 1.0, Status::Slip),
        (5.0, 1.0, Status::Slip),
        (4.5, 0.5, Status::Stick),
        (4.0, 0.0, Status::Stick),
        (3.5, -0.5, Status::Stick),
        (2.0, -1.0, Status::Slip),
        (2.5, -0.5, Status::Stick),
        (5.5, 1.0, Status::Slip),
    ];
    for (x, expected, status) in stations {
        let (t, found) = force(&mut pair, x);
        assert_eq!(found, status, "at {x}");
        most = most.max((t - expected).abs());
    }
    println!("history: hysteresis, error over the bound {most:.1e}");
    assert!(most < 1e-13);
    // 2 + 2 forward, 1 back, 1.5 forward
    assert!((pair.path() / ELASTIC - 6.5).abs() < 1e-12);
}

/// With the state frozen the branch of the history stays: sticking beyond the bound, sliding within it.
#[test]
fn a_frozen_state_keeps_its_branch() {
    let bound = MU * 10.0;
    let mut pair = plane();
    pair.step(&along(0.0));
    let forced = |pair: &Pair, x: f64| {
        let mut pair = pair.clone();
        pair.bits = request::FREEZE_STATE;
        pair.at(&along(x * ELASTIC))
    };
    let stuck = forced(&pair, 4.0);
    assert_eq!(stuck.status(), Status::Stick);
    assert!((stuck.residual[0] / bound - 4.0).abs() < 1e-13);
    pair.step(&along(3.0 * ELASTIC));
    // back by half the elastic displacement: free it sticks with half the bound
    let free = pair.at(&along(2.5 * ELASTIC));
    assert_eq!(free.status(), Status::Stick);
    assert!((free.residual[0] / bound - 0.5).abs() < 1e-13);
    let sliding = forced(&pair, 2.5);
    assert_eq!(sliding.status(), Status::Slip);
    assert!((sliding.residual[0] / bound - 1.0).abs() < 1e-13);
    // open stays open, in contact as it is
    pair.step(&[0.0, 0.0, 1.0]);
    let open = forced(&pair, 0.0);
    assert_eq!(open.status(), Status::Open);
    assert_eq!(largest(&open.residual), 0.0);
}

/// A history that is too short is refused, not read.
#[test]
fn a_short_history_is_refused() {
    let pair = facet();
    let (x, mut residual) = (at(0.1, 0.2, -0.05), vec![0.0; 15]);
    let result = evaluate(
        pair.element,
        &mut Evaluation {
            x: &x,
            parameters: &pair.parameters,
            history: &[2.0, 0.0, 0.0, 0.0, 0.0],
            residual: &mut residual,
            ..Evaluation::default()
        },
    );
    assert_eq!(result.map_err(|error| error.code), Err(code::NULL));
}
