//! Where a patch's sums go: arrays with strides, map and scales.

use core::cell::Cell;

use super::checked::HISTORY;
use super::pair::{Answer, Pair};
use crate::element::receiver::OUTPUT_SIZE;
use crate::evaluation::target::Strided;
use crate::point::values::Status;

/// Entries of a point's output.
const PROJECTION: usize = 4;
const FEATURE: usize = 10;

/// Outputs of a patch. Empty arrays are outputs that were not requested.
pub(crate) struct Sums<'a> {
    pub(crate) unknowns: usize,
    pub(crate) f: &'a [Cell<f64>],
    pub(crate) k: Strided<'a>,
    /// Row of the host for every unknown; `None` for the unknowns themselves.
    pub(crate) map: Option<&'a [i32]>,
    pub(crate) f_scale: f64,
    pub(crate) k_scale: f64,
    pub(crate) output: &'a [Cell<f64>],
    pub(crate) history: &'a [Cell<f64>],
    pub(crate) energy: &'a [Cell<f64>],
}

fn add(to: Option<&Cell<f64>>, value: f64) {
    if let Some(to) = to {
        to.set(to.get() + value);
    }
}

impl Sums<'_> {
    /// Row or column of the host for an unknown of the patch.
    fn host(&self, unknown: usize) -> usize {
        match self.map {
            None => unknown,
            // checked on entry: one entry that is not negative for every unknown
            Some(map) => map.get(unknown).map_or(0, |&row| row as usize),
        }
    }

    fn entry(&self, row: usize, column: usize) -> Option<&Cell<f64>> {
        self.k.entry(self.host(row), self.host(column))
    }

    /// Sets f and K to zero.
    pub(crate) fn clear(&self) {
        for i in 0..self.unknowns {
            if let Some(to) = self.f.get(self.host(i)) {
                to.set(0.0);
            }
            if self.k.cells.is_empty() {
                continue;
            }
            for to in (0..self.unknowns).filter_map(|j| self.entry(i, j)) {
                to.set(0.0);
            }
        }
    }

    /// Adds the contribution of a closed pair.
    pub(crate) fn add(&self, pair: &Pair<'_>, answer: &Answer) {
        let n = pair.unknowns();
        let rows = answer.tangent.chunks_exact(n.max(1));
        for (i, (residual, row)) in answer.residual.iter().zip(rows).enumerate().take(n) {
            let unknown = pair.unknown(i);
            add(self.f.get(self.host(unknown)), self.f_scale * residual);
            if self.k.cells.is_empty() {
                continue;
            }
            for (j, value) in row.iter().enumerate() {
                add(self.entry(unknown, pair.unknown(j)), self.k_scale * value);
            }
        }
    }

    /// Writes output and history of a slave point; without a pair it is outside.
    pub(crate) fn report(&self, slave: usize, pair: Option<&Pair<'_>>, answer: &Answer) {
        let (mut output, mut history) = ([0.0; OUTPUT_SIZE], [0.0; HISTORY]);
        match pair {
            None => {
                let outside = f64::from(Status::Outside as i32);
                (output[0], history[0]) = (outside, outside);
            }
            Some(pair) => {
                output = answer.output;
                let [first, second] = pair.place.zeta;
                let feature = f64::from(pair.place.feature);
                (output[PROJECTION], output[PROJECTION + 1]) = (first, second);
                output[FEATURE] = feature;
                let facet = (pair.place.facet + 1) as f64;
                history = [output[0], facet, feature, first, second];
            }
        }
        write(self.output, slave, &output);
        write(self.history, slave, &history);
    }

    /// Writes the energy of all pairs.
    pub(crate) fn energy(&self, energy: f64) {
        write(self.energy, 0, &[energy]);
    }
}

/// Writes row `number` of an array.
fn write(to: &[Cell<f64>], number: usize, values: &[f64]) {
    let own = to.get(number * values.len()..).unwrap_or_default();
    for (to, &value) in own.iter().zip(values) {
        to.set(value);
    }
}
