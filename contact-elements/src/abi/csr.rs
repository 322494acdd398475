//! The scatter maps into a sparse matrix, made once: a place for every entry, or one for every pair of nodes.

use super::sizes::{MOST_ENTRIES, slave_count};
use super::{Descriptor, code};

/// The caller's sparse matrix and the elements that go into it, as `cte_csr_map` takes them.
#[derive(Clone, Copy, Debug)]
pub struct Sparse {
    /// The element.
    pub element: *const Descriptor,
    /// Contacts.
    pub n: i64,
    /// Slave nodes of an interpolated slave.
    pub nslave: i32,
    /// Nodes of every contact.
    pub connectivity: *const i32,
    /// Rows of the matrix.
    pub rows: i64,
    /// Where each row begins, and the end of the last.
    pub row_start: *const i64,
    /// Columns, row by row.
    pub column: *const i32,
}

/// What has a place of its own.
#[derive(Clone, Copy)]
enum Kind {
    Entries,
    Blocks,
}

impl Kind {
    /// Places of an element.
    fn size(self, nodes: usize, unknowns: usize) -> usize {
        match self {
            Kind::Entries => unknowns * unknowns,
            Kind::Blocks => nodes * (nodes + 1),
        }
    }
}

/// `cte_csr_map`.
///
/// # Safety
/// Pointers are null or have the shapes that the header gives.
pub unsafe fn csr_map(sparse: Sparse, map: *mut i64) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { make(&sparse, map, Kind::Entries) }
}

/// `cte_csr_blocks`.
///
/// # Safety
/// Pointers are null or have the shapes that the header gives.
pub unsafe fn csr_blocks(sparse: Sparse, map: *mut i64) -> i32 {
    // SAFETY: promised by the caller.
    unsafe { make(&sparse, map, Kind::Blocks) }
}

/// Writes the places of all contacts; nothing where one of them has none.
///
/// # Safety
/// As [`csr_map`].
unsafe fn make(sparse: &Sparse, map: *mut i64, kind: Kind) -> i32 {
    // SAFETY: promised by the caller.
    let (pattern, n) = match unsafe { pattern(sparse, map, kind) } {
        Ok(Some(checked)) => checked,
        Ok(None) => return code::SUCCESS,
        Err(code) => return code,
    };
    // everything is looked up before anything is written
    if (0..n).any(|e| pattern.places(kind, e, &mut |_| {}).is_none()) {
        return code::INDEX;
    }
    let mut number = 0;
    for e in 0..n {
        let found = pattern.places(kind, e, &mut |place| {
            // SAFETY: the map has so many entries for every contact.
            unsafe { *map.add(number) = place as i64 };
            number += 1;
        });
        debug_assert!(found.is_some());
    }
    code::SUCCESS
}

/// What the caller handed in, checked, and the number of contacts; none where there are none.
///
/// # Safety
/// As [`csr_map`].
unsafe fn pattern<'a>(
    sparse: &Sparse,
    map: *mut i64,
    kind: Kind,
) -> Result<Option<(Pattern<'a>, usize)>, i32> {
    // SAFETY: promised by the caller.
    let element = unsafe { sparse.element.as_ref() }.ok_or(code::NULL)?;
    let (Ok(n), Ok(rows)) = (usize::try_from(sparse.n), usize::try_from(sparse.rows)) else {
        return Err(code::INDEX);
    };
    let nslave = slave_count(element, sparse.nslave).map_err(|(code, ..)| code)?;
    let nodes = element.nodes(nslave);
    let unknowns = element.unknowns(nodes);
    if n == 0 {
        return Ok(None);
    }
    let (connectivity, starts, columns) = (sparse.connectivity, sparse.row_start, sparse.column);
    if connectivity.is_null() || starts.is_null() || columns.is_null() || map.is_null() {
        return Err(code::NULL);
    }
    // an element has no more nodes than places
    let places = n.checked_mul(kind.size(nodes, unknowns));
    if places.is_none_or(|places| places > MOST_ENTRIES) || rows >= MOST_ENTRIES {
        return Err(code::INDEX);
    }
    // SAFETY: promised by the caller; the lengths fit the memory.
    unsafe {
        let starts = core::slice::from_raw_parts(starts, rows + 1);
        let length = usize::try_from(starts.last().copied().unwrap_or(0)).ok();
        let length = length.filter(|&length| length <= MOST_ENTRIES);
        let pattern = Pattern {
            element,
            nodes,
            unknowns,
            connectivity: core::slice::from_raw_parts(connectivity, n * nodes),
            starts,
            columns: core::slice::from_raw_parts(columns, length.ok_or(code::INDEX)?),
        };
        Ok(Some((pattern, n)))
    }
}

