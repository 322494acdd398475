//! Contributions to entries of another part's nodes: recorded while the parts work, added when all are done.

use std::vec::Vec;

use crate::evaluation::places::Places;

/// Nodes whose entries one thread adds up when journals are read: several, so that threads do not write side by side.
const NEIGHBOURS: usize = 16;

/// What one part records, in the order in which it would have added it.
#[derive(Default)]
pub(super) struct Journal<'a> {
    forces: Vec<Force>,
    rows: Vec<Row<'a>>,
    /// The values of all rows, one after another.
    values: Vec<f64>,
    /// The memory ran out and some contributions are missing.
    pub(super) is_short: bool,
}

/// A contribution to an entry of the host's vector.
struct Force {
    node: usize,
    entry: usize,
    value: f64,
}

/// Contributions to a row of a node in the host's sparse matrix.
struct Row<'a> {
    node: usize,
    places: Places<'a>,
    length: usize,
}

/// Numbers that a row takes in addition to its contributions.
pub(super) const ROW: usize = size_of::<Row<'_>>().div_ceil(size_of::<f64>());

/// Arrays that a journal is added to.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    pub(super) global_f: *mut f64,
    pub(super) csr_values: *mut f64,
}

impl<'a> Journal<'a> {
    pub(super) fn clear(&mut self) {
        self.forces.clear();
        self.rows.clear();
        self.values.clear();
    }

    /// How many numbers it holds.
    pub(super) fn length(&self) -> usize {
        self.forces.len() + self.values.len()
    }

    pub(super) fn note_force(&mut self, node: usize, entry: usize, value: f64) {
        self.is_short |= self.forces.try_reserve(1).is_err();
        if !self.is_short {
            self.forces.push(Force { node, entry, value });
        }
    }

    pub(super) fn note_row(&mut self, node: usize, places: Places<'a>, values: &[f64], scale: f64) {
        let length = values.len();
        self.is_short |= self.rows.try_reserve(1).is_err();
        self.is_short |= self.values.try_reserve(length).is_err();
        if !self.is_short {
            self.rows.push(Row {
                node,
                places,
                length,
            });
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
                row.places.each(values.unwrap_or(&[]), |place, value| {
                    // SAFETY: promised by the caller; the map has a place for every value.
                    unsafe { *sums.csr_values.add(place) += value };
                });
            }
        }
    }
}
