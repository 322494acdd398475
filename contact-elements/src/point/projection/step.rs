//! One step of Newton's method for the projection. [eq:newton-step] [eq:det-F]

use crate::arithmetic::{abs, quotient};
use crate::element::traits::Element;
use crate::lanes::Real;
use crate::point::values::{Status, Vectors, dot};

/// Tangents count as parallel, and F as singular, below this sine or relative determinant.
pub(crate) const SINGULAR: f64 = 1e-13;
/// det F below this part of its terms may vanish nearby.
pub(crate) const DELICATE: f64 = 1e-6;
/// det F below this part of its terms is rounding.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Tangents count as nearly parallel below this sine.
pub(crate) const SHARP: f64 = 1e-2;
/// Lengths below this are zero [length].
pub(crate) const SMALLEST: f64 = 1e-30;

/// A Newton step.
pub(crate) struct Step<const P: usize> {
    /// −F⁻¹ f [eq:newton-step] [eq:det-F]
    pub(crate) change: [f64; P],
    /// f
    pub(crate) slopes: [f64; P],
    /// a_ii
    pub(crate) metric: [f64; P],
    /// The tangents meet at an angle below about 0.01.
    pub(crate) is_sharp: bool,
    /// det F is small beside its terms: it may vanish nearby.
    pub(crate) is_delicate: bool,
}

/// −F⁻¹ f, or why F cannot be inverted: zero area or length, parallel tangents, focal surface, a foot
/// that is no minimum of the distance.
#[inline(always)]
pub(crate) fn step<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> Result<Step<P>, Status> {
    let Vectors { r, b, second } = vectors;
    let (mut change, mut slopes, mut metric) = ([0.0; P], [0.0; P], [0.0; P]);
    let mut is_sharp = false;
    let is_delicate;
    // r·r_,ij; a constant zero where there is no such derivative
    let bend = |h: usize| {
        if E::CURVED[h] {
            dot(r, &second[h])
        } else {
            0.0
        }
    };
    if P == 1 {
        let ([a, _], _) = tangents(b, E::PARALLEL)?;
        let h = bend(0);
        let f = a + h;
        if f <= SINGULAR * a {
            return Err(Status::NotUnique);
        }
        is_delicate = f < DELICATE * (a + abs(h));
        let f1 = dot(r, &b[0]);
        (slopes[0], metric[0]) = (f1, a);
        change[0] = quotient(-f1, f);
    } else {
        let ([a11, a22], determinant) = tangents(b, E::PARALLEL)?;
        let a12 = dot(&b[0], &b[1]);
        is_sharp = determinant < SHARP * SHARP * a11 * a22;
        let (h11, h12, h22) = (bend(0), bend(1), bend(2));
        let change_of_f =
            change_of_determinant::<E, D, P, H, f64>([a11, a12, a22], [h11, h12, h22]);
        let f = determinant + change_of_f;
        let (scaled, terms) = (
            f * a11 * a11,
            terms([a11, a12, determinant], [h11, h12, h22]),
        );
        let (f11, f12, f22) = (a11 + h11, a12 + h12, a22 + h22);
        if f <= SINGULAR * determinant || f11 <= 0.0 || scaled <= ROUNDING * terms {
            return Err(Status::NotUnique);
        }
        is_delicate = scaled < DELICATE * terms;
        let (f1, f2) = (dot(r, &b[0]), dot(r, &b[1]));
        (slopes[0], slopes[1]) = (f1, f2);
        (metric[0], metric[1]) = (a11, a22);
        change[0] = quotient(f12 * f2 - f22 * f1, f);
        change[1] = quotient(f12 * f1 - f11 * f2, f);
    }
    Ok(Step {
        change,
        slopes,
        metric,
        is_sharp,
        is_delicate,
    })
}

/// a_11 and a_22 with det a of tangents that are neither zero nor, which is reported as `parallel`, parallel.
#[inline(always)]
pub(crate) fn tangents<const D: usize, const P: usize>(
    b: &[[f64; D]; P],
    parallel: Status,
) -> Result<([f64; 2], f64), Status> {
    let squares = [dot(&b[0], &b[0]), dot(&b[P - 1], &b[P - 1])];
    if squares[0] < SMALLEST * SMALLEST || squares[1] < SMALLEST * SMALLEST {
        return Err(Status::Degenerate);
    }
    let mut determinant = squares[0];
    if P == 2 {
        determinant = area_squared(&b[0], &b[1]);
        if determinant <= SINGULAR * SINGULAR * squares[0] * squares[1] {
            return Err(parallel);
        }
    }
    Ok((squares, determinant))
}

/// Whether there is a normal: at a corner where nodes coincide it does not exist. Off the fast path, so shared.
#[inline(never)]
pub(crate) fn have_normal<const D: usize, const P: usize>(
    b: &[[f64; D]; P],
    parallel: Status,
) -> Result<(), Status> {
    tangents(b, parallel).map(|_| ())
}

/// det(a + h) − det a, without the products that vanish identically.
#[inline(always)]
pub(crate) fn change_of_determinant<
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
    T: Real,
>(
    [a11, a12, a22]: [T; 3],
    [h11, h12, h22]: [T; 3],
) -> T {
    let mut sum = T::constant(0.0);
    if E::CURVED[1] {
        sum = -h12 * (a12 + a12 + h12);
    }
    match (E::CURVED[0], E::CURVED[2]) {
        (true, true) => sum + (a11 * h22 + a22 * h11 + h11 * h22),
        (true, false) => sum + a22 * h11,
        (false, true) => sum + a11 * h22,
        (false, false) => sum,
    }
}

/// Size of the terms that the tangent makes det F of, times a_11²: in the basis b_1, b_2 − (a_12/a_11) b_1.
#[inline(always)]
pub(crate) fn terms<T: Real>([a11, a12, determinant]: [T; 3], h: [T; 3]) -> T {
    let ([h11, h12, h22], shear) = (h.map(T::abs), a12.abs());
    let twice = T::constant(2.0) * shear;
    let last = determinant * a11 + h22 * a11 * a11 + twice * h12 * a11 + shear * shear * h11;
    let mixed = h12 * a11 + shear * h11;
    (a11 + h11) * last + mixed * mixed
}

/// |b_1×b_2|²
#[inline(always)]
pub(crate) fn area_squared<const D: usize, T: Real>(a: &[T; D], b: &[T; D]) -> T {
    let mut sum = T::constant(0.0);
    for k in 0..D {
        for l in k + 1..D {
            let minor = a[k] * b[l] - a[l] * b[k];
            sum = sum + minor * minor;
        }
    }
    sum
}
