//! The scatter maps into a sparse matrix, made once: a place for every entry, or one for every pair of nodes.

use super::places::Contact;
use super::sizes::slave_count;
use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::error::Error;

/// A sparse matrix by compressed rows, and the contacts that go into it.
#[derive(Clone, Copy, Debug)]
pub struct Sparsity<'a> {
    /// Slave nodes of an interpolated slave; 0 for the others.
    pub slave_nodes: usize,
    /// Nodes of every contact, contact after contact.
    pub connectivity: &'a [i32],
    /// Where each row begins, and the end of the last.
    pub row_start: &'a [i64],
    /// Columns, row after row, ascending in each.
    pub column: &'a [i32],
}

/// Writes a place for every entry of the contacts' matrices: `map` has contacts · unknowns² entries.
///
/// # Errors
/// `map` is untouched: [`INDEX`](crate::code::INDEX) where the matrix lacks an entry,
/// [`NODE_COUNT`](crate::code::NODE_COUNT), [`NULL`](crate::code::NULL) for a map that is too short.
pub fn scatter_map(
    element: &Descriptor,
    sparsity: &Sparsity<'_>,
    map: &mut [i64],
) -> Result<(), Error> {
    Pattern::new(element, sparsity)?.write(map, false)
}

/// Writes a place for every pair of nodes: `map` has contacts · nodes · (nodes + 1) entries. The matrix must hold the
/// components of a node side by side.
///
/// # Errors
/// As [`scatter_map`].
pub fn scatter_blocks(
    element: &Descriptor,
    sparsity: &Sparsity<'_>,
    map: &mut [i64],
) -> Result<(), Error> {
    Pattern::new(element, sparsity)?.write(map, true)
}

/// A sparse matrix and the contacts that go into it, checked.
pub(crate) struct Pattern<'a> {
    element: &'a Descriptor,
    contact: Contact,
    connectivity: &'a [i32],
    starts: &'a [i64],
    columns: &'a [i32],
}

impl<'a> Pattern<'a> {
    fn new(element: &'a Descriptor, sparsity: &Sparsity<'a>) -> Result<Self, Error> {
        let slaves = i32::try_from(sparsity.slave_nodes).unwrap_or(i32::MAX);
        Ok(Self {
            element,
            contact: sizes(element, slave_count(element, slaves)?),
            connectivity: sparsity.connectivity,
            starts: sparsity.row_start,
            columns: sparsity.column,
        })
    }

    /// Contacts that the connectivity lists.
    fn count(&self) -> usize {
        let nodes = self.contact.nodes;
        self.connectivity.len().checked_div(nodes).unwrap_or(0)
    }

    /// Writes the places of all contacts; writes nothing if one of them has no place.
    fn write(&self, map: &mut [i64], by_blocks: bool) -> Result<(), Error> {
        let size = self.contact.places(by_blocks);
        let absent = Error::new(code::INDEX, argument::CSR, 0);
        let length = self.count().checked_mul(size).ok_or(absent)?;
        let map = map.get_mut(..length).ok_or(Error::missing(argument::CSR))?;
        // everything is looked up before anything is written
        for e in 0..self.count() {
            let found = self.places(by_blocks, e, &mut |_| {});
            found.ok_or(Error::new(code::INDEX, argument::CSR, e))?;
        }
        let mut rest = map.iter_mut();
        for e in 0..self.count() {
            self.places(by_blocks, e, &mut |place| {
                if let Some(to) = rest.next() {
                    *to = place as i64;
                }
            });
        }
        Ok(())
    }
}

/// Sizes of a contact with so many slave nodes.
pub(crate) fn sizes(element: &Descriptor, nslave: usize) -> Contact {
    let nodes = element.nodes(nslave);
    Contact {
        nodes,
        positions: nodes - element.multipliers(),
        dimension: element.dimension,
        unknowns: element.unknowns(nodes),
    }
}

impl Pattern<'_> {
    /// The places of contact `e`; `None` where one is missing.
    fn places(&self, by_blocks: bool, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        if by_blocks {
            self.blocks(e, take)
        } else {
            self.entries(e, take)
        }
    }

    /// Row of an element's unknown.
    fn row(&self, e: usize, unknown: usize) -> Option<usize> {
        let (a, component) = self.element.place(self.contact.nodes, unknown);
        let node = usize::try_from(*self.connectivity.get(e * self.contact.nodes + a)?).ok()?;
        let row = node * self.element.dimension + component;
        (row + 1 < self.starts.len()).then_some(row)
    }

    /// Where a row begins, and its columns.
    fn columns(&self, row: usize) -> Option<(usize, &[i32])> {
        let start = usize::try_from(*self.starts.get(row)?).ok()?;
        let end = usize::try_from(*self.starts.get(row + 1)?).ok()?;
        Some((start, self.columns.get(start..end)?))
    }

    /// Where the entries of element `e` stand, row by row; `None` where one is missing.
    fn entries(&self, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        for i in 0..self.contact.unknowns {
            let (start, columns) = self.columns(self.row(e, i)?)?;
            let mut next = 0;
            for j in 0..self.contact.unknowns {
                let wanted = i32::try_from(self.row(e, j)?).ok()?;
                // the components of a node stand side by side
                let found = match columns.get(next) {
                    Some(&column) if column == wanted => next,
                    _ => columns.binary_search(&wanted).ok()?,
                };
                take(start + found);
                next = found + 1;
            }
        }
        Some(())
    }

    /// Where the first entries of the blocks of element `e` stand, node by node, and how far the rows of the node are
    /// apart; `None` where an entry is missing or stands elsewhere.
    fn blocks(&self, e: usize, take: &mut dyn FnMut(usize)) -> Option<()> {
        for a in 0..self.contact.nodes {
            let (first, components) = self.unknowns_of(a);
            let row = self.row(e, first)?;
            let (start, columns) = self.columns(row)?;
            let apart = match components {
                1 => 0,
                _ => self.columns(row + 1)?.0.checked_sub(start)?,
            };
            for b in 0..self.contact.nodes {
                let (unknown, width) = self.unknowns_of(b);
                let wanted = i32::try_from(self.row(e, unknown)?).ok()?;
                let found = columns.binary_search(&wanted).ok()?;
                // the last column of a block may be beyond an i32, where none is
                let wanted = i64::from(wanted);
                for component in 0..components {
                    let (own, columns) = self.columns(row + component)?;
                    let block = columns.get(found..found + width)?;
                    let mut pairs = block.iter().zip(wanted..);
                    let is_there = pairs.all(|(&column, at)| i64::from(column) == at);
                    (is_there && own == start + component * apart).then_some(())?;
                }
                take(start + found);
            }
            take(apart);
        }
        Some(())
    }

    /// The first unknown of a node, and how many it has.
    fn unknowns_of(&self, node: usize) -> (usize, usize) {
        let (d, positions) = (self.contact.dimension, self.contact.positions);
        match node.checked_sub(positions) {
            Some(multiplier) => (positions * d + multiplier, 1),
            None => (node * d, d),
        }
    }
}
