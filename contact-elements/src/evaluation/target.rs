//! Where the outputs of one contact go: arrays with strides, maps and scales, and sums that contacts share.

use core::cell::Cell;

use crate::element::gather::Nodes;
use crate::element::receiver::{Call, InputError, OUTPUT_SIZE, Receiver, Report, Summary, Write};
use crate::point::history::HistoryLayout;

/// The compiled kernel of an element: inputs, nodes, workspace, outputs.
pub type Kernel =
    fn(&Call<'_>, &Nodes<'_>, &mut [f64], &mut Target<'_>) -> Result<Summary, InputError>;

/// Sums that the contacts of a batch share: the forces and the sparse matrix of a model.
pub(crate) trait Shared {
    /// Adds to the entry of a contact's node in the vector.
    fn add_force(&self, contact: usize, node: usize, component: usize, value: f64);

    /// Adds `scale` times the values to a contact's row of the matrix, from `column` on.
    fn add_row(&self, contact: usize, entry: Entry, values: &[f64], scale: f64);
}

/// Where a part of a row of K begins: unknowns of the contact.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) unknown: usize,
    pub(crate) column: usize,
}

/// The share of one contact in such sums.
#[derive(Clone, Copy)]
pub(crate) struct Share<'a> {
    pub(crate) sums: &'a dyn Shared,
    pub(crate) contact: usize,
}

/// A matrix of the host for one contact.
pub(crate) enum Matrix<'a> {
    /// The matrix was not requested.
    None,
    /// All pairs of unknowns, row after row.
    Dense(&'a mut [f64]),
    /// Entries apart; cells, because other arrays may lie in the gaps.
    Strided(Strided<'a>),
}

/// Entries of a matrix that are apart.
#[derive(Clone, Copy)]
pub(crate) struct Strided<'a> {
    pub(crate) cells: &'a [Cell<f64>],
    pub(crate) row: usize,
    pub(crate) column: usize,
}

impl Strided<'_> {
    /// One entry of the host's matrix.
    #[inline(always)]
    pub(crate) fn entry(&self, row: usize, column: usize) -> Option<&Cell<f64>> {
        self.cells.get(row * self.row + column * self.column)
    }
}

/// Outputs of one contact. Empty arrays are outputs that were not requested.
pub struct Target<'a> {
    pub(crate) unknowns: usize,
    pub(crate) dimension: usize,
    /// The history of a point.
    pub(crate) history_layout: HistoryLayout,
    pub(crate) f: &'a [Cell<f64>],
    pub(crate) k: Matrix<'a>,
    /// Row of the host for every unknown; `None` for the unknowns themselves.
    pub(crate) map: Option<&'a [i32]>,
    pub(crate) f_scale: f64,
    pub(crate) k_scale: f64,
    pub(crate) global_f: Option<Share<'a>>,
    pub(crate) sparse: Option<Share<'a>>,
    pub(crate) output: &'a mut [f64],
    pub(crate) history: &'a [Cell<f64>],
    pub(crate) energy: &'a mut [f64],
}

impl core::fmt::Debug for Target<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut shown = f.debug_struct("Target");
        shown.field("unknowns", &self.unknowns);
        shown.finish_non_exhaustive()
    }
}

/// Writes or adds.
#[inline(always)]
fn put(cell: Option<&Cell<f64>>, value: f64, write: Write) {
    if let Some(cell) = cell {
        cell.set(match write {
            Write::Replace => value,
            Write::Add => cell.get() + value,
        });
    }
}

