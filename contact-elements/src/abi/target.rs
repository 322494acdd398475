//! Where the outputs of one element go: the host's arrays with their strides, maps and scales.

use core::cell::Cell;

use super::OUTPUT_SIZE;
use super::places::Map;
use super::threads::Turn;
use crate::runtime::{HistoryLayout, Receiver, Report};

/// Outputs of one element. Null pointers are outputs that nobody asked for.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    pub(super) unknowns: usize,
    /// The history of a point.
    pub(super) history_layout: HistoryLayout,
    pub(super) f: *mut f64,
    pub(super) k: *mut f64,
    pub(super) row_stride: usize,
    pub(super) column_stride: usize,
    pub(super) map: *const i32,
    pub(super) f_scale: f64,
    pub(super) k_scale: f64,
    pub(super) global_f: *mut f64,
    /// Which shared entries are this element's to add to.
    pub(super) turn: Turn,
    /// Node numbers of the element in `global_f`.
    pub(super) connectivity: *const i32,
    pub(super) dimension: usize,
    pub(super) csr_values: *mut f64,
    /// Places of this element's entries.
    pub(super) csr_map: Map,
    pub(super) output: *mut f64,
    pub(super) history: *const Cell<f64>,
    pub(super) energy: *mut f64,
}

impl Target {
    /// Row or column of the host for an unknown.
    #[inline(always)]
    fn host(&self, unknown: usize) -> usize {
        if self.map.is_null() {
            unknown
        } else {
            // SAFETY: the map has one non-negative entry per unknown, checked on entry.
            unsafe { *self.map.add(unknown) as usize }
        }
    }

    /// Entry of the host's matrix.
    ///
    /// # Safety
    /// There is a matrix with these rows.
    #[inline(always)]
    unsafe fn entry(&self, row: usize, column: usize) -> *mut f64 {
        // SAFETY: promised by the caller.
        unsafe {
            self.k
                .add(row * self.row_stride + column * self.column_stride)
        }
    }

    /// Writes a row whose entries stand side by side in the host's matrix.
    #[inline(always)]
    fn dense_row(&self, unknown: usize, row: &[f64], first: bool) {
        // SAFETY: k has a row of this length for every unknown, and nothing else refers to it now.
        let to = unsafe {
            core::slice::from_raw_parts_mut(self.k.add(unknown * self.row_stride), row.len())
        };
        if first && self.k_scale == 1.0 {
            to.copy_from_slice(row);
            return;
        }
        for (to, &value) in to.iter_mut().zip(row) {
            let value = self.k_scale * value;
            *to = if first { value } else { *to + value };
        }
    }

    /// Writes a row through strides, a map or into a sparse matrix.
    // a call: it would be repeated in every kernel
    #[inline(never)]
    fn strided_row(&self, unknown: usize, row: &[f64], first: bool) {
        if !self.k.is_null() {
            let host = self.host(unknown);
            for (column, &value) in row.iter().enumerate() {
                let value = self.k_scale * value;
                // SAFETY: k has an entry for every pair of host rows.
                unsafe {
                    let entry = self.entry(host, self.host(column));
                    *entry = if first { value } else { *entry + value };
                }
            }
        }
        if !self.csr_values.is_null() {
            self.scatter(unknown, 0, row);
        }
    }

    /// Adds to an entry of the host's vector.
    #[inline(always)]
    fn add_force(&self, node: usize, component: usize, value: f64) {
        // SAFETY: the connectivity was checked against global_nodes, global_f has all their entries.
        unsafe {
            let node = *self.connectivity.add(node) as usize;
            let entry = node * self.dimension + component;
            if self.turn.is_mine(node) {
                *self.global_f.add(entry) += value;
            } else {
                self.turn.note_force(node, entry, value);
            }
        }
    }