/// A sparse matrix and the elements that go into it.
struct Pattern<'a> {
    element: &'a Descriptor,
    nodes: usize,
    unknowns: usize,
    connectivity: &'a [i32],
    starts: &'a [i64],
    columns: &'a [i32],
}

impl Pattern<'_> {
    /// The places of element `e`; none where one is missing.
    fn places(&self, kind: Kind, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        match kind {
            Kind::Entries => self.entries(e, take),
            Kind::Blocks => self.blocks(e, take),
        }
    }

    /// Row of an element's unknown.
    fn row(&self, e: usize, unknown: usize) -> Option<usize> {
        let (a, component) = self.element.place(self.nodes, unknown);
        let node = usize::try_from(*self.connectivity.get(e * self.nodes + a)?).ok()?;
        let row = node * self.element.dimension + component;
        (row + 1 < self.starts.len()).then_some(row)
    }

    /// Where a row begins, and its columns.
    fn columns(&self, row: usize) -> Option<(usize, &[i32])> {
        let start = usize::try_from(*self.starts.get(row)?).ok()?;
        let end = usize::try_from(*self.starts.get(row + 1)?).ok()?;
        Some((start, self.columns.get(start..end)?))
    }

    /// Where the entries of element `e` stand, row by row; none where one is missing.
    fn entries(&self, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        for i in 0..self.unknowns {
            let (start, columns) = self.columns(self.row(e, i)?)?;
            let mut next = 0;
            for j in 0..self.unknowns {
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

    /// Where the first entries of the blocks of element `e` stand, node by node, and how far the rows of the node are
    /// apart; none where an entry is missing or stands elsewhere.
    fn blocks(&self, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        for a in 0..self.nodes {
            let (first, components) = self.unknowns_of(a);
            let row = self.row(e, first)?;
            let (start, columns) = self.columns(row)?;
            let apart = match components {
                1 => 0,
                _ => self.columns(row + 1)?.0.checked_sub(start)?,
            };
            for b in 0..self.nodes {
                let (unknown, width) = self.unknowns_of(b);
                let wanted = i32::try_from(self.row(e, unknown)?).ok()?;
                let found = columns.binary_search(&wanted).ok()?;
                // the last column of a block may be beyond an i32, where none is
                let wanted = i64::from(wanted);
                for component in 0..components {
                    let (own, columns) = self.columns(row + component)?;
                    let block = columns.get(found..found + width)?;
                    let mut pairs = block.iter().zip(wanted..);
                    let is_there = pairs.all(|(&column, at)| i64::from(column) == at);
                    (is_there && own == start + component * apart).then_some(())?;
                }
                take(start + found);
            }
            take(apart);
        }
        Some(())
    }

    /// The first unknown of a node, and how many it has.
    fn unknowns_of(&self, node: usize) -> (usize, usize) {
        let (d, positions) = (
            self.element.dimension,
            self.nodes - self.element.multipliers(),
        );
        match node.checked_sub(positions) {
            Some(multiplier) => (positions * d + multiplier, 1),
            None => (node * d, d),
        }
    }
}
