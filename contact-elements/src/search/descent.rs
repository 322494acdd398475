//! The one minimum of ½ r·r in a box over which F is positive definite.

use super::pair::{Local, Sides};
use super::region::Box;
use crate::arithmetic::{abs, sqrt};

/// Most Newton steps in one box.
const MOST_STEPS: u32 = 60;
/// Steps below this part of the box's width or of ζ end the search.
const SMALL_STEP: f64 = 4.0 * f64::EPSILON;

/// Least definiteness of a unique foot.
pub(super) const REGULAR: f64 = 1e-13;

/// A foot and its squared distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub(super) zeta: [f64; 2],
    pub(super) square: f64,
}

/// |v|²
pub(super) fn square(v: &[f64; 3]) -> f64 {
    v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
}

pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// F_11, F_12, F_22. [eq:F]
fn curvature(local: &Local<f64>) -> [f64; 3] {
    let f =
        |i: usize, j: usize| dot(&local.b[i], &local.b[j]) + dot(&local.r, &local.second[i + j]);
    [f(0, 0), f(0, 1), f(1, 1)]
}

/// a/b, its size limited to 1e30. Every quotient of the search is formed so: the compiler may divide before the branch
/// that tests the divisor, and hosts run with traps for invalid and overflow.
fn quotient(a: f64, b: f64) -> f64 {
    let least = 1e-30 * abs(a) + 1e-200;
    a / abs(b).max(least).copysign(b)
}

/// Least eigenvalue of a⁻¹F; 1 without parameters, 0 where the tangents are parallel. [eq:admissible]
pub(super) fn definiteness(local: &Local<f64>, p: usize) -> f64 {
    let [f11, f12, f22] = curvature(local);
    let (a11, a12, a22) = (
        dot(&local.b[0], &local.b[0]),
        dot(&local.b[0], &local.b[1]),
        dot(&local.b[1], &local.b[1]),
    );
    match p {
        0 => 1.0,
        1 if a11 > 1e-60 => quotient(f11, a11),
        2 => {
            // det(F − λ a) = det a λ² − 2 h λ + det F
            let (a, f) = (a11 * a22 - a12 * a12, f11 * f22 - f12 * f12);
            if a <= 1e-26 * a11 * a22 || a < 1e-100 {
                return 0.0;
            }
            let h = 0.5 * (a11 * f22 + a22 * f11) - a12 * f12;
            let root = sqrt((h * h - a * f).max(0.0));
            if h > 0.0 {
                quotient(f, h + root)
            } else {
                quotient(h - root, a)
            }
        }
        _ => 0.0,
    }
}

/// The least distance within a box, and the steps that it took. `triangle`: within ξ + η ≤ 1 too.
pub(super) fn least_in_box(sides: &Sides<'_>, within: &Box, triangle: bool) -> (Foot, u32) {
    let (zeta, mut steps) = if within.is_diagonal {
        ([1.0; 2], 0)
    } else {
        newton(sides, within.middle(), within)
    };
    let mut foot = zeta;
    if triangle && zeta[0] + zeta[1] > 1.0 {
        let (along, more) = on_diagonal(sides, within);
        (foot, steps) = (along, steps + more);
    }
    let square = square(&sides.at(&foot).r);
    (Foot { zeta: foot, square }, steps)
}

/// Where Newton's method leads from a point of a box, and the steps that it took.
pub(super) fn descended(sides: &Sides<'_>, start: [f64; 2], within: &Box) -> (Foot, u32) {
    let (zeta, steps) = newton(sides, start, within);
    let square = square(&sides.at(&zeta).r);
    (Foot { zeta, square }, steps)
}

/// Projected Newton steps: bounds that hold are kept, others are free.
fn newton(sides: &Sides<'_>, start: [f64; 2], within: &Box) -> ([f64; 2], u32) {
    let mut zeta = start;
    let mut local = sides.at(&zeta);
    for step in 1..=MOST_STEPS {
        let (slopes, are_free) = free(&local, &zeta, within);
        let change = direction(&local, &slopes, are_free);
        let is_clipped = (0..2).any(|i| {
            let i = i.min(1);
            let next = zeta[i] + change[i];
            next < within.lower[i] || next > within.upper[i]
        });
        if advance(sides, &mut zeta, &mut local, &change, within) {
            continue;
        }
        // a side takes its part of Newton's step away, and what is left of it may lead upwards
        let (slopes, are_free) = free(&local, &zeta, within);
        let change = alone(&local, &slopes, are_free);
        if !is_clipped || !advance(sides, &mut zeta, &mut local, &change, within) {
            return (zeta, step);
        }
    }
    (zeta, MOST_STEPS)
}

