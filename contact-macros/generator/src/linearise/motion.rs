//! Linear forms over the motion of two curves: the rows in which a linearisation of their angles is written.
//!
//! A form multiplies s_A and, for either curve i, s_A,i, s_A,ii and s_A,iii by a vector each.

use super::row;
use crate::ir::{Graph, NodeId, Program, Vector};

/// Coefficients of a linear form of δx.
#[derive(Clone)]
pub(super) struct Motion {
    /// Multiplies δr.
    pub(super) position: Vector,
    /// Multiplies δr_,i.
    pub(super) turning: Vec<Vector>,
    /// Multiplies δr_,ii.
    pub(super) bending: Vec<Vector>,
    /// Multiplies δr_,iii.
    pub(super) third: Vec<Vector>,
}

impl Motion {
    /// The zero form.
    pub(super) fn zero(graph: &mut Graph) -> Self {
        let none = Vector::zero(graph, 3);
        Self {
            position: none.clone(),
            turning: vec![none.clone(); 2],
            bending: vec![none.clone(); 2],
            third: vec![none; 2],
        }
    }

    /// δζ^i = E^i_q Z_q from the forms Z_q of the frame.
    pub(super) fn of_parameter(
        graph: &mut Graph,
        (frame, n): (&[Vec<NodeId>], &Vector),
        projection: &[row::Variation],
        i: usize,
    ) -> Self {
        let mut result = Self::zero(graph);
        for (q, form) in projection.iter().enumerate() {
            let position = form.position.scale(graph, frame[i][q]);
            result.position = result.position.add(graph, &position);
            for (to, &lever) in result.turning.iter_mut().zip(&form.turning) {
                let lever = graph.multiply(lever, frame[i][q]);
                let turning = n.scale(graph, lever);
                *to = to.add(graph, &turning);
            }
        }
        result
    }

    /// All vectors, in the order of the outputs.
    fn vectors(&self) -> impl Iterator<Item = &Vector> {
        let rows = self.turning.iter().chain(&self.bending).chain(&self.third);
        std::iter::once(&self.position).chain(rows)
    }

    fn vectors_mut(&mut self) -> impl Iterator<Item = &mut Vector> {
        let rows = self.turning.iter_mut().chain(&mut self.bending);
        let rows = rows.chain(&mut self.third);
        std::iter::once(&mut self.position).chain(rows)
    }

    /// self + factor·other
    pub(super) fn add_scaled(&mut self, graph: &mut Graph, factor: NodeId, other: &Self) {
        for (to, from) in self.vectors_mut().zip(other.vectors()) {
            let scaled = from.scale(graph, factor);
            *to = to.add(graph, &scaled);
        }
    }

    /// factor·self
    pub(super) fn scaled(&self, graph: &mut Graph, factor: NodeId) -> Self {
        let mut result = Self::zero(graph);
        result.add_scaled(graph, factor, self);
        result
    }

    /// Adds the outputs of the form.
    pub(super) fn output(&self, program: &mut Program, name: &str) {
        for (k, vector) in self.vectors().enumerate() {
            program.output_vector(&format!("{name}_{k}"), vector);
        }
    }

    /// Adds the outputs of a form without third derivatives.
    pub(super) fn output_lower(&self, program: &mut Program, name: &str) {
        for (k, vector) in self.vectors().take(5).enumerate() {
            program.output_vector(&format!("{name}_{k}"), vector);
        }
    }
}

/// The total variation of a vector of the two curves, as the three forms of its components.
#[derive(Clone)]
pub(super) struct Variation(Vec<Motion>);

impl Variation {
    /// Forms of a vector that does not move.
    pub(super) fn none(graph: &mut Graph) -> Self {
        Self(vec![Motion::zero(graph); 3])
    }

    /// The unit row `row` of every component, and factor·δζ for each (factor, δζ).
    pub(super) fn new(
        graph: &mut Graph,
        row: fn(&mut Motion, usize) -> &mut Vector,
        curve: usize,
        shifts: &[(&Vector, &Motion)],
    ) -> Self {
        let one = graph.constant(1.0);
        let forms = (0..3).map(|k| {
            let mut form = Motion::zero(graph);
            row(&mut form, curve).0[k] = one;
            for (slope, shift) in shifts {
                form.add_scaled(graph, slope.0[k], shift);
            }
            form
        });
        Self(forms.collect())
    }

    /// direction·D
    pub(super) fn along(&self, graph: &mut Graph, direction: &Vector) -> Motion {
        let mut result = Motion::zero(graph);
        for (form, &component) in self.0.iter().zip(&direction.0) {
            result.add_scaled(graph, component, form);
        }
        result
    }
}
