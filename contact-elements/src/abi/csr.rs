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
    let pairs = move || (0..unknowns).flat_map(move |i| (0..unknowns).map(move |j| (i, j)));
    let all = || (0..n).flat_map(|e| pairs().map(move |(i, j)| (e, i, j)));
    let place = |(e, i, j)| pattern.position(e, i, j);
    // everything is looked up before anything is written
    if !all().all(|at| place(at).is_some()) {
        return code::INDEX;
    }
    for (number, at) in all().enumerate() {
        // SAFETY: the map has n · unknowns² entries.
        unsafe { *map.add(number) = place(at).unwrap_or(0) as i64 };
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

    /// Where entry (i, j) of element `e` stands.
    fn position(&self, e: usize, i: usize, j: usize) -> Option<usize> {
        let (row, wanted) = (self.row(e, i)?, self.row(e, j)?);
        let start = usize::try_from(*self.starts.get(row)?).ok()?;
        let end = usize::try_from(*self.starts.get(row + 1)?).ok()?;
        let wanted = i32::try_from(wanted).ok()?;
        let found = self.columns.get(start..end)?.binary_search(&wanted).ok()?;
        Some(start + found)
    }
}
