//! Run-time parameters: units, ranges, names that are reserved for elements.

use syn::LitStr;

use super::scope::{Role, Scope};
use super::types::Parameter;
use crate::diagnostics::{Mistakes, names as messages, short};
use crate::syntax;

/// Parameters that elements add; declarations cannot use these names.
pub const RESERVED: [&str; 18] = [
    "r0",
    "orientation",
    "weight",
    "eta_1",
    "eta_2",
    "axis_1",
    "axis_2",
    "angle_low",
    "angle_high",
    "origin_x",
    "origin_y",
    "origin_z",
    "quaternion_w",
    "quaternion_x",
    "quaternion_y",
    "quaternion_z",
    "direction_x",
    "direction_y",
];

/// Beginnings of such names: numbered weights of rational geometries, components of directors.
pub const RESERVED_PREFIXES: [&str; 4] = [
    "master_weight_",
    "slave_weight_",
    "master_director_",
    "slave_director_",
];

/// Declares the parameters in the scope and checks names and ranges.
pub(super) fn parameters(
    written: &[syntax::Parameter],
    scope: &mut Scope,
    mistakes: &mut Mistakes,
) -> Vec<Parameter> {
    written
        .iter()
        .map(|parameter| check(parameter, scope, mistakes))
        .collect()
}

fn check(written: &syntax::Parameter, scope: &mut Scope, mistakes: &mut Mistakes) -> Parameter {
    let name = &written.name;
    scope.declare(name, Role::Parameter, mistakes);
    let text = name.to_string();
    let numbered = RESERVED_PREFIXES
        .iter()
        .any(|prefix| text.starts_with(prefix));
    if numbered || RESERVED.contains(&text.as_str()) {
        let message = messages::reserved_parameter(&text, &RESERVED, &RESERVED_PREFIXES);
        mistakes.report(name.span(), message);
    }
    let unit = match &written.unit {
        Some(unit) => checked_unit(unit, mistakes),
        None => "1".to_string(),
    };
    let (mut lower, mut upper, mut closed) = (f64::NEG_INFINITY, f64::INFINITY, false);
    if let Some(([low, high], brackets)) = &written.range {
        if low.value >= high.value {
            let message = messages::empty_range(&short(low.value), &short(high.value));
            mistakes.report(low.span, message);
        }
        (lower, upper, closed) = (low.value, high.value, *brackets);
    }
    Parameter {
        name: name.clone(),
        unit,
        lower,
        upper,
        closed,
    }
}

/// A unit ends up in C strings and in tables: plain text only.
fn checked_unit(unit: &LitStr, mistakes: &mut Mistakes) -> String {
    let text = unit.value();
    let plain = |c: char| c.is_ascii_graphic() && c != '"' && c != '\\';
    if text.is_empty() || !text.chars().all(plain) {
        mistakes.report(unit.span(), messages::bad_unit());
    }
    text
}
