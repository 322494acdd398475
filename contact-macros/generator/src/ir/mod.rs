//! Intermediate representation: programs of scalar operations for one contact point.
//!
//! A [`Program`] has named inputs, named outputs and a hash-consed [`Graph`]. Nodes of the mesh do
//! not occur here: they are loops of constant length over shape rows in the run time.

mod differentiate;
mod graph;
mod interpret;
mod lower;
pub mod passes;
mod vector;

pub use differentiate::differentiate;
pub use graph::{Binary, Graph, Node, NodeId, TermId, Unary};
pub use interpret::interpret;
pub use lower::{Scope, lower};
pub use vector::Vector;

/// One term of a linearisation, as the proof knows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Equation tag of the documentation, for example `13-curvature`.
    pub tag: &'static str,
    /// False where the term vanishes identically for this element and was left out.
    pub present: bool,
    /// Why it vanishes; empty where present.
    pub reason: String,
}

/// A straight-line program: inputs in, outputs out, no branches.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Name of the emitted function.
    pub name: String,
    /// Names of the inputs, in order.
    pub inputs: Vec<String>,
    /// The operations.
    pub graph: Graph,
    /// Names and values of the outputs, in order.
    pub outputs: Vec<(String, NodeId)>,
    /// Terms of the linearisation that the outputs are made of.
    pub terms: Vec<Term>,
}

impl Program {
    /// An empty program.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_string(),
            ..Self::default()
        }
    }

    /// Adds an input and returns its node.
    pub fn input(&mut self, name: impl Into<String>) -> NodeId {
        self.inputs.push(name.into());
        self.graph.input(self.inputs.len() - 1)
    }

    /// Adds the inputs `name_0 … name_{n-1}`.
    pub fn input_vector(&mut self, name: &str, n: usize) -> Vector {
        Vector((0..n).map(|k| self.input(format!("{name}_{k}"))).collect())
    }

    /// Adds an output.
    pub fn output(&mut self, name: impl Into<String>, value: NodeId) {
        self.outputs.push((name.into(), value));
    }

    /// Adds the outputs `name_0 …`.
    pub fn output_vector(&mut self, name: &str, value: &Vector) {
        for (k, &v) in value.0.iter().enumerate() {
            self.output(format!("{name}_{k}"), v);
        }
    }

    /// Marks `coefficient` as the coefficient of the term with equation tag `tag`. Where nothing that
    /// reaches an output uses it, [`Program::settle_terms`] records it as left out for `reason`.
    pub fn term(&mut self, tag: &'static str, coefficient: NodeId, reason: &str) -> NodeId {
        self.terms(tag, &[coefficient], reason)[0]
    }

    /// [`Program::term`] with several coefficients.
    pub fn terms(
        &mut self,
        tag: &'static str,
        coefficients: &[NodeId],
        reason: &str,
    ) -> Vec<NodeId> {
        let id = TermId(u16::try_from(self.terms.len()).expect("fewer than 65536 terms"));
        self.terms.push(Term {
            tag,
            present: true,
            reason: reason.to_string(),
        });
        coefficients
            .iter()
            .map(|&coefficient| self.graph.term(coefficient, id))
            .collect()
    }

    /// Records a term that this form of the linearisation does not have.
    pub fn left_out(&mut self, tag: &'static str, reason: &str) {
        self.terms.push(Term {
            tag,
            present: false,
            reason: reason.to_string(),
        });
    }

    /// Finds out which terms reach an output; call it when all outputs are there.
    pub fn settle_terms(&mut self) {
        let needed = self.needed();
        for (number, term) in self.terms.iter_mut().enumerate() {
            let id = TermId(number as u16);
            let used = self.graph.nodes().iter().zip(&needed).any(
                |(node, needed)| matches!(node, Node::Term(_, used) if *used == id && *needed),
            );
            term.present = used;
            if used {
                term.reason.clear();
            }
        }
    }

    /// Number of arithmetic operations that the outputs need.
    pub fn operations(&self) -> usize {
        let needed = self.needed();
        self.graph
            .nodes()
            .iter()
            .zip(&needed)
            .filter(|(node, needed)| **needed && node.is_operation())
            .count()
    }

    /// For every node: do the outputs depend on it?
    pub fn needed(&self) -> Vec<bool> {
        let nodes = self.graph.nodes();
        let mut needed = vec![false; nodes.len()];
        for (_, id) in &self.outputs {
            needed[id.0 as usize] = true;
        }
        for index in (0..nodes.len()).rev() {
            if needed[index] {
                for operand in nodes[index].operands() {
                    needed[operand.0 as usize] = true;
                }
            }
        }
        needed
    }
}
