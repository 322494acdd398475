//! From declared expressions to nodes.

use std::collections::HashMap;

use super::{Binary, Graph, NodeId, Unary};
use crate::model::{BinaryOperator, Expr, Function};

/// What the names of an expression mean.
#[derive(Default, Clone)]
pub struct Scope {
    names: HashMap<String, NodeId>,
}

impl Scope {
    /// Gives `name` a meaning; a later definition hides an earlier one.
    pub fn define(&mut self, name: impl ToString, value: NodeId) {
        self.names.insert(name.to_string(), value);
    }

    /// Lowers `let name = expression;` bindings in order.
    pub fn bind<'a, N: ToString + 'a>(
        &mut self,
        graph: &mut Graph,
        bindings: impl IntoIterator<Item = &'a (N, Expr)>,
    ) {
        for (name, expression) in bindings {
            let value = lower(graph, self, expression);
            self.define(name.to_string(), value);
        }
    }
}

/// The node of a checked expression: the model has made sure that every name is defined.
pub fn lower(graph: &mut Graph, scope: &Scope, expression: &Expr) -> NodeId {
    match expression {
        Expr::Number(value) => graph.constant(*value),
        Expr::Variable(name) => scope.names[&name.to_string()],
        Expr::Negate(inner) => {
            let inner = lower(graph, scope, inner);
            graph.negate(inner)
        }
        Expr::Binary(operator, left, right) => {
            let left = lower(graph, scope, left);
            let right = lower(graph, scope, right);
            match operator {
                BinaryOperator::Add => graph.add(left, right),
                BinaryOperator::Subtract => graph.subtract(left, right),
                BinaryOperator::Multiply => graph.multiply(left, right),
                BinaryOperator::Divide => graph.divide(left, right),
            }
        }
        Expr::Call(function, arguments) => {
            let arguments: Vec<NodeId> = arguments
                .iter()
                .map(|argument| lower(graph, scope, argument))
                .collect();
            call(graph, *function, &arguments)
        }
    }
}

fn call(graph: &mut Graph, function: Function, arguments: &[NodeId]) -> NodeId {
    let unary = match function {
        Function::Sqrt => Unary::Sqrt,
        Function::Sin => Unary::Sin,
        Function::Cos => Unary::Cos,
        Function::Tan => Unary::Tan,
        Function::Exp => Unary::Exp,
        Function::Ln => Unary::Ln,
        Function::Pow => return graph.binary(Binary::Pow, arguments[0], arguments[1]),
        Function::Atan2 => return graph.binary(Binary::Atan2, arguments[0], arguments[1]),
    };
    graph.unary(unary, arguments[0])
}
