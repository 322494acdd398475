//! Linear forms over the motion of one contact point: the rows that a tangential linearisation is made of.
//!
//! A form multiplies s_A by a vector, s_A,q by one vector for each parameter, s_A,qr by n times a scalar,
//! and the row of the slave's tangent by a vector.

use super::{pair_index, second_derivatives};
use crate::ir::{Graph, NodeId, Vector};

/// Coefficients of a linear form of δx.
#[derive(Clone)]
pub(super) struct Form {
    /// Multiplies δr = s_A δx_A.
    pub(super) position: Vector,
    /// Multiplies δr_,q.
    pub(super) turning: Vec<Vector>,
    /// Multiplies n·δr_,11, n·δr_,12, n·δr_,22.
    pub(super) bending: Vec<NodeId>,
    /// Multiplies the motion of the slave's tangent.
    pub(super) slave: Vector,
}

impl Form {
    pub(super) fn zero(graph: &mut Graph, d: usize, p: usize) -> Self {
        let zero = graph.constant(0.0);
        let none = Vector::zero(graph, d);
        Self {
            position: none.clone(),
            turning: vec![none.clone(); p],
            bending: vec![zero; second_derivatives(p)],
            slave: none,
        }
    }

    /// self + factor·other
    pub(super) fn add_scaled(&mut self, graph: &mut Graph, factor: NodeId, other: &Self) {
        let add = |graph: &mut Graph, to: &mut Vector, from: &Vector| {
            let scaled = from.scale(graph, factor);
            *to = to.add(graph, &scaled);
        };
        add(graph, &mut self.position, &other.position);
        for (to, from) in self.turning.iter_mut().zip(&other.turning) {
            add(graph, to, from);
        }
        for (to, &from) in self.bending.iter_mut().zip(&other.bending) {
            let scaled = graph.multiply(factor, from);
            *to = graph.add(*to, scaled);
        }
        add(graph, &mut self.slave, &other.slave);
    }

    /// self + vector·δr
    pub(super) fn add_position(&mut self, graph: &mut Graph, vector: &Vector) {
        self.position = self.position.add(graph, vector);
    }

    /// self + vector·δr_,q
    pub(super) fn add_turning(&mut self, graph: &mut Graph, q: usize, vector: &Vector) {
        self.turning[q] = self.turning[q].add(graph, vector);
    }

    /// The form over the declared parameters: s_A,q = E^i_q s_A,i. Rows that vanish for parameters that
    /// move with no unknown are left out.
    pub(super) fn declared(
        &self,
        graph: &mut Graph,
        frame: &[Vec<NodeId>],
        moving: &[bool],
    ) -> Self {
        let (d, p) = (self.position.0.len(), self.turning.len());
        let mut result = Self::zero(graph, d, p);
        result.position = self.position.clone();
        result.slave = self.slave.clone();
        for i in 0..p {
            if !moving[i] {
                continue;
            }
            for q in 0..p {
                let part = self.turning[q].scale(graph, frame[i][q]);
                result.turning[i] = result.turning[i].add(graph, &part);
            }
            for j in 0..p {
                for q in 0..p {
                    for r in 0..p {
                        // an entry 12 stands for 12 and 21
                        let halves = if q == r { 1.0 } else { 0.5 };
                        let halves = graph.constant(halves);
                        let entry = graph.multiply(halves, self.bending[pair_index(q, r)]);
                        let entry = graph.multiply(frame[i][q], entry);
                        let entry = graph.multiply(entry, frame[j][r]);
                        let at = pair_index(i, j);
                        result.bending[at] = graph.add(result.bending[at], entry);
                    }
                }
            }
        }
        result
    }
}
