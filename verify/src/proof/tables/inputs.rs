//! Random inputs of a program, and derivatives of its outputs by dual numbers.

use contact_elements::table::Table;
use num_dual::Dual64;

use crate::configurations::Stream;
use crate::interpret::interpret;

/// Inputs tried per program.
pub(super) const TRIES: u64 = 50;

/// Random inputs in (0.2, 0.8): inside every parameter domain, away from every singularity.
pub(super) fn inputs(program: &Table, seed: u64, index: u64) -> Vec<f64> {
    let mut stream = Stream::new(seed, index, 77);
    program
        .inputs
        .iter()
        .map(|_| stream.uniform(0.2, 0.8))
        .collect()
}

/// Values over duals seeded in input `k`, and the derivative part of every output.
pub(super) fn derivative(program: &Table, inputs: &[f64], k: usize) -> Vec<f64> {
    let duals: Vec<Dual64> = inputs
        .iter()
        .enumerate()
        .map(|(i, &value)| Dual64::new(value, if i == k { 1.0 } else { 0.0 }))
        .collect();
    interpret(program, &duals, None)
        .iter()
        .map(|dual| dual.eps)
        .collect()
}