impl Target<'_> {
    /// Row or column of the host for an unknown.
    #[inline(always)]
    fn host(&self, unknown: usize) -> usize {
        match self.map {
            None => unknown,
            // checked on entry: one entry that is not negative for every unknown
            Some(map) => map.get(unknown).map_or(0, |&row| row as usize),
        }
    }

    /// Writes a row whose entries stand side by side in the host's matrix.
    #[inline(always)]
    fn dense_row(&mut self, unknown: usize, row: &[f64], write: Write) {
        let Matrix::Dense(k) = &mut self.k else {
            return;
        };
        let to = k.get_mut(unknown * self.unknowns..);
        let Some(to) = to.and_then(|to| to.get_mut(..row.len())) else {
            return;
        };
        if write == Write::Replace && self.k_scale == 1.0 {
            to.copy_from_slice(row);
            return;
        }
        for (to, &value) in to.iter_mut().zip(row) {
            let value = self.k_scale * value;
            *to = match write {
                Write::Replace => value,
                Write::Add => *to + value,
            };
        }
    }

    /// Writes a row through strides, a map or into a sparse matrix.
    // a call: it would be repeated in every kernel
    #[inline(never)]
    fn strided_row(&mut self, unknown: usize, row: &[f64], write: Write) {
        match &self.k {
            Matrix::None => {}
            Matrix::Dense(_) => self.dense_row(unknown, row, write),
            Matrix::Strided(k) => {
                let host = self.host(unknown);
                for (column, &value) in row.iter().enumerate() {
                    put(
                        k.entry(host, self.host(column)),
                        self.k_scale * value,
                        write,
                    );
                }
            }
        }
        if let Some(Share { sums, contact }) = self.sparse {
            let column = 0;
            sums.add_row(contact, Entry { unknown, column }, row, self.k_scale);
        }
    }

    /// Adds to one entry through strides, a map or into a sparse matrix.
    #[inline(never)]
    fn coupling_apart(&mut self, row: usize, column: usize, value: f64) {
        let scaled = self.k_scale * value;
        match &mut self.k {
            Matrix::None => {}
            Matrix::Dense(k) => {
                if let Some(entry) = k.get_mut(row * self.unknowns + column) {
                    *entry += scaled;
                }
            }
            Matrix::Strided(k) => {
                let k = *k;
                put(
                    k.entry(self.host(row), self.host(column)),
                    scaled,
                    Write::Add,
                );
            }
        }
        if let Some(Share { sums, contact }) = self.sparse {
            let unknown = row;
            sums.add_row(contact, Entry { unknown, column }, &[value], self.k_scale);
        }
    }

    /// Writes the trial history of a point: status and ζ; with friction also anchor and slip path; with
    /// rolling the anchors and paths of both angles and the regime; for edges the normal; a multiplier last.
    fn trial(&self, point: usize, report: &Report) {
        let layout = self.history_layout;
        let first = point * layout.size();
        let mut entries = self.history.get(first..).unwrap_or_default().iter();
        let mut put = |values: &[f64]| {
            for (&value, entry) in values.iter().zip(&mut entries) {
                entry.set(value);
            }
        };
        put(&[f64::from(report.status as i32)]);
        put(report.zeta.get(..layout.projected).unwrap_or(&[]));
        if layout.slip > 0 {
            put(report.anchor.get(..layout.projected).unwrap_or(&[]));
            put(&[report.path]);
        }
        if layout.rolling > 0 {
            put(&report.rolling.anchor);
            put(&report.rolling.path);
            put(&[report.rolling.regime]);
        }
        put(report.normal.get(..layout.side).unwrap_or(&[]));
        if layout.multiplier > 0 {
            put(&[report.multiplier]);
        }
    }

    /// Replaces K by (K + Kᵀ)/2.
    pub(crate) fn symmetrise(&mut self) {
        let n = self.unknowns;
        for i in 0..n {
            for j in 0..i {
                let (row, column) = (self.host(i), self.host(j));
                match &mut self.k {
                    Matrix::None => return,
                    Matrix::Dense(k) => {
                        let both = k.get(i * n + j).zip(k.get(j * n + i));
                        let mean = both.map_or(0.0, |(lower, upper)| 0.5 * (*lower + *upper));
                        for entry in [i * n + j, j * n + i] {
                            if let Some(to) = k.get_mut(entry) {
                                *to = mean;
                            }
                        }
                    }
                    Matrix::Strided(k) => {
                        let both = k.entry(row, column).zip(k.entry(column, row));
                        if let Some((lower, upper)) = both {
                            let mean = 0.5 * (lower.get() + upper.get());
                            lower.set(mean);
                            upper.set(mean);
                        }
                    }
                }
            }
        }
    }
}

