//! Messages about elements.

use super::{Diagnostic, list, suggest::nearest};

/// A word that an entry does not know.
pub fn unknown_choice(entry: &str, found: &str, choices: &[&str]) -> Diagnostic {
    let hint = match nearest(found, choices.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("write {}", list(choices, "or")),
    };
    Diagnostic::new(format!("`{found}` is not a choice for `{entry}`"), hint)
}

/// A dimension other than two or three.
pub fn wrong_dimension() -> Diagnostic {
    Diagnostic::new(
        "`dimension` must be 2 or 3",
        "write `dimension: 2;`, or leave it out for 3D",
    )
}

/// A number where a name is meant.
pub fn number_for_name(entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{entry}` must be a name"),
        format!("write `{entry}: Name;`"),
    )
}

/// `at` on something other than a slave.
pub fn rule_not_here(entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{entry}` takes no `at`"),
        "integration points belong to the slave: `slave: Quad4 at gauss(2, 2);`",
    )
}

/// `at` on a slave that is one point already.
pub fn rule_of_point(slave: &str) -> Diagnostic {
    Diagnostic::new(
        format!("a slave that is `{slave}` takes no `at`"),
        "remove it, or name the curve or surface to integrate over",
    )
}

/// `placed` on something other than a rigid master.
pub fn placed_not_here(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` cannot be `placed`"),
        "only rigid masters are: a deformable geometry is where its nodes are",
    )
}

/// `interpolated` as a master.
pub fn interpolated_master() -> Diagnostic {
    Diagnostic::new(
        "a master cannot be `interpolated`",
        "name a curve, a surface or a distance function, or write `point`",
    )
}

/// A law where a geometry is meant.
pub fn law_as_geometry(name: &str, kind: &str, entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is a {kind} law, but `{entry}` must be a geometry"),
        format!("write `{kind}: {name};` and name a geometry here"),
    )
}

/// A geometry where a law is meant.
pub fn geometry_as_law(name: &str, kind: &str, entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`{name}` is a {kind}, but `{entry}` must be a {} law",
            kind_of_law(entry)
        ),
        format!("name a law, such as `{}`", example_of_law(entry)),
    )
}

/// A law of one kind where one of the other is meant.
pub fn law_as_other_law(name: &str, kind: &str, entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`{name}` is a {kind} law, but `{entry}` must be a {} law",
            kind_of_law(entry)
        ),
        format!(
            "write `{kind}: {name};` and name a {} law here, such as `{}`",
            kind_of_law(entry),
            example_of_law(entry)
        ),
    )
}

/// The kind of law that an entry names: moments of rolling follow tangential laws.
fn kind_of_law(entry: &str) -> &str {
    match entry {
        "rolling" => "tangential",
        other => other,
    }
}

/// A law for an entry, as hints propose it.
fn example_of_law(entry: &str) -> &'static str {
    match entry {
        "normal" => "Penalty",
        "rolling" => "RollingResistance",
        _ => "Coulomb",
    }
}

/// A rigid slave.
pub fn rigid_slave(name: &str, kind: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is a {kind} and cannot be the slave"),
        format!("make it the master: `slave: interpolated; master: {name};`"),
    )
}

/// A surface as slave without integration points.
pub fn surface_slave_without_rule(name: &str, rule: &str) -> Diagnostic {
    Diagnostic::new(
        format!("the slave surface `{name}` needs integration points"),
        format!("write `slave: {name} at {rule};`"),
    )
}

/// A rule that the language does not have.
pub fn unknown_rule(found: &str) -> Diagnostic {
    let hint = match nearest(found, ["gauss", "given"]) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "write `at gauss(n)`, `at gauss(n, m)` or `at given`".to_string(),
    };
    Diagnostic::new(format!("unknown integration rule `{found}`"), hint)
}

/// `given` with points, or `gauss` without.
pub fn wrong_rule_form(found: &str) -> Diagnostic {
    let hint = match found {
        "given" => "write `at given`: the point and its weight come at run time",
        _ => "write `at gauss(n)` for curves and triangles, `at gauss(n, m)` for quadrilaterals",
    };
    Diagnostic::new(format!("`{found}` has the wrong arguments"), hint)
}

/// A rule that does not fit the domain of the slave.
pub fn rule_does_not_fit(name: &str, domain: &str, directions: usize, example: &str) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`{name}` is {domain}: its rule has {directions} number{}",
            if directions == 1 { "" } else { "s" }
        ),
        format!("write `{name} at {example}`"),
    )
}

/// A number of integration points that no rule has.
pub fn unsupported_points(found: &str, supported: &str) -> Diagnostic {
    Diagnostic::new(
        format!("there is no rule with {found} points"),
        format!("there are rules with {supported}"),
    )
}

/// A geometry of the wrong dimension.
pub fn dimension_mismatch(name: &str, found: usize, needed: usize) -> Diagnostic {
    let hint = match found {
        2 => "write `dimension: 2;`, or take a geometry in 3D",
        _ => "remove `dimension: 2;`, or take a geometry in 2D",
    };
    Diagnostic::new(
        format!("`{name}` lies in {found}D, but the element is in {needed}D"),
        hint,
    )
}

/// A surface in 2D.
pub fn surface_in_two_dimensions(name: &str, entry: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{name}` is a surface, but the element is in 2D"),
        format!("name a curve as `{entry}`, or remove `dimension: 2;`"),
    )
}

