//! Relative position of one contact point and its derivatives by the projected parameters, over any number.
//!
//! Everything is one row: `r(x, ζ) = Σ_A s_A(ζ) x_A − o`, with `s_A = +N_A` on the slave and `−N_A` on the
//! master, and o what a rigid master has instead of nodes. Derivatives by ζ come from nested duals.

use num_dual::{Dual, DualNum};
use num_traits::Zero;

use crate::oracle::geometry::{Interpolation, MAX_NODES, Placement, RigidParametric};
use crate::oracle::number::{Base, Number};
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::vector::{add, cross, dot, neg, norm, scale, sub};

/// Numbers that derivatives by the projected parameters can be taken of, twice.
pub trait Twice: Base<Nested: Base> {
    /// The number without derivatives.
    fn plain(self) -> Octuple;
    /// A constant.
    fn constant(value: Octuple) -> Self;
}

impl Twice for Octuple {
    fn plain(self) -> Octuple {
        self
    }
    fn constant(value: Octuple) -> Self {
        value
    }
}

impl Twice for Dual<Octuple> {
    fn plain(self) -> Octuple {
        self.re
    }
    fn constant(value: Octuple) -> Self {
        Self::from_re(value)
    }
}

/// A vector of constants.
pub fn constants<D: Twice>(v: [Octuple; 3]) -> [D; 3] {
    v.map(D::constant)
}

/// The rows s_A and their derivatives, and what they make of the nodes.
#[derive(Clone, Debug)]
pub struct Kinematics<D> {
    /// s_A
    pub row: Vec<D>,
    /// s_A,i
    pub slopes: [Vec<D>; 2],
    /// r
    pub r: [D; 3],
    /// b_i = r_,i; zero beyond the number of parameters.
    pub b: [[D; 3]; 2],
    /// r_,11 r_,12 r_,22
    pub second: [[D; 3]; 3],
}

/// A contact point: what of it does not depend on the projected parameters.
#[derive(Clone, Debug)]
pub struct Point<'a> {
    /// The pair.
    pub pair: &'a Pair,
    /// Weight of the rule.
    pub weight: f64,
    fixed: Vec<Octuple>,
    fixed_slopes: [Vec<Octuple>; 2],
}

/// The second derivative that directions i and j make.
const PAIRS: [(usize, usize); 3] = [(0, 0), (0, 1), (1, 1)];

impl<'a> Point<'a> {
    /// Point `q` of a pair.
    pub fn new(pair: &'a Pair, q: usize) -> Self {
        let mut point = Self {
            pair,
            weight: 1.0,
            fixed: vec![],
            fixed_slopes: [vec![], vec![]],
        };
        match &pair.slave {
            Slave::Point => point.fixed = vec![Octuple::from(1.0)],
            Slave::Curve(_) => {}
            Slave::Rows { rows, .. } => {
                point.weight = rows[q].weight;
                point.fixed = rows[q].shape.iter().map(|&v| Octuple::from(v)).collect();
            }
            Slave::Fixed {
                geometry, points, ..
            } => {
                point.weight = points[q].weight;
                let eta = points[q].eta.map(Octuple::from);
                for (k, (i, j)) in [(0, 0), (1, 1)].into_iter().enumerate() {
                    let rows = rows(geometry, eta, i, j);
                    point.fixed = rows.iter().map(|row| row[0]).collect();
                    point.fixed_slopes[k] = rows.iter().map(|row| row[1]).collect();
                }
            }
        }
        point
    }

    /// Rows and vectors at the parameters z, slave's first.
    pub fn at<D: Twice>(&self, x: &[[D; 3]], z: [D; 2]) -> Kinematics<D> {
        let zero = [D::zero(); 3];
        let n = self.pair.slave_nodes();
        let mut k = Kinematics {
            row: vec![D::zero(); x.len()],
            slopes: [vec![D::zero(); x.len()], vec![D::zero(); x.len()]],
            r: zero,
            b: [zero; 2],
            second: [zero; 3],
        };
        for (node, &shape) in self.fixed.iter().enumerate() {
            k.row[node] = D::constant(shape);
            k.r = add(k.r, scale(x[node], k.row[node]));
        }
        let mut first = 0;
        if let Slave::Curve(geometry) = &self.pair.slave {
            k.add(geometry, x, 0, [z[0], D::zero()], 0, 1.0);
            first = 1;
        }
        let at = [z[first], z[1]];
        match &self.pair.master {
            Master::Point => {
                k.row[n] = -D::one();
                k.r = sub(k.r, x[n]);
            }
            Master::Shape(geometry) => k.add(geometry, x, n, at, first, -1.0),
            Master::Parametric { surface, placement } => k.rigid(surface, placement, at, first),
            Master::Distance { placement, .. } => k.r = sub(k.r, origin(placement)),
        }
        k
    }

