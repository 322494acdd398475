//! A grid of facets, a second one near it, and contacts between both.

use std::collections::BTreeSet;

use contact_elements::abi::{Sparse, csr_blocks, csr_map, element_history_init};
use contact_elements::Registered;

use crate::random::Random;

/// Contacts on a facet: the more share an entry, the more does the order of a sum matter.
const PER_FACET: usize = 4;

/// Contacts of one element and the sparse matrix that they go into.
pub struct Mesh {
    pub element: &'static Registered,
    pub count: usize,
    /// Slave nodes given in the call; 0: the element's own.
    pub slaves: usize,
    pub unknowns: usize,
    pub x: Vec<f64>,
    pub u: Vec<f64>,
    pub connectivity: Vec<i32>,
    pub parameters: Vec<f64>,
    pub history: Vec<f64>,
    pub slave_rows: Vec<f64>,
    pub rows: usize,
    pub columns: Vec<i32>,
    /// A place for every entry.
    pub map: Vec<i64>,
    /// A place for every pair of nodes.
    pub blocks: Vec<i64>,
}

impl Mesh {
    pub fn new(element: &'static Registered, count: usize, is_shuffled: bool) -> Self {
        let mut random = Random(count as u64);
        let side = (count as f64 / PER_FACET as f64).sqrt().ceil() as usize;
        let slaves = if element.interpolated { 3 } else { 0 };
        let nodes = element.nodes(slaves);
        let mut mesh = Self {
            element,
            count,
            slaves,
            unknowns: element.unknowns(nodes),
            x: vec![],
            u: vec![],
            connectivity: vec![],
            parameters: vec![],
            history: vec![],
            slave_rows: vec![],
            rows: 0,
            columns: vec![],
            map: vec![],
            blocks: vec![],
        };
        mesh.add_nodes(side, &mut random);
        let mut order: Vec<usize> = (0..count).collect();
        if is_shuffled {
            for last in (1..count).rev() {
                order.swap(last, random.bits() as usize % (last + 1));
            }
        }
        for number in order {
            mesh.add_contact((number / PER_FACET, side), nodes, &mut random);
        }
        mesh.make_maps(nodes);
        mesh
    }

    /// Facets of size 1 at z = 0, then shifted at z = 0.1, then a node per facet for multipliers.
    fn add_nodes(&mut self, side: usize, random: &mut Random) {
        for (height, shift) in [(0.0, 0.0), (0.1, 0.4)] {
            for place in 0..(side + 1) * (side + 1) {
                let (i, j) = (place % (side + 1), place / (side + 1));
                for value in [i as f64 + shift, j as f64 + shift, height] {
                    self.x.push(value + random.within(-0.1, 0.1));
                }
            }
        }
        self.x.extend((0..3 * side * side).map(|_| 0.0));
        self.u = self.x.iter().map(|_| random.within(-0.1, 0.1)).collect();
    }

    /// Nodes of the facet below, those near it above first.
    fn add_contact(&mut self, (facet, side): (usize, usize), nodes: usize, random: &mut Random) {
        let per_grid = (side + 1) * (side + 1);
        let corner = facet % side + facet / side * (side + 1);
        let below = [corner, corner + 1, corner + side + 2, corner + side + 1];
        let above = below.map(|node| node + per_grid);
        let count = nodes - self.element.multipliers() - 4;
        let multipliers = (0..self.element.multipliers()).map(|_| 2 * per_grid + facet);
        let list = above
            .into_iter()
            .take(count)
            .chain(below)
            .chain(multipliers);
        self.connectivity.extend(list.map(|node| node as i32));
        let start = self.history.len();
        self.history.resize(start + self.element.history(), 0.0);
        // SAFETY: the element's own, and a history of its length.
        unsafe { element_history_init(self.element, self.history[start..].as_mut_ptr()) };
        if random.one_in(20) {
            self.history[start + 1] = f64::NAN;
        }
        self.slave_rows
            .extend([0.5, 0.3, 0.2, random.within(0.5, 1.5)]);
        for parameter in self.element.parameters {
            self.parameters
                .push(match parameter.name.trim_end_matches('\0') {
                    "r0" => random.within(0.0, 0.3),
                    "orientation" => 1.0,
                    "eps_n" if random.one_in(20) => -1.0,
                    _ => random.within(0.2, 0.9),
                });
        }
    }

    fn make_maps(&mut self, nodes: usize) {
        self.rows = self.x.len();
        let mut pattern = vec![BTreeSet::new(); self.x.len() / 3];
        for contact in self.connectivity.chunks(nodes) {
            for &node in contact {
                pattern[node as usize].extend(contact.iter().copied());
            }
        }
        let mut starts = vec![0];
        for row in 0..self.rows {
            let near = &pattern[row / 3];
            self.columns.extend(
                near.iter()
                    .flat_map(|node| (0..3).map(move |k| 3 * node + k)),
            );
            starts.push(self.columns.len() as i64);
        }
        self.map = vec![0; self.count * self.unknowns * self.unknowns];
        self.blocks = vec![0; self.count * nodes * (nodes + 1)];
        let sparse = Sparse {
            element: self.element,
            n: self.count as i64,
            nslave: self.slaves as i32,
            connectivity: self.connectivity.as_ptr(),
            rows: self.rows as i64,
            row_start: starts.as_ptr(),
            column: self.columns.as_ptr(),
        };
        // SAFETY: all arrays have the extents of the header.
        let codes = unsafe {
            [
                csr_map(sparse, self.map.as_mut_ptr()),
                csr_blocks(sparse, self.blocks.as_mut_ptr()),
            ]
        };
        assert_eq!(codes, [0; 2]);
    }
}
