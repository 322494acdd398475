//! Contributions to entries of another part's nodes: written down while the parts work, added when all are done.

use crate::abi::places::Places;
use core::sync::atomic::{AtomicUsize, Ordering};

use std::vec::Vec;

/// Nodes whose entries one thread adds up when journals are read: some, so that threads do not write side by side.
const NEIGHBOURS: usize = 16;

/// What one part writes down, in the order in which it would have added it.
#[derive(Default)]
pub(super) struct Journal {
    forces: Vec<Force>,
    rows: Vec<Row>,
    /// Of all rows, one after another.
    values: Vec<f64>,
    /// There was no memory left: something is missing.
    pub(super) is_short: bool,
}

/// A contribution to an entry of the host's vector.
struct Force {
    node: usize,
    entry: usize,
    value: f64,
}

/// Contributions to a row of a node in the host's sparse matrix.
struct Row {
    node: usize,
    places: Places,
    length: usize,
}

/// Numbers that a row takes beside its contributions.
pub(super) const ROW: usize = size_of::<Row>().div_ceil(size_of::<f64>());

/// Where a journal is added.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    pub(super) global_f: *mut f64,
    pub(super) csr_values: *mut f64,
}

impl Journal {
    pub(super) fn clear(&mut self) {
        self.forces.clear();
        self.rows.clear();
        self.values.clear();
    }

    /// How many numbers it holds.
    pub(super) fn length(&self) -> usize {
        self.forces.len() + self.values.len()
    }

    fn note_force(&mut self, force: Force) {
        self.is_short |= self.forces.try_reserve(1).is_err();
        if !self.is_short {
            self.forces.push(force);
        }
    }

    fn note_row(&mut self, row: Row, (values, scale): (&[f64], f64)) {
        self.is_short |= self.rows.try_reserve(1).is_err();
        self.is_short |= self.values.try_reserve(row.length).is_err();
        if !self.is_short {
            self.rows.push(row);
            self.values.extend(values.iter().map(|value| scale * value));
        }
    }

    /// Adds what belongs to the nodes of share `share` of `shares`.
    ///
    /// # Safety
    /// The arrays are those of the batch, and nothing else touches entries of these nodes.
    pub(super) unsafe fn add(&self, sums: Sums, share: usize, shares: usize) {
        let belongs = |node: usize| shares == 1 || node / NEIGHBOURS % shares == share;
        for force in &self.forces {
            if belongs(force.node) {
                // SAFETY: promised by the caller.
                unsafe { *sums.global_f.add(force.entry) += force.value };
            }
        }
        let mut first = 0;
        for row in &self.rows {
            let values = self.values.get(first..first + row.length);
            first += row.length;
            if belongs(row.node) {
                // SAFETY: promised by the caller; the map has a place for every value.
                unsafe { row.places.add(sums.csr_values, values.unwrap_or(&[]), 1.0) };
            }
        }
    }
}

/// Who adds to shared entries: the part at work to those of its own nodes.
#[derive(Clone, Copy, Debug)]
pub(in crate::abi) struct Turn {
    journal: *mut Journal,
    marks: *const AtomicUsize,
    mark: usize,
}

impl Turn {
    /// One thread, to all of them.
    pub(in crate::abi) const FREE: Self = Self {
        journal: core::ptr::null_mut(),
        marks: core::ptr::null(),
        mark: 0,
    };

    /// The turn of a part, as long as its journal and the marks live.
    pub(super) fn new(journal: *mut Journal, marks: *const AtomicUsize, mark: usize) -> Self {
        Self {
            journal,
            marks,
            mark,
        }
    }

    /// True where no other part is at work.
    #[inline(always)]
    pub(in crate::abi) fn is_free(&self) -> bool {
        self.journal.is_null()
    }

    /// True where the entries of a node are this part's to add to.
    ///
    /// # Safety
    /// The node is one of the batch.
    #[inline(always)]
    pub(in crate::abi) unsafe fn is_mine(&self, node: usize) -> bool {
        // SAFETY: promised by the caller; every node has a mark.
        self.is_free() || unsafe { (*self.marks.add(node)).load(Ordering::Relaxed) } == self.mark
    }

    /// Writes down a contribution to an entry of the host's vector.
    ///
    /// # Safety
    /// It is another part's turn.
    pub(in crate::abi) unsafe fn note_force(&self, node: usize, entry: usize, value: f64) {
        // SAFETY: the journal is this part's, and nothing else refers to it now.
        unsafe { &mut *self.journal }.note_force(Force { node, entry, value });
    }

    /// Writes down contributions to a row of the host's sparse matrix: their places, values and scale.
    ///
    /// # Safety
    /// It is another part's turn.
    #[inline(never)]
    pub(in crate::abi) unsafe fn note_row(
        &self,
        node: usize,
        places: Places,
        scaled: (&[f64], f64),
    ) {
        let length = scaled.0.len();
        // SAFETY: the journal is this part's, and nothing else refers to it now.
        unsafe { &mut *self.journal }.note_row(
            Row {
                node,
                places,
                length,
            },
            scaled,
        );
    }
}
