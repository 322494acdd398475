use num_traits::{Num, Signed};

use super::*;
use crate::configurations::{Generator, Wanted};
use crate::measure::stress::exact;
use crate::oracle::solve;
use crate::proof::cases;
use crate::subject;
use crate::tolerance::{RANDOM, relative_error};

fn worst(found: &[Octuple], expected: &[&str]) -> f64 {
    let expected: Vec<Octuple> = expected
        .iter()
        .map(|text| Octuple::from_str_radix(text, 10).unwrap())
        .collect();
    let top = expected.iter().fold(Octuple::zero(), |m, v| m.max(v.abs()));
    found.iter().zip(&expected).fold(0.0, |m: f64, (a, b)| {
        m.max(((*a - *b).abs() / top).to_f64())
    })
}

#[test]
fn all_digits_of_the_reference_cases_are_met() {
    let cases = cases::cases().unwrap();
    assert!(cases.len() > 70);
    for case in cases {
        let pair = case.pair().unwrap();
        let (start, friction) = ([case.start()], case.friction());
        let state = State {
            pair: &pair,
            nodes: exact::nodes(&case.positions(), pair.dimension),
            start: &start,
            friction: &friction,
            nudge: [0.0; 2],
        };
        let truth = evaluate(&state).unwrap();
        let (residual, tangent) = case.digits();
        assert_eq!(residual.len(), truth.residual.len());
        assert_eq!(tangent.len(), truth.tangent.len());
        let errors = [
            worst(&truth.residual, &residual),
            worst(&truth.tangent, &tangent),
        ];
        // the program behind the cases squares the coefficients of an ellipse in doubles
        let digits = if case.id.contains("orthotropic") {
            1e-16
        } else {
            1e-24
        };
        assert!(
            errors.iter().all(|&e| e < digits),
            "{}: {errors:?}",
            case.id
        );
    }
}

#[test]
fn the_oracle_in_doubles_agrees() {
    let mut compared = 0;
    for subject in subject::built_in().unwrap() {
        if !is_supported(&subject.template) || subject.template.unknowns() > 30 {
            continue;
        }
        let generator = Generator::new(subject.template.clone(), 7);
        let wanted = match &subject.template.tangential {
            Some(own) if own.law.is_bounded() => Wanted::Slip,
            Some(_) => Wanted::Stick,
            None => Wanted::Closed,
        };
        let c = generator.generate(wanted, 1).unwrap();
        if c.friction
            .iter()
            .any(|point| point.status == Accepted::Open)
        {
            continue;
        }
        let expected = solve::evaluate(&c.pair, &c.state()).unwrap();
        let dimension = c.pair.dimension;
        // the measure of the reference configuration is that of X
        if matches!(
            c.pair.slave,
            Slave::Fixed {
                measure: Measure::Reference,
                ..
            }
        ) {
            continue;
        }
        let positions: Vec<Octuple> = c
            .reference
            .iter()
            .zip(&c.displacement)
            .map(|(&x, &u)| Octuple::from(x) + u)
            .collect();
        let node = |v: &[Octuple]| [v[0], v[1], v.get(2).copied().unwrap_or_default()];
        let state = State {
            pair: &c.pair,
            nodes: positions.chunks(dimension).map(node).collect(),
            start: &c.start,
            friction: &c.friction,
            nudge: [0.0; 2],
        };
        let truth = evaluate(&state).unwrap();
        let plain = |v: &[Octuple]| v.iter().map(|v| v.to_f64()).collect::<Vec<_>>();
        for (a, b) in [
            (&truth.residual, &expected.residual),
            (&truth.tangent, &expected.tangent),
        ] {
            let error = relative_error(&plain(a), b);
            assert!(error < RANDOM, "{}: {error:e}", subject.name());
        }
        compared += 1;
    }
    assert!(compared >= 60, "{compared}");
}
