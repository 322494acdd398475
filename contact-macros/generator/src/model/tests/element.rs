//! Elements.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::model::{Enforcement, Linearisation, Master, Measure, Rule, Slave};

#[test]
fn entries_of_elements() {
    assert_mistake(
        "element «E { slave: point; normal: Penalty; }",
        "an element needs an entry `master`",
        "add `master: Quad4;`",
    );
    assert_mistake(
        "element E { slave: point; «mastr: Quad4; normal: Penalty; }",
        "an element has no entry `mastr`",
        "did you mean `master`?",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty; «damping: Viscous; }",
        "an element has no entry `damping`",
        "an element has the entries `dimension`, `slave`, `master`, `normal`, `tangential`, `axis`, \
         `rolling`, `director`, `angle`, `enforcement`, `gap`, `linearisation`, `measure`, `outputs` and `batch`",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; «master: Tri3; normal: Penalty; }",
        "`master` is given twice",
        "keep one of the two",
    );
}

#[test]
fn choices() {
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty; linearisation: «exakt; }",
        "`exakt` is not a choice for `linearisation`",
        "did you mean `exact`?",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty; outputs: «everything; }",
        "`everything` is not a choice for `outputs`",
        "write `residual_and_tangent` or `residual`",
    );
    assert_mistake(
        "element E { dimension: «4; slave: point; master: Line2; normal: Penalty; }",
        "`dimension` must be 2 or 3",
        "write `dimension: 2;`, or leave it out for 3D",
    );
    for entry in [
        "slave: «3; master: Quad4; normal: Penalty;",
        "slave: point; master: «3; normal: Penalty;",
    ] {
        let key = if entry.starts_with("slave: «") {
            "slave"
        } else {
            "master"
        };
        assert_mistake(
            &format!("element E {{ {entry} }}"),
            &format!("`{key}` must be a name"),
            &format!("write `{key}: Name;`"),
        );
    }
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: «3; }",
        "`normal` must be a name",
        "write `normal: Name;`",
    );
}

#[test]
fn words_that_belong_elsewhere() {
    let rule = "integration points belong to the slave: `slave: Quad4 at gauss(2, 2);`";
    assert_mistake(
        "element E { slave: point; master: Quad4 at «gauss(2, 2); normal: Penalty; }",
        "`master` takes no `at`",
        rule,
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty at «given; }",
        "`normal` takes no `at`",
        rule,
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty; outputs: residual at «given; }",
        "`outputs` takes no `at`",
        rule,
    );
    let placed = "only rigid masters are: a deformable geometry is where its nodes are";
    assert_mistake(
        "element E { slave: point; master: Quad4 «placed; normal: Penalty; }",
        "`Quad4` cannot be `placed`",
        placed,
    );
    assert_mistake(
        "element E { slave: point «placed; master: Quad4; normal: Penalty; }",
        "`point` cannot be `placed`",
        placed,
    );
    assert_mistake(
        "element E { slave: point; master: point «placed; normal: Penalty; }",
        "`point` cannot be `placed`",
        placed,
    );
    for word in ["point", "interpolated"] {
        assert_mistake(
            &format!("element E {{ slave: {word} at «gauss(2); master: Quad4; normal: Penalty; }}"),
            &format!("a slave that is `{word}` takes no `at`"),
            "remove it, or name the curve or surface to integrate over",
        );
    }
}

#[test]
fn unknown_geometries_and_laws() {
    assert_mistake(
        "element E { slave: point; master: «Quad5; normal: Penalty; }",
        "unknown geometry `Quad5`",
        "did you mean `Quad4`?",
    );
    assert_mistake(
        "element E { slave: «Thorus at gauss(2); master: Quad4; normal: Penalty; }",
        "unknown geometry `Thorus`",
        "known here: `BezierCurve2`, `BezierCurve3`, `BezierSurface2`, `Hermite`, `Line2`, `Line3`, \
         `Quad4`, `Quad9`, `RationalCurve2`, `RationalCurve3`, `RationalSurface2`, `Tri3` and `Tri6`",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: «Penalti; }",
        "unknown normal law `Penalti`",
        "did you mean `Penalty`?",
    );
}

