//! Errors against octuple precision.

use contact_verify::measure::stress::exact;
use contact_verify::measure::stress::truth::{State, evaluate};
use contact_verify::oracle::octuple::Octuple;
use contact_verify::oracle::pair::Pair;
use num_traits::Signed;

use crate::Failure;

/// Residual and tangent of a state.
#[derive(Clone, Debug)]
pub struct Truth {
    residual: Vec<Octuple>,
    tangent: Vec<Octuple>,
}

impl Truth {
    /// Truth of a closed state without friction.
    ///
    /// # Errors
    /// Where the pair has no truth.
    pub fn new(pair: &Pair, positions: &[f64], start: &[[f64; 2]]) -> Result<Self, Failure> {
        let state = State {
            pair,
            nodes: exact::nodes(positions, pair.dimension),
            start,
            friction: &[],
            nudge: [0.0; 2],
        };
        let truth = evaluate(&state).ok_or("a pair without truth")?;
        if !truth.status.is_closed() {
            return Err(format!("{:?} in truth", truth.status).into());
        }
        Ok(Self {
            residual: truth.residual,
            tangent: truth.tangent,
        })
    }

    /// Largest error of R and of K, each relative to the largest entry.
    pub fn errors(&self, residual: &[f64], tangent: &[f64]) -> [f64; 2] {
        [
            relative(residual, &self.residual),
            relative(tangent, &self.tangent),
        ]
    }
}

fn relative(found: &[f64], truth: &[Octuple]) -> f64 {
    if found.len() != truth.len() || !found.iter().all(|value| value.is_finite()) {
        return f64::INFINITY;
    }
    let size = |value: Octuple| value.abs().to_f64();
    let largest = truth.iter().map(|&value| size(value)).fold(0.0, f64::max);
    let pairs = found.iter().zip(truth);
    let error = pairs.map(|(&found, &truth)| size(Octuple::from(found) - truth));
    error.fold(0.0, f64::max) / largest
}
