//! Residual and tangent of the oracle against reference cases of 25 digits.

use super::solve::{self, PointStatus, Start, State};
use super::tangential::return_map::Regime;
use crate::proof::cases::{Case, frictional, frictionless};
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS, relative_error};

fn check(case: &Case) {
    let pair = case.pair().unwrap();
    let x = case.positions();
    let state = State {
        reference: &x,
        displacement: &vec![0.0; x.len()],
        start: Start::Given(&[case.start()]),
        friction: &case.friction(),
    };
    let found = solve::evaluate(&pair, &state).unwrap();
    let point = found.points[0];
    assert_eq!(point.status, PointStatus::Closed, "{}", case.id);
    let expected = case.expected().unwrap();
    let slips = point
        .friction
        .map(|friction| friction.regime == Regime::Slip);
    assert_eq!(slips, expected.slips, "{}", case.id);
    let (gap, zeta) = (expected.gap, &expected.zeta);
    assert!(
        (point.gap - gap).abs() <= 1e-9 * (1.0 + gap.abs()),
        "{}",
        case.id
    );
    for (found, expected) in point.zeta.iter().zip(zeta) {
        assert!((found - expected).abs() <= 1e-3, "{}", case.id);
    }
    for (found, expected, spread) in [
        (&found.residual, &expected.residual, case.spread.residual),
        (&found.tangent, &expected.tangent, case.spread.tangent),
    ] {
        let (error, limit) = (
            relative_error(found, expected),
            (REFERENCE_SPREADS * spread).max(REFERENCE),
        );
        assert!(error <= limit, "{}: {error:e} of {limit:e}", case.id);
    }
}

#[test]
fn frictionless_reference_cases() {
    let cases = frictionless().unwrap();
    cases.iter().for_each(check);
    assert_eq!(cases.len(), 52);
}

#[test]
fn frictional_reference_cases() {
    let cases = frictional().unwrap();
    cases.iter().for_each(check);
    assert_eq!(cases.len(), 26);
}
