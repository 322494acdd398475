//! From a row of K to the values of a sparse matrix.

use super::target::Entry;

/// Where the entries of the contacts' matrices stand in a sparse matrix.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Map<'a> {
    /// The places of all contacts.
    places: &'a [i64],
    /// From contact to contact.
    step: usize,
    unknowns: usize,
    dimension: usize,
    /// Nodes, and how many of them have a position; 0 nodes: a place for every entry.
    nodes: usize,
    positions: usize,
}

/// The places of a row of K, from a column on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Places<'a> {
    /// Places of the row's entries from the column on, or of the blocks of the row's node.
    places: &'a [i64],
    /// For blocks: distance of the row from the first row of its node.
    shift: usize,
    /// For blocks: the column.
    column: usize,
    /// For blocks: unknowns with a position and components of a node; otherwise 0.
    bound: usize,
    dimension: usize,
}

/// Sizes of a contact for a [`Map`].
#[derive(Clone, Copy)]
pub(crate) struct Contact {
    pub(crate) nodes: usize,
    /// Nodes with a position.
    pub(crate) positions: usize,
    pub(crate) dimension: usize,
    pub(crate) unknowns: usize,
}

impl Contact {
    /// Places of a contact.
    pub(crate) fn places(&self, by_blocks: bool) -> usize {
        if by_blocks {
            self.nodes * (self.nodes + 1)
        } else {
            self.unknowns * self.unknowns
        }
    }
}

impl<'a> Map<'a> {
    /// The map of contacts of one size: a place for every entry, or for every pair of nodes.
    pub(crate) fn new(places: &'a [i64], contact: Contact, by_blocks: bool) -> Self {
        Self {
            places,
            step: contact.places(by_blocks),
            unknowns: contact.unknowns,
            dimension: contact.dimension,
            nodes: if by_blocks { contact.nodes } else { 0 },
            positions: contact.positions,
        }
    }

    /// Node of an unknown.
    #[inline(always)]
    pub(crate) fn node(&self, unknown: usize) -> usize {
        place(unknown, self.positions * self.dimension, self.dimension).0
    }

    /// The first contact with a place that a matrix of so many values does not have.
    pub(crate) fn first_beyond(&self, values: usize) -> Option<usize> {
        let is_beyond = |contact: &[i64]| {
            if self.nodes == 0 {
                return contact.iter().any(|&place| !exists(place, 0, values));
            }
            let rows = contact.chunks_exact(self.nodes + 1).enumerate();
            rows.into_iter().any(|(node, row)| {
                let apart = row.last().copied().unwrap_or(0);
                let below = (self.components(node) as i64 - 1).saturating_mul(apart);
                let blocks = row.iter().take(self.nodes).enumerate();
                blocks.into_iter().any(|(node, &place)| {
                    let last = below.saturating_add(self.components(node) as i64 - 1);
                    apart < 0 || !exists(place, last, values)
                })
            })
        };
        self.places
            .chunks_exact(self.step.max(1))
            .position(is_beyond)
    }

    /// Unknowns of a node.
    fn components(&self, node: usize) -> usize {
        if node < self.positions {
            self.dimension
        } else {
            1
        }
    }

    /// The places of a contact's row.
    #[inline(always)]
    pub(crate) fn row(&self, contact: usize, entry: Entry) -> Places<'a> {
        let Entry { unknown, column } = entry;
        let from = |first: usize| self.places.get(contact * self.step + first..);
        if self.nodes == 0 {
            return Places {
                places: from(unknown * self.unknowns + column).unwrap_or_default(),
                shift: 0,
                column,
                bound: 0,
                dimension: 0,
            };
        }
        let bound = self.positions * self.dimension;
        let (node, component) = place(unknown, bound, self.dimension);
        let places = from(node * (self.nodes + 1)).unwrap_or_default();
        let apart = places.get(self.nodes).copied().unwrap_or(0);
        Places {
            places,
            shift: component * apart as usize,
            column,
            bound,
            dimension: self.dimension,
        }
    }
}

/// Whether a place and the one `beyond` it are some of so many.
fn exists(place: i64, beyond: i64, values: usize) -> bool {
    let last = place
        .checked_add(beyond)
        .and_then(|last| usize::try_from(last).ok());
    place >= 0 && last.is_some_and(|last| last < values)
}

/// Node and component of an unknown; those from `bound` on are multipliers.
#[inline(always)]
fn place(unknown: usize, bound: usize, dimension: usize) -> (usize, usize) {
    if unknown >= bound {
        (bound / dimension.max(1) + (unknown - bound), 0)
    } else if dimension == 2 {
        (unknown / 2, unknown % 2)
    } else {
        (unknown / 3, unknown % 3)
    }
}

impl Places<'_> {
    /// Passes every value on with its place.
    #[inline(always)]
    pub(crate) fn each(&self, values: &[f64], mut add: impl FnMut(usize, f64)) {
        match self.dimension {
            0 => {
                for (&place, &value) in self.places.iter().zip(values) {
                    add(place as usize, value);
                }
            }
            2 if self.column == 0 => self.blocks::<2>(values, &mut add),
            3 if self.column == 0 => self.blocks::<3>(values, &mut add),
            _ => self.entries(values, self.column, &mut add),
        }
    }

    /// A whole row, block after block.
    #[inline(always)]
    fn blocks<const D: usize>(&self, values: &[f64], add: &mut impl FnMut(usize, f64)) {
        let (blocks, _) = values.get(..self.bound).unwrap_or(values).as_chunks::<D>();
        for (block, &place) in blocks.iter().zip(self.places) {
            let own = place as usize + self.shift;
            for (k, &value) in block.iter().enumerate() {
                add(own + k, value);
            }
        }
        let done = blocks.len() * D;
        self.entries(values.get(done..).unwrap_or_default(), done, add);
    }

    /// Entry by entry, from a column on.
    #[inline(always)]
    fn entries(&self, values: &[f64], column: usize, add: &mut impl FnMut(usize, f64)) {
        for (unknown, &value) in (column..).zip(values) {
            let (node, component) = place(unknown, self.bound, self.dimension);
            let place = self.places.get(node).copied().unwrap_or(0);
            add(place as usize + self.shift + component, value);
        }
    }
}
