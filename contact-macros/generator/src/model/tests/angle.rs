//! Elements that act at some angles of two curves.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::formulate::Parameters;
use crate::model::Angle;

/// An element with the entries `text`.
fn element(slave: &str, master: &str, text: &str) -> String {
    format!("element E {{ slave: {slave}; master: {master}; {text} }}")
}

#[test]
fn both_parts() {
    for (slave, text, angle) in [
        (
            "Hermite",
            "normal: Penalty; gap: distance; angle: large;",
            Angle::Large,
        ),
        (
            "Line3 at gauss(3)",
            "normal: LogBarrier; angle: small;",
            Angle::Small,
        ),
        (
            "Line2 at given",
            "normal: PowerLaw; angle: small; outputs: residual;",
            Angle::Small,
        ),
    ] {
        let model = accept(&element(slave, "RationalCurve3", text));
        assert_eq!(model.elements[0].angle, Some(angle));
        let parameters = Parameters::new(&model.elements[0]);
        let last = parameters.entries.len();
        let names: Vec<&str> = parameters.entries[last - 2..]
            .iter()
            .map(|entry| entry.name.as_str())
            .collect();
        assert_eq!(names, ["angle_low", "angle_high"]);
        assert_eq!(parameters.layout.angle, Some(last - 2));
    }
    let model = accept(&element("Line2 at gauss(2)", "Line2", "normal: Penalty;"));
    assert_eq!(model.elements[0].angle, None);
}

#[test]
fn energies_begin_at_zero() {
    let law = "normal law Shifted(g; eps) { N = eps*g; W = eps*g*g/2 + 1; }";
    let text = "normal: Shifted; gap: distance; angle: «large;";
    assert_mistake(
        &format!("{law} {}", element("Line2", "Line2", text)),
        "`angle` needs an energy that is zero where contact begins, but that of `Shifted` is not",
        "subtract its value there from `W`: the force that turns the curves is proportional to W",
    );
}
