//! Counts and strides of the caller, checked before a pointer is moved by them.

use super::{Descriptor, argument, code};

/// What is wrong: return code, argument, entry.
pub(super) type Fault = (i32, i32, usize);

/// Most entries of an array of doubles: its bytes fit an `isize`.
pub(super) const MOST_ENTRIES: usize = isize::MAX as usize / size_of::<f64>();

/// Most unknowns of an element: they fit an `int32_t`, their matrix and the workspace fit the memory.
pub(super) const MOST_UNKNOWNS: usize = (1 << 30) - 1;

/// Nodes of a slave given in the call, or the element's own.
pub(super) fn slave_count(element: &Descriptor, nslave: i32) -> Result<usize, Fault> {
    let fits = |given: usize| {
        given > 0 && (given + element.master_nodes) * element.dimension <= MOST_UNKNOWNS
    };
    match usize::try_from(nslave) {
        Ok(given) if element.interpolated && fits(given) => Ok(given),
        Ok(given) if !element.interpolated && (given == 0 || given == element.slave_nodes) => {
            Ok(element.slave_nodes)
        }
        _ => Err((code::NODE_COUNT, argument::NSLAVE, 0)),
    }
}

/// The nodes of a call, 0 for the least number; `None` where the number does not fit.
pub(super) fn nodes_of_call(element: &Descriptor, nnode: i32) -> Option<usize> {
    let smallest = element.nodes(1);
    match usize::try_from(nnode).ok()? {
        0 => Some(smallest),
        n if n * element.dimension > MOST_UNKNOWNS => None,
        n if n == smallest || (element.interpolated && n > smallest) => Some(n),
        _ => None,
    }
}

/// Entries up to the last one, Σ last·stride + 1; `None` where no array is that long.
pub(super) fn extent(steps: &[(usize, usize)]) -> Option<usize> {
    let mut length: usize = 1;
    for &(last, stride) in steps {
        length = length.checked_add(last.checked_mul(stride)?)?;
    }
    (length <= MOST_ENTRIES).then_some(length)
}

/// The distance from item to item: 0 stands for `least`, less would overlap.
pub(super) fn spacing(stride: i64, least: usize) -> Option<usize> {
    match usize::try_from(stride).ok()? {
        0 => Some(least),
        stride => (stride >= least).then_some(stride),
    }
}

/// An index as the interface reports it.
pub(super) fn reported(index: usize) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}
