//! Edges of solids: the side on which they were stays theirs when they cross, when they turn through parallel, and
//! from segment to segment of a chain; it ends where they pass each other beyond an end.

use contact_elements::{Entered, Evaluation, Left, Status, code, evaluate, transfer};

use crate::pair::{Pair, State};
use crate::vector::{Vector, add, dot, length, scaled, subtract};

const EPS_N: f64 = 1000.0;

/// Edges that have not met: the first state says on which side they are.
fn edges(name: &str) -> Pair {
    let mut pair = Pair::new(name, &[("eps_n", EPS_N)]);
    if pair.element.friction {
        pair.set("eps_t", 500.0);
        pair.set("mu", 0.3);
    }
    pair.history = vec![0.0; pair.element.history()];
    pair
}

fn nodes(parts: &[Vector]) -> Vec<f64> {
    parts.iter().flatten().copied().collect()
}

/// Slave along x turned by `angle`, its middle at `at`; master along x, its middle at the origin.
fn crossed(angle: f64, at: Vector) -> Vec<f64> {
    let along = [angle.cos(), angle.sin(), 0.0];
    let ends = [-1.0, 1.0].map(|end| add(at, scaled(end, along)));
    nodes(&[ends[0], ends[1], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
}

/// Force on the slave.
fn force(state: &State) -> Vector {
    let slave = state.residual[..6].chunks(3);
    slave.fold([0.0; 3], |sum, f| subtract(sum, [f[0], f[1], f[2]]))
}

#[test]
fn edges_that_cross_are_pushed_back() {
    for side in [1.0, -1.0] {
        let mut pair = edges("Line2Line2Edges");
        let forgetful = pair.clone();
        for step in 0..21 {
            let height = side * (0.1 - 0.01 * f64::from(step)) + 1e-3;
            let x = crossed(1.2, [0.3, 0.2, height]);
            let state = pair.step(&x);
            let (point, gap) = (state.point(0), side * height);
            assert!((point.gap - gap).abs() < 1e-15, "{} {gap}", point.gap);
            let expected = if gap < 0.0 {
                Status::Closed
            } else {
                Status::Open
            };
            assert_eq!(point.status, expected, "side {side}, height {height}");
            let back = [0.0, 0.0, side * EPS_N * (-gap).max(0.0)];
            assert!(length(subtract(force(&state), back)) < 1e-11);
            // without a memory there is no crossing
            assert_eq!(forgetful.at(&x).status(), Status::Open);
        }
    }
}

#[test]
fn the_side_outlives_parallel_edges() {
    for (height, expected) in [(0.05, Status::Open), (-0.01, Status::Closed)] {
        let mut pair = edges("HermiteHermiteEdges");
        let along = |angle: f64| [angle.cos(), angle.sin(), 0.0];
        let x = |angle: f64, height: f64| {
            let (slave, at) = (along(angle), [0.0, 0.0, height]);
            let ends = [-1.0, 1.0].map(|end| add(at, scaled(end, slave)));
            let master = along(0.0);
            nodes(&[
                ends[0],
                slave,
                ends[1],
                slave,
                scaled(-1.0, master),
                master,
                master,
                master,
            ])
        };
        pair.step(&x(0.5, 0.05));
        // a fixed orientation turns the normal about with the edges
        let mut fixed = pair.clone();
        fixed.set(
            "orientation",
            if pair.at(&x(0.5, 0.05)).point(0).b[0][1] > 0.0 {
                -1.0
            } else {
                1.0
            },
        );
        fixed.history = vec![];
        let mut turned_about = false;
        for step in 0..11 {
            let angle = 0.5 - 0.1 * f64::from(step) + 0.01;
            let state = pair.step(&x(angle, height));
            let point = state.point(0);
            assert_eq!(point.status, expected, "angle {angle}");
            assert!((point.gap - height).abs() < 1e-14 && point.normal[2] > 0.999_999);
            let alone = fixed.at(&x(angle, height)).point(0);
            turned_about |= (alone.gap + height).abs() < 1e-14;
        }
        assert!(turned_about);
    }
}

#[test]
fn beyond_an_end_the_side_is_free_again() {
    let mut pair = edges("Line2Line2Edges");
    let state = pair.step(&crossed(1.5, [0.5, 0.0, 0.1]));
    assert_eq!(state.status(), Status::Open);
    // past the end, down beside it, and back below
    for (x, z, expected) in [
        (1.3, 0.1, Status::Outside),
        (1.3, -0.1, Status::Outside),
        (0.5, -0.1, Status::Open),
        (0.5, 0.02, Status::Closed),
    ] {
        assert_eq!(
            pair.step(&crossed(1.5, [x, 0.0, z])).status(),
            expected,
            "{x} {z}"
        );
    }
}

#[test]
fn a_turn_that_leaves_the_side_open_is_refused() {
    let mut pair = edges("Line2Line2Edges");
    pair.step(&crossed(1.0, [0.0, 0.0, 0.1]));
    let quarter = |angle: f64| {
        let x = crossed(1.0, [0.0, 0.0, 0.1]);
        let about_x = |v: &[f64]| {
            let (s, c) = angle.sin_cos();
            [v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]]
        };
        let x: Vec<f64> = x.chunks(3).flat_map(about_x).collect();
        let mut residual = vec![0.0; x.len()];
        let result = evaluate(
            pair.element,
            &mut Evaluation {
                x: &x,
                parameters: &pair.parameters,
                history: &pair.history,
                residual: &mut residual,
                ..Evaluation::default()
            },
        );
        result.map(|summary| summary.status)
    };
    assert_eq!(quarter(1.4), Ok(Status::Open));
    let lost = quarter(1.57).expect_err("no side");
    assert!(lost.is_cut_back() && lost.status == Some(Status::NotUnique));
    // further than that the side is lost: a step has to turn by less than a right angle
    assert_eq!(quarter(1.8), Ok(Status::Closed));
}

/// A slave that penetrates and slides from one segment of a chain to the next.
fn along_a_chain(name: &str, bend: f64) {
    let chain = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [3.0, 0.0, bend]];
    let slave = |x: f64, z: f64| [[x, -1.0, z], [x, 1.0, z]];
    let on = |segment: usize, x: f64, z: f64| {
        let [a, b] = slave(x, z);
        nodes(&[a, b, chain[segment], chain[segment + 1]])
    };
    let mut first = edges(name);
    first.step(&on(0, 0.9, 0.05));
    let accepted = first.step(&on(0, 0.99, -0.02));
    assert!(accepted.status().is_closed());
    let mut second = edges(name);
    second.set("orientation", 0.0);
    let fresh = second.at(&on(1, 0.99, -0.02));
    assert_eq!(fresh.status(), Status::Outside);
    let mut carried = fresh.history.clone();
    let left = Left {
        element: first.element,
        output: &accepted.output,
        history: &accepted.history,
    };
    let entered = Entered {
        element: second.element,
        output: &fresh.output,
        history: &mut carried,
    };
    transfer(left, entered).expect("carried");
    second.history = carried;
    let after = second.step(&on(1, 1.01, -0.02));
    assert!(after.status().is_closed(), "{:?}", after.status());
    let normal = accepted.point(0).normal;
    assert!(dot(after.point(0).normal, normal) > 0.9 && after.point(0).gap < 0.0);
    // without it the slave is taken to come from below
    let mut lost = edges(name);
    assert_eq!(lost.step(&on(1, 1.01, -0.02)).status(), Status::Open);
}

