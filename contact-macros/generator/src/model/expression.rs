//! Checked expressions: every name and every function is known.

use proc_macro2::Span;
use syn::Ident;

pub use crate::syntax::BinaryOperator;

/// An expression whose variables and functions have been resolved.
#[derive(Debug, Clone)]
pub enum Expr {
    /// A literal.
    Number(f64),
    /// A coordinate, a parameter or a binding.
    Variable(Ident),
    /// `-x`.
    Negate(Box<Expr>),
    /// `x op y`.
    Binary(BinaryOperator, Box<Expr>, Box<Expr>),
    /// `f(x, ..)` with the right number of arguments.
    Call(Function, Vec<Expr>),
}

/// The functions of the language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Sine of an angle in radians.
    Sin,
    /// Cosine of an angle in radians.
    Cos,
    /// Tangent of an angle in radians.
    Tan,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// `pow(x, y)`: x to the power y.
    Pow,
    /// `atan2(y, x)`: the angle of the point (x, y).
    Atan2,
}

impl Function {
    /// Every function, in the order in which messages list them.
    pub const ALL: [Function; 8] = [
        Function::Sqrt,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Exp,
        Function::Ln,
        Function::Pow,
        Function::Atan2,
    ];

    /// The name in the language.
    pub fn name(self) -> &'static str {
        match self {
            Function::Sqrt => "sqrt",
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Exp => "exp",
            Function::Ln => "ln",
            Function::Pow => "pow",
            Function::Atan2 => "atan2",
        }
    }

    /// The names of the arguments, as messages show them.
    pub fn arguments(self) -> &'static [&'static str] {
        match self {
            Function::Pow => &["x", "y"],
            Function::Atan2 => &["y", "x"],
            _ => &["x"],
        }
    }

    /// How the function is written, such as `atan2(y, x)`.
    pub fn signature(self) -> String {
        format!("{}({})", self.name(), self.arguments().join(", "))
    }

    /// The function of that name.
    pub fn from_name(name: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|f| f.name() == name)
    }
}

impl Expr {
    /// Where the expression stands: the span of its first name, or the call site if it has none.
    pub fn span(&self) -> Span {
        let mut first = None;
        self.visit_variables(&mut |name| first = first.or(Some(name.span())));
        first.unwrap_or_else(Span::call_site)
    }

    /// Calls `visit` for every variable, from left to right.
    pub fn visit_variables(&self, visit: &mut impl FnMut(&Ident)) {
        match self {
            Expr::Number(_) => {}
            Expr::Variable(name) => visit(name),
            Expr::Negate(x) => x.visit_variables(visit),
            Expr::Binary(_, x, y) => {
                x.visit_variables(visit);
                y.visit_variables(visit);
            }
            Expr::Call(_, arguments) => {
                for x in arguments {
                    x.visit_variables(visit);
                }
            }
        }
    }

    /// The value, where `variable` gives the value of each name (`None`: NaN).
    pub fn evaluate(&self, variable: &impl Fn(&Ident) -> Option<f64>) -> f64 {
        match self {
            Expr::Number(value) => *value,
            Expr::Variable(name) => variable(name).unwrap_or(f64::NAN),
            Expr::Negate(x) => -x.evaluate(variable),
            Expr::Binary(operator, x, y) => {
                operator.apply(x.evaluate(variable), y.evaluate(variable))
            }
            Expr::Call(function, arguments) => {
                let values: Vec<f64> = arguments.iter().map(|x| x.evaluate(variable)).collect();
                function.apply(&values)
            }
        }
    }
}

impl BinaryOperator {
    /// The value of `x op y`.
    pub fn apply(self, x: f64, y: f64) -> f64 {
        match self {
            BinaryOperator::Add => x + y,
            BinaryOperator::Subtract => x - y,
            BinaryOperator::Multiply => x * y,
            BinaryOperator::Divide => x / y,
        }
    }
}

impl Function {
    /// The value of `f(arguments)`; NaN where the number of arguments is wrong.
    pub fn apply(self, arguments: &[f64]) -> f64 {
        match (self, arguments) {
            (Function::Sqrt, [x]) => x.sqrt(),
            (Function::Sin, [x]) => x.sin(),
            (Function::Cos, [x]) => x.cos(),
            (Function::Tan, [x]) => x.tan(),
            (Function::Exp, [x]) => x.exp(),
            (Function::Ln, [x]) => x.ln(),
            (Function::Pow, [x, y]) => x.powf(*y),
            (Function::Atan2, [y, x]) => y.atan2(*x),
            _ => f64::NAN,
        }
    }
}