/// A projected slave curve in 2D.
pub fn projected_slave_in_two_dimensions(name: &str) -> Diagnostic {
    Diagnostic::new(
        format!("in 2D the slave curve `{name}` needs integration points"),
        format!("write `slave: {name} at gauss(2);`"),
    )
}

/// A projected slave curve against something that is not a curve.
pub fn projected_slave_without_curve(slave: &str, master: &str, is_point: bool) -> Diagnostic {
    let hint = match is_point {
        true => format!("make the curve the master: `slave: point; master: {slave};`"),
        false => format!("write `slave: {slave} at gauss(2);` to integrate over the slave curve"),
    };
    Diagnostic::new(
        format!("a slave curve can be projected onto a curve only, but `{master}` is not a curve"),
        hint,
    )
}

/// Curve to curve without a choice of the gap.
pub fn gap_missing() -> Diagnostic {
    Diagnostic::new(
        "curve to curve needs an entry `gap`",
        "add `gap: distance;` for beams (no sign, radii in r0) or `gap: signed;` for edges",
    )
}

/// Two curves have no inside by which an orientation could be chosen.
pub fn gap_not_oriented() -> Diagnostic {
    Diagnostic::new(
        "the gap of two curves cannot be `oriented`: neither has an inside",
        "write `gap: distance;` for beams or `gap: signed;` for edges",
    )
}

/// A pair that is not evaluated in lanes.
pub fn no_lanes() -> Diagnostic {
    Diagnostic::new(
        "this element cannot be evaluated in lanes: lanes are for points and curves against a shape, by a penalty, \
         without friction, rolling, angle or signed gap of two curves",
        "leave `batch` out: its contacts are then evaluated one after another",
    )
}

/// A gap that this pair does not have.
pub fn gap_not_possible(found: &str, possible: &str, reason: &str) -> Diagnostic {
    Diagnostic::new(
        format!("the gap of this pair cannot be `{found}`: {reason}"),
        format!("write `gap: {possible};` or leave it out"),
    )
}

/// A current measure without integration points that belong to the element.
pub fn measure_without_rule() -> Diagnostic {
    Diagnostic::new(
        "`measure: current` needs a slave with its own integration points",
        "write `slave: NAME at gauss(..);`, or remove `measure`",
    )
}

/// A multiplier with a law that is not a linear spring.
pub fn enforcement_needs_spring(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("a multiplier needs a linear normal law, but `{law}` is not linear"),
        "write `normal: Penalty;`, or any N = eps*g with contact at g < 0 and without `valid`",
    )
}

/// A multiplier whose weight moves.
pub fn measure_of_multiplier() -> Diagnostic {
    Diagnostic::new(
        "`measure: current` is not offered with `enforcement: multiplier`",
        "remove `measure`, or write `enforcement: augmented;`",
    )
}

/// A linearisation of a tangent that is not requested.
pub fn tangent_plane_of_residual() -> Diagnostic {
    Diagnostic::new(
        "`linearisation: tangent_plane` contradicts `outputs: residual`",
        "remove one of the two: the linearisation only changes the tangent",
    )
}

/// A tangent plane where nothing is projected.
pub fn tangent_plane_without_projection(master: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`linearisation: tangent_plane` needs a projection, but `{master}` has none"),
        "remove it: the exact tangent is as short",
    )
}

