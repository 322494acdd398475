//! Tensors of the projected parameters in a basis of orthogonal tangents. [eq:orthogonal-basis]

use super::pair_index;
use crate::ir::{Graph, NodeId, Vector};

/// A symmetric matrix of the projected parameters, entries 11, 12, 22.
pub(super) struct Symmetric(pub(super) Vec<NodeId>);

impl Symmetric {
    pub(super) fn at(&self, i: usize, j: usize) -> NodeId {
        self.0[pair_index(i, j)]
    }
}

/// b_1 and b_2 − t b_1 with t = a_12/a_11: a basis in which the metric is diagonal, so that nothing cancels
/// where the declared parameters are skew or two curves nearly parallel. [eq:orthogonal-basis]
pub(super) fn orthogonal(graph: &mut Graph, b: Vec<Vector>) -> (Vec<Vector>, NodeId) {
    let [first, second] = b.as_slice() else {
        let none = graph.constant(0.0);
        return (b, none);
    };
    let square = first.dot(graph, first);
    let mixed = first.dot(graph, second);
    let shear = graph.divide(mixed, square);
    let minus = graph.negate(shear);
    let along = first.scale(graph, minus);
    let second = second.add(graph, &along);
    (vec![first.clone(), second], shear)
}

/// a_11 b_2 − a_12 b_1: the direction of b_2 − t b_1 without a division in the way of the normal.
/// [eq:orthogonal-basis]
pub(super) fn orthogonal_direction(graph: &mut Graph, first: &Vector, second: &Vector) -> Vector {
    let square = first.dot(graph, first);
    let mixed = first.dot(graph, second);
    let minus = graph.negate(mixed);
    let along = first.scale(graph, minus);
    second.scale(graph, square).add(graph, &along)
}

/// A symmetric covariant tensor in the orthogonal basis:
/// κ_12 − t κ_11 and κ_22 − 2 t κ_12 + t² κ_11. [eq:orthogonal-basis]
pub(super) fn sheared(graph: &mut Graph, tensor: Symmetric, shear: NodeId) -> Symmetric {
    let [k11, k12, k22] = tensor.0[..] else {
        return tensor;
    };
    let back = graph.multiply(shear, k11);
    let mixed = graph.subtract(k12, back);
    // k22 − t (k12 + (k12 − t k11))
    let sum = graph.add(k12, mixed);
    let back = graph.multiply(shear, sum);
    let last = graph.subtract(k22, back);
    Symmetric(vec![k11, mixed, last])
}

/// Contravariant components in the declared basis from those in the orthogonal one:
/// m^11 − t (m^12 + m^21) + t² m^22 and m^12 − t m^22. [eq:orthogonal-basis]
pub(super) fn contravariant(graph: &mut Graph, tensor: Symmetric, shear: NodeId) -> Symmetric {
    let [m11, m12, m22] = tensor.0[..] else {
        return tensor;
    };
    let back = graph.multiply(shear, m22);
    let mixed = graph.subtract(m12, back);
    let sum = graph.add(m12, mixed);
    let back = graph.multiply(shear, sum);
    let first = graph.subtract(m11, back);
    Symmetric(vec![first, mixed, m22])
}

/// Index pairs k ≤ l of a symmetric matrix.
pub(super) fn upper(d: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..d).flat_map(move |k| (k..d).map(move |l| (k, l)))
}

/// Position of (k, l) in the order of [`upper`].
pub(super) fn upper_index(d: usize, k: usize, l: usize) -> usize {
    let (k, l) = (k.min(l), k.max(l));
    k * d - k * (k + 1) / 2 + l
}