#[test]
fn roles() {
    assert_mistake(
        "element E { slave: point; master: «Penalty; normal: Penalty; }",
        "`Penalty` is a normal law, but `master` must be a geometry",
        "write `normal: Penalty;` and name a geometry here",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: «Torus; }",
        "`Torus` is a rigid surface, but `normal` must be a normal law",
        "name a law, such as `Penalty`",
    );
    assert_mistake(
        "element E { slave: «Torus at gauss(2, 2); master: Quad4; normal: Penalty; }",
        "`Torus` is a rigid surface and cannot be the slave",
        "make it the master: `slave: interpolated; master: Torus;`",
    );
    assert_mistake(
        "element E { slave: «SphereDistance; master: Quad4; normal: Penalty; }",
        "`SphereDistance` is a distance function and cannot be the slave",
        "make it the master: `slave: interpolated; master: SphereDistance;`",
    );
    assert_mistake(
        "element E { slave: point; master: «interpolated; normal: Penalty; }",
        "a master cannot be `interpolated`",
        "name a curve, a surface or a distance function, or write `point`",
    );
    assert_mistake(
        "element E { slave: «Tri3; master: Quad4; normal: Penalty; }",
        "the slave surface `Tri3` needs integration points",
        "write `slave: Tri3 at gauss(3);`",
    );
}

#[test]
fn rules() {
    let element =
        |slave: &str| format!("element E {{ slave: {slave}; master: Quad4; normal: Penalty; }}");
    assert_mistake(
        &element("Quad4 at «gaus(2, 2)"),
        "unknown integration rule `gaus`",
        "did you mean `gauss`?",
    );
    assert_mistake(
        &element("Quad4 at «lobatto(2, 2)"),
        "unknown integration rule `lobatto`",
        "write `at gauss(n)`, `at gauss(n, m)` or `at given`",
    );
    assert_mistake(
        &element("Quad4 at «given(2)"),
        "`given` has the wrong arguments",
        "write `at given`: the point and its weight come at run time",
    );
    for written in ["Quad4 at «gauss", "Quad4 at «gauss()"] {
        assert_mistake(
            &element(written),
            "`gauss` has the wrong arguments",
            "write `at gauss(n)` for curves and triangles, `at gauss(n, m)` for quadrilaterals",
        );
    }
    assert_mistake(
        &element("Quad4 at «gauss(2)"),
        "`Quad4` is a quadrilateral: its rule has 2 numbers",
        "write `Quad4 at gauss(2, 2)`",
    );
    assert_mistake(
        &element("Tri6 at «gauss(3, 3)"),
        "`Tri6` is a triangle: its rule has 1 number",
        "write `Tri6 at gauss(3)`",
    );
    assert_mistake(
        &element("Tri6 at gauss(«4)"),
        "there is no rule with 4 points",
        "there are rules with 1, 3 and 6 points on a triangle",
    );
    assert_mistake(
        &element("Line2 at gauss(«11)"),
        "there is no rule with 11 points",
        "there are rules with 1 to 10 points",
    );
    assert_mistake(
        &element("Quad9 at gauss(3, «0)"),
        "there is no rule with 0 points",
        "there are rules with 1 to 10 points in each direction",
    );
}

#[test]
fn contradictions() {
    for slave in ["point", "interpolated", "Line2 at given"] {
        assert_mistake(
            &format!(
                "element E {{ slave: {slave}; master: Quad4; normal: Penalty; measure: «current; }}"
            ),
            "`measure: current` needs a slave with its own integration points",
            "write `slave: NAME at gauss(..);`, or remove `measure`",
        );
    }
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty;\n outputs: residual; linearisation: «tangent_plane; }",
        "`linearisation: tangent_plane` contradicts `outputs: residual`",
        "remove one of the two: the linearisation only changes the tangent",
    );
    assert_mistake(
        "element E { slave: point; master: PlaneDistance; normal: Penalty; linearisation: «tangent_plane; }",
        "`linearisation: tangent_plane` needs a projection, but `PlaneDistance` has none",
        "remove it: the exact tangent is as short",
    );
    assert_mistake(
        "normal law Soft(g; radius) { N = radius*g; }
         element E { slave: point; master: Sphere; normal: «Soft; }",
        "both `Soft` and `Sphere` have a parameter `radius`",
        "rename it in one of the two declarations: an element lists its parameters by name",
    );
}

#[test]
fn broken_items_are_no_further_mistake() {
    assert_mistake(
        "surface Bent(u, v) in square { N = [u «^ 2, v]; }
         element E { slave: point; master: Bent; normal: Penalty; }",
        "`^` cannot stand in an expression",
        "write `x*x` or `pow(x, y)`",
    );
    assert_mistake(
        "surface Bent(u, v) in square { «N = [u, v]; }
         element E { slave: point; master: Bent; normal: Penalty; gap: signed; }",
        "the shape functions sum to -2 instead of 1 at u = -1, v = -1",
        "a translation must move every point alike: check signs and factors in `N`",
    );
}

