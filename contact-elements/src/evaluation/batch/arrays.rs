//! The inputs of the contacts of a batch.

use super::shape::{Layout, Shape};
use crate::codes::{argument, code};
use crate::element::gather::{Coordinates, Nodes};
use crate::error::Error;
use crate::point::history::History;

/// Input arrays of a batch, as long as its shape says; empty where it has no contacts.
#[derive(Clone, Copy)]
pub(crate) struct Arrays<'a> {
    pub(crate) x: &'a [f64],
    pub(crate) u: Option<&'a [f64]>,
    pub(crate) connectivity: Option<&'a [i32]>,
    pub(crate) parameters: &'a [f64],
    pub(crate) history: Option<History<'a>>,
    pub(crate) slave_row: Option<&'a [f64]>,
}

impl<'a> Arrays<'a> {
    /// Every node of the connectivity is one of the model's.
    pub(crate) fn check(&self, shape: &Shape<'_>) -> Result<(), Error> {
        for (index, &node) in self.connectivity.unwrap_or(&[]).iter().enumerate() {
            if node < 0 || i64::from(node) >= shape.form.global_nodes {
                return Err(Error::new(code::INDEX, argument::CONNECTIVITY, index));
            }
        }
        Ok(())
    }

    /// Parameters of a contact, not checked.
    #[inline(always)]
    pub(crate) fn parameters(&self, shape: &Shape<'_>, contact: usize) -> &'a [f64] {
        let own = self.parameters.get(contact * shape.parameter_stride..);
        own.and_then(|own| own.get(..shape.parameters))
            .unwrap_or_default()
    }

    /// Accepted history of a contact.
    #[inline(always)]
    pub(crate) fn history(&self, shape: &Shape<'_>, contact: usize) -> Option<History<'a>> {
        let size = shape.element.history();
        self.history?.part(contact * size, size)
    }

    /// Row of an interpolated slave.
    #[inline(always)]
    pub(crate) fn slave_row(&self, shape: &Shape<'_>, contact: usize) -> &'a [f64] {
        let size = shape.nslave + 1;
        let own = self.slave_row.and_then(|rows| rows.get(contact * size..));
        own.and_then(|own| own.get(..size)).unwrap_or_default()
    }

    /// Nodes of a contact.
    #[inline(always)]
    pub(crate) fn nodes(&self, shape: &Shape<'_>, contact: usize) -> Nodes<'a> {
        let coordinates = |values: &'a [f64], layout: Layout| Coordinates {
            values,
            offset: contact * layout.element,
            node_stride: layout.node,
            component_stride: layout.component,
        };
        let nodes = shape.nodes;
        Nodes {
            x: coordinates(self.x, shape.x),
            u: self.u.map(|u| coordinates(u, shape.u)),
            connectivity: self.connectivity.map(|list| {
                let own = list.get(contact * nodes..);
                own.and_then(|own| own.get(..nodes)).unwrap_or_default()
            }),
            count: nodes,
        }
    }

    /// So many contacts, from `first` on.
    #[cfg(feature = "threads")]
    pub(crate) fn part(&self, shape: &Shape<'_>, first: usize, count: usize) -> Self {
        let coordinates = |values: &'a [f64], layout: Layout| {
            let length = layout.length - (shape.count - count) * layout.element;
            of(values, first * layout.element, length)
        };
        let (row, history) = (shape.nslave + 1, shape.element.history());
        let parameters = first * shape.parameter_stride;
        Self {
            x: coordinates(self.x, shape.x),
            u: self.u.map(|u| coordinates(u, shape.u)),
            connectivity: self
                .connectivity
                .map(|list| of(list, first * shape.nodes, count * shape.nodes)),
            parameters: self.parameters.get(parameters..).unwrap_or_default(),
            history: self
                .history
                .and_then(|own| own.part(first * history, count * history)),
            slave_row: self.slave_row.map(|own| of(own, first * row, count * row)),
        }
    }
}

/// `count` entries from `first` on.
#[cfg(feature = "threads")]
fn of<T>(values: &[T], first: usize, count: usize) -> &[T] {
    let rest = values.get(first..).unwrap_or_default();
    rest.get(..count).unwrap_or_default()
}
