//! What the tangential forms share: the contact point in the orthonormal frame, and the slip with its force.
//! [eq:frame] [eq:F]

use super::{Kinematics, pair_index, second_derivatives, third_derivatives};
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::{Axis, Linearisation};

/// Quantities at the contact point that the terms share, in the orthonormal frame.
pub(super) struct Contact {
    pub(super) n: Vector,
    /// L, or 0 on the tangent plane.
    pub(super) distance: NodeId,
    /// E^i_q
    pub(super) frame: Vec<Vec<NodeId>>,
    pub(super) e: Vec<Vector>,
    /// r_,qr
    pub(super) second: Vec<Vector>,
    /// m = (1 − Lκ)⁻¹, entries 11, 12, 22
    pub(super) m: Vec<NodeId>,
    pub(super) d: usize,
    pub(super) p: usize,
}

impl Contact {
    pub(super) fn new(program: &mut Program, kinematics: &Kinematics) -> Self {
        let (d, p) = (kinematics.dimension, kinematics.projected());
        let n = program.input_vector("n", d);
        let distance = program.input("distance");
        let b: Vec<Vector> = (0..p)
            .map(|i| program.input_vector(&format!("b_{i}"), d))
            .collect();
        let second: Vec<Vector> = (0..second_derivatives(p))
            .map(|h| program.input_vector(&format!("r_{h}"), d))
            .collect();
        let frame: Vec<Vec<NodeId>> = (0..p)
            .map(|i| {
                (0..p)
                    .map(|q| program.input(format!("E_{i}_{q}")))
                    .collect()
            })
            .collect();
        let graph = &mut program.graph;
        let distance = match kinematics.linearisation {
            Linearisation::Exact => distance,
            Linearisation::TangentPlane => graph.constant(0.0),
        };
        let declared: Vec<Vector> = second
            .into_iter()
            .zip(&kinematics.curved)
            .map(|(vector, &curved)| {
                if curved {
                    vector
                } else {
                    Vector::zero(graph, d)
                }
            })
            .collect();
        let e = (0..p)
            .map(|q| combination(graph, d, &|i| (frame[i][q], b[i].clone()), p))
            .collect();
        let second = framed_second(graph, &frame, &declared, d);
        let m = inverse(graph, &n, distance, &second);
        Self {
            n,
            distance,
            frame,
            e,
            second,
            m,
            d,
            p,
        }
    }

    /// τ_q = m_qr t_r
    pub(super) fn raised(&self, graph: &mut Graph, t: &[NodeId]) -> Vec<NodeId> {
        (0..self.p)
            .map(|q| {
                let mut sum = graph.constant(0.0);
                for (r, &t) in t.iter().enumerate() {
                    let part = graph.multiply(self.m[pair_index(q, r)], t);
                    sum = graph.add(sum, part);
                }
                sum
            })
            .collect()
    }

    /// v^i = E^i_q v_q
    pub(super) fn on_declared(&self, graph: &mut Graph, v: &[NodeId], i: usize) -> NodeId {
        let mut sum = graph.constant(0.0);
        for (q, &v) in v.iter().enumerate() {
            let part = graph.multiply(self.frame[i][q], v);
            sum = graph.add(sum, part);
        }
        sum
    }

    /// τ^i n·r_,iqr for the pair q, r: the declared third derivatives, once with a vector, twice in the frame.
    pub(super) fn framed_third(
        &self,
        graph: &mut Graph,
        third: &[NodeId],
        v: &[NodeId],
        pair: (usize, usize),
    ) -> NodeId {
        let factors = framing(graph, &self.frame, pair);
        let mut sum = graph.constant(0.0);
        for ((j, k), factor) in pairs(self.p).zip(factors) {
            let mut along = graph.constant(0.0);
            for (i, &v) in v.iter().enumerate() {
                let part = graph.multiply(v, third[i + j + k]);
                along = graph.add(along, part);
            }
            let part = graph.multiply(factor, along);
            sum = graph.add(sum, part);
        }
        sum
    }
}

/// Σ_i factor_i vector_i
pub(super) fn combination(
    graph: &mut Graph,
    d: usize,
    part: &dyn Fn(usize) -> (NodeId, Vector),
    count: usize,
) -> Vector {
    let mut sum = Vector::zero(graph, d);
    for i in 0..count {
        let (factor, vector) = part(i);
        let scaled = vector.scale(graph, factor);
        sum = sum.add(graph, &scaled);
    }
    sum
}

