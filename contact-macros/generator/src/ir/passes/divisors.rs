//! The values that a program divides by: an element evaluates them before the program itself, so that a master's
//! axis or a slave without area gives a status instead of 0/0.

use std::collections::BTreeSet;

use crate::ir::{Binary, Graph, Node, NodeId, Program, Unary};

/// The inputs of `program` → the values that must not vanish: all its denominators, and √a wherever a
/// must be positive (logarithms, powers that are not whole). `None` where nothing can vanish.
pub fn divisor_program(program: &Program, name: &str) -> Option<Program> {
    let mut result = Program {
        name: name.to_string(),
        outputs: Vec::new(),
        terms: Vec::new(),
        ..program.clone()
    };
    let needed = program.needed();
    let mut found = BTreeSet::new();
    for (&node, _) in program
        .graph
        .nodes()
        .iter()
        .zip(&needed)
        .filter(|(_, needed)| **needed)
    {
        found.extend(divisor(&mut result.graph, node));
    }
    for (number, &id) in found.iter().enumerate() {
        result.output(format!("divisor_{number}"), id);
    }
    (!found.is_empty()).then_some(result)
}

/// What must not vanish for `node` to have a value.
fn divisor(graph: &mut Graph, node: Node) -> Option<NodeId> {
    let value = match node {
        Node::Divide(_, b) => b,
        Node::Unary(Unary::Ln, a) => graph.unary(Unary::Sqrt, a),
        Node::Binary(Binary::Pow, a, b) => match graph.value(b) {
            Some(exponent) if exponent.fract() == 0.0 => a,
            _ => graph.unary(Unary::Sqrt, a),
        },
        _ => return None,
    };
    graph.value(value).is_none().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{differentiate, interpret};

    #[test]
    fn the_slope_of_a_root_divides_by_the_root() {
        let mut program = Program::new("f");
        let (x, y) = (program.input("x"), program.input("y"));
        let graph = &mut program.graph;
        let (xx, yy) = (graph.multiply(x, x), graph.multiply(y, y));
        let sum = graph.add(xx, yy);
        let root = graph.unary(Unary::Sqrt, sum);
        program.output("f", root);
        assert!(divisor_program(&program, "divisors").is_none());
        let slope = differentiate(&mut program.graph, root, 0);
        program.output("slope", slope);
        let divisors = divisor_program(&program, "divisors").expect("a root to divide by");
        assert_eq!(interpret(&divisors, &[3.0, 4.0]), [5.0]);
    }

    #[test]
    fn a_logarithm_needs_a_positive_argument() {
        let mut program = Program::new("f");
        let x = program.input("x");
        let logarithm = program.graph.unary(Unary::Ln, x);
        program.output("f", logarithm);
        let divisors = divisor_program(&program, "divisors").expect("an argument");
        assert_eq!(interpret(&divisors, &[4.0]), [2.0]);
    }
}
