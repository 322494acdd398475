//! Frictional patch test: two elastic layers, pressed and then sheared.

use contact_elements::runtime::Status;

use crate::linear::newton;
use crate::pair::{Pair, State};

/// Upper and lower layer of area 1: E/H and G/H, no lateral strain.
const NORMAL: [f64; 2] = [1000.0, 250.0];
const SHEAR: [f64; 2] = [500.0, 125.0];
const EPS: f64 = 1e5;

/// The interface: the lower face of the upper layer (slave) on the upper face of the lower one, which is
/// wider. Unknowns: (x, z) of both.
fn nodes(u: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let upper = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let lower = upper.map(|[x, y]: [f64; 2]| [3.0 * x - 1.0, 2.0 * y - 0.7]);
    let reference = upper.iter().chain(&lower);
    let reference = reference.flat_map(|[x, y]| [*x, *y, 0.0]).collect();
    let face = |at: usize| [u[at], 0.0, u[at + 1]].repeat(4);
    (reference, [face(0), face(2)].concat())
}

fn contact(pair: &Pair, u: &[f64]) -> State {
    let (reference, moved) = nodes(u);
    pair.moved(&reference, &moved)
}

/// The displacements of both faces with the top moved by (x, z) and the bottom held.
fn rest(pair: &Pair, start: Vec<f64>, top: [f64; 2]) -> Vec<f64> {
    let found = newton(start, 1e-10, |u| {
        let state = contact(pair, u);
        let mut residual = vec![0.0; 4];
        let mut rows = vec![vec![0.0; 4]; 4];
        let unknown = |i: usize| 2 * (i / 12) + if i % 3 == 2 { 1 } else { 0 };
        let moves = |i: usize| i % 3 != 1;
        for i in (0..24).filter(|i| moves(*i)) {
            residual[unknown(i)] += state.residual[i];
            for j in (0..24).filter(|j| moves(*j)) {
                rows[unknown(i)][unknown(j)] += state.k(i, j);
            }
        }
        for (k, stiffness) in [SHEAR, NORMAL].into_iter().enumerate() {
            residual[k] += stiffness[0] * (u[k] - top[k]);
            residual[2 + k] += stiffness[1] * u[2 + k];
            rows[k][k] += stiffness[0];
            rows[2 + k][2 + k] += stiffness[1];
        }
        (residual, rows)
    });
    found.expect("layers hold the faces")
}

/// Uniform pressure 2, shear 99.9001 per displacement of the top until 0.006006, then 0.6 for ever: series of
/// springs, so rounding is all that is lost: stiffnesses of 1e5 times coordinates of 1 with errors of 1e-16.
#[test]
fn two_layers_stick_and_slip() {
    let given = [("eps_n", EPS), ("eps_t", EPS), ("mu", 0.3)];
    let mut pair = Pair::new("Quad4Quad4Coulomb", &given);
    let (down, slope, onset, slip) = (-0.01002, 99.900099900099900, 0.006006, 0.6);
    let mut u = rest(&pair, vec![0.0, -1e-2, 0.0, -1e-2], [0.0, down]);
    pair.history = contact(&pair, &u).history;
    let mut most = [0.0_f64; 2];
    for step in 1..=40 {
        let top = 0.1 * onset * f64::from(step) * (1.0 + 1e-8);
        u = rest(&pair, u, [top, down]);
        let state = contact(&pair, &u);
        pair.history.clone_from(&state.history);
        for q in 0..4 {
            let point = state.point(q);
            let sticks = step < 10;
            assert_eq!(
                point.status,
                if sticks { Status::Stick } else { Status::Slip },
                "{step}"
            );
            let expected = if sticks { slope * top } else { slip };
            most[0] = most[0].max((point.friction() - expected).abs() / slip);
            most[1] = most[1].max((point.pressure - 2.0).abs() / 2.0);
        }
    }
    println!(
        "patch: shear stress {:.1e}, pressure {:.1e}, at four points",
        most[0], most[1]
    );
    assert!(most[0] < 1e-9 && most[1] < 1e-9);
}