    /// Adds to the host's sparse row, from a column of the element on.
    fn scatter(&self, unknown: usize, column: usize, values: &[f64]) {
        // SAFETY: csr_map has the places of this element, made by `csr_map` or `csr_blocks` for these values; the
        // connectivity was checked.
        unsafe {
            let places = self.csr_map.row(unknown, column);
            if !self.turn.is_free() {
                let (node, _) = self.csr_map.node(unknown);
                let node = *self.connectivity.add(node) as usize;
                if !self.turn.is_mine(node) {
                    self.turn.note_row(node, places, (values, self.k_scale));
                    return;
                }
            }
            places.add(self.csr_values, values, self.k_scale);
        }
    }

    /// Writes the trial history of a point: status and ζ; with friction the anchor and the slip path too; with
    /// rolling the anchors and paths of both angles and the regime; of edges the normal; a multiplier last.
    fn trial(&mut self, point: usize, report: &Report) {
        let layout = self.history_layout;
        let size = layout.size();
        let rolling = &report.rolling;
        // SAFETY: the history has `size` entries per point.
        let entries = unsafe { core::slice::from_raw_parts(self.history.add(point * size), size) };
        let status = [f64::from(report.status as i32)];
        let zeta = report.zeta.iter().take(layout.projected);
        let anchor = report.anchor.iter().take(layout.projected);
        let slid = anchor.chain([&report.path]).take(layout.slip);
        let rolled = rolling.anchor.iter().chain(&rolling.path);
        let rolled = rolled.chain([&rolling.regime]);
        let values = status
            .iter()
            .chain(zeta)
            .chain(slid)
            .chain(rolled.take(layout.rolling))
            .chain(report.normal.iter().take(layout.side))
            .chain([&report.multiplier]);
        for (entry, &value) in entries.iter().zip(values) {
            entry.set(value);
        }
    }

    /// Replaces K by (K + Kᵀ)/2.
    pub(super) fn symmetrise(&mut self) {
        for i in 0..self.unknowns {
            for j in 0..i {
                let (row, column) = (self.host(i), self.host(j));
                // SAFETY: the host's matrix holds every pair of its rows, see the header.
                unsafe {
                    let lower = self.entry(row, column);
                    let upper = self.entry(column, row);
                    let mean = 0.5 * (*lower + *upper);
                    *lower = mean;
                    *upper = mean;
                }
            }
        }
    }
}

impl Receiver for Target {
    #[inline(never)]
    fn open(&mut self, unknowns: usize) {
        if self.map.is_null() && self.column_stride == 1 && self.row_stride == unknowns {
            // SAFETY: f has an entry for every unknown, k all pairs of them.
            unsafe {
                if !self.f.is_null() {
                    core::ptr::write_bytes(self.f, 0, unknowns);
                }
                if !self.k.is_null() {
                    core::ptr::write_bytes(self.k, 0, unknowns * unknowns);
                }
            }
            return;
        }
        for i in 0..unknowns {
            // SAFETY: f has an entry for every host row, k for every pair of them.
            unsafe {
                if !self.f.is_null() {
                    *self.f.add(self.host(i)) = 0.0;
                }
                if !self.k.is_null() {
                    for j in 0..unknowns {
                        *self.entry(self.host(i), self.host(j)) = 0.0;
                    }
                }
            }
        }
    }

    #[inline(never)]
    fn clear(&mut self, unknown: usize) {
        // SAFETY: f has an entry for every host row, k for every pair of them.
        unsafe {
            let row = self.host(unknown);
            if !self.f.is_null() {
                *self.f.add(row) = 0.0;
            }
            if !self.k.is_null() {
                for other in 0..self.unknowns {
                    let other = self.host(other);
                    *self.entry(row, other) = 0.0;
                    *self.entry(other, row) = 0.0;
                }
            }
        }
    }

    #[inline(always)]
    fn force(&mut self, (node, component): (usize, usize), value: f64, first: bool) {
        let unknown = node * self.dimension + component;
        let value = self.f_scale * value;
        if !self.f.is_null() {
            // SAFETY: f has an entry for every host row.
            unsafe {
                let entry = self.f.add(self.host(unknown));
                *entry = if first { value } else { *entry + value };
            }
        }
        if !self.global_f.is_null() {
            self.add_force(node, component, value);
        }
    }

