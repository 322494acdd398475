//! Random contacts of one element: good ones, and some that cannot be evaluated.

use contact_elements::Registered;
use contact_elements::abi::{Sparse, csr_blocks, csr_map, element_history_init};
use contact_tests::random::Random;

/// Inputs of some contacts of one element.
pub struct Contacts {
    pub element: &'static Registered,
    pub count: usize,
    pub nodes: usize,
    pub x: Vec<f64>,
    pub u: Vec<f64>,
    pub history: Vec<f64>,
    pub parameters: Vec<f64>,
    pub connectivity: Vec<i32>,
    /// A place for every entry.
    pub map: Vec<i64>,
    /// A place for every pair of nodes.
    pub blocks: Vec<i64>,
}

/// Where the nodes are before they are moved: slave first.
fn layout(element: &Registered) -> Vec<[f64; 3]> {
    const QUAD: [[f64; 2]; 5] = [
        [0.0, 0.0],
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
    ];
    const MIDDLES: [[f64; 2]; 5] = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
    let flat = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let name = element.name.trim_end_matches('\0');
    let nodes: Vec<[f64; 3]> = if name.starts_with("PointTri3") {
        flat(&[[0.3, 0.3], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    } else if name.starts_with("PointQuad4") {
        flat(&QUAD)
    } else if name == "PointQuad9" {
        flat(&[&QUAD[..], &MIDDLES].concat())
    } else if name.starts_with("PointLine2") && element.dimension == 2 {
        flat(&[[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0]])
    } else if name == "Line2Line2Beams" {
        vec![
            [-1.0, 0.0, 0.2],
            [1.0, 0.0, 0.2],
            [0.0, -1.0, 0.0],
            [0.0, 1.0, 0.0],
        ]
    } else {
        panic!("no layout of {name}: add one")
    };
    assert_eq!(nodes.len(), element.nodes(0));
    nodes
}

impl Contacts {
    pub fn new(element: &'static Registered, count: usize, seed: u64) -> Self {
        let mut random = Random(seed);
        let base = layout(element);
        let mut contacts = Self {
            element,
            count,
            nodes: base.len(),
            x: vec![],
            u: vec![],
            history: vec![],
            parameters: vec![],
            connectivity: vec![],
            map: vec![],
            blocks: vec![],
        };
        for e in 0..count {
            contacts.add_nodes(&base, &mut random);
            contacts.add_history(&mut random);
            contacts.add_parameters(&mut random);
            // neighbours share their last node with the next contact's second
            let own = (e * (base.len() - 1)) as i32;
            contacts
                .connectivity
                .extend((0..base.len() as i32).map(|a| own + a));
        }
        contacts
    }

    fn add_nodes(&mut self, base: &[[f64; 3]], random: &mut Random) {
        let warp = if random.one_in(8) { 0.8 } else { 0.15 };
        let scale = match random.bits() % 24 {
            0 => 1e-12,
            1 => 1e25,
            2 => 1e7,
            _ => 1.0,
        };
        let (shift, reach) = (
            random.within(-3.0, 3.0),
            if random.one_in(6) { 4.0 } else { 0.9 },
        );
        let (start, d) = (self.x.len(), self.element.dimension);
        for (a, node) in base.iter().enumerate() {
            for (k, &value) in node.iter().enumerate().take(d) {
                let mut value = value + random.within(-warp, warp);
                if a == 0 && self.element.slave_nodes == 1 {
                    value += match k {
                        k if k + 1 == d => random.within(-0.3, 0.2),
                        _ => random.within(-reach, reach),
                    };
                }
                self.x.push(scale * (value + shift));
                self.u.push(scale * random.within(-0.01, 0.01));
            }
        }
        let place = |random: &mut Random| start + (random.bits() as usize) % (d * base.len());
        match random.bits() % 40 {
            0 => self.x[place(random)] = f64::NAN,
            1 => self.x[place(random)] = -2e30,
            2 => self.u[place(random)] = f64::INFINITY,
            3 => {
                // two nodes in one place
                let (from, to) = (start + d, start + 2 * d);
                self.x.copy_within(from..from + d, to);
                self.u.copy_within(from..from + d, to);
            }
            4 => self.x[start..].fill(scale * shift),
            _ => {}
        }
    }

    fn add_history(&mut self, random: &mut Random) {
        let mut history = vec![0.0; self.element.history()];
        // SAFETY: the element's own, and a history of its length.
        unsafe { element_history_init(self.element, history.as_mut_ptr()) };
        history[0] = (random.bits() % 5) as f64;
        for value in &mut history[1..] {
            if !random.one_in(4) {
                *value = random.within(-0.9, 0.9);
            }
        }
        match random.bits() % 50 {
            0 => history[1] = f64::NAN,
            1 => history[1] = 1e20,
            2 => history[0] = f64::NEG_INFINITY,
            3 => history[1] = 1e5,
            _ => {}
        }
        self.history.extend(history);
    }

    fn add_parameters(&mut self, random: &mut Random) {
        for parameter in self.element.parameters {
            let value = match parameter.name.trim_end_matches('\0') {
                "eps_n" | "kappa" if random.one_in(40) => -1.0,
                "eps_n" | "kappa" => random.within(1.0, 1e4),
                "r0" => random.within(0.0, 0.4),
                "orientation" if random.one_in(3) => -1.0,
                "orientation" => 1.0,
                "m" => random.within(1.0, 3.0),
                _ => random.within(0.1, 0.9),
            };
            self.parameters.push(value);
        }
    }

    /// The scatter map from a contact on.
    pub fn places(&self, by_blocks: bool, contact: usize) -> &[i64] {
        let map = if by_blocks { &self.blocks } else { &self.map };
        &map[contact * map.len() / self.count..]
    }

    /// Both scatter maps, for a dense matrix of all nodes; its rows.
    pub fn csr(&mut self) -> usize {
        let d = self.element.dimension;
        let rows = d * (self.count * (self.nodes - 1) + 1);
        let start: Vec<i64> = (0..=rows as i64).map(|row| row * rows as i64).collect();
        let columns: Vec<i32> = (0..rows * rows).map(|i| (i % rows) as i32).collect();
        self.map = vec![0; self.count * (d * self.nodes) * (d * self.nodes)];
        self.blocks = vec![0; self.count * self.nodes * (self.nodes + 1)];
        let sparse = Sparse {
            element: self.element,
            n: self.count as i64,
            nslave: 0,
            connectivity: self.connectivity.as_ptr(),
            rows: rows as i64,
            row_start: start.as_ptr(),
            column: columns.as_ptr(),
        };
        // SAFETY: all arrays have the extents of the header.
        let codes = unsafe {
            [
                csr_map(sparse, self.map.as_mut_ptr()),
                csr_blocks(sparse, self.blocks.as_mut_ptr()),
            ]
        };
        assert_eq!(codes, [0; 2]);
        rows
    }
}
