//! Reference interpreter: what a program means. A pass is right when this agrees before and after.

use super::{Binary, Node, Program, Unary};

/// Values of the outputs for the given inputs.
///
/// # Panics
/// `inputs` is shorter than the program's list of inputs.
pub fn interpret(program: &Program, inputs: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(program.graph.nodes().len());
    for &node in program.graph.nodes() {
        let at = |id: super::NodeId| values[id.0 as usize];
        let value = match node {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Input(index) => inputs[index as usize],
            Node::Negate(a) => -at(a),
            Node::Add(a, b) => at(a) + at(b),
            Node::Subtract(a, b) => at(a) - at(b),
            Node::Multiply(a, b) => at(a) * at(b),
            Node::Divide(a, b) => at(a) / at(b),
            Node::Unary(function, a) => unary(function, at(a)),
            Node::Binary(Binary::Pow, a, b) => at(a).powf(at(b)),
            Node::Binary(Binary::Atan2, a, b) => at(a).atan2(at(b)),
            Node::Term(a, _) => at(a),
        };
        values.push(value);
    }
    program
        .outputs
        .iter()
        .map(|(_, id)| values[id.0 as usize])
        .collect()
}

fn unary(function: Unary, x: f64) -> f64 {
    match function {
        Unary::Sqrt => x.sqrt(),
        Unary::Sin => x.sin(),
        Unary::Cos => x.cos(),
        Unary::Tan => x.tan(),
        Unary::Exp => x.exp(),
        Unary::Ln => x.ln(),
    }
}
