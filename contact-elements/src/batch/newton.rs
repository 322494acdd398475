//! The projection of several contacts, all lanes together, by the rules of [`project`](crate::point::projection::newton::project).
//!
//! A lane that leaves the common path is given up here and evaluated alone: no stationary point, nearly singular,
//! steps that do not settle.

use crate::element::traits::{Element, Search};
use crate::lanes::Wide;
use crate::point::projection::newton::{displaced, is_multilinear};
use crate::point::projection::step::{
    DELICATE, ROUNDING, SHARP, SINGULAR, SMALLEST, area_squared, change_of_determinant, terms,
};
use crate::point::values::{Rows, Vectors, dot};

/// Most steps of all lanes together.
const MOST_STEPS: u32 = 10;

/// Where the search ended.
pub(crate) struct Found<T: Wide, const D: usize, const P: usize, const H: usize> {
    pub(crate) zeta: [T; P],
    pub(crate) vectors: Vectors<D, P, H, T>,
    pub(crate) iterations: T,
    /// Lanes that stayed on the common path.
    pub(crate) good: T::Mask,
}

/// Projects the slave's points, whose rows already stand in `rows`.
#[inline(always)]
pub(crate) fn project<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    x: &[[T; D]],
    start: [T; P],
    given: bool,
    parameters: &[T],
    rows: &mut Rows<'_, P, T>,
    good: T::Mask,
) -> Found<T, D, P, H> {
    let mut found = Found {
        zeta: start,
        vectors: Vectors::default(),
        iterations: T::constant(0.0),
        good,
    };
    if P == 0 {
        found.vectors = E::kinematics(x, &found.zeta, parameters, rows);
        return found;
    }
    if given {
        found.vectors = E::kinematics(x, &found.zeta, parameters, rows);
        found.good = good & step::<E, T, D, P, H>(&found.vectors).is_regular;
        return found;
    }
    newton::<E, T, D, P, H>(x, parameters, rows, &mut found);
    let summed = E::kinematics(x, &found.zeta, parameters, rows);
    if !is_multilinear::<E, D, P, H>() {
        found.vectors = summed;
    }
    if !matches!(E::SEARCH, Search::Affine) {
        found.good = found.good & tangents::<T, D, P>(&found.vectors.b).0;
    }
    found
}

// long: one loop, whose conditions to end share all that a step computes
#[inline(always)]
fn newton<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    x: &[[T; D]],
    parameters: &[T],
    rows: &mut Rows<'_, P, T>,
    found: &mut Found<T, D, P, H>,
) {
    let multilinear = is_multilinear::<E, D, P, H>();
    let is_affine = matches!(E::SEARCH, Search::Affine);
    let centre = E::centre().map(T::constant);
    let mut at_centre = Vectors::default();
    if multilinear {
        at_centre = E::kinematics(x, &centre, parameters, rows);
    }
    let (mut zeta, mut good) = (found.zeta, found.good);
    let mut active = good;
    let mut previous = T::constant(f64::MAX);
    for iteration in 1..=MOST_STEPS {
        let vectors = if multilinear {
            from_centre::<E, T, D, P, H>(&at_centre, &centre, &zeta)
        } else {
            E::kinematics(x, &zeta, parameters, rows)
        };
        let step = step::<E, T, D, P, H>(&vectors);
        let mut size = T::constant(0.0);
        let mut is_near = step.is_regular;
        for i in 0..P {
            let extent = T::constant(E::extent(i));
            let mut change = step.change[i];
            if !is_affine {
                change = change.larger(-extent).smaller(extent);
            }
            is_near = is_near & step.change[i].is_finite();
            zeta[i] = T::select(active & is_near, zeta[i] + change, zeta[i]);
            let relative = change.abs() / extent;
            size = T::select(size.below(relative), relative, size);
            is_near = is_near & zeta[i].abs().at_most(T::constant(1e6) * extent);
        }
        let is_finished = finished::<T>(E::SEARCH, iteration, size, previous, step.is_sharp);
        let mut lost = !is_near | is_finished & step.is_delicate;
        if !is_affine && iteration > 2 {
            // rounding noise, or steps that do not shrink
            lost = lost | !is_finished & (T::constant(0.25) * previous).below(size);
        }
        lost = lost & active;
        good = good & !lost;
        let ended = (is_finished | lost) & active;
        found.iterations = T::select(ended, T::constant(f64::from(iteration)), found.iterations);
        active = active & !ended;
        if T::bits(lost) != 0 {
            for i in 0..P {
                zeta[i] = T::select(lost, centre[i], zeta[i]);
            }
        }
        if T::bits(active) == 0 {
            break;
        }
        previous = size;
    }
    found.zeta = zeta;
    found.good = good & !active;
    if multilinear {
        found.vectors = displaced::<E, D, P, H, T>(&at_centre, &centre, &zeta);
    }
}

