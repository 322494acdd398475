//! Closest point projection: f_i = r·r_,i = 0 by Newton's method. [eq:projection]
//!
//! F_ij = a_ij + r·r_,ij; det F is formed from |b_1×b_2|² so that it keeps its digits where tangents are
//! nearly parallel. Affine pairs need one linear solve; rigid geometries with a declared closed projection
//! and distance functions need none. Every outcome has a status; a failure says so.

use super::element::{Element, Search};
use super::values::{Rows, Status, Vectors, dot};
use crate::arithmetic::abs;

/// A converged projection.
#[derive(Clone, Copy, Debug)]
pub struct Projected<const D: usize, const P: usize, const H: usize> {
    /// Projected parameters.
    pub zeta: [f64; P],
    /// Kinematics there.
    pub vectors: Vectors<D, P, H>,
    /// Newton steps taken.
    pub iterations: u32,
}

/// Most Newton steps before the projection is given up.
const MOST_STEPS: u32 = 40;
/// Tangents count as parallel, and F as singular, below this sine or relative determinant.
const SINGULAR: f64 = 1e-13;
/// Lengths below this are zero [length].
const SMALLEST: f64 = 1e-30;

/// Projects the slave's point, whose row already stands in `rows`.
///
/// `scale`: largest coordinate relative to the local origin, for the rounding error of f.
#[inline(always)]
pub fn project<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: [f64; P],
    given: bool,
    parameters: &[f64],
    scale: f64,
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    let mut zeta = start;
    if matches!(E::SEARCH, Search::Closed) && !given {
        zeta = E::closed_projection(&super::slave_point(x, rows.s, 0), parameters);
    }
    let mut vectors = E::kinematics(x, &zeta, parameters, rows);
    if P == 0 {
        return Ok(Projected {
            zeta,
            vectors,
            iterations: 0,
        });
    }
    let iterations = if given || matches!(E::SEARCH, Search::Closed) {
        step::<E, D, P, H>(&vectors)?;
        0
    } else {
        newton::<E, D, P, H>(x, parameters, scale, rows, &mut zeta, &mut vectors)?
    };
    Ok(Projected {
        zeta,
        vectors,
        iterations,
    })
}

#[inline(always)]
fn newton<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    parameters: &[f64],
    scale: f64,
    rows: &mut Rows<'_, P>,
    zeta: &mut [f64; P],
    vectors: &mut Vectors<D, P, H>,
) -> Result<u32, Status> {
    let mut previous = f64::MAX;
    for iteration in 1..=MOST_STEPS {
        let mut change = step::<E, D, P, H>(vectors)?;
        let converged = at_rounding_level(vectors, scale);
        let mut size: f64 = 0.0;
        for i in 0..P {
            let extent = E::extent(i);
            change[i] = change[i].clamp(-extent, extent);
            zeta[i] += change[i];
            size = size.max(abs(change[i]) / extent);
        }
        *vectors = E::kinematics(x, zeta, parameters, rows);
        if converged || finished(E::SEARCH, iteration, size, previous) {
            step::<E, D, P, H>(vectors)?;
            return Ok(iteration);
        }
        if abs(zeta[0]) > 1e6 * E::extent(0) || abs(zeta[P - 1]) > 1e6 * E::extent(P - 1) {
            break;
        }
        previous = size;
    }
    Err(Status::NotConverged)
}

/// After a step of relative size `size`: is the next one below rounding? Quadratic convergence predicts
/// size·(size/previous)²·… from the last two steps; an affine pair needs a second step only to remove the
/// rounding of a far start.
#[inline(always)]
fn finished(search: Search, iteration: u32, size: f64, previous: f64) -> bool {
    if matches!(search, Search::Affine) {
        return iteration == 2 || size < 4.0;
    }
    if size <= 1e-15 {
        return true;
    }
    let ratio = size / previous;
    iteration > 1 && ratio < 0.1 && size * ratio * ratio <= 1e-17
}

/// |f_i| is no larger than the rounding of its terms.
#[inline(always)]
fn at_rounding_level<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
    scale: f64,
) -> bool {
    let mut small = true;
    for b in &vectors.b {
        let mut length: f64 = 0.0;
        for k in 0..D {
            length = length.max(abs(b[k]));
        }
        small &= abs(dot(&vectors.r, b)) <= f64::EPSILON * length * scale;
    }
    small
}

/// −F⁻¹ f, or why F cannot be inverted: zero area or length, parallel tangents, focal surface, a foot
/// that is no minimum of the distance.
#[inline(always)]
fn step<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> Result<[f64; P], Status> {
    let Vectors { r, b, second } = vectors;
    let mut change = [0.0; P];
    if P == 1 {
        let a = dot(&b[0], &b[0]);
        if a < SMALLEST * SMALLEST {
            return Err(Status::Degenerate);
        }
        let f = a + dot(r, &second[0]);
        if f <= SINGULAR * a {
            return Err(Status::NotUnique);
        }
        change[0] = -dot(r, &b[0]) / f;
    } else {
        let (a11, a12, a22) = (dot(&b[0], &b[0]), dot(&b[0], &b[1]), dot(&b[1], &b[1]));
        let determinant = area_squared(&b[0], &b[1]);
        if a11.min(a22) < SMALLEST * SMALLEST {
            return Err(Status::Degenerate);
        }
        if determinant <= SINGULAR * SINGULAR * a11 * a22 {
            return Err(E::PARALLEL);
        }
        let (h11, h12, h22) = (dot(r, &second[0]), dot(r, &second[1]), dot(r, &second[2]));
        let f = determinant + (a11 * h22 + a22 * h11 - 2.0 * a12 * h12) + (h11 * h22 - h12 * h12);
        if f <= SINGULAR * determinant || a11 + h11 <= 0.0 {
            return Err(Status::NotUnique);
        }
        let (f1, f2) = (dot(r, &b[0]), dot(r, &b[1]));
        let inverse = 1.0 / f;
        change[0] = -((a22 + h22) * f1 - (a12 + h12) * f2) * inverse;
        change[1] = -((a11 + h11) * f2 - (a12 + h12) * f1) * inverse;
    }
    Ok(change)
}

/// |b_1×b_2|²
#[inline(always)]
fn area_squared<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    let mut sum = 0.0;
    for k in 0..D {
        for l in k + 1..D {
            let minor = a[k] * b[l] - a[l] * b[k];
            sum += minor * minor;
        }
    }
    sum
}