    /// Length or area per parameter of the slave at its fixed point; 1 for a slave without fixed points.
    pub fn measure<D: Twice>(&self, x: &[[D; 3]]) -> D {
        let Slave::Fixed { geometry, .. } = &self.pair.slave else {
            return D::one();
        };
        let t = [0, 1].map(|k| self.slave_tangent(x, k));
        match geometry.shape.parameters() {
            0 => D::one(),
            1 => norm(t[0]),
            _ => norm(cross(t[0], t[1])),
        }
    }

    /// Tangent of a slave at its fixed point.
    pub fn slave_tangent<D: Twice>(&self, x: &[[D; 3]], k: usize) -> [D; 3] {
        let mut t = [D::zero(); 3];
        for (node, &slope) in x.iter().zip(&self.fixed_slopes[k]) {
            t = add(t, scale(*node, D::constant(slope)));
        }
        t
    }

    /// Distance L and unit normal.
    pub fn distance<D: Twice>(&self, k: &Kinematics<D>) -> (D, [D; 3]) {
        let side = self.pair.orientation;
        let direction = match (&self.pair.master, self.pair.gap) {
            (Master::Distance { .. }, _) => return self.rigid_distance(k.r),
            (_, GapKind::Distance) => {
                let length = norm(k.r);
                return (length, scale(k.r, length.recip()));
            }
            (_, GapKind::Oriented) => {
                let length = norm(k.r) * side;
                return (length, scale(k.r, length.recip()));
            }
            (_, GapKind::Signed) if self.pair.dimension == 2 => [k.b[0][1], -k.b[0][0], D::zero()],
            (_, GapKind::Signed) => cross(k.b[0], k.b[1]),
        };
        let n = scale(direction, norm(direction).recip() * side);
        (dot(k.r, n), n)
    }

    fn rigid_distance<D: Twice>(&self, r: [D; 3]) -> (D, [D; 3]) {
        let Master::Distance { body, placement } = &self.pair.master else {
            return (norm(r), r);
        };
        let axes = rotation(placement);
        let local = [0, 1, 2].map(|c| dot(r, constants([axes[0][c], axes[1][c], axes[2][c]])));
        let slope = |axis: usize| {
            let seed = |i: usize| D::nest(local[i], if i == axis { D::one() } else { D::zero() });
            D::parts(body.distance([seed(0), seed(1), seed(2)]))
        };
        let parts = [slope(0), slope(1), slope(2)];
        let gradient = parts.map(|part| part.1 * self.pair.orientation);
        let n = axes.map(|row| dot(gradient, constants(row)));
        (parts[0].0 * self.pair.orientation, n)
    }
}

impl<D: Twice> Kinematics<D> {
    /// Adds a geometry with nodes from `node` on, whose parameters are number `first` and the following.
    fn add(
        &mut self,
        geometry: &Interpolation,
        x: &[[D; 3]],
        node: usize,
        z: [D; 2],
        first: usize,
        sign: f64,
    ) {
        for (h, (i, j)) in directions(geometry.shape.parameters(), first) {
            let rows = rows(geometry, z, i, j);
            for (a, [value, by_i, by_j, by_both]) in rows.into_iter().enumerate() {
                let (a, x) = (node + a, x[node + a]);
                let times = |v: D| scale(x, v * sign);
                self.second[h] = add(self.second[h], times(by_both));
                if i != j {
                    continue;
                }
                self.slopes[first + i][a] = by_j * sign;
                self.b[first + i] = add(self.b[first + i], times(by_i));
                if i == 0 {
                    self.row[a] = value * sign;
                    self.r = add(self.r, times(value));
                }
            }
        }
    }

