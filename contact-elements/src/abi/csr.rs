//! The scatter map into a sparse matrix, made once.

use super::{Descriptor, code};

/// `cte_csr_map`.
///
/// # Safety
/// Pointers are null or have the shapes that the header gives.
#[allow(clippy::too_many_arguments)]
pub unsafe fn csr_map(
    element: *const Descriptor,
    n: i64,
    nslave: i32,
    connectivity: *const i32,
    rows: i64,
    row_start: *const i64,
    column: *const i32,
    map: *mut i64,
) -> i32 {
    // SAFETY: promised by the caller.
    let Some(element) = (unsafe { element.as_ref() }) else {
        return code::NULL;
    };
    if connectivity.is_null() || row_start.is_null() || column.is_null() || map.is_null() {
        return code::NULL;
    }
    let (Ok(n), Ok(rows), Ok(nslave)) = (
        usize::try_from(n),
        usize::try_from(rows),
        usize::try_from(nslave),
    ) else {
        return code::INDEX;
    };
    let nodes = element.nodes(nslave);
    let unknowns = nodes * element.dimension;
    // SAFETY: promised by the caller.
    let (connectivity, starts) = unsafe {
        (
            core::slice::from_raw_parts(connectivity, n * nodes),
            core::slice::from_raw_parts(row_start, rows + 1),
        )
    };
    let length = starts.last().copied().unwrap_or(0);
    let Ok(length) = usize::try_from(length) else {
        return code::INDEX;
    };
    // SAFETY: promised by the caller.
    let columns = unsafe { core::slice::from_raw_parts(column, length) };
    let global = |e: usize, unknown: usize| -> Option<usize> {
        let (a, component) = element.place(unknown);
        let node = usize::try_from(*connectivity.get(e * nodes + a)?).ok()?;
        let row = node * element.dimension + component;
        (row < rows).then_some(row)
    };
    let position = |e: usize, i: usize, j: usize| -> Option<usize> {
        let (row, wanted) = (global(e, i)?, global(e, j)?);
        let start = usize::try_from(*starts.get(row)?).ok()?;
        let end = usize::try_from(*starts.get(row + 1)?).ok()?;
        let found = columns
            .get(start..end)?
            .binary_search(&i32::try_from(wanted).ok()?)
            .ok()?;
        Some(start + found)
    };
    for e in 0..n {
        for i in 0..unknowns {
            for j in 0..unknowns {
                let Some(found) = position(e, i, j) else {
                    return code::INDEX;
                };
                // SAFETY: the map has n · unknowns² entries.
                unsafe { *map.add((e * unknowns + i) * unknowns + j) = found as i64 };
            }
        }
    }
    code::SUCCESS
}
