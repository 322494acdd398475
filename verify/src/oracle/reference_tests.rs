//! Residual and tangent of the oracle against frictionless reference cases of 25 digits.

use super::solve::{self, PointStatus, Start, State};
use crate::proof::reference::cases;
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS, relative_error};

#[test]
fn frictionless_reference_cases() {
    let cases = cases().unwrap();
    for case in &cases {
        let pair = case.pair().unwrap();
        let x = case.positions();
        let state = State {
            reference: &x,
            displacement: &vec![0.0; x.len()],
            start: Start::Given(&[case.start()]),
        };
        let found = solve::evaluate(&pair, &state).unwrap();
        let point = found.points[0];
        assert_eq!(point.status, PointStatus::Closed, "{}", case.id);
        let expected = case.expected().unwrap();
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
    assert_eq!(cases.len(), 52);
}
