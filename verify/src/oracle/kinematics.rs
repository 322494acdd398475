//! Relative position, tangents, normal and gap of one contact point, over any number.

use super::geometry::MAX_NODES;
use super::multiplier::Enforced;
use super::number::{Base, Number};
use super::pair::{GapKind, Master, Measure, Pair, Slave};
use super::vector::{constant, cross, dot, neg, norm, scale, sub};
use num_dual::Dual64;

/// Current node positions relative to a local origin.
#[derive(Debug, Clone)]
pub struct Nodes<D> {
    /// Slave nodes; entries beyond their number are zero.
    pub slave: [[D; 3]; MAX_NODES],
    /// Master nodes; entries beyond their number are zero.
    pub master: [[D; 3]; MAX_NODES],
}

impl<D: Number> Nodes<D> {
    /// The same positions as constants of a richer number.
    pub fn lifted(plain: &Nodes<f64>) -> Self {
        Self {
            slave: plain.slave.map(constant),
            master: plain.master.map(constant),
        }
    }
}

/// Relative position `r = slave - master` and its derivatives `b_i` by the projected parameters.
#[derive(Debug, Clone, Copy)]
pub struct Relative<D> {
    /// r.
    pub position: [D; 3],
    /// b_i = r_,i; zero beyond the number of parameters.
    pub tangents: [[D; 3]; 2],
}

/// One contact point of a pair at one state: what does not depend on the number type.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    /// The pair.
    pub pair: &'a Pair,
    /// Its normal law with the point's multiplier.
    pub enforced: Enforced<'a>,
    /// Weight of the point times its measure; for [`Measure::Current`] the bare weight.
    pub weight: f64,
    /// Current positions relative to the local origin.
    pub nodes: Nodes<f64>,
    /// Number of projected parameters.
    pub parameters: usize,
    /// Typical size (length): largest distance of a position from the local origin, largest
    /// direction, `r0`.
    pub size: f64,
    row: [f64; MAX_NODES],
    slopes: [[f64; MAX_NODES]; 2],
    rotation: [[f64; 3]; 3],
}

impl<'a> Frame<'a> {
    /// Point `q` of a validated pair; `reference` and `displacement` hold all unknowns.
    pub fn new(pair: &'a Pair, q: usize, reference: &[f64], displacement: &[f64]) -> Self {
        let zero = Nodes {
            slave: [[0.0; 3]; MAX_NODES],
            master: [[0.0; 3]; MAX_NODES],
        };
        let mut frame = Self {
            pair,
            enforced: pair.enforced(q),
            weight: 1.0,
            nodes: zero,
            parameters: pair.parameters(),
            size: 0.0,
            row: [0.0; MAX_NODES],
            slopes: [[0.0; MAX_NODES]; 2],
            rotation: pair.placement().rotation(),
        };
        frame.fill_rows(q);
        let at_reference = frame.localise(reference, &vec![0.0; displacement.len()]);
        frame.nodes = frame.localise(reference, displacement);
        if let Slave::Fixed {
            measure: Measure::Reference,
            ..
        } = pair.slave
        {
            frame.weight *= frame.measure(&at_reference.slave);
        }
        let largest = |m: f64, v: &[f64; 3]| v.iter().fold(m, |m, c| m.max(c.abs()));
        frame.size = frame
            .nodes
            .slave
            .iter()
            .chain(&frame.nodes.master)
            .fold(0.0, largest);
        frame.size = frame.size.max(pair.r0.abs());
        frame
    }

    /// Shape functions of the slave at its fixed point, and their slopes for the measure.
    fn fill_rows(&mut self, q: usize) {
        match &self.pair.slave {
            Slave::Point => self.row[0] = 1.0,
            Slave::Curve(_) => {}
            Slave::Fixed {
                geometry, points, ..
            } => {
                self.weight = points[q].weight;
                for k in 0..geometry.shape.parameters() {
                    let mut row = [Dual64::from_re(0.0); MAX_NODES];
                    let eta = points[q].eta;
                    let seed = |i: usize| Dual64::new(eta[i], f64::from(u8::from(i == k)));
                    geometry.row([seed(0), seed(1)], &mut row);
                    self.row = row.map(|entry| entry.re);
                    self.slopes[k] = row.map(|entry| entry.eps);
                }
            }
            Slave::Rows { rows, .. } => {
                self.weight = rows[q].weight;
                self.row[..rows[q].shape.len()].copy_from_slice(&rows[q].shape);
            }
        }
    }

