//! Sums of a model that the contacts of a batch add to.

use core::cell::Cell;

use crate::codes::{argument, code};
use crate::error::Error;
use crate::evaluation::places::Map;
use crate::evaluation::target::{Entry, Shared};

/// Forces and sparse matrix of a model, which contacts add to.
#[derive(Debug, Default)]
pub struct Assembly<'a> {
    /// Force vector \[model nodes · dimension\]; empty if not requested.
    pub force: &'a mut [f64],
    /// Values of the sparse matrix; empty if not requested.
    pub matrix: &'a mut [f64],
    /// Scatter map of the contacts, by [`scatter_map`](crate::scatter_map) or
    /// [`scatter_blocks`](crate::scatter_blocks).
    pub map: &'a [i64],
    /// True for a map by [`scatter_blocks`](crate::scatter_blocks).
    pub by_blocks: bool,
}

/// The same while a batch is at work.
pub(super) struct Sums<'a> {
    pub(super) force: &'a [Cell<f64>],
    pub(super) matrix: &'a [Cell<f64>],
    pub(super) map: Map<'a>,
    pub(super) connectivity: &'a [i32],
    pub(super) nodes: usize,
    pub(super) dimension: usize,
}

impl Sums<'_> {
    /// Every place of the map is one of the matrix.
    pub(super) fn check(&self) -> Result<(), Error> {
        let beyond = self.map.first_beyond(self.matrix.len());
        let fault = beyond.filter(|_| !self.matrix.is_empty());
        fault.map_or(Ok(()), |contact| {
            Err(Error::new(code::INDEX, argument::CSR, contact))
        })
    }
}

fn add(to: Option<&Cell<f64>>, value: f64) {
    if let Some(to) = to {
        to.set(to.get() + value);
    }
}

impl Shared for Sums<'_> {
    fn add_force(&self, contact: usize, node: usize, component: usize, value: f64) {
        let number = self.connectivity.get(contact * self.nodes + node);
        let entry = number.map_or(0, |&node| node as usize) * self.dimension + component;
        add(self.force.get(entry), value);
    }

    fn add_row(&self, contact: usize, entry: Entry, values: &[f64], scale: f64) {
        let places = self.map.row(contact, entry);
        places.each(values, |place, value| {
            add(self.matrix.get(place), scale * value);
        });
    }
}
