//! Who may meet whom.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::model::Gap;

#[test]
fn dimensions() {
    assert_mistake(
        "element E { slave: point; master: «Circle2d; normal: Penalty; }",
        "`Circle2d` lies in 2D, but the element is in 3D",
        "write `dimension: 2;`, or take a geometry in 3D",
    );
    assert_mistake(
        "element E { dimension: 2; slave: point; master: «SphereDistance; normal: Penalty; }",
        "`SphereDistance` lies in 3D, but the element is in 2D",
        "remove `dimension: 2;`, or take a geometry in 2D",
    );
    for master in ["Quad4", "Torus"] {
        assert_mistake(
            &format!(
                "element E {{ dimension: 2; slave: point; master: «{master}; normal: Penalty; }}"
            ),
            &format!("`{master}` is a surface, but the element is in 2D"),
            "name a curve as `master`, or remove `dimension: 2;`",
        );
    }
    assert_mistake(
        "element E { dimension: 2; slave: «Quad4 at gauss(2, 2); master: Line2; normal: Penalty; }",
        "`Quad4` is a surface, but the element is in 2D",
        "name a curve as `slave`, or remove `dimension: 2;`",
    );
    assert_mistake(
        "element E { dimension: 2; slave: «Line2; master: Line2; normal: Penalty; }",
        "in 2D the slave curve `Line2` needs integration points",
        "write `slave: Line2 at gauss(2);`",
    );
}

#[test]
fn projected_slaves() {
    for master in ["Quad4", "Plane", "PlaneDistance"] {
        assert_mistake(
            &format!("element E {{ slave: «Line2; master: {master}; normal: Penalty; }}"),
            &format!(
                "a slave curve can be projected onto a curve only, but `{master}` is not a curve"
            ),
            "write `slave: Line2 at gauss(2);` to integrate over the slave curve",
        );
    }
    assert_mistake(
        "element E { slave: «Line2; master: point; normal: Penalty; }",
        "a slave curve can be projected onto a curve only, but `point` is not a curve",
        "make the curve the master: `slave: point; master: Line2;`",
    );
    assert_mistake(
        "element «E { slave: Line2; master: Hermite; normal: Penalty; }",
        "curve to curve needs an entry `gap`",
        "add `gap: distance;` for beams (no sign, radii in r0) or `gap: signed;` for edges",
    );
}

#[test]
fn gaps_that_a_pair_cannot_have() {
    let cases = [
        (
            "slave: point; master: Quad4; gap: «distance",
            "signed",
            "the master has two sides",
        ),
        (
            "slave: point; master: PlaneDistance; gap: «distance",
            "signed",
            "a distance function has a sign",
        ),
        (
            "slave: Line2 at gauss(2); master: Helix; gap: «signed",
            "distance",
            "the master has no sides that a sign could tell apart",
        ),
        (
            "dimension: 2; slave: point; master: Line2; gap: «distance",
            "signed",
            "the master has two sides",
        ),
        (
            "slave: interpolated; master: point; gap: «signed",
            "distance",
            "the master has no sides that a sign could tell apart",
        ),
    ];
    for (entries, possible, reason) in cases {
        let found = if possible == "signed" {
            "distance"
        } else {
            "signed"
        };
        assert_mistake(
            &format!("element E {{ {entries}; normal: Penalty; }}"),
            &format!("the gap of this pair cannot be `{found}`: {reason}"),
            &format!("write `gap: {possible};` or leave it out"),
        );
    }
}

#[test]
fn the_gap_follows_from_the_pair() {
    let cases = [
        ("slave: point; master: point", Gap::Distance),
        ("slave: point; master: Line2", Gap::Distance),
        ("slave: point; master: Quad4", Gap::Signed),
        ("slave: point; master: Helix placed", Gap::Distance),
        ("slave: interpolated; master: Torus placed", Gap::Signed),
        (
            "slave: interpolated; master: SphereDistance placed",
            Gap::Signed,
        ),
        ("slave: Line2; master: Line2; gap: distance", Gap::Distance),
        ("slave: Line2; master: Hermite; gap: signed", Gap::Signed),
        ("slave: Line2; master: Helix; gap: distance", Gap::Distance),
        (
            "slave: Line2 at gauss(3); master: RationalCurve2",
            Gap::Distance,
        ),
        (
            "slave: Line2 at given; master: RationalSurface2; gap: signed",
            Gap::Signed,
        ),
        ("dimension: 2; slave: point; master: point", Gap::Distance),
        ("dimension: 2; slave: point; master: Line2", Gap::Signed),
        (
            "dimension: 2; slave: Line2 at gauss(2); master: Circle2d",
            Gap::Signed,
        ),
        (
            "dimension: 2; slave: interpolated; master: CircleDistance2d",
            Gap::Signed,
        ),
    ];
    for (entries, gap) in cases {
        let model = accept(&format!("element E {{ {entries}; normal: Penalty; }}"));
        assert_eq!(model.elements[0].gap, gap, "{entries}");
    }
}
