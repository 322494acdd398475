//! Messages of the parser.

use super::{Diagnostic, suggest::nearest};

/// The words that start an item.
pub const ITEMS: [&str; 6] = [
    "surface",
    "curve",
    "rigid",
    "normal",
    "tangential",
    "element",
];

/// How numbers are written.
const DECIMAL: &str = "numbers are decimal, such as `2`, `0.5` or `1e-3`";

/// An item starts with an unknown word.
pub fn unknown_item(found: &str) -> Diagnostic {
    let hint = match (found, nearest(found, ITEMS)) {
        ("distance", _) => "did you mean `rigid distance`?".to_string(),
        ("export", _) => "`export PREFIX;` stands once, before all items".to_string(),
        ("law", _) => "did you mean `normal law` or `tangential law`?".to_string(),
        ("friction", _) => "did you mean `tangential law`?".to_string(),
        (_, Some(name)) => format!("did you mean `{name}`?"),
        (_, None) => "an item starts with `surface`, `curve`, `rigid surface`, `rigid curve`, \
                      `rigid distance`, `normal law`, `tangential law` or `element`"
            .to_string(),
    };
    Diagnostic::new(format!("unknown item `{found}`"), hint)
}

/// `rigid` is followed by something else than a kind of geometry.
pub fn unknown_rigid(found: &str) -> Diagnostic {
    let hint = match nearest(found, ["surface", "curve", "distance"]) {
        Some(name) => format!("did you mean `rigid {name}`?"),
        None => "write `rigid surface`, `rigid curve` or `rigid distance`".to_string(),
    };
    Diagnostic::new(format!("unknown kind of rigid geometry `{found}`"), hint)
}

/// `normal` or `tangential` is not followed by `law`.
pub fn word_without_law(word: &str, found: &str) -> Diagnostic {
    let hint = match word {
        "normal" => "write `normal law Name(g; parameter: \"unit\") { N = ..; }`",
        _ => "write `tangential law Name(pressure, slip; parameter: \"unit\") { stiffness = ..; }`",
    };
    Diagnostic::new(
        format!("expected `law` after `{word}`, found {found}"),
        hint,
    )
}

/// Something else was expected here.
pub fn expected(what: &str, found: &str, hint: &str) -> Diagnostic {
    Diagnostic::new(format!("expected {what}, found {found}"), hint)
}

/// An attribute that is not a doc comment.
pub fn foreign_attribute() -> Diagnostic {
    Diagnostic::new(
        "only doc comments can stand before an item",
        "remove the attribute; choices are entries of the element",
    )
}

/// A literal that is not a plain decimal number.
pub fn bad_number(text: &str) -> Diagnostic {
    let digits = text.len()
        - text
            .trim_start_matches(|c: char| c.is_ascii_digit() || c == '.')
            .len();
    let (number, rest) = text.split_at(digits);
    let hint = match rest.chars().next() {
        Some('x' | 'o' | 'b') if number == "0" => DECIMAL.to_string(),
        None => DECIMAL.to_string(),
        _ if number.is_empty() => DECIMAL.to_string(),
        Some('f' | 'u' | 'i') => format!("write `{number}` without a type"),
        Some(_) => format!("write `{number}*{rest}` for a product"),
    };
    Diagnostic::new(format!("`{text}` is not a number"), hint)
}

/// An operator that the language does not have.
pub fn unknown_operator(operator: &str) -> Diagnostic {
    let hint = match operator {
        "^" | "**" => "write `x*x` or `pow(x, y)`",
        "." => "write `f(x)` for a function of x",
        "<" | ">" | "<=" | ">=" | "==" | "=" => {
            "comparisons stand in `active` and `valid` only, once, as `g < e` or `g > e`"
        }
        "&" | "|" | "?" => "a law has one half line of gaps in `active` and one in `valid`",
        _ => "the operators are `+`, `-`, `*`, `/`; functions are written `f(x)`",
    };
    Diagnostic::new(format!("`{operator}` cannot stand in an expression"), hint)
}

/// A list where one expression is meant.
pub fn list_inside_expression() -> Diagnostic {
    Diagnostic::new(
        "a list cannot stand inside an expression",
        "lists stand alone, as in `N = [a, b];`",
    )
}
