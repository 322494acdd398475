//! Angles about two curves against 25 digits, and against the element.
#![allow(clippy::excessive_precision)] // 25 digits, as they were computed

use crate::oracle::geometry::{Interpolation, Shape};
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{GapKind, Master, Pair, Rolling, Slave, Tangential};
use crate::oracle::solve::{self, Start, State};
use crate::oracle::tangential::TangentialLaw;
use crate::subject::{self, Input, Wanted};

/// Nodes of two Hermite curves, and the angles about them, computed with 25 digits by a program that
/// shares nothing with this one: principal normal and binormal from the cross products of ρ' and ρ''.
const REFERENCE: [([f64; 24], [f64; 2]); 3] = [
    (
        [
            -1.0, 0.1, 0.35, 0.9, 0.2, -0.1, 1.1, -0.05, 0.3, 1.0, -0.3, 0.2, 0.05, -1.0, -0.1,
            0.1, 1.2, 0.3, -0.1, 0.95, 0.05, -0.2, 0.8, -0.25,
        ],
        [2.2158661671100778990379, 2.642438836402442536978623],
    ),
    (
        [
            -0.8, -0.7, 0.6, 0.7, 0.9, 0.4, 0.9, 0.6, 0.5, 1.1, 0.3, -0.5, 0.9, -0.8, 0.1, -0.6,
            1.1, -0.2, -0.7, 0.9, -0.05, -1.0, 0.6, 0.3,
        ],
        [0.6320475184389075544725682, 1.20005696549366632071565],
    ),
    (
        [
            -1.0, 0.2, -0.5, 1.1, 0.3, 0.4, 1.0, 0.1, -0.4, 0.8, -0.2, -0.6, -0.1, -1.1, 0.2, 0.4,
            1.0, -0.3, 0.15, 1.0, 0.1, -0.3, 1.1, 0.2,
        ],
        [-2.739004161079864334862135, -2.144440577364073853663134],
    ),
];

fn pair() -> Pair {
    let curve = || Interpolation::new(Shape::Hermite);
    let law = |eps_t| TangentialLaw::Coulomb { eps_t, mu: 0.3 };
    Pair {
        dimension: 3,
        slave: Slave::Curve(curve()),
        master: Master::Shape(curve()),
        gap: GapKind::Distance,
        orientation: 1.0,
        r0: 1.0,
        law: Law::Penalty { eps_n: 100.0 },
        tangential: Some(Tangential {
            rolling: Some(Rolling {
                law: law(10.0),
                directors: None,
            }),
            ..Tangential::isotropic(law(50.0))
        }),
        angle: None,
        multipliers: Multipliers::None,
    }
}

#[test]
fn angles_of_reference_curves() {
    let subjects = subject::built_in().expect("known names");
    let mut subjects = subjects.iter();
    let element = subjects.find(|subject| subject.name() == "HermiteHermiteBeamsRolling");
    let element = element.expect("a built-in element");
    for (x, expected) in &REFERENCE {
        let pair = pair();
        let state = State {
            reference: x,
            displacement: &[0.0; 24],
            start: Start::Given(&[[0.1, -0.1]]),
            friction: &[],
        };
        let report = &solve::reports(&pair, &state).expect("a state")[0];
        let found = report.friction.and_then(|friction| friction.rolling);
        let found = found.expect("a closed point").angle;
        let answer = element.call(
            &Input {
                reference: x,
                displacement: &[0.0; 24],
                parameters: &element.parameters(&pair),
                history: &element.history(&[[0.1, -0.1]], &[], &Multipliers::None),
                slave_row: &[],
                multipliers: &[],
            },
            Wanted::BOTH,
        );
        for c in 0..2 {
            assert!((found[c] - expected[c]).abs() < 1e-13, "{found:?}");
            assert!((answer.output[19 + c] - expected[c]).abs() < 1e-13);
        }
    }
}
