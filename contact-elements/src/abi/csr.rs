//! The scatter maps into a sparse matrix.

use super::pointers::optional;
use crate::codes::code;
use crate::error::Error;
use crate::evaluation::pattern::{Sparsity, scatter_blocks, scatter_map, sizes};
use crate::evaluation::sizes::{MOST_ENTRIES, slave_count};
use crate::registered::Registered;

/// The caller's sparse matrix and the elements that go into it, as `cte_csr_map` takes them.
#[derive(Clone, Copy, Debug)]
pub struct Sparse {
    /// The element.
    pub element: *const Registered,
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

/// `cte_csr_map`.
///
/// # Safety
/// Pointers are null or have the shapes that the header gives.
pub unsafe fn csr_map(sparse: Sparse, map: *mut i64) -> i32 {
    // SAFETY: promised by the caller.
    returned(unsafe { make(&sparse, map, false) })
}

/// `cte_csr_blocks`.
///
/// # Safety
/// Pointers are null or have the shapes that the header gives.
pub unsafe fn csr_blocks(sparse: Sparse, map: *mut i64) -> i32 {
    // SAFETY: promised by the caller.
    returned(unsafe { make(&sparse, map, true) })
}

fn returned(result: Result<(), i32>) -> i32 {
    result.err().unwrap_or(code::SUCCESS)
}

/// # Safety
/// As [`csr_map`].
unsafe fn make(sparse: &Sparse, map: *mut i64, by_blocks: bool) -> Result<(), i32> {
    // SAFETY: promised by the caller.
    let element = unsafe { sparse.element.as_ref() }.ok_or(code::NULL)?;
    let (Ok(n), Ok(rows)) = (usize::try_from(sparse.n), usize::try_from(sparse.rows)) else {
        return Err(code::INDEX);
    };
    let code_of = |error: Error| error.code;
    let nslave = slave_count(element, sparse.nslave).map_err(code_of)?;
    if n == 0 {
        return Ok(());
    }
    let contact = sizes(element, nslave);
    // an element has no more nodes than places
    let places = n.checked_mul(contact.places(by_blocks));
    let places = places.filter(|&places| places <= MOST_ENTRIES && rows < MOST_ENTRIES);
    let is_missing = sparse.connectivity.is_null()
        || sparse.row_start.is_null()
        || sparse.column.is_null()
        || map.is_null();
    if is_missing {
        return Err(code::NULL);
    }
    let places = places.ok_or(code::INDEX)?;
    // SAFETY: promised by the caller; the lengths fit the memory.
    unsafe {
        let row_start = optional(sparse.row_start, rows + 1).unwrap_or_default();
        let length = usize::try_from(row_start.last().copied().unwrap_or(0)).ok();
        let length = length.filter(|&length| length <= MOST_ENTRIES);
        let sparsity = Sparsity {
            slave_nodes: nslave,
            connectivity: optional(sparse.connectivity, n * contact.nodes).unwrap_or_default(),
            row_start,
            column: optional(sparse.column, length.ok_or(code::INDEX)?).unwrap_or_default(),
        };
        let map = core::slice::from_raw_parts_mut(map, places);
        if by_blocks {
            scatter_blocks(element, &sparsity, map).map_err(code_of)
        } else {
            scatter_map(element, &sparsity, map).map_err(code_of)
        }
    }
}
