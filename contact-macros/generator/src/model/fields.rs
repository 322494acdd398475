//! The block of a geometry or law: bindings in order, and fields by name.

use syn::Ident;

use super::expression::Expr;
use super::scope::{Role, Scope};
use crate::diagnostics::{Mistakes, names as messages};
use crate::syntax::{self, Field, Statement, Value};

/// The fields of a block: known ones only, each once.
pub(super) struct Fields<'a> {
    fields: Vec<&'a Field>,
    /// Whether a field that is not there is missing rather than misspelt or misread.
    complete: bool,
    item: &'static str,
    name: &'a Ident,
}

impl<'a> Fields<'a> {
    /// Sorts a block into fields; `item` is what messages call it, `known` its fields.
    pub fn new(
        name: &'a Ident,
        item: &'static str,
        known: &[&str],
        body: &'a syntax::Body,
        mistakes: &mut Mistakes,
    ) -> Self {
        let (mut fields, mut misspelt): (Vec<&Field>, bool) = (Vec::new(), false);
        for statement in &body.statements {
            let Statement::Field(field) = statement else {
                continue;
            };
            let text = field.name.to_string();
            if !known.contains(&text.as_str()) {
                misspelt = true;
                mistakes.report(
                    field.name.span(),
                    messages::unknown_entry(&text, item, known),
                );
            } else if fields.iter().any(|other| other.name == field.name) {
                mistakes.report(field.name.span(), messages::duplicate_entry(&text));
            } else {
                fields.push(field);
            }
        }
        Fields {
            fields,
            complete: body.complete && !misspelt,
            item,
            name,
        }
    }

    /// The field of that name, if it is there.
    pub fn get(&self, name: &str) -> Option<&'a Field> {
        self.fields.iter().find(|field| field.name == name).copied()
    }

    /// The field of that name; a mistake if it is missing.
    pub fn require(&self, name: &str, example: &str, mistakes: &mut Mistakes) -> Option<&'a Field> {
        let field = self.get(name);
        if field.is_none() && self.complete {
            let message = messages::missing_entry(name, self.item, example);
            mistakes.report(self.name.span(), message);
        }
        field
    }
}

/// Declares the bindings of a block in the scope, in order.
pub(super) fn bindings(
    body: &syntax::Body,
    scope: &mut Scope,
    mistakes: &mut Mistakes,
) -> Vec<(Ident, Expr)> {
    let mut bindings = Vec::new();
    for statement in &body.statements {
        if let Statement::Let(name, value) = statement {
            let value = scope.resolve(value, mistakes);
            scope.declare(name, Role::Binding, mistakes);
            bindings.push((name.clone(), value));
        }
    }
    bindings
}

/// The value of a field that is one expression.
pub(super) fn single(
    field: &Field,
    example: &str,
    scope: &Scope,
    mistakes: &mut Mistakes,
) -> Option<Expr> {
    no_arguments(field, mistakes);
    match &field.value {
        Value::Expr(value) => Some(scope.resolve(value, mistakes)),
        _ => {
            let message = messages::wrong_value(&field.name.to_string(), "one expression", example);
            mistakes.report(field.name.span(), message);
            None
        }
    }
}

/// The values of a field that is a list.
pub(super) fn list(
    field: &Field,
    example: &str,
    scope: &Scope,
    mistakes: &mut Mistakes,
) -> Option<Vec<Expr>> {
    let written = written_list(field, example, mistakes)?;
    Some(
        written
            .iter()
            .map(|value| scope.resolve(value, mistakes))
            .collect(),
    )
}

/// The values of a field that is a list, as written.
pub(super) fn written_list<'a>(
    field: &'a Field,
    example: &str,
    mistakes: &mut Mistakes,
) -> Option<&'a [syntax::Expr]> {
    match &field.value {
        Value::List(values) if !values.is_empty() => Some(values),
        _ => {
            let message = messages::wrong_value(&field.name.to_string(), "a list", example);
            mistakes.report(field.name.span(), message);
            None
        }
    }
}

/// A field that stands for one value takes no arguments.
pub(super) fn no_arguments(field: &Field, mistakes: &mut Mistakes) {
    if field.arguments.is_some() {
        let message = messages::entry_without_arguments(&field.name.to_string());
        mistakes.report(field.name.span(), message);
    }
}
