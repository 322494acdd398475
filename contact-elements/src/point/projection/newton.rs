//! Closest point projection: f_i = r·r_,i = 0 by Newton's method. [eq:projection]
//!
//! F_ij = a_ij + r·r_,ij; det F is formed from |b_1×b_2|² so that it keeps its digits where tangents are
//! nearly parallel. Where Newton finds no stationary point, a search within the domain decides (see
//! `constrained`). Affine pairs need one linear solve; rigid geometries with a declared closed projection
//! and distance functions need no step. Every outcome has a status; a failure says so.

use crate::arithmetic::abs;
use crate::element::traits::{Element, Search};
use crate::lanes::Real;
use crate::point::kinematics::slave_point;
use crate::point::projection::constrained::constrained;
use crate::point::projection::extent::{limited, measure_endless, nearest_integer};
use crate::point::projection::foot::{Projected, largest};
use crate::point::projection::step::{Step, step, tangents};
use crate::point::values::{Rows, Status, Vectors};

/// Most Newton steps before the projection is given up.
pub(crate) const MOST_STEPS: u32 = 40;

/// The closed projection, on the turn nearest to the start.
#[inline(always)]
fn closed<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: &[f64; P],
    parameters: &[f64],
    rows: &Rows<'_, P>,
) -> [f64; P] {
    let mut zeta = E::closed_projection(&slave_point(x, rows.s, 0), parameters);
    for (i, zeta) in zeta.iter_mut().enumerate() {
        let period = E::PERIODS[i];
        if period > 0.0 {
            *zeta += period * nearest_integer((start[i] - *zeta) / period);
        }
    }
    zeta
}

/// Projects the slave's point, whose row already stands in `rows`.
#[inline(always)]
pub fn project<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: [f64; P],
    given: bool,
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    let mut zeta = start;
    if matches!(E::SEARCH, Search::Closed) && !given {
        zeta = closed::<E, D, P, H>(x, &start, parameters, rows);
    }
    let mut iterations = 0;
    let (mut is_free, mut is_checked) = (true, false);
    let mut known = None;
    let mut extent = core::array::from_fn(E::extent);
    if P > 0 && !given && !matches!(E::SEARCH, Search::Closed) {
        let newton =
            newton::<E, D, P, H>(x, parameters, rows, &mut zeta, &mut extent, &mut iterations);
        match newton {
            Ok(found) => {
                is_checked = found.is_checked;
                known = found.vectors;
            }
            Err(Status::Degenerate) => return Err(Status::Degenerate),
            // beyond an edge the free stationary point need not exist
            Err(_) => is_free = false,
        }
    }
    // fills the rows; its sums are left out where the vectors are known
    let summed = E::kinematics(x, &zeta, parameters, rows);
    let vectors = known.unwrap_or(summed);
    if P > 0 && is_free && is_checked {
        // the last step may lead to where a tangent vanishes; those of an affine pair are the same everywhere
        if !matches!(E::SEARCH, Search::Affine) {
            tangents(&vectors.b, E::PARALLEL)?;
        }
    } else if P > 0 && is_free {
        match step::<E, D, P, H>(&vectors) {
            Ok(_) => {}
            Err(Status::NotUnique) if iterations > 0 => is_free = false,
            Err(status) => return Err(status),
        }
    }
    if !is_free {
        let found = apart::<E, D, P, H>(x, start, &extent, parameters, rows)?;
        // once more here: results of a call stay in memory, and every other path would then go through memory
        return Ok(Projected {
            zeta: found.zeta,
            vectors: E::kinematics(x, &found.zeta, parameters, rows),
            iterations: iterations + found.iterations,
            feature: found.feature,
        });
    }
    Ok(Projected {
        zeta,
        vectors,
        iterations,
        feature: E::feature(&zeta),
    })
}

/// The search within the domain, on copies: the arrays of the kernel itself are handed to no call, so that
/// they need not be memory.
#[inline(always)]
fn apart<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: [f64; P],
    extent: &[f64; P],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    const ROOM: usize = 32;
    let n = x.len();
    if n > ROOM {
        return constrained::<E, D, P, H>(x, start, extent, parameters, rows);
    }
    let mut nodes = [[0.0; D]; ROOM];
    let mut s = [0.0; ROOM];
    let mut ds = [[0.0; ROOM]; P];
    copy(x, &mut nodes);
    copy(rows.s, &mut s);
    let mut copies = Rows {
        s: &mut s[..n],
        // not row[..n]: a panicking path that the compiler does not see through
        ds: ds
            .each_mut()
            .map(|row| row.get_mut(..n).unwrap_or_default()),
    };
    constrained::<E, D, P, H>(&nodes[..n], start, extent, parameters, &mut copies)
}

/// Copies the entries to the first places, at once: one by one, with a running pointer, they could not stay in
/// registers elsewhere.
#[inline(always)]
fn copy<T: Copy>(from: &[T], to: &mut [T]) {
    if let Some(to) = to.get_mut(..from.len()) {
        to.copy_from_slice(from);
    }
}

/// Where Newton's method ends.
struct Found<const D: usize, const P: usize, const H: usize> {
    /// F was regular so close by that it is regular here.
    is_checked: bool,
    /// Kinematics here, where they take no sums over the nodes.
    vectors: Option<Vectors<D, P, H>>,
}

