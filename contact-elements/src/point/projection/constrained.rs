//! Minimum of r·r/2 within the parameter domain: the answer where Newton's method finds no free stationary
//! point. [eq:constrained-projection]
//!
//! Projected Newton steps on the parameters that no bound holds, the metric alone where F is indefinite, step
//! halving until r·r falls. A minimum held by a bound is the outcome "outside" with that feature.

use crate::arithmetic::abs;
use crate::element::traits::Element;
use crate::point::domain::Domain;
use crate::point::projection::extent::limited;
use crate::point::projection::foot::Projected;
use crate::point::projection::step::{have_normal, step};
use crate::point::values::{Rows, Status, Vectors, dot};

/// Most steps before the search is given up.
const MOST_STEPS: u32 = 80;
/// Most halvings of one step.
const MOST_HALVINGS: u32 = 40;
/// A parameter this close to a bound, relative to the extent, is on it.
const ON_BOUND: f64 = 1e-13;
/// Steps below this, relative to the extent, end the search.
const SMALL_STEP: f64 = 1e-9;
/// Free steps that lead farther than this from the end of the search, relative to the extent, lead to no minimum.
const POLISHED: f64 = 0.05;

/// The kinematics, as a call: the search is rare, so its size counts more than its time.
#[inline(never)]
fn kinematics<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    zeta: &[f64; P],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> Vectors<D, P, H> {
    E::kinematics(x, zeta, parameters, rows)
}

/// Searches the domain from `start`.
#[cold]
#[inline(never)]
pub(crate) fn constrained<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: [f64; P],
    extent: &[f64; P],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    let mut zeta = inside::<E, D, P, H>(start);
    let found = descend::<E, D, P, H>(x, &mut zeta, extent, parameters, rows)?;
    if E::SIGNED {
        have_normal(&found.vectors.b, E::PARALLEL)?;
    }
    Ok(found)
}

/// Where the search from `start` ends, whatever it finds there.
pub(crate) fn nearest<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    start: [f64; P],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> ([f64; P], Vectors<D, P, H>) {
    let extent = core::array::from_fn(E::extent);
    let mut zeta = inside::<E, D, P, H>(start);
    // only the place matters, not the status
    let _ = descend::<E, D, P, H>(x, &mut zeta, &extent, parameters, rows);
    let vectors = kinematics::<E, D, P, H>(x, &zeta, parameters, rows);
    (zeta, vectors)
}

/// The search; `zeta` is where it stands.
fn descend<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    zeta: &mut [f64; P],
    extent: &[f64; P],
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    let mut vectors = kinematics::<E, D, P, H>(x, zeta, parameters, rows);
    for iteration in 1..=MOST_STEPS {
        let held = held::<E, D, P, H>(zeta, &vectors, extent);
        let change = descent::<E, D, P, H>(&vectors, &held);
        let taken = search::<E, D, P, H>(x, zeta, &mut vectors, (change, extent), parameters, rows);
        if taken > SMALL_STEP {
            continue;
        }
        let before = held;
        let held = self::held::<E, D, P, H>(zeta, &vectors, extent);
        // a bound met on the way took its part of the step away: what is left has not been followed yet
        if held.side != before.side || held.diagonal != before.diagonal {
            continue;
        }
        if held.count > 0 {
            let feature = beyond::<E, D, P, H>(zeta, &held, extent);
            return Ok(Projected {
                zeta: *zeta,
                vectors,
                iterations: iteration,
                feature,
            });
        }
        return polish::<E, D, P, H>(x, (*zeta, extent), parameters, iteration, rows);
    }
    Err(Status::NotConverged)
}

