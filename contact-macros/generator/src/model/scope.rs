//! Names of one item, and the resolution of expressions in them.

use syn::Ident;

use super::expression::{Expr, Function};
use crate::diagnostics::{Mistakes, names as messages};
use crate::syntax;

/// What a name of an item stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Coordinate,
    Gap,
    Pressure,
    Slip,
    Parameter,
    Binding,
}

impl Role {
    fn describe(self) -> &'static str {
        match self {
            Role::Coordinate => "coordinate",
            Role::Gap => "gap",
            Role::Pressure => "pressure",
            Role::Slip => "slip",
            Role::Parameter => "parameter",
            Role::Binding => "binding",
        }
    }
}

/// The names that may be used in an expression.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    names: Vec<(String, Role)>,
    /// Names that exist in the item but not here, and the reason.
    hidden: Vec<(String, Role)>,
    place: &'static str,
    allowed: &'static str,
}

impl Scope {
    /// Declares a name; one that is taken is a mistake.
    pub fn declare(&mut self, name: &Ident, role: Role, mistakes: &mut Mistakes) {
        let text = name.to_string();
        let taken = self
            .names
            .iter()
            .chain(&self.hidden)
            .find(|(known, _)| *known == text);
        if let Some((_, role)) = taken {
            mistakes.report(name.span(), messages::name_taken(&text, role.describe()));
        } else {
            self.names.push((text, role));
        }
    }

    /// The same names, of which only those of one role may be used in `place`.
    pub fn only(&self, role: Role, place: &'static str, allowed: &'static str) -> Scope {
        let (names, hidden) = self
            .names
            .iter()
            .cloned()
            .partition(|(_, known)| *known == role);
        Scope {
            names,
            hidden,
            place,
            allowed,
        }
    }

    /// The expression with every name looked up; what is unknown becomes a mistake and NaN.
    pub fn resolve(&self, expr: &syntax::Expr, mistakes: &mut Mistakes) -> Expr {
        match expr {
            syntax::Expr::Number(value, _) => Expr::Number(*value),
            syntax::Expr::Name(name) => self.variable(name, mistakes),
            syntax::Expr::Negate(x, _) => Expr::Negate(Box::new(self.resolve(x, mistakes))),
            syntax::Expr::Binary(operator, x, y) => Expr::Binary(
                *operator,
                Box::new(self.resolve(x, mistakes)),
                Box::new(self.resolve(y, mistakes)),
            ),
            syntax::Expr::Call(name, arguments) => {
                let arguments: Vec<Expr> = arguments
                    .iter()
                    .map(|x| self.resolve(x, mistakes))
                    .collect();
                self.call(name, arguments, mistakes)
            }
        }
    }

    fn find<'a>(names: &'a [(String, Role)], text: &str) -> Option<&'a (String, Role)> {
        names.iter().find(|(known, _)| known == text)
    }

    fn variable(&self, name: &Ident, mistakes: &mut Mistakes) -> Expr {
        let text = name.to_string();
        if Self::find(&self.names, &text).is_some() {
            return Expr::Variable(name.clone());
        }
        let message = if let Some((_, role)) = Self::find(&self.hidden, &text) {
            messages::variable_not_here(&text, role.describe(), self.place, self.allowed)
        } else if let Some(function) = Function::from_name(&text) {
            messages::function_without_arguments(&text, &function.signature())
        } else {
            let known: Vec<String> = self.names.iter().map(|(name, _)| name.clone()).collect();
            messages::unknown_variable(&text, &known)
        };
        mistakes.report(name.span(), message);
        Expr::Number(f64::NAN)
    }

    fn call(&self, name: &Ident, arguments: Vec<Expr>, mistakes: &mut Mistakes) -> Expr {
        let text = name.to_string();
        let message = match Function::from_name(&text) {
            Some(function) if function.arguments().len() == arguments.len() => {
                return Expr::Call(function, arguments);
            }
            Some(function) => {
                messages::wrong_argument_count(&text, &function.signature(), arguments.len())
            }
            None if Self::find(&self.names, &text).is_some() => messages::variable_called(&text),
            None => messages::unknown_function(&text, &Function::ALL.map(|f| f.name().to_string())),
        };
        mistakes.report(name.span(), message);
        Expr::Number(f64::NAN)
    }
}
