//! Intermediate representation: programs of scalar operations for one contact point.
//!
//! A [`Sheet`] is a program that is being written, a [`Program`] a finished one. It has named inputs, named outputs and a hash-consed [`Graph`]. Nodes of the mesh do
//! not occur here: they are loops of constant length over shape rows in the run time.

mod differentiate;
mod graph;
mod interpret;
pub mod passes;
mod sheet;
mod tensor;

pub use differentiate::differentiate;
pub use graph::{Binary, Graph, Node, NodeId, TermId, Unary};
pub use interpret::interpret;
pub use sheet::{Scalar, Sheet};
pub use tensor::{Symmetric, Vector, pairs};

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
    /// Finds out which terms reach an output; call it when all outputs are there.
    fn settle_terms(&mut self) {
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
