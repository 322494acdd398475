//! Slave points over a grid of facets, and the sparse matrix that their contacts are added to.

use std::hint::black_box;
use std::time::Instant;

use contact_elements::abi::{Batch, Sparse, csr_blocks, csr_map, element_evaluate_batch, element_evaluate_batch_threads};
use contact_elements::request;
use contact_library::PointQuad4;

use crate::random::Random;

const PARAMETERS: [f64; 3] = [1000.0, 0.0, 1.0];
const UNKNOWNS: usize = 15;
const MATRIX: usize = UNKNOWNS * UNKNOWNS;
const BLOCKS: usize = 5 * 6;

/// Points against bilinear facets of size 2: node numbers, starts and the places of their matrices.
pub struct Grid {
    side: usize,
    pub count: usize,
    connectivity: Vec<i32>,
    history: Vec<f64>,
    map: Vec<i64>,
    blocks: Vec<i64>,
    global_f: Vec<f64>,
    csr_values: Vec<f64>,
    /// Time of `cte_csr_map` and of `cte_csr_blocks` [s].
    pub map_times: [f64; 2],
    /// Leaves open contacts unprojected.
    pub screens: bool,
}

/// Where the outputs go.
#[derive(Clone, Copy)]
pub enum Into {
    /// Sums, a place for every entry.
    Csr,
    /// Sums, a place for every pair of nodes.
    Blocks,
    /// Sums of the residual, K nowhere.
    Vector,
    /// f and k of every contact.
    Own,
    /// f and k of every contact, in places that are used again after so many contacts.
    Again(usize),
}

/// f and k of some contacts.
#[derive(Default)]
pub struct Room {
    f: Vec<f64>,
    k: Vec<f64>,
    status: Vec<i32>,
}

impl Grid {
    pub fn new(side: usize) -> Self {
        let (count, nodes) = (side * side, (side + 1) * (side + 1));
        let mut random = Random(3);
        let mut grid = Self {
            side,
            count,
            connectivity: vec![],
            history: vec![],
            map: vec![],
            blocks: vec![],
            global_f: vec![],
            csr_values: vec![],
            map_times: [0.0; 2],
            screens: false,
        };
        for facet in 0..count {
            let corner = facet % side + facet / side * (side + 1);
            let facets = [corner, corner + 1, corner + side + 2, corner + side + 1];
            grid.connectivity.push((nodes + facet) as i32);
            grid.connectivity.extend(facets.map(|node| node as i32));
            // the projection is near the middle
            let near = [0.0; 2].map(|_| random.within(-0.05, 0.05));
            grid.history.extend([1.0, near[0], near[1]]);
        }
        grid.make_map(nodes);
        grid
    }

    fn make_map(&mut self, nodes: usize) {
        let mut pattern = vec![vec![]; nodes + self.count];
        for contact in self.connectivity.chunks(5) {
            for &node in contact {
                pattern[node as usize].extend(contact);
            }
        }
        let (mut starts, mut columns) = (vec![0], Vec::<i32>::new());
        for near in &mut pattern {
            near.sort();
            near.dedup();
            for _ in 0..3 {
                columns.extend(
                    near.iter()
                        .flat_map(|node| (0..3).map(move |k| 3 * node + k)),
                );
                starts.push(columns.len() as i64);
            }
        }
        self.global_f = vec![0.0; starts.len() - 1];
        self.csr_values = vec![0.0; columns.len()];
        self.map = vec![0; self.count * MATRIX];
        self.blocks = vec![0; self.count * BLOCKS];
        let sparse = Sparse {
            element: PointQuad4::DESCRIPTOR,
            n: self.count as i64,
            nslave: 0,
            connectivity: self.connectivity.as_ptr(),
            rows: self.global_f.len() as i64,
            row_start: starts.as_ptr(),
            column: columns.as_ptr(),
        };
        let timed = |make: unsafe fn(Sparse, *mut i64) -> i32, map: &mut [i64]| {
            let start = Instant::now();
            // SAFETY: all arrays have the extents of the header.
            let code = unsafe { make(sparse, map.as_mut_ptr()) };
            assert_eq!(code, 0);
            start.elapsed().as_secs_f64()
        };
        self.map_times = [
            timed(csr_map, &mut self.map),
            timed(csr_blocks, &mut self.blocks),
        ];
    }

