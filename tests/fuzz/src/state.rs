//! Values of a call: near enough to what a host sends that contact is found, then changed in single places or at large.

use crate::element::{Element, Range};
use crate::entropy::Entropy;

/// Most slave nodes of an interpolated slave.
const MOST_SLAVES: usize = 24;

/// Values of one contact.
#[derive(Clone, Debug)]
pub struct State {
    /// Slave nodes.
    pub nslave: usize,
    /// All nodes.
    pub nodes: usize,
    /// Reference coordinates [nodes · dimension].
    pub x: Vec<f64>,
    /// Displacements, the same shape.
    pub u: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
    /// Shape functions and weight of an interpolated slave.
    pub row: Vec<f64>,
}

impl State {
    /// Values that the interface accepts.
    pub fn new(element: &Element, entropy: &mut Entropy) -> Self {
        let nslave = match element.interpolated() {
            true if entropy.chance(1, 16) => 1 + entropy.below(MOST_SLAVES),
            true => 1 + entropy.below(5),
            false => element.info.slave_nodes as usize,
        };
        Self::with_slaves(element, entropy, nslave)
    }

    /// The same with a given number of slave nodes.
    pub fn with_slaves(element: &Element, entropy: &mut Entropy, nslave: usize) -> Self {
        let (nodes, d) = (element.nodes(nslave), element.dimension());
        let mut state = Self {
            nslave,
            nodes,
            x: Vec::with_capacity(nodes * d),
            u: Vec::with_capacity(nodes * d),
            parameters: Vec::with_capacity(element.parameters.len()),
            row: Vec::new(),
        };
        state.place(element, entropy);
        for range in &element.parameters {
            state.parameters.push(parameter(range, entropy));
        }
        if element.interpolated() {
            let mut rest = 1.0;
            for a in 0..nslave {
                let share = rest * entropy.unit();
                state.row.push(if a + 1 == nslave { rest } else { share });
                rest -= share;
            }
            state.row.push(entropy.power(-2.0, 1.0));
        }
        state
    }

    /// Master nodes on a template or anywhere, slave nodes near them, displacements.
    fn place(&mut self, element: &Element, entropy: &mut Entropy) {
        let d = element.dimension();
        let scattered = entropy.chance(1, 8);
        let noise = entropy.pick(&[0.0, 0.01, 0.2]);
        let lift = entropy.between(-0.5, 0.5);
        let beside = [entropy.between(-0.9, 0.9), entropy.between(-0.9, 0.9)];
        let positions = self.nodes - element.multipliers;
        for a in 0..positions {
            let is_slave = a < self.nslave;
            let first = if is_slave { 0 } else { self.nslave };
            let count = if is_slave {
                self.nslave
            } else {
                element.masters()
            };
            let is_vector = vector(element, positions, a);
            let mut x = template(element, a - first, count, is_slave, is_vector);
            if is_slave && !is_vector {
                let shift = [beside[0], if d == 2 { lift } else { beside[1] }, lift];
                for k in 0..3 {
                    x[k] += shift[k];
                }
            }
            for value in x.iter().take(d) {
                let scatter = entropy.between(-1.0, 1.0);
                let near = value + noise * scatter;
                self.x.push(if scattered { scatter } else { near });
            }
        }
        let moved = entropy.pick(&[0.0, 1e-3, 0.3]);
        for _ in 0..positions * d {
            self.u.push(moved * entropy.between(-1.0, 1.0));
        }
        for _ in 0..element.multipliers {
            // what is not looked at must not matter
            self.x
                .resize(self.x.len() + d, f64::from_bits(0x7ff4_dead_0000_0000));
            self.u.push(entropy.between(-100.0, 20.0));
            self.u.resize(self.u.len() + d - 1, f64::NAN);
        }
    }

    /// Lists of values, each with its name.
    fn lists(&mut self) -> [&mut Vec<f64>; 4] {
        [
            &mut self.x,
            &mut self.u,
            &mut self.parameters,
            &mut self.row,
        ]
    }

    /// One change of the values.
    pub fn change(&mut self, element: &Element, entropy: &mut Entropy) {
        let d = element.dimension();
        let whole = entropy.chance(1, 4);
        match entropy.below(8) {
            0 if whole => self.collapse(d, entropy),
            1 if whole => self.align(d, entropy),
            2 => self.repeat_node(d, entropy),
            choice => {
                let lists = self.lists();
                let list = match choice {
                    0..=3 => 0,
                    4 => 1,
                    5 | 6 => 2,
                    _ => 3,
                };
                if let Some(list) = lists.into_iter().nth(list) {
                    change_list(list, whole, entropy);
                }
            }
        }
    }

    /// All nodes in one place, or nearly.
    fn collapse(&mut self, d: usize, entropy: &mut Entropy) {
        let size = entropy.pick(&[0.0, 1e-300, 1e-160, 1e-31, 1e-29, 1e-16, 1e-8]);
        let far = entropy.pick(&[0.0, 1.0, 1e8, 1e30]);
        for (at, x) in self.x.iter_mut().enumerate() {
            *x = far * [1.0, -1.0, 0.5][at % d] * (1.0 - f64::EPSILON) + size * *x;
        }
    }

