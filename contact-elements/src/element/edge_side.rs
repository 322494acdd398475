//! The side of two edges of solids, kept in the history. [eq:side]

use crate::element::stage::{orientation, placement};
use crate::element::traits::Element;
use crate::point::history::History;
use crate::point::values::{Status, Vectors, dot};

/// Least cosine between the normals of two accepted states: the sides of edges that turn further are undecided.
const LEAST_COSINE: f64 = 0.1;

/// Factor ±1 of the normal along b_1×b_2.
#[inline(always)]
pub(crate) fn side<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    history: Option<History<'_>>,
    vectors: &Vectors<D, P, H>,
    feature: u8,
    parameters: &[f64],
) -> Result<f64, Status> {
    let given = orientation::<E, D, P, H>(parameters);
    if !E::KEEPS_SIDE {
        return Ok(given);
    }
    let n = E::gap(vectors, parameters, 1.0).n;
    let apart = if dot(&vectors.r, &n) < 0.0 { -1.0 } else { 1.0 };
    if feature != 0 {
        // the edges no longer lie side by side: where they meet next, they meet from this side
        return Ok(apart);
    }
    let remembered: [f64; D] = core::array::from_fn(|k| {
        history.map_or(0.0, |history| history.at(E::HISTORY_LAYOUT.side_at() + k))
    });
    if remembered != [0.0; D] {
        let n = match placement::<E, D, P, H>(parameters) {
            Some(placement) => placement.vector_to_global(&n),
            None => n,
        };
        let cosine = dot(&remembered, &n);
        return if cosine >= LEAST_COSINE {
            Ok(1.0)
        } else if cosine <= -LEAST_COSINE {
            Ok(-1.0)
        } else {
            Err(Status::NotUnique)
        };
    }
    Ok(if is_side_given::<E, D, P, H>(parameters) {
        given
    } else {
        apart
    })
}

/// True if `orientation` gives the side of edges whose history has none.
#[inline(always)]
pub(crate) fn is_side_given<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> bool {
    let value = E::LAYOUT.orientation.and_then(|at| parameters.get(at));
    value.is_some_and(|&value| value != 0.0)
}
