//! Which elements there are and what each needs.

use crate::codes::{argument, kind};
use crate::descriptor::Descriptor;
use crate::error::Error;
use crate::evaluation::inputs;
use crate::registered::Registered;

/// The number of an element in a list, by its name.
pub fn find(elements: &[&Registered], name: &[u8]) -> Option<usize> {
    let wanted = name.trim_ascii_end();
    elements
        .iter()
        .position(|element| element.name.trim_end_matches('\0').as_bytes() == wanted)
}

/// Checks parameters against their ranges.
///
/// # Errors
/// [`PARAMETER`](crate::code::PARAMETER) for one that is missing or out of its range,
/// [`NOT_FINITE`](crate::code::NOT_FINITE); the index is that of the parameter.
pub fn check_parameters(element: &Descriptor, parameters: &[f64]) -> Result<(), Error> {
    inputs::check_parameters(element, parameters)
}

/// Makes `history` the history of contacts that begin: open, projections and anchors at the centre.
///
/// # Errors
/// [`NULL`](crate::code::NULL) where it is too short.
pub fn initial_history(element: &Descriptor, history: &mut [f64]) -> Result<(), Error> {
    let history = history.get_mut(..element.history());
    let history = history.ok_or(Error::missing(argument::HISTORY_TRIAL))?;
    let layout = element.history_layout();
    // a history of a point is never empty; the least size is for the compiler, which would keep a panic otherwise
    for own in history.chunks_exact_mut(layout.size().max(1)) {
        layout.begin(element.centre, own);
    }
    Ok(())
}

/// Node and kind of an unknown of a call with `n` nodes: a number of [`kind`], for displacements and tangent vectors plus
/// the component.
pub(crate) fn unknown(element: &Descriptor, n: usize, index: usize) -> Option<(usize, i32)> {
    if index >= element.unknowns(n) {
        return None;
    }
    let (a, component) = element.place(n, index);
    let positions = n - element.multipliers().min(n);
    let first = positions - element.vectors.len().min(positions);
    let vector = a
        .checked_sub(first)
        .and_then(|a| element.vectors.get(a))
        .copied()
        .unwrap_or(false);
    let first = if a >= positions {
        kind::MULTIPLIER
    } else if vector {
        kind::TANGENT_VECTOR
    } else {
        kind::DISPLACEMENT
    };
    Some((a, first + component as i32))
}

/// The parameters to check, of those that a host passes.
pub(crate) fn parameter_count(element: &Descriptor, count: i32) -> usize {
    let count = usize::try_from(count).unwrap_or(0);
    count.min(element.parameters.len())
}
