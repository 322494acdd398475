//! Laws of rolling, and elements that name them.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::model::Reference;

const DIRECTOR: &str = "add `director: given;`: directions across the curves, given at run time";

/// Two curves with the entries `text`.
fn beams(slave: &str, master: &str, text: &str) -> String {
    format!(
        "element E {{ slave: {slave}; master: {master}; normal: Penalty; tangential: Coulomb; gap: distance; {text} }}"
    )
}

fn hermite(text: &str) -> String {
    beams("Hermite", "Hermite", text)
}

#[test]
fn curves_with_a_principal_normal() {
    for curve in ["Hermite", "Line3", "BezierCurve2", "BezierCurve3"] {
        let model = accept(&beams(curve, "Hermite", "rolling: RollingResistance;"));
        let rolling = model.elements[0].rolling.as_ref().unwrap();
        assert_eq!(rolling.reference, Reference::PrincipalNormal);
        assert_eq!(rolling.law.name, "RollingResistance");
    }
    assert_mistake(
        &beams("Line2", "Line2", "rolling: «RollingResistance;"),
        "`Line2` is straight and has no principal normal to measure angles from",
        DIRECTOR,
    );
    assert_mistake(
        &beams("Hermite", "RationalCurve3", "rolling: «RollingResistance;"),
        "angles from the principal normal need cubic curves, but `RationalCurve3` is of higher degree or rational",
        DIRECTOR,
    );
    let quartic = "curve Quartic(t) in unit_line { N = [1 - t*t*t*t, t*t*t*t]; }";
    assert_mistake(
        &format!(
            "{quartic} {}",
            beams("Quartic", "Hermite", "rolling: «RollingResistance;")
        ),
        "angles from the principal normal need cubic curves, but `Quartic` is of higher degree or rational",
        DIRECTOR,
    );
}

#[test]
fn directors() {
    for curve in ["Line2", "RationalCurve3", "Hermite"] {
        let text = "rolling: RollingResistance; director: given;";
        let model = accept(&beams(curve, "Line2", text));
        let rolling = model.elements[0].rolling.as_ref().unwrap();
        assert_eq!(rolling.reference, Reference::Director);
    }
    assert_mistake(
        &hermite("director: «given;"),
        "`director` belongs to a law of rolling, but the element has none",
        "add `rolling: RollingResistance;`, or remove `director`",
    );
    assert_mistake(
        &hermite("rolling: RollingResistance; director: «gven;"),
        "`gven` is not a choice for `director`",
        "did you mean `given`?",
    );
}

#[test]
fn pairs_that_do_not_roll() {
    assert_mistake(
        "element E { slave: point; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: «RollingResistance; }",
        "`rolling: RollingResistance` needs two curves, both projected",
        "remove `rolling`, or name two curves: `slave: Hermite; master: Hermite; gap: distance;`",
    );
    assert_mistake(
        &beams("Hermite", "Helix placed", "rolling: «RollingResistance;"),
        "`rolling: RollingResistance` needs an interpolated master, but `Helix` is rigid",
        "name a curve with shape functions as `master`, and hold its nodes",
    );
    assert_mistake(
        "element E { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; gap: signed; rolling: «RollingResistance; }",
        "`rolling: RollingResistance` needs `gap: distance`: edges do not roll",
        "write `gap: distance;` for beams (no sign, radii in r0)",
    );
    assert_mistake(
        &hermite("linearisation: tangent_plane; rolling: «RollingResistance;"),
        "`rolling: RollingResistance` has no `linearisation: tangent_plane`",
        "remove `linearisation`: the exact tangent holds at any distance",
    );
    assert_mistake(
        &hermite("enforcement: multiplier; rolling: «RollingResistance;"),
        "`rolling: RollingResistance` is not offered with `enforcement: multiplier`",
        "write `enforcement: augmented;`, or remove one of the two",
    );
    assert_mistake(
        "element E { slave: Hermite; master: Hermite; normal: Penalty; gap: distance; rolling: «RollingResistance; }",
        "`rolling: RollingResistance` needs a tangential law: what slides freely does not roll",
        "add `tangential: Coulomb;`",
    );
}

#[test]
fn laws_of_rolling() {
    assert_mistake(
        "tangential law Axes(p, s; a, b) { stiffness = [a, b]; }
         element E { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; gap: distance; rolling: «Axes; }",
        "`Axes` has two axes, but an angle about a curve has none",
        "name a law with one stiffness, such as `RollingResistance`",
    );
    assert_mistake(
        &hermite("rolling: «Penalty;"),
        "`Penalty` is a normal law, but `rolling` must be a tangential law",
        "write `normal: Penalty;` and name a tangential law here, such as `RollingResistance`",
    );
    assert_mistake(
        "tangential law Again(p, s; eps_t) { stiffness = eps_t; }
         element E { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; gap: distance; rolling: «Again; }",
        "both `Again` and `Coulomb` have a parameter `eps_t`",
        "rename it in one of the two declarations: an element lists its parameters by name",
    );
    accept(
        "tangential law Hardening(p, s; k, b) { stiffness = k; bound = b*sqrt(p)*(1 + s); }
         element E { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; gap: distance; rolling: Hardening; }",
    );
}