    /// Positions: one contact in `apart` is closed.
    pub fn positions(&self, apart: usize, seed: u64) -> Vec<f64> {
        let mut random = Random(seed);
        let mut x = vec![];
        for node in 0..(self.side + 1) * (self.side + 1) {
            let (i, j) = (node % (self.side + 1), node / (self.side + 1));
            let mut off = || random.within(-0.1, 0.1);
            x.extend([2.0 * i as f64 + off(), 2.0 * j as f64 + off(), off()]);
        }
        for facet in 0..self.count {
            let (i, j) = (facet % self.side, facet / self.side);
            let height = if facet % apart == 0 {
                random.within(-0.3, -0.15)
            } else {
                random.within(0.2, 0.5)
            };
            x.extend([2.0 * i as f64 + 1.0, 2.0 * j as f64 + 1.0, height]);
        }
        x
    }

    /// The same facets and matrix, only the contacts `0, apart, 2 apart …`.
    pub fn thinned(&self, apart: usize) -> Self {
        fn every<T: Copy>(values: &[T], size: usize, apart: usize) -> Vec<T> {
            let kept = values.chunks(size).step_by(apart);
            kept.flatten().copied().collect()
        }
        Self {
            side: self.side,
            count: self.count.div_ceil(apart),
            connectivity: every(&self.connectivity, 5, apart),
            history: every(&self.history, 3, apart),
            map: every(&self.map, MATRIX, apart),
            blocks: every(&self.blocks, BLOCKS, apart),
            global_f: self.global_f.clone(),
            csr_values: self.csr_values.clone(),
            map_times: [0.0; 2],
            screens: false,
        }
    }

    /// Evaluates all contacts at positions x; threads 0: by the function without threads. The number of closed ones.
    pub fn evaluate(&mut self, x: &[f64], into: Into, threads: i32, room: &mut Room) -> usize {
        let length = match into {
            Into::Again(length) => length,
            _ => self.count,
        };
        let own = if let Into::Csr | Into::Blocks | Into::Vector = into {
            0
        } else {
            length
        };
        room.f.resize(own * UNKNOWNS, 0.0);
        room.k.resize(own * MATRIX, 0.0);
        room.status.resize(self.count, 0);
        let mut batch = Batch::EMPTY;
        batch.request = request::RESIDUAL;
        if !matches!(into, Into::Vector) {
            batch.request |= request::TANGENT;
        }
        let has_blocks = matches!(into, Into::Blocks);
        if has_blocks {
            batch.request |= request::CSR_BY_BLOCKS;
        }
        if self.screens {
            batch.request |= request::SCREEN;
        }
        (batch.x, batch.global_nodes) = (x.as_ptr(), (x.len() / 3) as i64);
        (batch.parameters, batch.parameter_count) = (PARAMETERS.as_ptr(), 3);
        if own > 0 {
            (batch.f, batch.k) = (room.f.as_mut_ptr(), room.k.as_mut_ptr());
        } else {
            batch.global_f = self.global_f.as_mut_ptr();
            batch.csr_values = self.csr_values.as_mut_ptr();
        }
        for first in (0..self.count).step_by(length) {
            let n = length.min(self.count - first) as i64;
            batch.connectivity = self.connectivity[5 * first..].as_ptr();
            batch.history_accepted = self.history[3 * first..].as_ptr();
            batch.csr_map = if has_blocks {
                self.blocks[BLOCKS * first..].as_ptr()
            } else {
                self.map[MATRIX * first..].as_ptr()
            };
            batch.status = room.status[first..].as_mut_ptr();
            let element = PointQuad4::DESCRIPTOR;
            // SAFETY: all arrays have the extents of the header.
            let code = unsafe {
                match threads {
                    0 => element_evaluate_batch(element, n, &mut batch),
                    _ => element_evaluate_batch_threads(element, n, &mut batch, threads),
                }
            };
            assert_eq!(code, 0);
        }
        black_box((&room.k, &self.csr_values));
        room.status.iter().filter(|&&status| status == 1).count()
    }
}
