//! Counts and strides of the caller, checked before an array is indexed by them.

use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::error::Error;

/// Most entries of an array of doubles: its bytes fit an `isize`.
pub(crate) const MOST_ENTRIES: usize = isize::MAX as usize / size_of::<f64>();

/// Most unknowns of an element: they fit an `int32_t`, their matrix and the workspace fit the memory.
pub(crate) const MOST_UNKNOWNS: usize = (1 << 30) - 1;

/// Nodes of a slave given in the call, or the element's own.
#[inline]
pub(crate) fn slave_count(element: &Descriptor, nslave: i32) -> Result<usize, Error> {
    let fits = |given: usize| {
        given > 0 && (given + element.master_nodes) * element.dimension <= MOST_UNKNOWNS
    };
    match usize::try_from(nslave) {
        Ok(given) if element.interpolated && fits(given) => Ok(given),
        Ok(given) if !element.interpolated && (given == 0 || given == element.slave_nodes) => {
            Ok(element.slave_nodes)
        }
        _ => Err(Error::new(code::NODE_COUNT, argument::NSLAVE, 0)),
    }
}

/// The nodes of a call, 0 for the least number; `None` where the number does not fit.
pub(crate) fn nodes_of_call(element: &Descriptor, nnode: i32) -> Option<usize> {
    let smallest = element.nodes(1);
    match usize::try_from(nnode).ok()? {
        0 => Some(smallest),
        n if n * element.dimension > MOST_UNKNOWNS => None,
        n if n == smallest || (element.interpolated && n > smallest) => Some(n),
        _ => None,
    }
}

/// Strides that keep all entries of a matrix with so many rows apart; 0, 0 stands for dense, row after row.
pub(crate) fn strides(row: i64, column: i64, rows: usize) -> Result<(usize, usize), Error> {
    let fault = Error::new(code::STRIDE, argument::K_STRIDE, 0);
    if row == 0 && column == 0 && rows <= MOST_UNKNOWNS {
        return Ok((rows, 1));
    }
    let (Ok(row), Ok(column)) = (usize::try_from(row), usize::try_from(column)) else {
        return Err(fault);
    };
    let last = rows.saturating_sub(1);
    let apart = |small: usize, large: usize| large.checked_div(small).is_some_and(|n| n >= rows);
    let fits = extent(&[(last, row), (last, column)]).is_some();
    if fits && (apart(column, row) || apart(row, column)) {
        Ok((row, column))
    } else {
        Err(fault)
    }
}

/// Number of host rows that the map reaches.
pub(crate) fn host_rows(map: Option<&[i32]>, unknowns: usize) -> Result<usize, Error> {
    let Some(map) = map else {
        return Ok(unknowns);
    };
    let mut rows = 0;
    for (index, &row) in map.iter().enumerate() {
        match usize::try_from(row) {
            Ok(row) => rows = rows.max(row + 1),
            Err(_) => return Err(Error::new(code::INDEX, argument::UNKNOWN_MAP, index)),
        }
    }
    Ok(rows)
}

/// Entries up to the last one, Σ last·stride + 1; `None` where no array is that long.
pub(crate) fn extent(steps: &[(usize, usize)]) -> Option<usize> {
    let mut length: usize = 1;
    for &(last, stride) in steps {
        length = length.checked_add(last.checked_mul(stride)?)?;
    }
    (length <= MOST_ENTRIES).then_some(length)
}

/// The distance from item to item: 0 stands for `least`, less would overlap.
pub(crate) fn spacing(stride: i64, least: usize) -> Option<usize> {
    match usize::try_from(stride).ok()? {
        0 => Some(least),
        stride => (stride >= least).then_some(stride),
    }
}

/// An index as the interface reports it.
pub(crate) fn reported(index: usize) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}