#[test]
fn the_side_goes_along_a_chain() {
    for bend in [0.0, 0.1, -0.1] {
        along_a_chain("Line2Line2Edges", bend);
        along_a_chain("Line2Line2EdgesCoulomb", bend);
    }
}

#[test]
fn what_cannot_be_a_side_is_refused() {
    let pair = edges("Line2Line2Edges");
    let x = crossed(1.0, [0.0, 0.0, 0.1]);
    let outcome = |history: &[f64]| {
        let mut residual = vec![0.0; x.len()];
        let found = evaluate(
            pair.element,
            &mut Evaluation {
                x: &x,
                parameters: &pair.parameters,
                history,
                residual: &mut residual,
                ..Evaluation::default()
            },
        );
        found.map_or_else(|error| (error.code, error.index), |_| (code::SUCCESS, 0))
    };
    assert_eq!(outcome(&[]).0, code::NULL);
    let with = |side: [f64; 3]| [&[0.0; 3], side.as_slice()].concat();
    assert_eq!(outcome(&with([0.0; 3])).0, code::SUCCESS);
    assert_eq!(outcome(&with([0.0, 0.0, 1.0])).0, code::SUCCESS);
    assert_eq!(outcome(&with([0.0, 0.0, 1.1])), (code::HISTORY, 3));
    assert_eq!(outcome(&with([0.0, 0.6, 0.0])), (code::HISTORY, 3));
    assert_eq!(outcome(&with([f64::NAN, 0.0, 0.0])), (code::NOT_FINITE, 3));
}
