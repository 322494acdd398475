//! Static and kinetic friction: the coefficient falls with the path slid, and a new contact is at rest again.

use contact_elements::runtime::Status;

use crate::linear::bisect;
use crate::pair::Pair;

const EPS_T: f64 = 3e5;
const STATIC: f64 = 0.6;
const KINETIC: f64 = 0.2;
const DECAY: f64 = 0.05;
const PRESSURE: f64 = 10.0;

fn facet() -> Pair {
    let given = [
        ("eps_n", 1e4),
        ("eps_t", EPS_T),
        ("mu_s", STATIC),
        ("mu_k", KINETIC),
        ("decay", DECAY),
    ];
    Pair::new("PointQuad4CoulombStaticKinetic", &given)
}

fn at(x: f64, height: f64) -> Vec<f64> {
    let point = [x, 0.1, height];
    let facet = [
        -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
    ];
    [&point[..], &facet].concat()
}

/// |T| after the displacement d of monotone sliding is p μ(d): the bound counts the whole path, the elastic
/// part included, so steps of any size are on the same curve, μ(d) = μ_k + (μ_s − μ_k) exp(−d/decay), but
/// for the elastic part that a step before gave back: d is path + |s|, exactly.
#[test]
fn the_coefficient_falls_with_the_path() {
    let coefficient = |slip: f64| KINETIC + (STATIC - KINETIC) * (-slip / DECAY).exp();
    for steps in [20_u32, 200] {
        let mut pair = facet();
        pair.step(&at(-0.5, -PRESSURE / 1e4));
        let mut most: f64 = 0.0;
        for step in 1..=steps {
            let d = 0.9 * f64::from(step) / f64::from(steps);
            let state = pair.step(&at(-0.5 + d, -PRESSURE / 1e4));
            assert_eq!(state.status(), Status::Slip);
            most = most.max((state.residual[0] / PRESSURE - coefficient(d)).abs());
            // the path slid is what the elastic part leaves of d
            let elastic = state.residual[0] / EPS_T;
            assert!((pair.path() + elastic - d).abs() < 1e-13);
        }
        println!(
            "static and kinetic: {steps} steps of sliding, error of the coefficient {most:.1e}"
        );
        // coordinates and pressure carry rounding of 1e-16/1e-3
        assert!(most < 1e-12);
    }
}

/// The force at which sliding starts is the static one; after sliding far, the kinetic one; after lifting
/// off, the static one again. The bound falls already in the elastic part: its end solves e d = p μ(d).
#[test]
fn a_new_contact_is_at_rest_again() {
    let z = -PRESSURE / 1e4;
    let onset = |pair: &Pair, x: f64| {
        let (last, _) = bisect(0.0, 0.1, |d| {
            pair.at(&at(x + d, z)).status() == Status::Stick
        });
        pair.at(&at(x + last, z)).residual[0] / PRESSURE
    };
    let mut pair = facet();
    pair.step(&at(-0.5, z));
    let first = onset(&pair, -0.5);
    pair.step(&at(0.7, z));
    // back to the anchor, so that nothing is stored
    let anchor = pair.anchor()[0];
    pair.step(&at(anchor, z));
    let slid = onset(&pair, anchor);
    pair.step(&at(0.0, 0.5));
    pair.step(&at(-0.5, z));
    let again = onset(&pair, -0.5);
    println!(
        "static and kinetic: sliding starts at {first:.6}, after sliding {slid:.6}, after lifting off {again:.6}"
    );
    let expected = KINETIC + (STATIC - KINETIC) * (-first * PRESSURE / EPS_T / DECAY).exp();
    // positions of 0.5 carry the force with 1e-16·eps_t
    assert!((first - expected).abs() < 1e-10);
    assert!((slid - KINETIC - (STATIC - KINETIC) * (-1.2 / DECAY).exp()).abs() < 1e-9);
    assert!((again - first).abs() < 1e-10);
}