impl Receiver for Target<'_> {
    #[inline(never)]
    fn open(&mut self, unknowns: usize) {
        if !self.f.is_empty() {
            for i in 0..unknowns {
                put(self.f.get(self.host(i)), 0.0, Write::Replace);
            }
        }
        match &mut self.k {
            Matrix::None => {}
            Matrix::Dense(k) => k.fill(0.0),
            Matrix::Strided(k) => {
                let k = *k;
                for i in 0..unknowns {
                    for j in 0..unknowns {
                        put(k.entry(self.host(i), self.host(j)), 0.0, Write::Replace);
                    }
                }
            }
        }
    }

    #[inline(never)]
    fn clear(&mut self, unknown: usize) {
        let (n, row) = (self.unknowns, self.host(unknown));
        put(self.f.get(row), 0.0, Write::Replace);
        match &mut self.k {
            Matrix::None => {}
            Matrix::Dense(k) => {
                let own = k.get_mut(unknown * n..).and_then(|own| own.get_mut(..n));
                own.unwrap_or_default().fill(0.0);
                for row in k.chunks_exact_mut(n.max(1)) {
                    if let Some(entry) = row.get_mut(unknown) {
                        *entry = 0.0;
                    }
                }
            }
            Matrix::Strided(k) => {
                let k = *k;
                for other in 0..n {
                    let other = self.host(other);
                    put(k.entry(row, other), 0.0, Write::Replace);
                    put(k.entry(other, row), 0.0, Write::Replace);
                }
            }
        }
    }

    #[inline(always)]
    fn force(&mut self, (node, component): (usize, usize), value: f64, write: Write) {
        let value = self.f_scale * value;
        let unknown = self.host(node * self.dimension + component);
        put(self.f.get(unknown), value, write);
        if let Some(Share { sums, contact }) = self.global_f {
            sums.add_force(contact, node, component, value);
        }
    }

    #[inline(always)]
    fn forces(&mut self, forces: &[f64], dimension: usize) {
        if self.map.is_some() || self.global_f.is_some() {
            for (node, force) in forces.chunks(dimension).enumerate() {
                for (component, &value) in force.iter().enumerate() {
                    self.force((node, component), value, Write::Replace);
                }
            }
            return;
        }
        for (to, &value) in self.f.iter().zip(forces) {
            to.set(self.f_scale * value);
        }
    }

    #[inline(always)]
    fn rows(&mut self) -> Option<(&mut [f64], usize)> {
        match &mut self.k {
            Matrix::Dense(k) if self.k_scale == 1.0 && self.sparse.is_none() => {
                Some((k, self.unknowns))
            }
            _ => None,
        }
    }

    #[inline(always)]
    fn row(&mut self, unknown: usize, row: &[f64], write: Write) {
        if matches!(self.k, Matrix::Dense(_)) && self.sparse.is_none() {
            self.dense_row(unknown, row, write);
        } else {
            self.strided_row(unknown, row, write);
        }
    }

    fn multiplier(&mut self, (node, unknown): (usize, usize), value: f64) {
        let value = self.f_scale * value;
        put(self.f.get(self.host(unknown)), value, Write::Add);
        if let Some(Share { sums, contact }) = self.global_f {
            sums.add_force(contact, node, 0, value);
        }
    }

    #[inline(always)]
    fn coupling(&mut self, row: usize, column: usize, value: f64) {
        match &mut self.k {
            Matrix::Dense(k) if self.sparse.is_none() => {
                if let Some(entry) = k.get_mut(row * self.unknowns + column) {
                    *entry += self.k_scale * value;
                }
            }
            _ => self.coupling_apart(row, column, value),
        }
    }

    #[inline(always)]
    fn reports(&self) -> bool {
        !self.output.is_empty() || !self.history.is_empty()
    }

    #[inline(never)]
    fn report(&mut self, point: usize, report: &Report) {
        let output = self.output.get_mut(point * OUTPUT_SIZE..);
        if let Some(output) = output.and_then(<[f64]>::first_chunk_mut) {
            *output = values(report);
        }
        if !self.history.is_empty() {
            self.trial(point, report);
        }
    }

    fn energy(&mut self, energy: f64) {
        if let Some(to) = self.energy.first_mut() {
            *to = energy;
        }
    }
}

/// The output of a contact point, entry by entry.
fn values(report: &Report) -> [f64; OUTPUT_SIZE] {
    let [first, second] = report.zeta;
    let [x, y, z] = report.normal;
    let [b, c] = report.tangents;
    [
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
    ]
}