/// f_i, and which parameters no bound holds.
fn free(local: &Local<f64>, zeta: &[f64; 2], within: &Box) -> ([f64; 2], [bool; 2]) {
    let slopes = [0_usize, 1].map(|i| {
        let i = i.min(1);
        dot(&local.r, &local.b[i])
    });
    let free = [0_usize, 1].map(|i| {
        let i = i.min(1);
        let below = zeta[i] <= within.lower[i] && slopes[i] >= 0.0;
        let above = zeta[i] >= within.upper[i] && slopes[i] <= 0.0;
        !(below || above)
    });
    (slopes, free)
}

/// −f_i/F_ii in each of the free parameters: r·r falls along any part of it.
fn alone(local: &Local<f64>, slopes: &[f64; 2], free: [bool; 2]) -> [f64; 2] {
    let [f11, _, f22] = curvature(local);
    let alone = |slope: f64, curvature: f64, metric: f64| {
        let divisor = if curvature > 1e-12 * metric {
            curvature
        } else {
            metric
        };
        if divisor > 1e-100 {
            quotient(-slope, divisor)
        } else {
            0.0
        }
    };
    let metric = [0_usize, 1].map(|i| {
        let i = i.min(1);
        dot(&local.b[i], &local.b[i])
    });
    let each = [
        alone(slopes[0], f11, metric[0]),
        alone(slopes[1], f22, metric[1]),
    ];
    [
        if free[0] { each[0] } else { 0.0 },
        if free[1] { each[1] } else { 0.0 },
    ]
}

/// −F⁻¹ f in the free parameters.
fn direction(local: &Local<f64>, slopes: &[f64; 2], free: [bool; 2]) -> [f64; 2] {
    let [f11, f12, f22] = curvature(local);
    let determinant = f11 * f22 - f12 * f12;
    let is_regular = determinant > 1e-15 * f11 * f22 && f11 > 0.0 && determinant > 1e-200;
    match free {
        [true, true] if is_regular => [
            quotient(f12 * slopes[1] - f22 * slopes[0], determinant),
            quotient(f12 * slopes[0] - f11 * slopes[1], determinant),
        ],
        _ => alone(local, slopes, free),
    }
}

/// A step within the box, halved until r·r falls; false if no step is left to take.
fn advance(
    sides: &Sides<'_>,
    zeta: &mut [f64; 2],
    local: &mut Local<f64>,
    change: &[f64; 2],
    within: &Box,
) -> bool {
    let before = square(&local.r);
    let mut factor = 1.0;
    for _ in 0..30 {
        let trial: [f64; 2] = core::array::from_fn(|i| {
            (zeta[i] + factor * change[i])
                .max(within.lower[i])
                .min(within.upper[i])
        });
        let is_small = |i: usize| {
            let scale = (within.upper[i] - within.lower[i]).max(abs(zeta[i]));
            abs(trial[i] - zeta[i]) <= SMALL_STEP * scale
        };
        let last = is_small(0) && is_small(1);
        let candidate = sides.at(&trial);
        let after = square(&candidate.r);
        // near the minimum r·r is flat to rounding: steps of Newton's method still improve ζ
        if after < before || (factor == 1.0 && after <= before * (1.0 + 4.0 * f64::EPSILON)) {
            let moved = !last && after < before;
            (*zeta, *local) = (trial, candidate);
            return moved;
        }
        if last {
            return false;
        }
        factor *= 0.5;
    }
    false
}

/// The least distance on ξ + η = 1 within the box: Newton's method kept between two ends by bisection.
fn on_diagonal(sides: &Sides<'_>, within: &Box) -> ([f64; 2], u32) {
    let (mut low, mut high) = (
        within.lower[0].max(1.0 - within.upper[1]),
        within.upper[0].min(1.0 - within.lower[1]),
    );
    let mut t = 0.5 * (low + high);
    for step in 1..=MOST_STEPS {
        let local = sides.at(&[t, 1.0 - t]);
        let along = core::array::from_fn(|k| local.b[0][k] - local.b[1][k]);
        let bend = core::array::from_fn(|k| {
            local.second[0][k] - 2.0 * local.second[1][k] + local.second[2][k]
        });
        let slope = dot(&local.r, &along);
        let curvature = square(&along) + dot(&local.r, &bend);
        if slope > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let wanted = if curvature > 1e-100 {
            t - quotient(slope, curvature)
        } else {
            low
        };
        let next = if wanted > low && wanted < high {
            wanted
        } else if wanted >= high {
            if slope < 0.0 && high - t > 0.0 {
                0.5 * (t + high)
            } else {
                high
            }
        } else {
            0.5 * (low + t)
        };
        if abs(next - t) <= SMALL_STEP || high - low <= SMALL_STEP {
            return ([next, 1.0 - next], step);
        }
        t = next;
    }
    ([t, 1.0 - t], MOST_STEPS)
}
