//! From declared expressions to scalars.

use std::collections::HashMap;

use syn::Ident;

use crate::ir::{Binary, Scalar, Sheet, Unary};
use crate::model::{BinaryOperator, Expr, Function, Geometry};

/// A sheet on which declared names have a meaning.
pub struct Scope<'s> {
    sheet: &'s Sheet,
    names: HashMap<String, Scalar<'s>>,
}

impl<'s> Scope<'s> {
    /// No name has a meaning yet.
    pub fn new(sheet: &'s Sheet) -> Self {
        Self {
            sheet,
            names: HashMap::new(),
        }
    }

    /// The names of a geometry: coordinates and parameters become inputs, bindings values.
    pub fn of_geometry(sheet: &'s Sheet, geometry: &Geometry) -> Self {
        let mut scope = Self::new(sheet);
        scope.inputs(&geometry.coordinates);
        scope.inputs(geometry.parameters.iter().map(|parameter| &parameter.name));
        scope.bind(&geometry.bindings);
        scope
    }

    /// Gives `name` a meaning; a later definition hides an earlier one.
    pub fn define(&mut self, name: impl ToString, value: Scalar<'s>) {
        self.names.insert(name.to_string(), value);
    }

    /// Adds an input for each of the `names`, which stand for them.
    pub fn inputs<'a>(&mut self, names: impl IntoIterator<Item = &'a Ident>) {
        for name in names {
            self.define(name, self.sheet.input(name.to_string()));
        }
    }

    /// Lowers `let name = expression;` bindings in order.
    pub fn bind(&mut self, bindings: &[(Ident, Expr)]) {
        for (name, expression) in bindings {
            self.define(name, self.lower(expression));
        }
    }

    /// The values of several expressions.
    pub fn lower_all(&self, expressions: &[Expr]) -> Vec<Scalar<'s>> {
        expressions.iter().map(|one| self.lower(one)).collect()
    }

    /// The value of a checked expression: the model has made sure that every name is defined.
    pub fn lower(&self, expression: &Expr) -> Scalar<'s> {
        match expression {
            Expr::Number(value) => self.sheet.constant(*value),
            Expr::Variable(name) => self.names[&name.to_string()],
            Expr::Negate(inner) => -self.lower(inner),
            Expr::Binary(operator, left, right) => {
                let (left, right) = (self.lower(left), self.lower(right));
                match operator {
                    BinaryOperator::Add => left + right,
                    BinaryOperator::Subtract => left - right,
                    BinaryOperator::Multiply => left * right,
                    BinaryOperator::Divide => left / right,
                }
            }
            Expr::Call(function, arguments) => call(*function, &self.lower_all(arguments)),
        }
    }
}

fn call<'s>(function: Function, arguments: &[Scalar<'s>]) -> Scalar<'s> {
    let unary = match function {
        Function::Sqrt => Unary::Sqrt,
        Function::Sin => Unary::Sin,
        Function::Cos => Unary::Cos,
        Function::Tan => Unary::Tan,
        Function::Exp => Unary::Exp,
        Function::Ln => Unary::Ln,
        Function::Pow => return arguments[0].binary(Binary::Pow, arguments[1]),
        Function::Atan2 => return arguments[0].atan2(arguments[1]),
    };
    arguments[0].unary(unary)
}
