//! Where the outputs of each contact of a batch go.

use super::ownership::Ownership;
use super::pointers::{cells, if_wanted, outputs};
use super::types::Batch;
use crate::codes::{code, request};
use crate::element::receiver::OUTPUT_SIZE;
use crate::error::Error;
use crate::evaluation::batch::run::Outputs;
use crate::evaluation::batch::shape::Shape;
use crate::evaluation::pattern::sizes;
use crate::evaluation::places::Map;
use crate::evaluation::target::{Entry, Matrix, Share, Shared, Target};
use crate::point::values::Status;

/// The outputs of the contacts, and the distance to those of the next contact.
pub(super) struct Pointers<'s, 'a> {
    shape: &'s Shape<'s>,
    f: *mut f64,
    k: *mut f64,
    output: *mut f64,
    history: *mut f64,
    energy: *mut f64,
    status: *mut i32,
    code: *mut i32,
    sums: Sums<'a>,
}

/// The host's force vector and sparse matrix.
pub(super) struct Sums<'a> {
    pub(super) global_f: *mut f64,
    pub(super) csr_values: *mut f64,
    map: Map<'a>,
    connectivity: &'a [i32],
    nodes: usize,
    dimension: usize,
    /// Which shared entries this thread adds to.
    ownership: Ownership<'a>,
}

impl<'s, 'a> Pointers<'s, 'a> {
    /// The outputs of the contacts of a shape, from contact `first` of the batch on.
    ///
    /// # Safety
    /// The pointers of the batch are valid for the shapes that the header gives as long as this lives.
    pub(super) unsafe fn new(
        shape: &'s Shape<'s>,
        batch: &Batch,
        first: usize,
        map: &'a [i64],
        connectivity: &'a [i32],
        ownership: Ownership<'a>,
    ) -> Self {
        let element = shape.element;
        let asked = |bit: u32, pointer: *mut f64| if_wanted(batch.request, bit, pointer);
        let at = |pointer: *mut f64, apart: usize| {
            if pointer.is_null() {
                pointer
            } else {
                pointer.wrapping_add(first * apart)
            }
        };
        let output = element.points * OUTPUT_SIZE;
        Self {
            shape,
            f: at(asked(request::RESIDUAL, batch.f), shape.f_stride),
            k: at(asked(request::TANGENT, batch.k), shape.k_stride),
            output: at(asked(request::OUTPUT, batch.output), output),
            history: at(
                asked(request::HISTORY, batch.history_trial),
                element.history(),
            ),
            energy: at(asked(request::ENERGY, batch.energy), 1),
            status: batch.status.wrapping_add(first),
            code: if batch.code.is_null() {
                batch.code
            } else {
                batch.code.wrapping_add(first)
            },
            sums: Sums {
                global_f: asked(request::RESIDUAL, batch.global_f),
                csr_values: asked(request::TANGENT, batch.csr_values),
                map: Map::new(map, sizes(element, shape.nslave), shape.by_blocks()),
                connectivity,
                nodes: shape.nodes,
                dimension: element.dimension,
                ownership,
            },
        }
    }
}

impl Outputs for Pointers<'_, '_> {
    #[inline]
    fn target(&mut self, contact: usize) -> Target<'_> {
        let (shape, element) = (self.shape, self.shape.element);
        let unknowns = shape.unknowns();
        let (output, history) = (element.points * OUTPUT_SIZE, element.history());
        let at = |pointer: *mut f64, apart: usize| {
            if pointer.is_null() {
                pointer
            } else {
                pointer.wrapping_add(contact * apart)
            }
        };
        let share = |sums: *mut f64| {
            (!sums.is_null()).then_some(Share {
                sums: &self.sums,
                contact,
            })
        };
        // SAFETY: promised by the caller of `new`: every array has entries for this contact, which nothing else refers
        // to as long as its target lives.
        unsafe {
            Target {
                unknowns,
                dimension: element.dimension,
                history_layout: element.history_layout(),
                f: cells(at(self.f, shape.f_stride), unknowns),
                k: match outputs(at(self.k, shape.k_stride), unknowns * unknowns) {
                    [] => Matrix::None,
                    matrix => Matrix::Dense(matrix),
                },
                map: None,
                f_scale: shape.f_scale,
                k_scale: shape.k_scale,
                global_f: share(self.sums.global_f),
                sparse: share(self.sums.csr_values),
                output: outputs(at(self.output, output), output),
                history: cells(at(self.history, history), history),
                energy: outputs(at(self.energy, 1), 1),
            }
        }
    }

    #[inline]
    fn note(&mut self, contact: usize, result: Result<Status, Error>) {
        let (status, code) = match result {
            Ok(status) => (status, code::SUCCESS),
            Err(error) => (error.status.unwrap_or(Status::Open), error.code),
        };
        // SAFETY: promised by the caller of `new`: one entry per contact.
        unsafe {
            *self.status.add(contact) = status as i32;
            if !self.code.is_null() {
                *self.code.add(contact) = code;
            }
        }
    }
}

impl Sums<'_> {
    /// Model node of a node of a contact.
    #[inline(always)]
    fn node(&self, contact: usize, node: usize) -> usize {
        let number = self.connectivity.get(contact * self.nodes + node);
        number.map_or(0, |&number| number as usize)
    }
}

impl Shared for Sums<'_> {
    #[inline]
    fn add_force(&self, contact: usize, node: usize, component: usize, value: f64) {
        let node = self.node(contact, node);
        let entry = node * self.dimension + component;
        if self.ownership.is_mine(node) {
            // SAFETY: the connectivity was checked against global_nodes, global_f has all their entries.
            unsafe { *self.global_f.add(entry) += value };
        } else {
            self.ownership.note_force(node, entry, value);
        }
    }

    #[inline]
    fn add_row(&self, contact: usize, entry: Entry, values: &[f64], scale: f64) {
        let places = self.map.row(contact, entry);
        if !self.ownership.is_free() {
            let node = self.node(contact, self.map.node(entry.unknown));
            if !self.ownership.is_mine(node) {
                self.ownership.note_row(node, places, values, scale);
                return;
            }
        }
        places.each(values, |place, value| {
            // SAFETY: csr_map has the places of this contact, made by `csr_map` or `csr_blocks` for these values.
            unsafe { *self.csr_values.add(place) += scale * value };
        });
    }
}