    /// Positions `(X - origin) + u`; directions are not shifted. The origin is the master's
    /// where it is rigid, else the first node that is a position.
    fn localise(&self, reference: &[f64], displacement: &[f64]) -> Nodes<f64> {
        let (pair, dim) = (self.pair, self.pair.dimension);
        let (n_slave, n_master) = (pair.slave_nodes(), pair.master_nodes());
        let is_position = |node: usize| {
            if node < n_slave {
                pair.slave_is_position(node)
            } else {
                pair.master_is_position(node - n_slave)
            }
        };
        let read = |array: &[f64], node: usize| {
            let mut v = [0.0; 3];
            v[..dim].copy_from_slice(&array[dim * node..dim * (node + 1)]);
            v
        };
        let origin = match pair.master {
            Master::Parametric { placement, .. } | Master::Distance { placement, .. } => {
                placement.origin()
            }
            _ => (0..n_slave + n_master)
                .find(|&node| is_position(node))
                .map_or([0.0; 3], |node| read(reference, node)),
        };
        let mut nodes = Nodes {
            slave: [[0.0; 3]; MAX_NODES],
            master: [[0.0; 3]; MAX_NODES],
        };
        for node in 0..n_slave + n_master {
            let mut v = read(reference, node);
            if is_position(node) {
                v = sub(v, origin);
            }
            let u = read(displacement, node);
            let target = if node < n_slave {
                &mut nodes.slave[node]
            } else {
                &mut nodes.master[node - n_slave]
            };
            *target = [v[0] + u[0], v[1] + u[1], v[2] + u[2]];
        }
        nodes
    }