#[test]
fn enforcement() {
    let element = |law: &str, rest: &str| {
        format!("{law} element E {{ slave: Quad4 at gauss(2, 2); master: Quad4; {rest} }}")
    };
    assert_mistake(
        &element("", "normal: Penalty; enforcement: «augmentd;"),
        "`augmentd` is not a choice for `enforcement`",
        "did you mean `augmented`?",
    );
    for law in [
        "N = k*g*g;",
        "N = k*g + 1;",
        "N = k*g; active = g < k;",
        "N = k*g; valid = g > -k;",
        "N = -k*g;",
    ] {
        let law = format!("normal law Odd(g; k in (0, inf)) {{ {law} }}");
        assert_mistake(
            &element(&law, "normal: Odd; enforcement: «multiplier;"),
            "a multiplier needs a linear normal law, but `Odd` is not linear",
            "write `normal: Penalty;`, or any N = eps*g with contact at g < 0 and without `valid`",
        );
    }
    assert_mistake(
        &element(
            "",
            "normal: Penalty; enforcement: multiplier; measure: «current;",
        ),
        "`measure: current` is not offered with `enforcement: multiplier`",
        "remove `measure`, or write `enforcement: augmented;`",
    );
    let model = accept(&element(
        "normal law Even(g; a in (0, inf), b in (0, inf)) { let c = a/b; N = 2*c*g; }",
        "normal: Even; enforcement: augmented; measure: current;",
    ));
    assert_eq!(model.elements[0].enforcement, Enforcement::Augmented);
}

#[test]
fn batches_in_lanes() {
    let model = accept(
        "element A { slave: point; master: Quad4; normal: Penalty; batch: lanes; }
         element B { slave: Line2; master: Line2; gap: distance; normal: Penalty; batch: lanes; }
         element C { slave: point; master: Quad4; normal: Penalty; batch: single; }",
    );
    let lanes: Vec<bool> = model.elements.iter().map(|element| element.lanes).collect();
    assert_eq!(lanes, [true, true, false]);
    for rest in [
        "slave: point; master: Torus placed; normal: Penalty;",
        "slave: point; master: Quad4; normal: Penalty; tangential: Coulomb;",
        "slave: point; master: Quad4; normal: Penalty; enforcement: augmented;",
        "slave: point; master: point; normal: Penalty;",
        "slave: Line2; master: Line2; normal: Penalty; gap: signed;",
    ] {
        assert_mistake(
            &format!("element A {{ {rest} batch: «lanes; }}"),
            "this element cannot be evaluated in lanes: lanes are for points and curves against a shape, by a penalty, \
             without friction, rolling, angle or signed gap of two curves",
            "leave `batch` out: its contacts are then evaluated one after another",
        );
    }
}

#[test]
fn what_is_left_out() {
    let model = accept("element E { slave: point; master: Quad4; normal: Penalty; }");
    let element = &model.elements[0];
    assert_eq!((element.dimension, element.residual_only), (3, false));
    assert_eq!(element.linearisation, Linearisation::Exact);
    assert_eq!(element.measure, Measure::Reference);
    assert_eq!(element.enforcement, Enforcement::Penalty);
    assert!(matches!(element.slave, Slave::Point));
    assert_eq!(element.law.name, "Penalty");
}

#[test]
fn everything_at_once() {
    let model = accept(
        "element A { slave: Quad4 at gauss(2, 3); master: Tri6; normal: LogBarrier; measure: current;
                     linearisation: tangent_plane; outputs: residual_and_tangent; }
         element B { slave: Line2 at given; master: Torus placed; normal: PowerLaw; outputs: residual; }",
    );
    let [a, b] = model.elements.as_slice() else {
        panic!()
    };
    assert!(matches!(&a.slave, Slave::Integrated { rule: Rule::Gauss(n), .. } if *n == [2, 3]));
    assert!(a.slave.has_own_points() && !b.slave.has_own_points());
    assert_eq!(
        (a.measure, a.linearisation),
        (Measure::Current, Linearisation::TangentPlane)
    );
    assert!(matches!(
        b.slave,
        Slave::Integrated {
            rule: Rule::Given,
            ..
        }
    ));
    assert!(
        matches!(&b.master, Master::Rigid { placed: true, geometry } if geometry.name == "Torus")
    );
    assert_eq!(b.master.projected(), 2);
    assert!(b.residual_only);
}