    /// All nodes on a line.
    fn align(&mut self, d: usize, entropy: &mut Entropy) {
        let direction = [0; 3].map(|_| entropy.between(-1.0, 1.0));
        for node in self.x.chunks_mut(d) {
            let t = node.first().copied().unwrap_or(0.0);
            for (x, direction) in node.iter_mut().zip(direction) {
                *x = t * direction;
            }
        }
    }

    /// Two nodes in one place.
    fn repeat_node(&mut self, d: usize, entropy: &mut Entropy) {
        let (from, to) = (entropy.below(self.nodes), entropy.below(self.nodes));
        self.x.copy_within(from * d..(from + 1) * d, to * d);
        self.u.copy_within(from * d..(from + 1) * d, to * d);
    }
}

/// One change of a list: a single value, or all of them.
pub fn change_list(list: &mut [f64], whole: bool, entropy: &mut Entropy) {
    if list.is_empty() {
        return;
    }
    let (at, beside) = (entropy.below(list.len()), entropy.below(list.len()));
    if !whole {
        match entropy.below(6) {
            0 => list[at] = list[beside],
            1 => list.swap(at, beside),
            _ => list[at] = entropy.strange(list[beside]),
        }
        return;
    }
    match entropy.below(5) {
        0 => {
            let factor = entropy.power(-40.0, 40.0);
            list.iter_mut().for_each(|value| *value *= factor);
        }
        1 => {
            let value = entropy.strange(list[at]);
            list.fill(value);
        }
        2 => {
            for value in list.iter_mut() {
                *value = f64::from_bits(entropy.bits());
            }
        }
        3 => {
            for value in list.iter_mut() {
                *value = entropy.strange(*value);
            }
        }
        _ => list.reverse(),
    }
}

/// Whether node `a` of a call is a tangent vector: the flags count from the last position backwards, since slave nodes
/// given in the call are positions.
fn vector(element: &Element, positions: usize, a: usize) -> bool {
    let known = element.vectors.len() - element.multipliers;
    let at = (a + known).checked_sub(positions);
    at.is_some_and(|at| element.vectors[at])
}

/// A node of a curve along x (of a slave curve along y), or of a facet in the plane; a point at the origin.
pub fn template(element: &Element, a: usize, count: usize, slave: bool, vector: bool) -> [f64; 3] {
    const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let along = |t: f64| match slave && element.dimension() == 3 {
        true => [0.2 * t, t, 0.0],
        false => [t, 0.0, 0.0],
    };
    let name = element.name.as_str();
    let [x, y] = match count {
        _ if vector => return along(1.0),
        0 | 1 => [0.0; 2],
        3 | 6 if name.contains("Tri") => {
            let [i, j] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]][a];
            let corner = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
            [0, 1].map(|k| 0.5 * (corner[i][k] + corner[j][k]))
        }
        3 if name.contains("Line3") => return along([-1.0, 1.0, 0.0][a]),
        4 if name.contains("Hermite") && !name.contains("Quad4") => {
            return along([-1.0, 0.0, 1.0, 0.0][a]);
        }
        4 if name.contains("HermiteQuad4") && slave => return along([-1.0, 0.0, 1.0, 0.0][a]),
        4 if name.contains("Quad4") => CORNERS[a],
        9 if name.contains("Quad9") => {
            let rest = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
            *CORNERS.iter().chain(&rest).nth(a).unwrap_or(&[0.0; 2])
        }
        9 => [(a % 3) as f64 - 1.0, (a / 3) as f64 - 1.0],
        _ => return along(2.0 * a as f64 / (count - 1) as f64 - 1.0),
    };
    [x, y, 0.0]
}

/// A value within the range of a parameter.
pub fn parameter(range: &Range, entropy: &mut Entropy) -> f64 {
    if entropy.chance(1, 32) {
        let bounds = [range.lower, range.upper];
        let bound = entropy.pick(&bounds);
        return if range.closed && bound.is_finite() {
            bound
        } else {
            inside(range, entropy)
        };
    }
    match range.name.as_str() {
        "r0" if entropy.chance(1, 2) => entropy.between(0.0, 1.5),
        "orientation" => entropy.pick(&[1.0, -1.0]),
        "quaternion_w" => 1.0,
        name if name.starts_with("quaternion") && entropy.chance(1, 2) => 0.0,
        name if name.starts_with("eps") => entropy.power(0.0, 4.0),
        _ => inside(range, entropy),
    }
}

fn inside(range: &Range, entropy: &mut Entropy) -> f64 {
    let (lower, upper) = (range.lower, range.upper);
    match (lower.is_finite(), upper.is_finite()) {
        (true, true) => lower + (upper - lower) * (0.01 + 0.98 * entropy.unit()),
        (true, false) => lower + entropy.power(-1.0, 0.5),
        (false, true) => upper - entropy.power(-1.0, 0.5),
        (false, false) => entropy.between(-1.0, 1.0),
    }
}
