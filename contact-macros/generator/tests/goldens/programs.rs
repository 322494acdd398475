//! Programs as text: one operation per line, the equation beside each term.

use std::fmt::Write as _;

use contact_generator::ir::{Binary, Node, NodeId, Program, Unary};

/// All programs, one after the other.
pub fn listing<'a>(programs: impl Iterator<Item = &'a Program>) -> String {
    let programs: Vec<String> = programs.map(text).collect();
    programs.join("\n")
}

fn text(program: &Program) -> String {
    let (name, operations) = (&program.name, program.operations());
    let mut text = format!("{name}: {operations} operations\n");
    let _ = writeln!(text, "    inputs {}", program.inputs.join(" "));
    let needed = program.needed();
    for (index, &node) in program.graph.nodes().iter().enumerate() {
        let shown = node.is_operation() || matches!(node, Node::Term(..));
        if needed[index] && shown {
            let _ = writeln!(text, "    t{index} = {}", operation(program, node));
        }
    }
    for (name, id) in &program.outputs {
        let _ = writeln!(text, "    output {name} = {}", operand(program, *id));
    }
    for term in program.terms.iter().filter(|term| !term.present) {
        let _ = writeln!(text, "    left out {}: {}", term.tag, term.reason);
    }
    text
}

fn operand(program: &Program, id: NodeId) -> String {
    match program.graph.node(id) {
        Node::Constant(bits) => f64::from_bits(bits).to_string(),
        Node::Input(number) => program.inputs[number as usize].clone(),
        _ => format!("t{}", id.0),
    }
}

fn operation(program: &Program, node: Node) -> String {
    let of = |id: NodeId| operand(program, id);
    match node {
        Node::Negate(a) => format!("-{}", of(a)),
        Node::Add(a, b) => format!("{} + {}", of(a), of(b)),
        Node::Subtract(a, b) => format!("{} - {}", of(a), of(b)),
        Node::Multiply(a, b) => format!("{}*{}", of(a), of(b)),
        Node::Divide(a, b) => format!("{}/{}", of(a), of(b)),
        Node::Unary(function, a) => format!("{}({})", unary(function), of(a)),
        Node::Binary(Binary::Pow, a, b) => format!("pow({}, {})", of(a), of(b)),
        Node::Binary(Binary::Atan2, a, b) => format!("atan2({}, {})", of(a), of(b)),
        Node::Term(a, term) => {
            let tag = program.terms[usize::from(term.0)].tag;
            format!("{:<30}[eq:{tag}]", of(a))
        }
        Node::Constant(_) | Node::Input(_) => unreachable!("shown as an operand"),
    }
}

fn unary(function: Unary) -> &'static str {
    match function {
        Unary::Sqrt => "sqrt",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
    }
}
