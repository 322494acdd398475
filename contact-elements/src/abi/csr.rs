//! The scatter map into a sparse matrix, made once.

use super::sizes::{MOST_ENTRIES, slave_count};
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
    let (Ok(n), Ok(rows)) = (usize::try_from(n), usize::try_from(rows)) else {
        return code::INDEX;
    };
    let nodes = match slave_count(element, nslave) {
        Ok(nslave) => element.nodes(nslave),
        Err((code, ..)) => return code,
    };
    if n == 0 {
        return code::SUCCESS;
    }
    if connectivity.is_null() || row_start.is_null() || column.is_null() || map.is_null() {
        return code::NULL;
    }
    let unknowns = element.unknowns(nodes);
    let entries = n.checked_mul(unknowns * unknowns);
    if entries.is_none_or(|entries| entries > MOST_ENTRIES) || rows >= MOST_ENTRIES {
        return code::INDEX;
    }
    // SAFETY: promised by the caller; both lengths fit the memory.
    let pattern = unsafe {
        let starts = core::slice::from_raw_parts(row_start, rows + 1);
        match usize::try_from(starts.last().copied().unwrap_or(0)) {
            Ok(length) if length <= MOST_ENTRIES => Pattern {
                element,
                nodes,
                connectivity: core::slice::from_raw_parts(connectivity, n * nodes),
                starts,
                columns: core::slice::from_raw_parts(column, length),
            },
            _ => return code::INDEX,
        }
    };
    // everything is looked up before anything is written
    if (0..n).any(|e| pattern.positions(e, unknowns, |_| {}).is_none()) {
        return code::INDEX;
    }
    let mut number = 0;
    for e in 0..n {
        let found = pattern.positions(e, unknowns, |position| {
            // SAFETY: the map has n · unknowns² entries.
            unsafe { *map.add(number) = position as i64 };
            number += 1;
        });
        debug_assert!(found.is_some());
    }
    code::SUCCESS
}

/// A sparse matrix and the elements that go into it.
struct Pattern<'a> {
    element: &'a Descriptor,
    nodes: usize,
    connectivity: &'a [i32],
    starts: &'a [i64],
    columns: &'a [i32],
}

impl Pattern<'_> {
    /// Row of an element's unknown.
    fn row(&self, e: usize, unknown: usize) -> Option<usize> {
        let (a, component) = self.element.place(self.nodes, unknown);
        let node = usize::try_from(*self.connectivity.get(e * self.nodes + a)?).ok()?;
        let row = node * self.element.dimension + component;
        (row + 1 < self.starts.len()).then_some(row)
    }

    /// Where the entries of element `e` stand, row by row; none where one is missing.
    fn positions(&self, e: usize, unknowns: usize, mut take: impl FnMut(usize)) -> Option<()> {
        for i in 0..unknowns {
            let row = self.row(e, i)?;
            let start = usize::try_from(*self.starts.get(row)?).ok()?;
            let end = usize::try_from(*self.starts.get(row + 1)?).ok()?;
            let columns = self.columns.get(start..end)?;
            let mut next = 0;
            for j in 0..unknowns {
                let wanted = i32::try_from(self.row(e, j)?).ok()?;
                // the components of a node stand side by side
                let found = match columns.get(next) {
                    Some(&column) if column == wanted => next,
                    _ => columns.binary_search(&wanted).ok()?,
                };
                take(start + found);
                next = found + 1;
            }
        }
        Some(())
    }
}