/// A tangential law where nothing is projected.
pub fn tangential_without_projection(law: &str, master: &str, is_point: bool) -> Diagnostic {
    let hint = match is_point {
        true => "remove `tangential`, or make the master a curve or a surface to slide along",
        false => "name the body as a rigid curve or surface instead, such as `Plane` or `Sphere`",
    };
    Diagnostic::new(
        format!("`tangential: {law}` needs a projection, but `{master}` has none"),
        hint,
    )
}

/// A law with two axes where there is one direction.
pub fn axes_of_one_direction(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{law}` has two axes, but this pair slides in one direction only"),
        "name a law with one stiffness, such as `Coulomb`",
    )
}

/// A law with two axes without the direction of the first.
pub fn axis_missing(law: &str, slave_has_direction: bool) -> Diagnostic {
    let slave = match slave_has_direction {
        true => " or `axis: slave;` (along the slave curve)",
        false => "",
    };
    Diagnostic::new(
        format!("`{law}` has two axes and needs an entry `axis`"),
        format!("add `axis: convected;` (a direction on the master, given at run time){slave}"),
    )
}

/// An axis for a law that has no axes.
pub fn axis_of_isotropic_law(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{law}` has one stiffness for all directions: it takes no `axis`"),
        "remove `axis`, or name a law with two stiffnesses, such as `CoulombOrthotropic`",
    )
}

/// An axis without a tangential law.
pub fn axis_without_law() -> Diagnostic {
    Diagnostic::new(
        "`axis` belongs to a tangential law, but the element has none",
        "add `tangential: CoulombOrthotropic;`, or remove `axis`",
    )
}

/// `axis: slave` with a slave that has no direction.
pub fn slave_without_direction() -> Diagnostic {
    Diagnostic::new(
        "`axis: slave` needs a slave curve with integration points",
        "write `axis: convected;`: the direction on the master is given at run time",
    )
}

/// Two of the laws and the geometry of an element with a parameter of the same name.
pub fn parameter_of_both(name: &str, law: &str, other: &str) -> Diagnostic {
    Diagnostic::new(
        format!("both `{law}` and `{other}` have a parameter `{name}`"),
        "rename it in one of the two declarations: an element lists its parameters by name",
    )
}

/// A law of rolling with two stiffnesses.
pub fn rolling_with_axes(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{law}` has two axes, but an angle about a curve has none"),
        "name a law with one stiffness, such as `RollingResistance`",
    )
}

/// Rolling of a pair that is not two curves.
pub fn rolling_without_curves(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` needs two curves, both projected"),
        "remove `rolling`, or name two curves: `slave: Hermite; master: Hermite; gap: distance;`",
    )
}

/// Rolling on a rigid curve.
pub fn rolling_on_rigid_curve(law: &str, master: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` needs an interpolated master, but `{master}` is rigid"),
        "name a curve with shape functions as `master`, and hold its nodes",
    )
}

/// Rolling without a tangential law.
pub fn rolling_without_friction(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` needs a tangential law: what slides freely does not roll"),
        "add `tangential: Coulomb;`",
    )
}

/// Rolling of edges.
pub fn rolling_of_edges(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` needs `gap: distance`: edges do not roll"),
        "write `gap: distance;` for beams (no sign, radii in r0)",
    )
}

/// Rolling on the tangent plane.
pub fn rolling_on_tangent_plane(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` has no `linearisation: tangent_plane`"),
        "remove `linearisation`: the exact tangent holds at any distance",
    )
}

/// Rolling with a multiplier that is an unknown.
pub fn rolling_with_multiplier(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`rolling: {law}` is not offered with `enforcement: multiplier`"),
        "write `enforcement: augmented;`, or remove one of the two",
    )
}

/// Principal normal of a curve without curvature.
pub fn rolling_of_straight_curve(curve: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`{curve}` is straight and has no principal normal to measure angles from"),
        "add `director: given;`: directions across the curves, given at run time",
    )
}

/// Principal normal of a curve with a fourth derivative.
pub fn rolling_of_higher_curve(curve: &str) -> Diagnostic {
    Diagnostic::new(
        format!(
            "angles from the principal normal need cubic curves, but `{curve}` is of higher degree or rational"
        ),
        "add `director: given;`: directions across the curves, given at run time",
    )
}

/// A director without a law of rolling.
pub fn director_without_rolling() -> Diagnostic {
    Diagnostic::new(
        "`director` belongs to a law of rolling, but the element has none",
        "add `rolling: RollingResistance;`, or remove `director`",
    )
}
