//! From a row of K to the values of the host's sparse matrix.

/// Where the entries of a contact's matrix stand: `csr_map` of a batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    /// Places of this contact.
    pub(super) places: *const i64,
    /// From contact to contact; 0 where there is no map.
    pub(super) step: usize,
    pub(super) unknowns: usize,
    pub(super) dimension: usize,
    /// Nodes, and how many of them have a position; 0 nodes: a place for every entry.
    pub(super) nodes: usize,
    pub(super) positions: usize,
}

/// The places of a row of K, from a column on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Places {
    /// Of the row's entries from the column on, or of the blocks of the row's node.
    places: *const i64,
    /// Of blocks: how far the row is from the first of its node.
    shift: usize,
    /// Of blocks: the column.
    column: usize,
    /// Of blocks: unknowns with a position, components of a node; else 0.
    bound: usize,
    dimension: usize,
}

impl Map {
    /// No sparse matrix.
    pub(super) const NONE: Self = Self {
        places: core::ptr::null(),
        step: 0,
        unknowns: 0,
        dimension: 0,
        nodes: 0,
        positions: 0,
    };

    /// The map of another contact.
    #[inline(always)]
    pub(super) fn of(&self, contact: usize) -> Self {
        Self {
            places: self.places.wrapping_add(contact * self.step),
            ..*self
        }
    }

    /// Node and component of an unknown.
    #[inline(always)]
    pub(super) fn node(&self, unknown: usize) -> (usize, usize) {
        place(unknown, self.positions * self.dimension, self.dimension)
    }

    /// The places of a row from a column on.
    ///
    /// # Safety
    /// The map has the places of this contact.
    #[inline(always)]
    pub(super) unsafe fn row(&self, unknown: usize, column: usize) -> Places {
        // SAFETY: promised by the caller.
        unsafe {
            if self.nodes == 0 {
                return Places {
                    places: self.places.add(unknown * self.unknowns + column),
                    shift: 0,
                    column,
                    bound: 0,
                    dimension: 0,
                };
            }
            let (node, component) = self.node(unknown);
            let places = self.places.add(node * (self.nodes + 1));
            Places {
                places,
                shift: component * *places.add(self.nodes) as usize,
                column,
                bound: self.positions * self.dimension,
                dimension: self.dimension,
            }
        }
    }
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

impl Places {
    /// Adds `scale` times the values.
    ///
    /// # Safety
    /// The places are those of the sparse matrix, there is one for every value, and nothing else refers to them now.
    #[inline(always)]
    pub(super) unsafe fn add(&self, to: *mut f64, values: &[f64], scale: f64) {
        // SAFETY: promised by the caller.
        unsafe {
            match self.dimension {
                0 => {
                    for (place, &value) in values.iter().enumerate() {
                        *to.add(*self.places.add(place) as usize) += scale * value;
                    }
                }
                2 if self.column == 0 => self.add_blocks::<2>(to, values, scale),
                3 if self.column == 0 => self.add_blocks::<3>(to, values, scale),
                _ => self.add_entries(to, (values, self.column), scale),
            }
        }
    }

    /// A whole row, block after block.
    ///
    /// # Safety
    /// As [`Places::add`].
    #[inline(always)]
    unsafe fn add_blocks<const D: usize>(&self, to: *mut f64, values: &[f64], scale: f64) {
        let (blocks, _) = values.get(..self.bound).unwrap_or(values).as_chunks::<D>();
        for (node, block) in blocks.iter().enumerate() {
            // SAFETY: promised by the caller.
            unsafe {
                let own = to.add(*self.places.add(node) as usize + self.shift);
                let sums: [f64; D] = core::array::from_fn(|k| *own.add(k) + scale * block[k]);
                for (k, &sum) in sums.iter().enumerate() {
                    *own.add(k) = sum;
                }
            }
        }
        let done = blocks.len() * D;
        // SAFETY: promised by the caller.
        unsafe { self.add_entries(to, (values.get(done..).unwrap_or_default(), done), scale) }
    }

    /// Entry by entry, from a column on.
    ///
    /// # Safety
    /// As [`Places::add`].
    unsafe fn add_entries(&self, to: *mut f64, (values, column): (&[f64], usize), scale: f64) {
        for (unknown, &value) in (column..).zip(values) {
            let (node, component) = place(unknown, self.bound, self.dimension);
            // SAFETY: promised by the caller.
            unsafe {
                let own = *self.places.add(node) as usize + self.shift + component;
                *to.add(own) += scale * value;
            }
        }
    }
}
