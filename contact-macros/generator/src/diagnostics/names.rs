//! Messages about names: unknown, taken, reserved, badly formed.

use super::{Diagnostic, list, suggest::nearest};

/// The hint of an unknown name: the nearest known one, or all of them.
fn near_or_all(name: &str, known: &[String], none: &str) -> String {
    match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None if known.is_empty() => none.to_string(),
        None => format!("known here: {}", list(known, "and")),
    }
}

/// A variable that is neither coordinate, parameter nor binding.
pub fn unknown_variable(name: &str, known: &[String]) -> Diagnostic {
    let hint = match name {
        "pi" | "PI" => "write the number 3.141592653589793".to_string(),
        "inf" => "`inf` can stand in a range only".to_string(),
        _ => near_or_all(
            name,
            known,
            "declare it as a parameter after `;` or with `let`",
        ),
    };
    Diagnostic::new(format!("unknown variable `{name}`"), hint)
}

/// A variable that exists, but not in this place.
pub fn variable_not_here(name: &str, role: &str, place: &str, allowed: &str) -> Diagnostic {
    Diagnostic::new(
        format!("{role} `{name}` cannot be used in {place}"),
        format!("use {allowed} only"),
    )
}

/// A function that the language does not have.
pub fn unknown_function(name: &str, known: &[String]) -> Diagnostic {
    let hint = match name {
        "log" => "did you mean `ln`?".to_string(),
        "atan" => "write `atan2(y, x)`, the angle of the point (x, y)".to_string(),
        "powi" | "powf" => "did you mean `pow`?".to_string(),
        _ => near_or_all(name, known, ""),
    };
    Diagnostic::new(format!("unknown function `{name}`"), hint)
}

/// A function used without arguments in brackets.
pub fn function_without_arguments(name: &str, signature: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is a function"),
        format!("write `{signature}`"),
    )
}

/// A coordinate, parameter or binding used like a function.
pub fn variable_called(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is a variable, not a function"),
        format!("write `{name}*(..)` for a product"),
    )
}

/// A function with too few or too many arguments.
pub fn wrong_argument_count(name: &str, signature: &str, found: usize) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`{name}` does not take {found} argument{}",
            if found == 1 { "" } else { "s" }
        ),
        format!("write `{signature}`"),
    )
}

/// A name that is used twice in one item.
pub fn name_taken(name: &str, role: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is already a {role} here"),
        "choose another name",
    )
}

/// A parameter whose name elements use for the parameters that they add.
pub fn reserved_parameter(name: &str, reserved: &[&str], prefixes: &[&str]) -> Diagnostic {
    let any = prefixes.iter().map(|prefix| format!("{prefix}*"));
    let all: Vec<String> = reserved
        .iter()
        .map(ToString::to_string)
        .chain(any)
        .collect();
    Diagnostic::new(
        format!("`{name}` is reserved for a parameter that elements add"),
        format!("choose another name; reserved are {}", list(&all, "and")),
    )
}

/// A unit that is not plain text.
pub fn bad_unit() -> Diagnostic {
    Diagnostic::new(
        "a unit is text without spaces, of ASCII letters, digits and signs",
        "write something like `\"force/length^2\"`, or `\"1\"` for a parameter without unit",
    )
}

/// A range without an inside.
pub fn empty_range(lower: &str, upper: &str) -> Diagnostic {
    Diagnostic::new(
        format!("the range from {lower} to {upper} is empty"),
        "the lower bound comes first and is less than the upper one",
    )
}

/// Two items of one name.
pub fn duplicate_item(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is declared twice"),
        "geometries, laws and elements share one set of names: choose another",
    )
}

/// The first of two items of one name.
pub fn first_declared_here(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is declared here first"),
        "rename or remove one of the two",
    )
}

/// A name of an item that is not in camel case.
pub fn not_camel_case(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("the name `{name}` is not in camel case"),
        format!(
            "write `{}`: ASCII letters and digits, a capital first",
            camel_case(name)
        ),
    )
}

/// `name` in camel case.
fn camel_case(name: &str) -> String {
    let parts = name
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|part| !part.is_empty());
    let text: String = parts
        .flat_map(|part| {
            part[..1]
                .to_uppercase()
                .chars()
                .chain(part[1..].chars())
                .collect::<Vec<_>>()
        })
        .collect();
    match text.starts_with(|c: char| c.is_ascii_uppercase()) {
        true => text,
        false => format!("Item{text}"),
    }
}

/// A geometry that was declared nowhere.
pub fn unknown_geometry(name: &str, known: &[String]) -> Diagnostic {
    Diagnostic::new(
        format!("unknown geometry `{name}`"),
        near_or_all(name, known, "declare it"),
    )
}

/// A law that was declared nowhere.
pub fn unknown_law(kind: &str, name: &str, known: &[String]) -> Diagnostic {
    Diagnostic::new(
        format!("unknown {kind} law `{name}`"),
        near_or_all(name, known, "declare it"),
    )
}

/// An entry that an item of this kind does not have.
pub fn unknown_entry(name: &str, item: &str, entries: &[&str]) -> Diagnostic {
    let hint = match nearest(name, entries.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if name == "friction" && entries.contains(&"tangential") => {
            "did you mean `tangential`?".to_string()
        }
        None => format!("{item} has the entries {}", list(entries, "and")),
    };
    Diagnostic::new(format!("{item} has no entry `{name}`"), hint)
}

/// An entry that stands twice in one item.
pub fn duplicate_entry(name: &str) -> Diagnostic {
    Diagnostic::new(format!("`{name}` is given twice"), "keep one of the two")
}

/// An entry that must be there.
pub fn missing_entry(name: &str, item: &str, example: &str) -> Diagnostic {
    Diagnostic::new(
        format!("{item} needs an entry `{name}`"),
        format!("add `{example}`"),
    )
}

/// An entry whose value has the wrong form.
pub fn wrong_value(name: &str, what: &str, example: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` must be {what}"),
        format!("write `{example}`"),
    )
}

/// An entry with arguments that takes no arguments.
pub fn entry_without_arguments(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` takes no arguments"),
        format!("write `{name} = ..`; its variables are those of the item"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn camel_case_is_proposed() {
        assert_eq!(camel_case("point_quad4"), "PointQuad4");
        assert_eq!(camel_case("pointQuad4"), "PointQuad4");
        assert_eq!(camel_case("_4"), "Item4");
    }

    #[test]
    fn well_known_names_have_their_own_hints() {
        assert_eq!(
            unknown_variable("pi", &[]).hint,
            "write the number 3.141592653589793"
        );
        assert_eq!(unknown_function("log", &[]).hint, "did you mean `ln`?");
    }
}