/// Free Newton steps at an interior minimum, down to rounding.
fn polish<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    (mut zeta, extent): ([f64; P], &[f64; P]),
    parameters: &[f64],
    iterations: u32,
    rows: &mut Rows<'_, P>,
) -> Result<Projected<D, P, H>, Status> {
    let start = zeta;
    let mut vectors = kinematics::<E, D, P, H>(x, &zeta, parameters, rows);
    for _ in 0..3 {
        let change = step::<E, D, P, H>(&vectors)?.change;
        for i in 0..P {
            zeta[i] += limited(change[i], extent[i]);
        }
        vectors = kinematics::<E, D, P, H>(x, &zeta, parameters, rows);
    }
    step::<E, D, P, H>(&vectors)?;
    for i in 0..P {
        // the search stood still where there is no minimum
        if abs(zeta[i] - start[i]) > POLISHED * extent[i] {
            return Err(Status::NotConverged);
        }
    }
    Ok(Projected {
        zeta,
        vectors,
        iterations: iterations + 3,
        feature: E::feature(&zeta),
    })
}

/// Which directions no bound blocks.
struct Held<const P: usize> {
    /// Bounds that hold the descent.
    count: usize,
    /// −1, 0, 1: the bound of parameter i that holds it.
    side: [f64; P],
    /// True where the bound ξ + η = 1 of a triangle holds.
    diagonal: bool,
}

/// Bounds of parameter i; infinite where a bound is missing.
fn bounds<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    i: usize,
) -> (f64, f64) {
    let own = if E::TWO_CURVES {
        E::DOMAINS.get(i)
    } else {
        E::DOMAINS.first()
    };
    match own {
        Some(Domain::Interval(lower, upper)) => (*lower, *upper),
        Some(Domain::Rectangle(lower, upper)) => match (lower.get(i), upper.get(i)) {
            (Some(&lower), Some(&upper)) => (lower, upper),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        },
        Some(Domain::Triangle) => (0.0, 1.0),
        Some(Domain::Unbounded) | None => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

fn is_triangle<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>() -> bool {
    P == 2 && !E::TWO_CURVES && matches!(E::DOMAINS[0], Domain::Triangle)
}

/// The nearest parameters of the domain.
fn inside<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    mut zeta: [f64; P],
) -> [f64; P] {
    for i in 0..P {
        let (lower, upper) = bounds::<E, D, P, H>(i);
        zeta[i] = zeta[i].max(lower).min(upper);
    }
    if is_triangle::<E, D, P, H>() {
        let excess = zeta[0] + zeta[P - 1] - 1.0;
        if excess > 0.0 {
            let first = (zeta[0] - 0.5 * excess).clamp(0.0, 1.0);
            zeta[0] = first;
            zeta[P - 1] = 1.0 - first;
        }
    }
    zeta
}

/// Bounds against which the descent −f pushes.
fn held<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    zeta: &[f64; P],
    vectors: &Vectors<D, P, H>,
    extent: &[f64; P],
) -> Held<P> {
    let mut held = Held {
        count: 0,
        side: [0.0; P],
        diagonal: false,
    };
    let mut f = [0.0; P];
    for i in 0..P {
        f[i] = dot(&vectors.r, &vectors.b[i]);
    }
    if is_triangle::<E, D, P, H>() && zeta[0] + zeta[P - 1] >= 1.0 - ON_BOUND {
        // along the diagonal only the difference of the slopes counts
        held.diagonal = f[0] + f[P - 1] < 0.0;
        held.count += usize::from(held.diagonal);
    }
    let mean = if held.diagonal {
        0.5 * (f[0] + f[P - 1])
    } else {
        0.0
    };
    for i in 0..P {
        let (lower, upper) = bounds::<E, D, P, H>(i);
        let slack = ON_BOUND * extent[i];
        let slope = f[i] - mean;
        if zeta[i] <= lower + slack && slope > 0.0 {
            held.side[i] = -1.0;
        } else if zeta[i] >= upper - slack && slope < 0.0 && !held.diagonal {
            held.side[i] = 1.0;
        }
        held.count += usize::from(held.side[i] != 0.0);
    }
    held
}

