//! Steps of the projection relative to the extent of each parameter. [eq:extent]

use crate::arithmetic::{abs, sqrt};
use crate::point::projection::foot::largest;
use crate::point::projection::step::SMALLEST;
use crate::point::values::{Vectors, dot};

/// The step, at most one extent long. It does not use `clamp`, which panics where a bound is NaN.
#[inline(always)]
pub(crate) fn limited(step: f64, extent: f64) -> f64 {
    step.max(-extent).min(extent)
}

/// The integer nearest to x; x itself where its digits hold no fraction.
#[inline(always)]
pub(crate) fn nearest_integer(x: f64) -> f64 {
    const SHIFT: f64 = 6_755_399_441_055_744.0; // 1.5·2⁵²
    if abs(x) < 1e15 {
        (x + SHIFT) - SHIFT
    } else {
        x
    }
}

/// Replaces infinite extents by what the start tells, whatever unit the parameter has: the step over which
/// b_i turns by about its own length (one radian of a circle), at most the reach of the coordinates.
/// [eq:extent]
#[inline(always)]
pub(crate) fn measure_endless<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
    x: &[[f64; D]],
    extent: &mut [f64; P],
) {
    for i in 0..P {
        if extent[i] > f64::MAX {
            let second = &vectors.second[2 * i];
            let length = sqrt(dot(&vectors.b[i], &vectors.b[i]));
            let turn = sqrt(dot(second, second));
            let reach = largest(x) + sqrt(dot(&vectors.r, &vectors.r));
            extent[i] = if length < SMALLEST || reach < SMALLEST {
                1.0
            } else if turn * reach > length * length {
                length / turn
            } else {
                reach / length
            };
        }
    }
}