    /// The entry of `nodes` that belongs to unknown `i`.
    #[inline]
    pub fn unknown<'n, D>(&self, nodes: &'n mut Nodes<D>, i: usize) -> &'n mut D {
        let (node, component) = (i / self.pair.dimension, i % self.pair.dimension);
        match node.checked_sub(self.pair.slave_nodes()) {
            None => &mut nodes.slave[node][component],
            Some(master) => &mut nodes.master[master][component],
        }
    }

    /// Length or area of the slave per parameter at its fixed point.
    pub fn measure<D: Number>(&self, slave: &[[D; 3]; MAX_NODES]) -> D {
        let Slave::Fixed { geometry, .. } = &self.pair.slave else {
            return D::one();
        };
        let tangent = |k: usize| self.slave_tangent(slave, k);
        match geometry.shape.parameters() {
            0 => D::one(),
            1 => norm(tangent(0)),
            _ => norm(cross(tangent(0), tangent(1))),
        }
    }

    /// Derivative of the slave's position by its own parameter `k` at its fixed point; zero for a
    /// slave without fixed points.
    pub fn slave_tangent<D: Number>(&self, slave: &[[D; 3]; MAX_NODES], k: usize) -> [D; 3] {
        let mut t = [D::zero(); 3];
        for (node, slope) in slave.iter().zip(self.slopes[k]) {
            for c in 0..3 {
                t[c] += node[c] * slope;
            }
        }
        t
    }

    /// Relative position and tangents at parameters `z` (slave's first).
    #[inline]
    pub fn relative<D: Base>(&self, nodes: &Nodes<D>, z: [D; 2]) -> Relative<D> {
        let mut tangents = [[D::zero(); 3]; 2];
        let mut position = [D::zero(); 3];
        let first = if let Slave::Curve(geometry) = &self.pair.slave {
            let (value, slopes) = geometry.evaluate([z[0], D::zero()], &nodes.slave);
            position = value;
            tangents[0] = slopes[0];
            1
        } else {
            let count = self.pair.slave_nodes();
            for (node, &shape) in nodes.slave.iter().zip(&self.row).take(count) {
                for c in 0..3 {
                    position[c] += node[c] * shape;
                }
            }
            0
        };
        let at = if first == 1 { [z[1], D::zero()] } else { z };
        let (value, slopes) = match &self.pair.master {
            Master::Point => (nodes.master[0], [[D::zero(); 3]; 2]),
            Master::Shape(geometry) => geometry.evaluate(at, &nodes.master),
            Master::Parametric { surface, .. } => {
                let (value, slopes) = surface.evaluate(at);
                (self.rotated(value), slopes.map(|s| self.rotated(s)))
            }
            Master::Distance { .. } => return Relative { position, tangents },
        };
        for k in first..self.parameters {
            tangents[k] = neg(slopes[k - first]);
        }
        Relative {
            position: sub(position, value),
            tangents,
        }
    }

    /// `rotation v`.
    #[inline]
    fn rotated<D: Number>(&self, v: [D; 3]) -> [D; 3] {
        self.rotation
            .map(|row| v[0] * row[0] + v[1] * row[1] + v[2] * row[2])
    }

    /// `rotationᵀ v`.
    #[inline]
    fn unrotated<D: Number>(&self, v: [D; 3]) -> [D; 3] {
        let column = |c: usize| {
            v[0] * self.rotation[0][c] + v[1] * self.rotation[1][c] + v[2] * self.rotation[2][c]
        };
        [column(0), column(1), column(2)]
    }

    /// The parameters `a^ij b_j·v` of a vector of the tangent plane at `z`.
    pub fn parameters_of(&self, z: [f64; 2], v: [f64; 3]) -> [f64; 2] {
        let tangents = self.relative(&self.nodes, z).tangents;
        let along = tangents.map(|b| dot(b, v));
        let a = |i: usize, j: usize| dot(tangents[i], tangents[j]);
        if self.parameters == 1 {
            return [along[0] / a(0, 0), 0.0];
        }
        let determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
        [
            (a(1, 1) * along[0] - a(0, 1) * along[1]) / determinant,
            (a(0, 0) * along[1] - a(0, 1) * along[0]) / determinant,
        ]
    }

    /// Unit normal of a signed gap, `r / |r|` of a distance, `± r / |r|` of an oriented one.
    #[inline]
    pub fn normal<D: Base>(&self, relative: &Relative<D>) -> [D; 3] {
        let [b1, b2] = relative.tangents;
        let direction = match (&self.pair.master, self.pair.gap) {
            (Master::Distance { .. }, _) => {
                return scale(
                    self.distance_gradient(relative),
                    D::from(self.pair.orientation),
                );
            }
            (_, GapKind::Distance) => {
                return scale(relative.position, norm(relative.position).recip());
            }
            (_, GapKind::Oriented) => relative.position,
            (_, GapKind::Signed) if self.pair.dimension == 2 => [b1[1], -b1[0], D::zero()],
            (_, GapKind::Signed) => cross(b1, b2),
        };
        scale(direction, norm(direction).recip() * self.pair.orientation)
    }

    /// Slope of the master's distance along the global axes, from nested duals.
    fn distance_gradient<D: Base>(&self, relative: &Relative<D>) -> [D; 3] {
        let Master::Distance { body, .. } = &self.pair.master else {
            return relative.position;
        };
        let local = self.unrotated(relative.position);
        let slope = |axis: usize| {
            let seed = |i: usize| D::nest(local[i], if i == axis { D::one() } else { D::zero() });
            D::parts(body.distance([seed(0), seed(1), seed(2)])).1
        };
        self.rotated([slope(0), slope(1), slope(2)])
    }

    /// Gap `g = L - r0`.
    #[inline]
    pub fn gap<D: Base>(&self, relative: &Relative<D>) -> D {
        let length = match (&self.pair.master, self.pair.gap) {
            (Master::Distance { body, .. }, _) => {
                body.distance(self.unrotated(relative.position)) * self.pair.orientation
            }
            (_, GapKind::Distance) => norm(relative.position),
            (_, GapKind::Oriented) => norm(relative.position) * self.pair.orientation,
            (_, GapKind::Signed) => dot(relative.position, self.normal(relative)),
        };
        length - self.pair.r0
    }
}
