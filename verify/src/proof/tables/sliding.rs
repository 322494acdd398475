//! Derivatives of tangential laws in their tables against duals of the declared bound and of the force.

use contact_elements::table::{Table, TangentialLawPrograms};
use num_dual::Dual64;

use super::inputs::{TRIES, derivative, inputs};
use crate::interpret::interpret;
use crate::proof::Finding;
use crate::proof::interpreted::ellipse;
use crate::tolerance::{DERIVATIVES, relative_error};

/// Bounds are made this much smaller than the trial force of the random inputs.
const BEYOND: f64 = 0.02;

/// Slopes of the bound; beyond it the slopes of the force by slip and pressure.
pub(super) fn derivatives(finding: &mut Finding, law: &TangentialLawPrograms, seed: u64) {
    let axes = if law.orthotropic { 2 } else { 1 };
    let Some(sliding) = &law.sliding else {
        return;
    };
    for index in 0..TRIES {
        let own = inputs(&law.friction, seed, index);
        let values = interpret(&law.friction, &own, None);
        for (input, name) in [(0, "∂B/∂p"), (1, "∂B/∂path")] {
            let slopes = derivative(&law.friction, &own, input);
            let (found, exact) = (&values[(2 + input) * axes..], &slopes[axes..2 * axes]);
            let error = relative_error(&found[..axes], exact);
            finding.compare(&format!("{}: {name}", law.name), error, DERIVATIVES);
        }
        let mut own = inputs(sliding, seed, index);
        for bound in &mut own[2 + axes..2 + 2 * axes] {
            *bound *= BEYOND;
        }
        if law.orthotropic {
            own[2 + 4 * axes] = ellipse([own[0], own[1]], &own[2..]);
        }
        let values = interpret(sliding, &own, None);
        let length = own[0].hypot(own[1]);
        let slope = |which: usize, q: usize| own[2 + (2 + which) * axes + q];
        for r in 0..3 {
            // along s_r the path grows too; r = 2: along the pressure
            let change = |q: usize| match r {
                2 => slope(0, q),
                r => slope(1, q) * own[r] / length,
            };
            let changes: Vec<f64> = (0..own.len())
                .map(|i| match i {
                    i if i == r && r < 2 => 1.0,
                    i if (2 + axes..2 + 2 * axes).contains(&i) => change(i - 2 - axes),
                    _ => 0.0,
                })
                .collect();
            let exact = along(sliding, &own, &changes, law.orthotropic);
            let found = match r {
                2 => [values[6], values[7]],
                r => [values[2 + r], values[4 + r]],
            };
            let error = relative_error(&found, &exact);
            finding.compare(&format!("{}: ∂t, column {r}", law.name), error, DERIVATIVES);
        }
    }
}

/// Change of the force along changes of slip and bound; γ keeps it on the ellipse.
fn along(program: &Table, own: &[f64], changes: &[f64], ellipse: bool) -> [f64; 2] {
    let change = |changes: &[f64]| -> [Dual64; 2] {
        let numbers = own.iter().zip(changes);
        let duals: Vec<Dual64> = numbers.map(|(&v, &d)| Dual64::new(v, d)).collect();
        let values = interpret(program, &duals, None);
        [values[0], values[1]]
    };
    let fixed = change(changes);
    if !ellipse {
        return fixed.map(|t| t.eps);
    }
    let last = own.len() - 1;
    let mut of_gamma = vec![0.0; own.len()];
    of_gamma[last] = 1.0;
    let turned = change(&of_gamma);
    // Σ (t_q/B_q)² = 1
    let leaves = |t: &[Dual64; 2], changes: &[f64]| -> f64 {
        let square = |q: usize| {
            let z = t[q] / Dual64::new(own[4 + q], changes[4 + q]);
            z * z
        };
        (square(0) + square(1)).eps
    };
    let gamma = -leaves(&fixed, changes) / leaves(&turned, &of_gamma);
    [0, 1].map(|q| fixed[q].eps + gamma * turned[q].eps)
}