// long: one loop, whose conditions to end share all that a step computes
#[inline(always)]
fn newton<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
    zeta: &mut [f64; P],
    extent: &mut [f64; P],
    iterations: &mut u32,
) -> Result<Found<D, P, H>, Status> {
    let multilinear = is_multilinear::<E, D, P, H>();
    let centre = E::centre();
    let mut at_centre = Vectors::default();
    if multilinear {
        at_centre = E::kinematics(x, &centre, parameters, rows);
    }
    let is_affine = matches!(E::SEARCH, Search::Affine);
    let most = if is_affine { 3 } else { MOST_STEPS };
    let mut previous = f64::MAX;
    for iteration in 1..=most {
        *iterations = iteration;
        let vectors = if !multilinear {
            E::kinematics(x, zeta, parameters, rows)
        } else if *zeta == centre {
            at_centre
        } else {
            displaced::<E, D, P, H, f64>(&at_centre, &centre, zeta)
        };
        if iteration == 1 {
            measure_endless(&vectors, x, extent);
        }
        let Step {
            mut change,
            slopes,
            metric,
            is_sharp,
            is_delicate,
        } = step::<E, D, P, H>(&vectors)?;
        let mut size: f64 = 0.0;
        for i in 0..P {
            if !is_affine {
                change[i] = limited(change[i], extent[i]);
            }
            zeta[i] += change[i];
            let relative = abs(change[i]) / extent[i];
            size = if relative > size { relative } else { size };
        }
        // the steps no longer shrink because f is rounding noise
        let may_stagnate = !is_affine && iteration > 2 && size > 0.25 * previous;
        let stagnates = may_stagnate && are_rounding(&slopes, &metric, x);
        let is_finished = finished(E::SEARCH, iteration, size, previous, is_sharp);
        // wherever the search ends, no history could hold it; a first solve of an affine pair whose tangents
        // are nearly parallel may still come back
        let is_lost = abs(zeta[0]) > 1e6 * extent[0] || abs(zeta[P - 1]) > 1e6 * extent[P - 1];
        if is_lost && (is_finished || !is_affine) {
            break;
        }
        if stagnates || is_finished {
            return Ok(Found {
                is_checked: is_finished && !is_delicate,
                vectors: multilinear
                    .then(|| displaced::<E, D, P, H, f64>(&at_centre, &centre, zeta)),
            });
        }
        previous = size;
    }
    Err(Status::NotConverged)
}

/// r_,11 and r_,22 vanish identically, so that r is linear in each parameter.
#[inline(always)]
pub(crate) fn is_multilinear<
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
>() -> bool {
    !E::CURVED[0] && (P == 1 || !E::CURVED[2])
}

/// r, b_i and r_,12 at ζ from those at another point, where r is linear in each parameter: r_,12 is constant,
/// and Newton's steps need neither shape functions nor nodes. [eq:bilinear]
#[inline(always)]
pub(crate) fn displaced<
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
    T: Real,
>(
    from: &Vectors<D, P, H, T>,
    at: &[T; P],
    zeta: &[T; P],
) -> Vectors<D, P, H, T> {
    let mut to = *from;
    let (first, last) = (zeta[0] - at[0], zeta[P - 1] - at[P - 1]);
    for k in 0..D {
        if P == 2 {
            if E::CURVED[1] {
                let mixed = from.second[1][k];
                to.b[0][k] = from.b[0][k] + last * mixed;
                to.b[1][k] = from.b[1][k] + first * mixed;
            }
            to.r[k] = to.r[k] + last * from.b[1][k];
        }
        // r + b_1 d_1 + b_2 d_2 + r_,12 d_1 d_2
        to.r[k] = to.r[k] + first * to.b[0][k];
    }
    to
}

/// After a step of relative size `size`: is the next one below rounding? Quadratic convergence makes it
/// C·size² with C = size/previous², but a single ratio can be small by luck, so C counts as at least 1; where the
/// tangents are nearly parallel it is not quadratic, since the solve loses digits, and steps go on down to
/// rounding. An affine pair needs a second step only to remove the rounding of a far one, and two more where
/// the tangents are nearly parallel: a solve loses ε/sin²θ, each further one as much of what is left.
#[inline(always)]
fn finished(search: Search, iteration: u32, size: f64, previous: f64, is_sharp: bool) -> bool {
    if matches!(search, Search::Affine) {
        return iteration == 3 || !is_sharp && (iteration == 2 || size < 4.0);
    }
    if size <= 1e-15 {
        return true;
    }
    let square = size * size;
    iteration > 1
        && !is_sharp
        && size < 0.1 * previous
        && square <= 1e-15
        && square * size <= 1e-15 * (previous * previous)
}

/// |f_i| ≤ 64 ε |b_i| times the largest coordinate: no larger than the rounding of its terms, with room for
/// their sum.
#[cold]
#[inline(never)]
fn are_rounding<const D: usize, const P: usize>(
    slopes: &[f64; P],
    metric: &[f64; P],
    x: &[[f64; D]],
) -> bool {
    let rounding = 64.0 * f64::EPSILON * largest(x);
    slopes
        .iter()
        .zip(metric)
        .all(|(f, metric)| f * f <= rounding * rounding * metric)
}