/// Factors of the entries 11, 12, 22 of a symmetric tensor in E^i_q E^j_r T_ij.
fn framing(graph: &mut Graph, frame: &[Vec<NodeId>], (q, r): (usize, usize)) -> Vec<NodeId> {
    pairs(frame.len())
        .map(|(i, j)| {
            let factor = graph.multiply(frame[i][q], frame[j][r]);
            if i == j {
                return factor;
            }
            let other = graph.multiply(frame[j][q], frame[i][r]);
            graph.add(factor, other)
        })
        .collect()
}

/// r_,qr = E^i_q E^j_r r_,ij
fn framed_second(
    graph: &mut Graph,
    frame: &[Vec<NodeId>],
    declared: &[Vector],
    d: usize,
) -> Vec<Vector> {
    let mut result = Vec::new();
    for pair in pairs(frame.len()) {
        let factors = framing(graph, frame, pair);
        let count = factors.len();
        let part = |h: usize| (factors[h], declared[h].clone());
        result.push(combination(graph, d, &part, count));
    }
    result
}

/// The index pairs 11, 12, 22.
pub(super) fn pairs(p: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..p).flat_map(move |q| (q..p).map(move |r| (q, r)))
}

/// m = (1 − Lκ)⁻¹, κ_qr = −n·r_,qr [eq:F]
fn inverse(graph: &mut Graph, n: &Vector, distance: NodeId, second: &[Vector]) -> Vec<NodeId> {
    let one = graph.constant(1.0);
    let bend: Vec<NodeId> = second
        .iter()
        .map(|r| {
            let along = n.dot(graph, r);
            graph.multiply(distance, along)
        })
        .collect();
    match bend.as_slice() {
        [only] => {
            let f = graph.add(one, *only);
            vec![graph.divide(one, f)]
        }
        [first, mixed, last] => {
            let (f11, f22) = (graph.add(one, *first), graph.add(one, *last));
            let product = graph.multiply(f11, f22);
            let square = graph.multiply(*mixed, *mixed);
            let determinant = graph.subtract(product, square);
            let back = graph.negate(*mixed);
            vec![
                graph.divide(f22, determinant),
                graph.divide(back, determinant),
                graph.divide(f11, determinant),
            ]
        }
        _ => unreachable!("tangential contact has one or two projected parameters"),
    }
}

/// Further inputs of the tangent.
pub(super) struct Sliding {
    /// n·r_,ijk of the declared parameters, by the sum of the indices.
    pub(super) third: Vec<NodeId>,
    pub(super) slip: Vec<NodeId>,
    pub(super) t: Vec<NodeId>,
    /// Factor of δζ̂^q: t_q, with rolling also the share of the moments.
    pub(super) force: Vec<NodeId>,
    /// C_qr = ∂t_q/∂s_r
    pub(super) c: Vec<Vec<NodeId>>,
    /// h_q = ∂t_q/∂p
    pub(super) h: Vec<NodeId>,
    /// N'
    pub(super) slope: NodeId,
    pub(super) slave_tangent: Option<Vector>,
}

impl Sliding {
    pub(super) fn new(
        program: &mut Program,
        kinematics: &Kinematics,
        contact: &Contact,
        axis: Option<Axis>,
        rolls: bool,
    ) -> Self {
        let (d, p) = (contact.d, contact.p);
        let third: Vec<Vector> = (0..third_derivatives(p))
            .map(|k| program.input_vector(&format!("third_{k}"), d))
            .collect();
        let slip = program.input_vector("s", p).0;
        let t = program.input_vector("t", p).0;
        let c = (0..p)
            .map(|q| program.input_vector(&format!("c_{q}"), p).0)
            .collect();
        let h = program.input_vector("h", p).0;
        let slope = program.input("slope");
        let force = if rolls {
            program.input_vector("force", p).0
        } else {
            t.clone()
        };
        let slave_tangent =
            (axis == Some(Axis::Slave)).then(|| program.input_vector("slave_tangent", d));
        let graph = &mut program.graph;
        let third = third
            .iter()
            .zip(&kinematics.third)
            .map(|(third, &remains)| match remains {
                true => contact.n.dot(graph, third),
                false => graph.constant(0.0),
            })
            .collect();
        Self {
            third,
            slip,
            t,
            force,
            c,
            h,
            slope,
            slave_tangent,
        }
    }
}