/// Newton's step on what is free, or the metric's where the curvature there is not positive.
fn descent<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
    held: &Held<P>,
) -> [f64; P] {
    let Vectors { r, b, second } = vectors;
    let mut change = [0.0; P];
    if held.count == 0 {
        if let Ok(newton) = step::<E, D, P, H>(vectors) {
            return newton.change;
        }
        if P == 2 {
            return gauss_newton(vectors);
        }
    }
    if P == 2 && held.diagonal {
        if held.count > 1 {
            return change;
        }
        let mut along = b[0];
        let mut bend = second[0];
        for k in 0..D {
            along[k] -= b[P - 1][k];
            bend[k] += second[H - 1][k] - 2.0 * second[1][k];
        }
        let slope = dot(r, &along);
        let square = dot(&along, &along);
        let curvature = square + dot(r, &bend);
        change[0] = -slope / positive(curvature, square);
        change[P - 1] = -change[0];
        return change;
    }
    for i in 0..P {
        if held.side[i] == 0.0 {
            let square = dot(&b[i], &b[i]);
            let curvature = square + dot(r, &second[2 * i]);
            change[i] = -dot(r, &b[i]) / positive(curvature, square);
        }
    }
    change
}

/// −a⁻¹ f: a descent direction whatever the curvature; zero where the tangents are parallel.
fn gauss_newton<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> [f64; P] {
    let mut change = [0.0; P];
    let (first, second) = (&vectors.b[0], &vectors.b[P - 1]);
    let (a11, a12, a22) = (dot(first, first), dot(first, second), dot(second, second));
    let (f1, f2) = (dot(&vectors.r, first), dot(&vectors.r, second));
    let determinant = a11 * a22 - a12 * a12;
    if determinant > 1e-10 * a11 * a22 && determinant > 1e-100 {
        change[0] = (a12 * f2 - a22 * f1) / determinant;
        change[P - 1] = (a12 * f1 - a11 * f2) / determinant;
    } else {
        change[0] = -f1 / positive(a11, a11);
    }
    change
}

/// The curvature where it is clearly positive, else the metric, never zero.
fn positive(curvature: f64, square: f64) -> f64 {
    let value = if curvature > 1e-3 * square {
        curvature
    } else {
        square
    };
    value.max(1e-60)
}

/// Halves the step until r·r falls; returns the relative size of the step taken.
fn search<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    x: &[[f64; D]],
    zeta: &mut [f64; P],
    vectors: &mut Vectors<D, P, H>,
    (change, extent): ([f64; P], &[f64; P]),
    parameters: &[f64],
    rows: &mut Rows<'_, P>,
) -> f64 {
    let before = dot(&vectors.r, &vectors.r);
    let mut factor = 1.0;
    for _ in 0..MOST_HALVINGS {
        let mut trial = *zeta;
        for i in 0..P {
            trial[i] += limited(factor * change[i], extent[i]);
        }
        let trial = inside::<E, D, P, H>(trial);
        let candidate = kinematics::<E, D, P, H>(x, &trial, parameters, rows);
        if dot(&candidate.r, &candidate.r) < before {
            let mut size: f64 = 0.0;
            for i in 0..P {
                size = size.max(abs(trial[i] - zeta[i]) / extent[i]);
            }
            (*zeta, *vectors) = (trial, candidate);
            return size;
        }
        factor *= 0.5;
    }
    *vectors = kinematics::<E, D, P, H>(x, zeta, parameters, rows);
    0.0
}

/// The feature just beyond the bounds that hold.
fn beyond<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    zeta: &[f64; P],
    held: &Held<P>,
    extent: &[f64; P],
) -> u8 {
    let mut outside = *zeta;
    let mut outward = held.side;
    if is_triangle::<E, D, P, H>() && (held.diagonal || held.side.contains(&1.0)) {
        // beyond the diagonal, and beyond one of its ends
        let (first, last) = match (held.side[0] < 0.0, held.side[P - 1] < 0.0) {
            (true, _) => (-1.0, 2.0),
            (false, true) => (2.0, -1.0),
            (false, false) => (1.0, 1.0),
        };
        (outward[0], outward[P - 1]) = (first, last);
    }
    for i in 0..P {
        outside[i] += 1e-6 * extent[i] * outward[i];
    }
    E::feature(&outside)
}
