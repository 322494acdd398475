//! Linear forms over the motion of one contact point: the rows in which a tangential linearisation is written.
//!
//! A form is written in the variations Z_k of the projected parameters and in the motions apart from them, along
//! the axes of the contact point; most of its entries vanish. Only its last step, over the declared parameters,
//! has vectors.

use super::contact::{Contact, combination};
use super::{pair_index, second_derivatives};
use crate::ir::{Graph, NodeId, Vector};

/// Z_q = position·δr + turning_i n·δr_,i, i over the declared parameters.
pub(super) struct Variation {
    /// Multiplies δr.
    pub(super) position: Vector,
    /// Multiplies n·δr_,i.
    pub(super) turning: Vec<NodeId>,
}

/// Coefficients of a linear form of δx.
#[derive(Clone)]
pub(super) struct Form {
    /// Multiplies Z_k.
    pub(super) variation: Vec<NodeId>,
    /// Multiplies n·δr.
    pub(super) normal: NodeId,
    /// Multiplies δr.
    pub(super) position: Vector,
    /// Entry (q, r) multiplies e_q·δr_,r.
    pub(super) along: Vec<Vec<NodeId>>,
    /// Multiplies n·δr_,r.
    pub(super) lift: Vec<NodeId>,
    /// Multiplies n·δr_,11, n·δr_,12, n·δr_,22 of the declared parameters.
    pub(super) bending: Vec<NodeId>,
    /// Multiplies the motion of the slave's tangent.
    pub(super) slave: Vector,
}

/// A form over the declared parameters.
pub(super) struct Declared {
    /// Multiplies δr.
    pub(super) position: Vector,
    /// Multiplies δr_,i.
    pub(super) turning: Vec<Vector>,
}

impl Form {
    pub(super) fn zero(graph: &mut Graph, d: usize, p: usize) -> Self {
        let zero = graph.constant(0.0);
        let none = Vector::zero(graph, d);
        Self {
            variation: vec![zero; p],
            normal: zero,
            position: none.clone(),
            along: vec![vec![zero; p]; p],
            lift: vec![zero; p],
            bending: vec![zero; second_derivatives(p)],
            slave: none,
        }
    }

    /// self + factor·other
    pub(super) fn add_scaled(&mut self, graph: &mut Graph, factor: NodeId, other: &Self) {
        let mut add = |to: &mut NodeId, from: NodeId| {
            let scaled = graph.multiply(factor, from);
            *to = graph.add(*to, scaled);
        };
        add(&mut self.normal, other.normal);
        let own = [&mut self.variation, &mut self.lift, &mut self.bending];
        let others = [&other.variation, &other.lift, &other.bending];
        for (to, from) in own.into_iter().zip(others) {
            to.iter_mut()
                .zip(from)
                .for_each(|(to, &from)| add(to, from));
        }
        let own = self.along.iter_mut().flatten();
        own.zip(other.along.iter().flatten())
            .for_each(|(to, &from)| add(to, from));
        let own = self.position.0.iter_mut().chain(&mut self.slave.0);
        own.zip(other.position.0.iter().chain(&other.slave.0))
            .for_each(|(to, &from)| add(to, from));
    }

    /// self + factor e_q·δr_,r
    pub(super) fn add_along(&mut self, graph: &mut Graph, (q, r): (usize, usize), factor: NodeId) {
        self.along[q][r] = graph.add(self.along[q][r], factor);
    }

    /// The form over the declared parameters: δr_,q = E^i_q δr_,i. Rows of parameters that move with no
    /// unknown are left out.
    pub(super) fn declared(
        &self,
        graph: &mut Graph,
        contact: &Contact,
        variations: &[Variation],
        moving: &[bool],
    ) -> Declared {
        let (d, p) = (contact.d, contact.p);
        let through = combination(
            graph,
            d,
            &|k| (self.variation[k], variations[k].position.clone()),
            p,
        );
        let normal = contact.n.scale(graph, self.normal);
        let position = through.add(graph, &normal).add(graph, &self.position);
        let mut turning = Vec::new();
        for i in 0..p {
            if !moving[i] {
                turning.push(Vector::zero(graph, d));
                continue;
            }
            let mut sum = Vector::zero(graph, d);
            for q in 0..p {
                let factor = contact.on_declared(graph, &self.along[q], i);
                let part = contact.e[q].scale(graph, factor);
                sum = sum.add(graph, &part);
            }
            let mut lift = contact.on_declared(graph, &self.lift, i);
            for (&factor, variation) in self.variation.iter().zip(variations) {
                let part = graph.multiply(factor, variation.turning[i]);
                lift = graph.add(lift, part);
            }
            let part = contact.n.scale(graph, lift);
            turning.push(sum.add(graph, &part));
        }
        Declared { position, turning }
    }
}

/// v^i E^j_k + v^j E^i_k for i ≠ j, v^i E^i_k else: the factor of n·δr_,ij in Σ_ij v^i E^j_k n·δr_,ij.
pub(super) fn symmetric_row(
    graph: &mut Graph,
    frame: &[Vec<NodeId>],
    v: &[NodeId],
    k: usize,
) -> Vec<NodeId> {
    let p = v.len();
    let mut row = vec![graph.constant(0.0); second_derivatives(p)];
    for i in 0..p {
        for j in 0..p {
            let part = graph.multiply(v[i], frame[j][k]);
            let at = pair_index(i, j);
            row[at] = graph.add(row[at], part);
        }
    }
    row
}
