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
        result.outputs.push((format!("divisor_{number}"), id));
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
    use crate::ir::{Sheet, interpret};

    #[test]
    fn the_slope_of_a_root_divides_by_the_root() {
        let program = |with_slope: bool| {
            let sheet = Sheet::new("f");
            let (x, y) = (sheet.input("x"), sheet.input("y"));
            let root = (x * x + y * y).sqrt();
            sheet.output("f", root);
            if with_slope {
                sheet.output("slope", root.derivative(0));
            }
            sheet.finish()
        };
        assert!(divisor_program(&program(false), "divisors").is_none());
        let divisors = divisor_program(&program(true), "divisors").expect("a root to divide by");
        assert_eq!(interpret(&divisors, &[3.0, 4.0]), [5.0]);
    }

    #[test]
    fn a_logarithm_needs_a_positive_argument() {
        let sheet = Sheet::new("f");
        let x = sheet.input("x");
        sheet.output("f", x.unary(Unary::Ln));
        let divisors = divisor_program(&sheet.finish(), "divisors").expect("an argument");
        assert_eq!(interpret(&divisors, &[4.0]), [2.0]);
    }
}