    /// Subtracts a placed rigid geometry.
    fn rigid(&mut self, surface: &RigidParametric, placement: &Placement, z: [D; 2], first: usize) {
        self.r = sub(self.r, origin(placement));
        let axes = rotation(placement).map(constants);
        let turned = |v: [D; 3]| neg(axes.map(|row| dot(row, v)));
        for (h, (i, j)) in directions(surface.parameters(), first) {
            let parts = surface.point(seeded(z, i, j)).map(unnested);
            let part = |k: usize| turned([parts[0][k], parts[1][k], parts[2][k]]);
            self.second[h] = part(3);
            if i == j {
                self.b[first + i] = part(1);
            }
            if (i, j) == (0, 0) {
                self.r = add(self.r, part(0));
            }
        }
    }
}

/// Slots of second derivatives, and the two directions of a geometry they belong to.
fn directions(parameters: usize, first: usize) -> Vec<(usize, (usize, usize))> {
    let slot = |(i, j): (usize, usize)| {
        let both = (i + first, j + first);
        PAIRS
            .iter()
            .position(|&pair| pair == both)
            .map(|h| (h, (i, j)))
    };
    let own = PAIRS.into_iter().filter(|&(_, j)| j < parameters);
    own.filter_map(slot).collect()
}

/// z with one derivative along direction i and one along j.
fn seeded<D: Twice>(z: [D; 2], i: usize, j: usize) -> [<D::Nested as Base>::Nested; 2] {
    let unit = |k: usize, along: usize| if k == along { D::one() } else { D::zero() };
    [0, 1].map(|k| {
        let inner = D::nest(z[k], unit(k, i));
        <D::Nested as Base>::nest(inner, D::nest(unit(k, j), D::zero()))
    })
}

/// Value, derivative along i, along j, along both.
fn unnested<D: Twice>(v: <D::Nested as Base>::Nested) -> [D; 4] {
    let (inner, outer) = <D::Nested as Base>::parts(v);
    let ((value, by_i), (by_j, by_both)) = (D::parts(inner), D::parts(outer));
    [value, by_i, by_j, by_both]
}

/// Shape functions of every node with derivatives along two directions.
fn rows<D: Twice>(geometry: &Interpolation, z: [D; 2], i: usize, j: usize) -> Vec<[D; 4]> {
    let mut row = [<D::Nested as Base>::Nested::zero(); MAX_NODES];
    geometry.row(seeded(z, i, j), &mut row);
    row[..geometry.shape.nodes()]
        .iter()
        .map(|&entry| unnested::<D>(entry))
        .collect()
}

fn origin<D: Number>(placement: &Placement) -> [D; 3] {
    placement.origin().map(D::from)
}

/// Rows of the rotation of a placement: images of the axes, in full precision.
pub fn rotation(placement: &Placement) -> [[Octuple; 3]; 3] {
    let number = |v: f64| Octuple::from(v);
    let zero = number(0.0);
    match *placement {
        Placement::Identity => {
            let unit = |i: usize| std::array::from_fn(|k| number(f64::from(u8::from(k == i))));
            [unit(0), unit(1), unit(2)]
        }
        Placement::Planar {
            direction: [c, s], ..
        } => {
            let v = [number(c), number(s), zero];
            let [c, s, _] = scale(v, norm(v).recip());
            [[c, -s, zero], [s, c, zero], [zero, zero, number(1.0)]]
        }
        Placement::Spatial { quaternion, .. } => {
            let q = quaternion.map(number);
            let (w, v) = (q[0], [q[1], q[2], q[3]]);
            let square = w * w + dot(v, v);
            // v' = v + 2 q × (q × v + w v) / |q|²
            let image = |i: usize| {
                let axis: [Octuple; 3] =
                    std::array::from_fn(|k| number(f64::from(u8::from(k == i))));
                let turn = cross(v, add(cross(v, axis), scale(axis, w)));
                add(axis, scale(turn, number(2.0) / square))
            };
            let columns = [image(0), image(1), image(2)];
            [0, 1, 2].map(|row| [columns[0][row], columns[1][row], columns[2][row]])
        }
    }
}