    #[inline(always)]
    fn forces(&mut self, forces: &[f64], dimension: usize) {
        if self.f.is_null() || !self.map.is_null() || !self.global_f.is_null() {
            for (node, force) in forces.chunks(dimension).enumerate() {
                for (component, &value) in force.iter().enumerate() {
                    self.force((node, component), value, true);
                }
            }
            return;
        }
        let scale = self.f_scale;
        // SAFETY: f has an entry for every unknown, and nothing else refers to it now.
        let to = unsafe { core::slice::from_raw_parts_mut(self.f, forces.len()) };
        for (to, &value) in to.iter_mut().zip(forces) {
            *to = scale * value;
        }
    }

    #[inline(always)]
    fn rows(&mut self) -> Option<(&mut [f64], usize)> {
        let n = self.unknowns;
        let is_dense = self.map.is_null() && self.column_stride == 1 && self.row_stride == n;
        if self.k.is_null() || !is_dense || self.k_scale != 1.0 || !self.csr_values.is_null() {
            return None;
        }
        // SAFETY: k has all pairs of unknowns, and nothing else refers to it now.
        Some((unsafe { core::slice::from_raw_parts_mut(self.k, n * n) }, n))
    }

    #[inline(always)]
    fn row(&mut self, unknown: usize, row: &[f64], first: bool) {
        if !self.k.is_null()
            && self.map.is_null()
            && self.column_stride == 1
            && self.csr_values.is_null()
        {
            self.dense_row(unknown, row, first);
        } else {
            self.strided_row(unknown, row, first);
        }
    }

    fn multiplier(&mut self, (node, unknown): (usize, usize), value: f64) {
        let value = self.f_scale * value;
        if !self.f.is_null() {
            // SAFETY: f has an entry for every host row.
            unsafe { *self.f.add(self.host(unknown)) += value };
        }
        if !self.global_f.is_null() {
            self.add_force(node, 0, value);
        }
    }

    #[inline]
    fn coupling(&mut self, row: usize, column: usize, value: f64) {
        if !self.csr_values.is_null() {
            self.scatter(row, column, &[value]);
        }
        if !self.k.is_null() {
            let value = self.k_scale * value;
            let (row, column) = (self.host(row), self.host(column));
            // SAFETY: k has an entry for every pair of host rows.
            unsafe { *self.entry(row, column) += value };
        }
    }

    #[inline(always)]
    fn reports(&self) -> bool {
        !self.output.is_null() || !self.history.is_null()
    }

    #[inline(never)]
    fn report(&mut self, point: usize, report: &Report) {
        if !self.output.is_null() {
            let [first, second] = report.zeta;
            let [x, y, z] = report.normal;
            let [b, c] = report.tangents;
            let values: [f64; OUTPUT_SIZE] = [
                f64::from(report.status as i32),
                report.gap,
                report.traction,
                report.weight,
                first,
                second,
                x,
                y,
                z,
                f64::from(report.iterations),
                f64::from(report.feature),
                report.tangential[0],
                report.tangential[1],
                b[0],
                b[1],
                b[2],
                c[0],
                c[1],
                c[2],
                report.rolling.angle[0],
                report.rolling.angle[1],
                report.rolling.moment[0],
                report.rolling.moment[1],
            ];
            // SAFETY: output has OUTPUT_SIZE entries per point.
            unsafe {
                let to = self.output.add(point * OUTPUT_SIZE);
                core::ptr::copy_nonoverlapping(values.as_ptr(), to, OUTPUT_SIZE);
            }
        }
        if !self.history.is_null() {
            self.trial(point, report);
        }
    }

    fn energy(&mut self, energy: f64) {
        if !self.energy.is_null() {
            // SAFETY: energy has one entry.
            unsafe { *self.energy = energy };
        }
    }
}
