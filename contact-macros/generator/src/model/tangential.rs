//! Checks of tangential laws.

use super::expression::Expr;
use super::fields::{Fields, bindings, no_arguments};
use super::parameter::parameters;
use super::scope::{Role, Scope};
use super::types::TangentialLaw;
use crate::diagnostics::{Mistakes, law as messages, names};
use crate::syntax::{Field, LawItem, Value};

/// The tangential law an item describes; `None` after a mistake.
pub(super) fn tangential_law(
    item: &LawItem,
    built_in: bool,
    mistakes: &mut Mistakes,
) -> Option<TangentialLaw> {
    let before = mistakes.count();
    let mut scope = coordinates(item, mistakes);
    let parameters = parameters(&item.head.parameters, &mut scope, mistakes);
    let known = ["stiffness", "bound"];
    let fields = Fields::new(&item.name, "tangential law", &known, &item.body, mistakes);
    let bindings = bindings(&item.body, &mut scope, mistakes);
    let of_parameters = scope.only(Role::Parameter, "a stiffness", "parameters and numbers");
    let stiffness = fields
        .require("stiffness", "stiffness = ..;", mistakes)
        .and_then(|field| per_axis(field, &of_parameters, mistakes));
    let bound = match fields.get("bound") {
        Some(field) => per_axis(field, &scope, mistakes).map(|bound| (bound, field.name.span())),
        None => None,
    };
    if let (Some(stiffness), Some((bound, span))) = (&stiffness, &bound)
        && stiffness.len() != bound.len()
    {
        let message = messages::bound_unlike_stiffness(bound.len(), stiffness.len());
        mistakes.report(*span, message);
    }
    if mistakes.count() > before || !item.body.complete {
        return None;
    }
    let [pressure, slip] = item.head.coordinates.as_slice() else {
        return None;
    };
    Some(TangentialLaw {
        name: item.name.clone(),
        docs: item.docs.clone(),
        pressure: pressure.clone(),
        slip: slip.clone(),
        parameters,
        bindings,
        stiffness: stiffness?,
        bound: bound.map_or_else(Vec::new, |(bound, _)| bound),
        built_in,
    })
}

/// Declares the pressure and the slip; names beyond them count as parameters that came too early.
fn coordinates(item: &LawItem, mistakes: &mut Mistakes) -> Scope {
    let names = &item.head.coordinates;
    if names.len() != 2 {
        let message = messages::wrong_pressure_and_slip(names.len());
        mistakes.report(item.name.span(), message);
    }
    let mut scope = Scope::default();
    for (index, name) in names.iter().enumerate() {
        let role = [Role::Pressure, Role::Slip].get(index).copied();
        scope.declare(name, role.unwrap_or(Role::Parameter), mistakes);
    }
    scope
}

/// One value for all directions, or one for each of two axes.
fn per_axis(field: &Field, scope: &Scope, mistakes: &mut Mistakes) -> Option<Vec<Expr>> {
    no_arguments(field, mistakes);
    let name = field.name.to_string();
    let written = match &field.value {
        Value::Expr(value) => std::slice::from_ref(value),
        Value::List(values) => values.as_slice(),
        Value::Comparison(_) => {
            let what = "one expression, or a list of two";
            let message = names::wrong_value(&name, what, &format!("{name} = ..;"));
            mistakes.report(field.name.span(), message);
            return None;
        }
    };
    let values = written
        .iter()
        .map(|value| scope.resolve(value, mistakes))
        .collect();
    if matches!(field.value, Value::List(_)) && written.len() != 2 {
        let message = messages::wrong_axis_count(&name, written.len());
        mistakes.report(field.name.span(), message);
        return None;
    }
    Some(values)
}
