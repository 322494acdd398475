//! Messages about laws.

use super::Diagnostic;

/// A law of more or less than one gap.
pub fn wrong_gap_count(found: usize) -> Diagnostic {
    Diagnostic::new(
        format!("a normal law depends on one gap, found {found} names before `;`"),
        "write `normal law Name(g; parameter: \"unit\")`: parameters come after `;`",
    )
}

/// A condition that is not a comparison of the gap.
pub fn not_a_condition(entry: &str, gap: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{entry}` must compare the gap with a value"),
        format!("write `{entry} = {gap} < ..;` or `{entry} = {gap} > ..;`"),
    )
}

/// A comparison whose left side is not the gap.
pub fn gap_not_on_the_left(gap: &str) -> Diagnostic {
    Diagnostic::new(
        format!("the left side of a condition is the gap `{gap}`"),
        format!("write `{gap} < ..` or `{gap} > ..`"),
    )
}

/// A law whose energy does not belong to its traction.
pub fn energy_mismatch(point: &str, slope: &str, traction: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`N` is not the derivative of `W`: at {point}, dW/dg = {slope} but N = {traction}"),
        "check signs and factors, or leave `W` out: it is used for reporting only",
    )
}

/// A tangential law of more or fewer names than pressure and slip.
pub fn wrong_pressure_and_slip(found: usize) -> Diagnostic {
    let plural = if found == 1 { "" } else { "s" };
    Diagnostic::new(
        format!(
            "a tangential law depends on pressure and slip, found {found} name{plural} before `;`"
        ),
        "write `tangential law Name(pressure, slip; parameter: \"unit\")`: parameters come after `;`",
    )
}

/// A list of `stiffness` or `bound` that does not have two values.
pub fn wrong_axis_count(entry: &str, found: usize) -> Diagnostic {
    Diagnostic::new(
        format!("a list of `{entry}` has two values, one for each axis, found {found}"),
        format!("write `{entry} = [.., ..];`, or `{entry} = ..;` for all directions alike"),
    )
}

/// Numbers of bounds and stiffnesses that differ.
pub fn bound_unlike_stiffness(bounds: usize, stiffnesses: usize) -> Diagnostic {
    let hint = match stiffnesses {
        1 => "write `bound = ..;`, or give two stiffnesses: `stiffness = [.., ..];`",
        _ => "write `bound = [.., ..];`: one for each axis",
    };
    let plural = if bounds == 1 { "" } else { "s" };
    Diagnostic::new(
        format!("`bound` has {bounds} value{plural}, but `stiffness` has {stiffnesses}"),
        hint,
    )
}
