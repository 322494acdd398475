//! Checks of normal laws.

use syn::Ident;

use super::expression::Expr;
use super::fields::{Fields, bindings, no_arguments, single};
use super::numeric;
use super::parameter::parameters;
use super::scope::{Role, Scope};
use super::types::{Bound, Law};
use crate::diagnostics::{Mistakes, law as messages};
use crate::syntax::{self, Field, LawItem, Relation, Value};

/// The law an item describes; `None` after a mistake.
pub(super) fn law(item: &LawItem, built_in: bool, mistakes: &mut Mistakes) -> Option<Law> {
    let before = mistakes.count();
    let names = &item.head.coordinates;
    if names.len() != 1 {
        mistakes.report(item.name.span(), messages::wrong_gap_count(names.len()));
    }
    let mut scope = Scope::default();
    for name in names {
        scope.declare(name, Role::Gap, mistakes);
    }
    let parameters = parameters(&item.head.parameters, &mut scope, mistakes);
    let known = ["N", "W", "active", "valid"];
    let fields = Fields::new(&item.name, "normal law", &known, &item.body, mistakes);
    let bindings = bindings(&item.body, &mut scope, mistakes);
    let traction = fields
        .require("N", "N = ..;", mistakes)
        .and_then(|field| single(field, "N = ..;", &scope, mistakes));
    let energy = fields
        .get("W")
        .map(|field| (field, single(field, "W = ..;", &scope, mistakes)));
    let gap = names.first().cloned();
    let condition = |name: &str, mistakes: &mut Mistakes| {
        let field = fields.get(name)?;
        bound(field, gap.as_ref()?, &scope, mistakes)
    };
    let active = condition("active", mistakes);
    let valid = condition("valid", mistakes);
    if mistakes.count() > before || !item.body.complete {
        return None;
    }
    let law = Law {
        name: item.name.clone(),
        docs: item.docs.clone(),
        gap: gap?,
        parameters,
        bindings,
        active: active.unwrap_or(Bound::Below(Expr::Number(0.0))),
        valid,
        traction: traction?,
        energy: energy.as_ref().and_then(|(_, value)| value.clone()),
        built_in,
    };
    if let Some((field, _)) = energy
        && let Some(message) = numeric::energy(&law)
    {
        mistakes.report(field.name.span(), message);
        return None;
    }
    Some(law)
}

/// The half line of `active` or `valid`.
fn bound(field: &Field, gap: &Ident, scope: &Scope, mistakes: &mut Mistakes) -> Option<Bound> {
    no_arguments(field, mistakes);
    let Value::Comparison(comparison) = &field.value else {
        let message = messages::not_a_condition(&field.name.to_string(), &gap.to_string());
        mistakes.report(field.name.span(), message);
        return None;
    };
    if !matches!(&comparison.left, syntax::Expr::Name(name) if name == gap) {
        let message = messages::gap_not_on_the_left(&gap.to_string());
        mistakes.report(comparison.left.span(), message);
        return None;
    }
    let scope = scope.only(Role::Parameter, "a condition", "parameters and numbers");
    let limit = scope.resolve(&comparison.right, mistakes);
    Some(match comparison.relation {
        Relation::Less => Bound::Below(limit),
        Relation::Greater => Bound::Above(limit),
    })
}
