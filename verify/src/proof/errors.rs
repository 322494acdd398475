//! Errors of an answer against the oracle, each relative to what it is made of.

use crate::oracle::solve::{Couplings, Evaluation};
use crate::subject::{Answer, Subject};
use crate::tolerance::relative_error;

/// Largest error of the parts that belong to multipliers, each relative to its own largest entry.
pub(super) fn couplings_error(found: &Couplings, expected: &Couplings) -> f64 {
    let parts = found.parts().into_iter().zip(expected.parts());
    parts
        .map(|(found, expected)| relative_error(found, expected))
        .fold(0.0, f64::max)
}

/// Error of an energy relative to the magnitudes that it is made of.
pub(super) fn relative_energy(found: &[f64], expected: f64, size: f64) -> f64 {
    let error = relative_error(found, &[expected]);
    if error == 0.0 {
        0.0
    } else {
        error * (expected / size).abs()
    }
}

/// Whether the tangent of the element is a derivative that the oracle can judge.
pub(super) fn has_tangent(subject: &Subject) -> bool {
    subject.description.descriptor.tangent && !subject.description.tangent_plane
}

/// Error of the tangent relative to its largest entry; or of its product with the directions, relative to the
/// largest sum of absolute terms, because the terms of a product may cancel.
pub(super) fn tangent_error(
    subject: &Subject,
    answer: &Answer,
    truth: &Evaluation,
    directions: &[Vec<f64>],
) -> f64 {
    if !has_tangent(subject) {
        return 0.0;
    }
    if directions.is_empty() {
        return relative_error(&answer.tangent, &truth.tangent);
    }
    let unknowns = answer.residual.len();
    let mut worst: f64 = 0.0;
    for (direction, expected) in directions.iter().zip(&truth.products) {
        let (mut difference, mut scale) = (0.0_f64, 0.0_f64);
        for (row, expected) in answer.tangent.chunks_exact(unknowns).zip(expected) {
            let terms = || row.iter().zip(direction).map(|(k, d)| k * d);
            let error = (terms().sum::<f64>() - expected).abs();
            difference = if error.is_nan() {
                f64::INFINITY
            } else {
                difference.max(error)
            };
            scale = scale.max(terms().map(f64::abs).sum());
        }
        worst = worst.max(difference / scale);
    }
    worst
}