/// Kinematics at ζ from those at the centre, which stay unchanged.
#[inline(always)]
fn from_centre<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    at_centre: &Vectors<D, P, H, T>,
    centre: &[T; P],
    zeta: &[T; P],
) -> Vectors<D, P, H, T> {
    let mut vectors = displaced::<E, D, P, H, T>(at_centre, centre, zeta);
    let mut is_there = zeta[0].equals(centre[0]);
    for i in 1..P {
        is_there = is_there & zeta[i].equals(centre[i]);
    }
    if T::bits(is_there) != 0 {
        let pick = |there: T, away: T| T::select(is_there, there, away);
        for k in 0..D {
            vectors.r[k] = pick(at_centre.r[k], vectors.r[k]);
            for i in 0..P {
                vectors.b[i][k] = pick(at_centre.b[i][k], vectors.b[i][k]);
            }
        }
    }
    vectors
}

/// The rule of the scalar search.
#[inline(always)]
fn finished<T: Wide>(
    search: Search,
    iteration: u32,
    size: T,
    previous: T,
    is_sharp: T::Mask,
) -> T::Mask {
    let tiny = T::constant(1e-15);
    if matches!(search, Search::Affine) {
        return match iteration {
            1 => !is_sharp & size.below(T::constant(4.0)),
            2 => !is_sharp,
            _ => T::mask(T::all()),
        };
    }
    let small = size.at_most(tiny);
    if iteration == 1 {
        return small;
    }
    let square = size * size;
    let shrinks = size.below(T::constant(0.1) * previous) & square.at_most(tiny);
    let next = (square * size).at_most(tiny * (previous * previous));
    small | !is_sharp & shrinks & next
}

struct Step<T: Wide, const P: usize> {
    change: [T; P],
    is_regular: T::Mask,
    is_sharp: T::Mask,
    is_delicate: T::Mask,
}

/// −F⁻¹ f, and in which lanes F can be inverted. [eq:newton-step] [eq:det-F]
#[inline(always)]
fn step<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H, T>,
) -> Step<T, P> {
    let Vectors { r, b, second } = vectors;
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let bend = |h: usize| {
        if E::CURVED[h] {
            dot(r, &second[h])
        } else {
            zero
        }
    };
    let (mut is_regular, [a11, a22], determinant) = tangents::<T, D, P>(b);
    let mut change = [zero; P];
    let (is_sharp, is_delicate);
    if P == 1 {
        let h = bend(0);
        let f = a11 + h;
        is_regular = is_regular & !f.at_most(T::constant(SINGULAR) * a11);
        is_delicate = f.below(T::constant(DELICATE) * (a11 + h.abs()));
        is_sharp = T::mask(0);
        change[0] = -dot(r, &b[0]) / T::select(is_regular, f, one);
    } else {
        let a12 = dot(&b[0], &b[P - 1]);
        is_sharp = determinant.below(T::constant(SHARP * SHARP) * a11 * a22);
        let (h11, h12, h22) = (bend(0), bend(1), bend(2));
        let change_of_f = change_of_determinant::<E, D, P, H, T>([a11, a12, a22], [h11, h12, h22]);
        let f = determinant + change_of_f;
        let scaled = f * a11 * a11;
        let terms = terms([a11, a12, determinant], [h11, h12, h22]);
        let (f11, f12, f22) = (a11 + h11, a12 + h12, a22 + h22);
        let is_singular = f.at_most(T::constant(SINGULAR) * determinant)
            | f11.at_most(zero)
            | scaled.at_most(T::constant(ROUNDING) * terms);
        is_regular = is_regular & !is_singular;
        is_delicate = scaled.below(T::constant(DELICATE) * terms);
        let (f1, f2) = (dot(r, &b[0]), dot(r, &b[P - 1]));
        let f = T::select(is_regular, f, one);
        change[0] = (f12 * f2 - f22 * f1) / f;
        change[P - 1] = (f12 * f1 - f11 * f2) / f;
    }
    Step {
        change,
        is_regular,
        is_sharp,
        is_delicate,
    }
}

/// a_11 and a_22, det a, and in which lanes the tangents are neither zero nor parallel.
#[inline(always)]
fn tangents<T: Wide, const D: usize, const P: usize>(b: &[[T; D]; P]) -> (T::Mask, [T; 2], T) {
    let smallest = T::constant(SMALLEST * SMALLEST);
    let squares = [dot(&b[0], &b[0]), dot(&b[P - 1], &b[P - 1])];
    let mut are_regular = !(squares[0].below(smallest) | squares[1].below(smallest));
    let mut determinant = squares[0];
    if P == 2 {
        determinant = area_squared(&b[0], &b[P - 1]);
        let least = T::constant(SINGULAR * SINGULAR) * squares[0] * squares[1];
        are_regular = are_regular & !determinant.at_most(least);
    }
    (are_regular, squares, determinant)
}
