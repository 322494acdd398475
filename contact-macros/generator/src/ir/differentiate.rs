//! Symbolic differentiation: forward over the graph, sharing every intermediate derivative.

use super::{Binary, Graph, Node, NodeId, Unary};

/// ∂value/∂input, where `input` is the number of a program input. New nodes go into the same graph.
pub fn differentiate(graph: &mut Graph, value: NodeId, input: usize) -> NodeId {
    let zero = graph.constant(0.0);
    let mut derivative: Vec<NodeId> = Vec::with_capacity(value.0 as usize + 1);
    for index in 0..=value.0 {
        let node = graph.node(NodeId(index));
        let d = |a: NodeId| derivative[a.0 as usize];
        let result = if node.operands().all(|a| d(a) == zero) {
            match node {
                Node::Input(number) if number as usize == input => graph.constant(1.0),
                _ => zero,
            }
        } else {
            rule(graph, NodeId(index), node, d)
        };
        derivative.push(result);
    }
    derivative[value.0 as usize]
}

fn rule(graph: &mut Graph, id: NodeId, node: Node, d: impl Fn(NodeId) -> NodeId) -> NodeId {
    match node {
        Node::Constant(_) | Node::Input(_) => graph.constant(0.0),
        Node::Negate(a) => graph.negate(d(a)),
        Node::Add(a, b) => graph.add(d(a), d(b)),
        Node::Subtract(a, b) => graph.subtract(d(a), d(b)),
        Node::Multiply(a, b) => {
            let left = graph.multiply(d(a), b);
            let right = graph.multiply(a, d(b));
            graph.add(left, right)
        }
        // (a/b)' = (a' − (a/b) b')/b
        Node::Divide(_, b) if graph.value(b).is_none() => {
            let Node::Divide(a, b) = node else {
                unreachable!("matched above")
            };
            let change = graph.multiply(id, d(b));
            let numerator = graph.subtract(d(a), change);
            graph.divide(numerator, b)
        }
        Node::Divide(a, b) => graph.divide(d(a), b),
        Node::Unary(function, a) => {
            let slope = unary_slope(graph, function, id, a);
            graph.multiply(slope, d(a))
        }
        Node::Binary(Binary::Pow, a, b) => power_rule(graph, id, (a, b), (d(a), d(b))),
        Node::Binary(Binary::Atan2, a, b) => {
            let aa = graph.multiply(a, a);
            let bb = graph.multiply(b, b);
            let square = graph.add(aa, bb);
            let first = graph.multiply(b, d(a));
            let second = graph.multiply(a, d(b));
            let numerator = graph.subtract(first, second);
            graph.divide(numerator, square)
        }
        Node::Term(a, term) => {
            let inner = d(a);
            graph.term(inner, term)
        }
    }
}

/// Derivative of an elementary function at `a`, where `id` is its value.
fn unary_slope(graph: &mut Graph, function: Unary, id: NodeId, a: NodeId) -> NodeId {
    let one = graph.constant(1.0);
    match function {
        Unary::Sqrt => {
            let half = graph.constant(0.5);
            graph.divide(half, id)
        }
        Unary::Sin => graph.unary(Unary::Cos, a),
        Unary::Cos => {
            let sine = graph.unary(Unary::Sin, a);
            graph.negate(sine)
        }
        Unary::Tan => {
            let square = graph.multiply(id, id);
            graph.add(one, square)
        }
        Unary::Exp => id,
        Unary::Ln => graph.divide(one, a),
    }
}

/// (aᵇ)' = b aᵇ⁻¹ a' + aᵇ ln(a) b'
fn power_rule(
    graph: &mut Graph,
    id: NodeId,
    (a, b): (NodeId, NodeId),
    (da, db): (NodeId, NodeId),
) -> NodeId {
    let one = graph.constant(1.0);
    let lower = graph.subtract(b, one);
    let power = graph.binary(Binary::Pow, a, lower);
    let slope = graph.multiply(b, power);
    let base = graph.multiply(slope, da);
    if graph.is(db, 0.0) {
        return base;
    }
    let logarithm = graph.unary(Unary::Ln, a);
    let growth = graph.multiply(id, logarithm);
    let exponent = graph.multiply(growth, db);
    graph.add(base, exponent)
}

#[cfg(test)]
mod tests {
    use crate::ir::{Binary, Program, Sheet, Unary, interpret};

    /// Value number `which` of the elementary functions, and its derivative with respect to an input.
    fn program(which: usize, input: usize) -> Program {
        let sheet = Sheet::new("f");
        let (x, y) = (sheet.input("x"), sheet.input("y"));
        let quotient = x / y;
        let value = match which {
            0 => quotient,
            1 => x.binary(Binary::Pow, y),
            2 => y.atan2(x),
            _ => quotient.unary(FUNCTIONS[which - 3]),
        };
        sheet.output("value", value);
        sheet.output("slope", value.derivative(input));
        sheet.finish()
    }

    const FUNCTIONS: [Unary; 6] = [
        Unary::Sqrt,
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Exp,
        Unary::Ln,
    ];

    /// Central difference of every elementary function against its rule, to 1e-8.
    #[test]
    fn rules_agree_with_differences() {
        for (input, which) in (0..2).flat_map(|input| (0..9).map(move |which| (input, which))) {
            let program = program(which, input);
            let at = |shift: f64| {
                let mut inputs = [0.7, 1.3];
                inputs[input] += shift;
                interpret(&program, &inputs)
            };
            let difference = (at(1e-6)[0] - at(-1e-6)[0]) / 2e-6;
            assert!((difference - at(0.0)[1]).abs() < 1e-8, "{which} {input}");
        }
    }
}
