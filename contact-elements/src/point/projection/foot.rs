//! Where a projection ends.

use crate::arithmetic::abs;
use crate::point::values::Vectors;

/// A converged projection.
#[derive(Clone, Copy, Debug)]
pub struct Projected<const D: usize, const P: usize, const H: usize> {
    /// Projected parameters.
    pub zeta: [f64; P],
    /// Kinematics there.
    pub vectors: Vectors<D, P, H>,
    /// Newton steps taken.
    pub iterations: u32,
    /// 0 inside the domain, else the feature beyond which the projection lies.
    pub feature: u8,
}

/// Largest coordinate relative to the local origin.
#[inline(always)]
pub(crate) fn largest<const D: usize>(x: &[[f64; D]]) -> f64 {
    let mut largest: f64 = 0.0;
    for node in x {
        for k in 0..D {
            let size = abs(node[k]);
            largest = if size > largest { size } else { largest };
        }
    }
    largest
}
