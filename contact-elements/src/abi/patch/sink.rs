//! Where a patch's sums go: the host's arrays with their strides, map and scales.

use super::super::evaluate::{host_rows, scale, strides};
use super::super::sizes::Fault;
use super::super::types::Arguments;
use super::super::{OUTPUT_SIZE, argument, code, request};
use super::HISTORY;
use super::checked::Checked;
use super::pair::{Answer, Pair};
use crate::runtime::Status;

/// Entries of a point's output.
const PROJECTION: usize = 4;
const FEATURE: usize = 10;

/// Outputs of a patch. Null pointers are outputs that nobody asked for.
pub(super) struct Sink {
    unknowns: usize,
    f: *mut f64,
    k: *mut f64,
    strides: (usize, usize),
    map: *const i32,
    f_scale: f64,
    k_scale: f64,
    output: *mut f64,
    history: *mut f64,
    energy: *mut f64,
}

impl Sink {
    /// Of the arguments; every output that is wanted must be there.
    ///
    /// # Safety
    /// The pointers of `arguments` are valid for the shapes that the header gives, or null.
    pub(super) unsafe fn new(checked: &Checked<'_>, arguments: &Arguments) -> Result<Self, Fault> {
        let wanted = |bit: u32, pointer: *mut f64, name: i32| {
            if arguments.request & bit == 0 {
                Ok(core::ptr::null_mut())
            } else if pointer.is_null() {
                Err((code::NULL, name, 0))
            } else {
                Ok(pointer)
            }
        };
        let unknowns = checked.unknowns();
        let k = wanted(request::TANGENT, arguments.k, argument::K)?;
        // SAFETY: promised by the caller.
        let rows = unsafe { host_rows(arguments.unknown_map, unknowns)? };
        Ok(Self {
            unknowns,
            f: wanted(request::RESIDUAL, arguments.f, argument::F)?,
            k,
            strides: if k.is_null() {
                (0, 0)
            } else {
                strides(arguments.k_row_stride, arguments.k_col_stride, rows)?
            },
            map: arguments.unknown_map,
            f_scale: scale(arguments.f_scale)?,
            k_scale: scale(arguments.k_scale)?,
            output: wanted(request::OUTPUT, arguments.output, argument::OUTPUT)?,
            history: wanted(
                request::HISTORY,
                arguments.history_trial,
                argument::HISTORY_TRIAL,
            )?,
            energy: wanted(request::ENERGY, arguments.energy, argument::ENERGY)?,
        })
    }

    /// Row or column of the host for an unknown of the patch.
    fn host(&self, unknown: usize) -> usize {
        if self.map.is_null() {
            unknown
        } else {
            // SAFETY: the map has one non-negative entry per unknown, checked on entry.
            unsafe { *self.map.add(unknown) as usize }
        }
    }

    fn place(&self, row: usize, column: usize) -> usize {
        self.host(row) * self.strides.0 + self.host(column) * self.strides.1
    }

    /// Sets f and K to zero.
    pub(super) fn clear(&self) {
        for i in 0..self.unknowns {
            // SAFETY: f has an entry for every host row, k for every pair of them.
            unsafe {
                if !self.f.is_null() {
                    *self.f.add(self.host(i)) = 0.0;
                }
                if !self.k.is_null() {
                    for j in 0..self.unknowns {
                        *self.k.add(self.place(i, j)) = 0.0;
                    }
                }
            }
        }
    }

    /// Adds what a closed pair gives.
    pub(super) fn add(&self, pair: &Pair, answer: &Answer) {
        let n = pair.unknowns();
        let rows = answer.tangent.chunks_exact(n.max(1));
        for (i, (residual, row)) in answer.residual.iter().zip(rows).enumerate().take(n) {
            let unknown = pair.unknown(i);
            // SAFETY: f has an entry for every host row, k for every pair of them.
            unsafe {
                if !self.f.is_null() {
                    *self.f.add(self.host(unknown)) += self.f_scale * residual;
                }
                if !self.k.is_null() {
                    for (j, value) in row.iter().enumerate() {
                        let at = self.place(unknown, pair.unknown(j));
                        *self.k.add(at) += self.k_scale * value;
                    }
                }
            }
        }
    }

    /// Writes output and history of a slave point; without a pair it is outside.
    pub(super) fn report(&self, slave: usize, pair: Option<&Pair>, answer: &Answer) {
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
        // SAFETY: both arrays have a row for every slave point.
        unsafe {
            if !self.output.is_null() {
                let to = self.output.add(slave * OUTPUT_SIZE);
                core::ptr::copy_nonoverlapping(output.as_ptr(), to, OUTPUT_SIZE);
            }
            if !self.history.is_null() {
                let to = self.history.add(slave * HISTORY);
                core::ptr::copy_nonoverlapping(history.as_ptr(), to, HISTORY);
            }
        }
    }

    /// Writes the energy of all pairs.
    pub(super) fn energy(&self, energy: f64) {
        if !self.energy.is_null() {
            // SAFETY: energy has one entry.
            unsafe { *self.energy = energy };
        }
    }
}
