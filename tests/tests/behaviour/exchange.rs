//! Two curves are equivalent: exchanging slave and master changes neither energy, forces nor tangent.

use contact_elements::runtime::Status;

use crate::pair::{Pair, State};
use crate::vector::{list, relative};

/// Energy, forces, tangent of `exchanged` in the order of the pair as it was, against `state`.
fn differences(state: &State, exchanged: &State) -> [f64; 3] {
    let n = state.residual.len();
    let other = |i: usize| (i + n / 2) % n;
    let residual: Vec<f64> = (0..n).map(|i| exchanged.residual[other(i)]).collect();
    let tangent: Vec<f64> = (0..n * n)
        .map(|at| exchanged.k(other(at / n), other(at % n)))
        .collect();
    [
        (exchanged.energy / state.energy - 1.0).abs(),
        relative(&residual, &state.residual),
        relative(&tangent, &state.tangent),
    ]
}

/// Runs both orders of a pair through steps that stick and then slip; 1e-12 for curves with a Newton
/// projection: the parameters of the two orders agree to its tolerance.
fn check(name: &str, r0: f64, slave: &[f64], master: &[f64], tolerance: f64) {
    let given = [("eps_n", 1e4), ("eps_t", 5e3), ("mu", 0.2), ("r0", r0)];
    let pairs = [Pair::new(name, &given), Pair::new(name, &given)];
    check_pairs(name, pairs, slave, master, tolerance);
}

fn check_pairs(name: &str, pairs: [Pair; 2], slave: &[f64], master: &[f64], tolerance: f64) {
    let [mut pair, mut exchanged] = pairs;
    let mut most = [0.0_f64; 3];
    let (mut seen, mut rolled) = (vec![], false);
    for step in 0..8 {
        // the slave's first position goes along both curves and deeper
        let s = 4e-3 * f64::from(step * step);
        let mut slave = slave.to_vec();
        for (x, by) in slave.iter_mut().zip([0.6 * s, 1.0 * s, -0.1 * s]) {
            *x += by;
        }
        let state = pair.step(&[&slave, master].concat());
        let other = exchanged.step(&[master, &slave].concat());
        assert_eq!(state.outcome.status, other.outcome.status);
        seen.push(state.status());
        let about = |state: &State| [state.output[21], state.output[22]];
        let ([first, last], others) = (about(&state), about(&other));
        let apart = relative(&[last, first, 1e-3], &[others[0], others[1], 1e-3]);
        // a moment follows a small difference of angles
        assert!(
            apart < 10.0 * tolerance,
            "moments at step {step}: {apart:.1e}"
        );
        rolled |= first.abs().min(last.abs()) > 1e-3;
        let differences = differences(&state, &other);
        for (most, difference) in most.iter_mut().zip(differences) {
            *most = most.max(difference);
        }
    }
    assert!(
        seen[1..].contains(&Status::Stick) && seen.contains(&Status::Slip),
        "{seen:?}"
    );
    assert_eq!(rolled, pair.element.rolling);
    println!("exchange: {name}: energy, forces, tangent {}", list(&most));
    assert!(most.iter().all(|&most| most < tolerance), "{most:?}");
}

#[test]
fn straight_beams() {
    let slave = [-1.0, 0.2, 0.19, 1.0, -0.1, 0.17];
    let master = [0.1, -1.0, 0.0, 0.3, 1.0, 0.03];
    check("Line2Line2BeamsCoulomb", 0.2, &slave, &master, 1e-12);
}

#[test]
fn curved_beams() {
    let slave = [
        -1.0, 0.1, 0.17, 2.0, 0.0, 0.2, 1.0, -0.1, 0.2, 2.0, 0.3, -0.1,
    ];
    let master = [0.1, -1.0, 0.0, 0.2, 2.0, 0.1, 0.0, 1.0, 0.1, -0.1, 2.0, 0.0];
    check("HermiteHermiteBeamsCoulomb", 0.3, &slave, &master, 1e-12);
}

/// Laws of rolling, and directors in the order of the names.
fn rolls(name: &str, r0: f64, directors: [[f64; 3]; 2]) -> Pair {
    let given = [
        ("eps_n", 1e4),
        ("eps_t", 5e3),
        ("mu", 0.2),
        ("eps_phi", 30.0),
        ("mu_phi", 0.02),
        ("r0", r0),
    ];
    let mut pair = Pair::new(name, &given);
    if pair.parameters.len() > given.len() {
        for (side, director) in ["slave", "master"].into_iter().zip(directors) {
            for (axis, component) in ["x", "y", "z"].into_iter().zip(director) {
                pair.set(&format!("{side}_director_{axis}"), component);
            }
        }
    }
    pair
}

#[test]
fn rolling_beams() {
    let directors = [[0.1, 0.3, 1.0], [0.9, -0.2, 0.4]];
    let [first, last] = directors;
    let slave = [
        -1.0, 0.1, 0.17, 2.0, 0.0, 0.2, 1.0, -0.1, 0.2, 2.0, 0.3, -0.1,
    ];
    let master = [0.1, -1.0, 0.0, 0.2, 2.0, 0.1, 0.0, 1.0, 0.1, -0.1, 2.0, 0.0];
    for name in [
        "HermiteHermiteBeamsRolling",
        "HermiteHermiteBeamsRollingDirector",
    ] {
        let pairs = [rolls(name, 0.3, directors), rolls(name, 0.3, [last, first])];
        check_pairs(name, pairs, &slave, &master, 1e-12);
    }
}
