//! Messages about geometries.

use super::Diagnostic;

/// A curve, surface or distance function with the wrong number of coordinates.
pub fn wrong_coordinate_count(kind: &str, needed: &str, found: usize, example: &str) -> Diagnostic {
    Diagnostic::new(
        format!("a {kind} has {needed}, found {found}"),
        format!("write `{example}`"),
    )
}

/// A shape without a domain.
pub fn missing_domain(kind: &str, example: &str) -> Diagnostic {
    Diagnostic::new(
        format!("this {kind} needs a domain"),
        format!("write {example} after the coordinates"),
    )
}

/// A domain that the language does not have.
pub fn unknown_domain(name: &str, hint: String) -> Diagnostic {
    Diagnostic::new(format!("unknown domain `{name}`"), hint)
}

/// A domain of surfaces on a curve, or the other way round.
pub fn wrong_domain(name: &str, kind: &str, hint: String) -> Diagnostic {
    Diagnostic::new(format!("`{name}` is not a domain of a {kind}"), hint)
}

/// A domain with the wrong number of bounds.
pub fn wrong_bound_count(name: &str, signature: &str, found: usize) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`{name}` does not take {found} bound{}",
            if found == 1 { "" } else { "s" }
        ),
        format!("write `{signature}`"),
    )
}

/// An infinite domain of a shape.
pub fn infinite_domain() -> Diagnostic {
    Diagnostic::new(
        "the domain of a deformable geometry is finite",
        "write numbers; `inf` is for rigid geometries",
    )
}

/// A domain of a distance function.
pub fn domain_of_distance() -> Diagnostic {
    Diagnostic::new(
        "a distance function has no domain",
        "remove it: the distance is defined at every point of space",
    )
}

/// `rational` on something that is not a shape.
pub fn rational_rigid() -> Diagnostic {
    Diagnostic::new(
        "`rational` is for deformable geometries",
        "remove it: write a rigid geometry's quotient in `rho`",
    )
}

/// A shape that is rational and has vectors.
pub fn rational_with_vectors() -> Diagnostic {
    Diagnostic::new(
        "a rational geometry cannot have `vectors`",
        "remove `vectors` or `rational`: weights apply to positions only",
    )
}

/// A shape with parameters.
pub fn parameter_of_shape(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("a deformable geometry cannot have the parameter `{name}`"),
        "write its value as a number, or declare a `rigid` geometry",
    )
}

/// Shape functions that do not reproduce a translation.
pub fn no_partition_of_unity(sum: &str, point: &str, vectors: bool) -> Diagnostic {
    let of = if vectors { " of the positions" } else { "" };
    let vectors = if vectors { " and `vectors`" } else { "" };
    Diagnostic::new(
        format!("the shape functions{of} sum to {sum} instead of 1 at {point}"),
        format!(
            "a translation must move every point alike: check signs and factors in `N`{vectors}"
        ),
    )
}

/// An index of `vectors` that is not one of a control.
pub fn vector_out_of_range(text: &str, controls: usize) -> Diagnostic {
    Diagnostic::new(
        format!("{text} is not the index of a control"),
        format!(
            "`N` has {controls} functions: indices run from 0 to {}",
            controls.saturating_sub(1)
        ),
    )
}

/// An index that stands twice in `vectors`, or not in order.
pub fn vectors_not_ascending() -> Diagnostic {
    Diagnostic::new(
        "the indices in `vectors` are not ascending",
        "name each index once, in order",
    )
}

/// A position with the wrong number of components.
pub fn wrong_component_count(kind: &str, found: usize) -> Diagnostic {
    let hint = match kind {
        "surface" => "a surface lies in 3D: write `rho = [x, y, z];`",
        _ => "write `rho = [x, y];` for a curve in 2D, `rho = [x, y, z];` in 3D",
    };
    Diagnostic::new(
        format!(
            "the position of a {kind} cannot have {found} component{}",
            if found == 1 { "" } else { "s" }
        ),
        hint,
    )
}

/// A closed projection from a point with the wrong number of components.
pub fn wrong_projection_point(found: usize, components: usize) -> Diagnostic {
    let point = if components == 2 { "x, y" } else { "x, y, z" };
    Diagnostic::new(
        format!("`projection` takes a point with {found} components, but `rho` has {components}"),
        format!("write `projection({point}) = [..];`"),
    )
}

/// A closed projection without the point.
pub fn projection_without_point() -> Diagnostic {
    Diagnostic::new(
        "`projection` needs the names of the point's components",
        "write `projection(x, y, z) = [..];`",
    )
}

/// A closed projection with the wrong number of values.
pub fn wrong_projection_values(found: usize, coordinates: &[String]) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`projection` gives {found} values for {} coordinates",
            coordinates.len()
        ),
        format!("give one value for each of ({})", coordinates.join(", ")),
    )
}

/// A closed projection that moves a point of the geometry.
pub fn projection_moves_point(point: &str, distance: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`projection` does not return the point at {point}: it lands {distance} away"),
        "a point of the geometry is its own closest point: check `projection` against `rho`",
    )
}
