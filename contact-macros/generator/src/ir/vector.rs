//! Vectors of nodes: dot and cross products in index notation.

use super::{Graph, NodeId, Unary};

/// Components of a vector, each a node.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector(pub Vec<NodeId>);

impl Vector {
    /// The zero vector of dimension `n`.
    pub fn zero(graph: &mut Graph, n: usize) -> Self {
        let zero = graph.constant(0.0);
        Self(vec![zero; n])
    }

    /// True where every component vanishes identically.
    pub fn vanishes(&self, graph: &Graph) -> bool {
        self.0.iter().all(|&v| graph.is(v, 0.0))
    }

    /// a·b
    pub fn dot(&self, graph: &mut Graph, other: &Self) -> NodeId {
        let mut sum = graph.constant(0.0);
        for (&a, &b) in self.0.iter().zip(&other.0) {
            let product = graph.multiply(a, b);
            sum = graph.add(sum, product);
        }
        sum
    }

    /// a×b in three dimensions.
    pub fn cross(&self, graph: &mut Graph, other: &Self) -> Self {
        let component = |graph: &mut Graph, i: usize, j: usize| {
            let positive = graph.multiply(self.0[i], other.0[j]);
            let negative = graph.multiply(self.0[j], other.0[i]);
            graph.subtract(positive, negative)
        };
        Self(vec![
            component(graph, 1, 2),
            component(graph, 2, 0),
            component(graph, 0, 1),
        ])
    }

    /// factor·a
    pub fn scale(&self, graph: &mut Graph, factor: NodeId) -> Self {
        Self(self.0.iter().map(|&v| graph.multiply(factor, v)).collect())
    }

    /// a + b
    pub fn add(&self, graph: &mut Graph, other: &Self) -> Self {
        Self(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(&a, &b)| graph.add(a, b))
                .collect(),
        )
    }

    /// |a|
    pub fn norm(&self, graph: &mut Graph) -> NodeId {
        let square = self.dot(graph, self);
        graph.unary(Unary::Sqrt, square)
    }
}
