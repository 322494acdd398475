//! Bounds of ½ r·r over a box: of its value, its slopes and its curvature. [eq:box-bounds]

// min(1), min(2): an index that the compiler does not see through would be a panicking path

use super::descent::square;
use super::interval::{Interval, Scratch};
use super::pair::{Local, Sides};
use super::region::Box;
use crate::arithmetic::sqrt;

/// Lengths below this are zero.
const SMALLEST: f64 = 1e-200;
/// Rounding of sums over the nodes, relative to their size.
const NOISE: f64 = 1e-14;

/// Bounds over a box of one or two parameters, or over a piece of the diagonal of a triangle.
pub(super) struct Enclosure {
    /// Least r·r.
    pub(super) least: f64,
    /// f_i
    pub(super) slopes: [Interval; 2],
    /// F_11, F_12, F_22
    pub(super) curvature: [Interval; 3],
    /// All of the box is one point in space, to rounding.
    pub(super) is_point: bool,
}

impl Enclosure {
    pub(super) fn new(sides: &Sides<'_>, next: &Box, p: usize, scratch: &mut Scratch) -> Self {
        let ranges = [0_usize, 1].map(|i| {
            let i = i.min(1);
            Interval::between(next.lower[i], next.upper[i])
        });
        let middle = next.middle();
        let mut over = sides.over(&ranges, scratch);
        let mut centre = sides.at(&middle);
        let mut way = [0_usize, 1].map(|i| {
            let i = i.min(1);
            ranges[i].subtract(Interval::exactly(middle[i]))
        });
        let mut axes = p;
        if next.is_diagonal {
            over = along_diagonal(&over, Interval::subtract, |a| a.times(2.0));
            centre = along_diagonal(&centre, |a, b| a - b, |a| 2.0 * a);
            way[1] = Interval::ZERO;
            axes = 1;
        }
        let noise = NOISE * size(&centre, axes);
        refine(&mut over, &centre, &way, axes, noise);
        let f = |i: usize, j: usize| {
            dot(&over.b[i.min(1)], &over.b[j.min(1)])
                .add(dot(&over.r, &over.second[(i + j).min(2)]))
        };
        let curvature = [f(0, 0), f(0, 1), f(1, 1)];
        let slopes = slopes(&over, &centre, &way, &curvature, axes);
        let least = least(&over, &centre, &way, &curvature, axes);
        let width = over.r.iter().map(|r| r.upper - r.lower).fold(0.0, f64::max);
        Self {
            is_point: width <= 100.0 * noise + SMALLEST,
            least,
            slopes,
            curvature,
        }
    }

    /// F is positive definite in the parameters along which the box has a width.
    pub(super) fn is_convex(&self, wide: [bool; 2]) -> bool {
        let [first, mixed, last] = self.curvature;
        match wide {
            [true, true] => {
                let determinant = first.multiply(last).subtract(mixed.square());
                first.lower > 0.0 && determinant.lower > 0.0
            }
            [true, false] => first.lower > 0.0,
            [false, true] => last.lower > 0.0,
            [false, false] => true,
        }
    }
}

/// r, its slope b_1 − b_2 and its curvature r_,11 − 2 r_,12 + r_,22 along (1, −1).
fn along_diagonal<T: Copy>(
    local: &Local<T>,
    minus: impl Fn(T, T) -> T,
    twice: impl Fn(T) -> T,
) -> Local<T> {
    let [first, mixed, last] = local.second;
    let zero = local.r.map(|r| minus(r, r));
    let bend = |k: usize| {
        let k = k.min(2);
        minus(minus(first[k], twice(mixed[k])), minus(zero[k], last[k]))
    };
    let along = |k: usize| {
        let k = k.min(2);
        minus(local.b[0][k], local.b[1][k])
    };
    let bend = [bend(0), bend(1), bend(2)];
    Local {
        r: local.r,
        b: [[along(0), along(1), along(2)], zero],
        second: [bend, zero, zero],
    }
}

/// b_i and r by the mean value about the middle of the box, where that is narrower.
fn refine(
    over: &mut Local<Interval>,
    centre: &Local<f64>,
    way: &[Interval; 2],
    axes: usize,
    noise: f64,
) {
    let about = |value: f64| Interval::between(value - noise, value + noise);
    for i in (0..2).take(axes) {
        for k in 0..3 {
            let mut mean = about(centre.b[i][k]);
            for j in (0..2).take(axes) {
                mean = mean.add(over.second[i + j][k].multiply(way[j]));
            }
            over.b[i][k] = over.b[i][k].common(mean);
        }
    }
    for k in 0..3 {
        let mut mean = about(centre.r[k]);
        for i in (0..2).take(axes) {
            mean = mean.add(over.b[i][k].multiply(way[i]));
        }
        over.r[k] = over.r[k].common(mean);
    }
}

/// r·r_,i, and by the mean value f_i + F_ij (ζ^j − c^j).
fn slopes(
    over: &Local<Interval>,
    centre: &Local<f64>,
    way: &[Interval; 2],
    curvature: &[Interval; 3],
    axes: usize,
) -> [Interval; 2] {
    let mut slopes = [Interval::ZERO; 2];
    for (i, slope) in slopes.iter_mut().enumerate().take(axes) {
        let i = i.min(1);
        let mut mean = slope_at(centre, i, axes);
        for j in (0..2).take(axes) {
            mean = mean.add(curvature[i + j].multiply(way[j]));
        }
        *slope = dot(&over.r, &over.b[i]).common(mean);
    }
    slopes
}

/// f_i at the middle, with its rounding.
fn slope_at(centre: &Local<f64>, i: usize, axes: usize) -> Interval {
    let value = dot(
        &centre.r.map(Interval::exactly),
        &centre.b[i.min(1)].map(Interval::exactly),
    );
    let noise = NOISE * size(centre, axes) * size(centre, axes);
    value.add(Interval::between(-noise, noise))
}

/// r·r from the components of r, and by Taylor's formula of second order.
fn least(
    over: &Local<Interval>,
    centre: &Local<f64>,
    way: &[Interval; 2],
    curvature: &[Interval; 3],
    axes: usize,
) -> f64 {
    let near = over.r.iter().map(|r| r.least_magnitude());
    let apart = near.fold(0.0, |sum, r| sum + r * r);
    let noise = 2.0 * NOISE * size(centre, axes) * size(centre, axes);
    let mut taylor = Interval::exactly(square(&centre.r) - noise);
    for i in (0..2).take(axes) {
        taylor = taylor.add(slope_at(centre, i, axes).multiply(way[i]).times(2.0));
        taylor = taylor.add(curvature[2 * i].multiply(way[i].square()));
    }
    if axes == 2 {
        taylor = taylor.add(curvature[1].multiply(way[0]).multiply(way[1]).times(2.0));
    }
    apart.max(taylor.lower)
}

/// A length: |r| and the way of one unit of each parameter.
pub(super) fn size(local: &Local<f64>, axes: usize) -> f64 {
    let mut sum = sqrt(square(&local.r));
    for b in local.b.iter().take(axes) {
        sum += sqrt(square(b));
    }
    sum
}

fn dot(a: &[Interval; 3], b: &[Interval; 3]) -> Interval {
    let mut sum = a[0].multiply(b[0]);
    for k in 1..3 {
        sum = sum.add(a[k].multiply(b[k]));
    }
    sum
}
