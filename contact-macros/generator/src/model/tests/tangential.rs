//! Tangential laws, and elements that name them.

use crate::diagnostics::testing::{accept, assert_mistake, mistakes};
use crate::model::{Axis, Model};

/// A tangential law with `eps`, `mu` and the statements `text`.
fn law(text: &str) -> String {
    format!("tangential law Rub(p, s; eps, mu) {{ {text} }}")
}

/// A point on a facet with the entries `text`.
fn element(text: &str) -> String {
    format!("element E {{ slave: point; master: Quad4; normal: Penalty; {text} }}")
}

#[test]
fn entries_of_laws() {
    assert_mistake(
        "tangential law «Rub(p, s; mu) { bound = mu*p; }",
        "tangential law needs an entry `stiffness`",
        "add `stiffness = ..;`",
    );
    assert_mistake(
        &law("«stifness = eps; bound = mu*p;"),
        "tangential law has no entry `stifness`",
        "did you mean `stiffness`?",
    );
    assert_mistake(
        &law("stiffness = eps; «N = mu*p;"),
        "tangential law has no entry `N`",
        "tangential law has the entries `stiffness` and `bound`",
    );
    assert_mistake(
        &law("stiffness = eps; bound = mu*p; «bound = p;"),
        "`bound` is given twice",
        "keep one of the two",
    );
    assert_mistake(
        &law("stiffness = eps; «bound(p) = mu*p;"),
        "`bound` takes no arguments",
        "write `bound = ..`; its variables are those of the item",
    );
    assert_mistake(
        &law("stiffness = eps; «bound = p < mu;"),
        "`bound` must be one expression, or a list of two",
        "write `bound = ..;`",
    );
}

#[test]
fn pressure_and_slip() {
    let hint = "write `tangential law Name(pressure, slip; parameter: \"unit\")`: parameters come after `;`";
    assert_mistake(
        "tangential law «Rub(p; eps, mu) { stiffness = eps; bound = mu*p; }",
        "a tangential law depends on pressure and slip, found 1 name before `;`",
        hint,
    );
    assert_mistake(
        "tangential law «Rub(p, s, eps, mu) { stiffness = eps; bound = mu*p; }",
        "a tangential law depends on pressure and slip, found 4 names before `;`",
        hint,
    );
    assert_mistake(
        "tangential law Rub(p, «p; eps) { stiffness = eps; }",
        "`p` is already a pressure here",
        "choose another name",
    );
    assert_mistake(
        "tangential law Rub(p, s; «s) { stiffness = 1; }",
        "`s` is already a slip here",
        "choose another name",
    );
}

#[test]
fn stiffnesses_are_made_of_parameters() {
    let hint = "use parameters and numbers only";
    for (text, role) in [
        ("stiffness = eps*«p;", "pressure `p`"),
        ("stiffness = [eps, eps*(1 + «s)];", "slip `s`"),
        ("let e = 2*eps; stiffness = «e;", "binding `e`"),
    ] {
        let message = format!("{role} cannot be used in a stiffness");
        assert_mistake(&law(text), &message, hint);
    }
    assert_mistake(
        &law("stiffness = «esp;"),
        "unknown variable `esp`",
        "did you mean `eps`?",
    );
}

#[test]
fn one_value_or_one_for_each_axis() {
    assert_mistake(
        &law("«stiffness = [eps]; bound = mu*p;"),
        "a list of `stiffness` has two values, one for each axis, found 1",
        "write `stiffness = [.., ..];`, or `stiffness = ..;` for all directions alike",
    );
    assert_mistake(
        &law("stiffness = [eps, eps]; «bound = [p, p, p];"),
        "a list of `bound` has two values, one for each axis, found 3",
        "write `bound = [.., ..];`, or `bound = ..;` for all directions alike",
    );
    assert_mistake(
        &law("stiffness = [eps, 2*eps]; «bound = mu*p;"),
        "`bound` has 1 value, but `stiffness` has 2",
        "write `bound = [.., ..];`: one for each axis",
    );
    assert_mistake(
        &law("stiffness = eps; «bound = [mu*p, p];"),
        "`bound` has 2 values, but `stiffness` has 1",
        "write `bound = ..;`, or give two stiffnesses: `stiffness = [.., ..];`",
    );
}

#[test]
fn several_mistakes_of_one_law() {
    let text = "tangential law Rub(p; eps, mu) { stiffness = [eps*p, e]; bound = mu*q; }";
    let found = mistakes(text);
    let expected = [
        "1:16 a tangential law depends on pressure and slip, found 1 name before `;`",
        "1:51 pressure `p` cannot be used in a stiffness",
        "1:54 unknown variable `e`",
        "1:58 `bound` has 1 value, but `stiffness` has 2",
        "1:69 unknown variable `q`",
    ];
    let starts: Vec<&str> = found.iter().map(|m| m.lines().next().unwrap()).collect();
    assert_eq!(starts, expected);
}

#[test]
fn names_of_laws() {
    assert_mistake(
        &element("tangential: «Coulom;"),
        "unknown tangential law `Coulom`",
        "did you mean `Coulomb`?",
    );
    assert_mistake(
        &element("tangential: «Rough;"),
        "unknown tangential law `Rough`",
        "known here: `Coulomb`, `CoulombAdhesive`, `CoulombOrthotropic`, `CoulombStaticKinetic`, \
         `RollingResistance` and `Stick`",
    );
    assert_mistake(
        &element("tangential: «PowerLaw;"),
        "`PowerLaw` is a normal law, but `tangential` must be a tangential law",
        "write `normal: PowerLaw;` and name a tangential law here, such as `Coulomb`",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: «Coulomb; }",
        "`Coulomb` is a tangential law, but `normal` must be a normal law",
        "write `tangential: Coulomb;` and name a normal law here, such as `Penalty`",
    );
    assert_mistake(
        &element("tangential: «Plane;"),
        "`Plane` is a rigid surface, but `tangential` must be a tangential law",
        "name a law, such as `Coulomb`",
    );
    assert_mistake(
        "element E { slave: point; master: «Stick; normal: Penalty; }",
        "`Stick` is a tangential law, but `master` must be a geometry",
        "write `tangential: Stick;` and name a geometry here",
    );
    assert_mistake(
        &element("tangential: «2;"),
        "`tangential` must be a name",
        "write `tangential: Name;`",
    );
    assert_mistake(
        &element("tangential: Coulomb at «given;"),
        "`tangential` takes no `at`",
        "integration points belong to the slave: `slave: Quad4 at gauss(2, 2);`",
    );
    assert_mistake(
        &element("«friction: Coulomb;"),
        "an element has no entry `friction`",
        "did you mean `tangential`?",
    );
}

#[test]
fn pairs_without_a_direction_to_slide() {
    for master in ["PlaneDistance", "SphereDistance placed"] {
        let name = master.split(' ').next().unwrap();
        assert_mistake(
            &format!(
                "element E {{ slave: point; master: {master}; normal: Penalty; tangential: «Coulomb; }}"
            ),
            &format!("`tangential: Coulomb` needs a projection, but `{name}` has none"),
            "name the body as a rigid curve or surface instead, such as `Plane` or `Sphere`",
        );
    }
    assert_mistake(
        "element E { slave: point; master: point; normal: Penalty; tangential: «Stick; }",
        "`tangential: Stick` needs a projection, but `point` has none",
        "remove `tangential`, or make the master a curve or a surface to slide along",
    );
}

#[test]
fn axes() {
    assert_mistake(
        &element("tangential: Coulomb; «axis: convected;"),
        "`Coulomb` has one stiffness for all directions: it takes no `axis`",
        "remove `axis`, or name a law with two stiffnesses, such as `CoulombOrthotropic`",
    );
    assert_mistake(
        &element("«axis: convected;"),
        "`axis` belongs to a tangential law, but the element has none",
        "add `tangential: CoulombOrthotropic;`, or remove `axis`",
    );
    assert_mistake(
        &element("tangential: «CoulombOrthotropic;"),
        "`CoulombOrthotropic` has two axes and needs an entry `axis`",
        "add `axis: convected;` (a direction on the master, given at run time)",
    );
    assert_mistake(
        "element E { slave: Line2 at gauss(2); master: Quad4; normal: Penalty; tangential: «CoulombOrthotropic; }",
        "`CoulombOrthotropic` has two axes and needs an entry `axis`",
        "add `axis: convected;` (a direction on the master, given at run time) or \
         `axis: slave;` (along the slave curve)",
    );
    assert_mistake(
        &element("tangential: CoulombOrthotropic; axis: «slve;"),
        "`slve` is not a choice for `axis`",
        "did you mean `slave`?",
    );
    for pair in [
        "slave: point; master: Quad4",
        "slave: interpolated; master: Quad4",
        "slave: Tri3 at gauss(3); master: Quad4",
        "slave: Line2; master: Line2; gap: signed",
    ] {
        assert_mistake(
            &format!(
                "element E {{ {pair}; normal: Penalty; tangential: CoulombOrthotropic; axis: «slave; }}"
            ),
            "`axis: slave` needs a slave curve with integration points",
            "write `axis: convected;`: the direction on the master is given at run time",
        );
    }
    for pair in [
        "dimension: 2; slave: point; master: Line2",
        "slave: Line2 at gauss(2); master: Line2",
    ] {
        assert_mistake(
            &format!(
                "element E {{ {pair}; normal: Penalty; tangential: «CoulombOrthotropic; axis: slave; }}"
            ),
            "`CoulombOrthotropic` has two axes, but this pair slides in one direction only",
            "name a law with one stiffness, such as `Coulomb`",
        );
    }
}

#[test]
fn a_misspelt_entry_is_not_missing_too() {
    assert_mistake(
        &element("tangential: CoulombOrthotropic; «axes: convected;"),
        "an element has no entry `axes`",
        "did you mean `axis`?",
    );
    assert_mistake(
        &element("«tangental: CoulombOrthotropic; axis: convected;"),
        "an element has no entry `tangental`",
        "did you mean `tangential`?",
    );
}

#[test]
fn broken_laws_are_no_further_mistake() {
    let broken = law("stiffness = eps*«x; bound = p;");
    assert_mistake(
        &format!("{broken} {}", element("tangential: Rub; axis: convected;")),
        "unknown variable `x`",
        "known here: `eps` and `mu`",
    );
}

#[test]
fn parameters_share_one_list() {
    let hint = "rename it in one of the two declarations: an element lists its parameters by name";
    let sliding =
        "tangential law Rub(p, s; eps_n, radius) { stiffness = eps_n; bound = radius*p; }";
    assert_mistake(
        &format!("{sliding} {}", element("tangential: «Rub;")),
        "both `Rub` and `Penalty` have a parameter `eps_n`",
        hint,
    );
    assert_mistake(
        &format!(
            "{sliding} element E {{ slave: point; master: Sphere; normal: LogBarrier; tangential: «Rub; }}"
        ),
        "both `Rub` and `Sphere` have a parameter `radius`",
        hint,
    );
}

#[test]
fn names_that_elements_keep_for_the_axis() {
    let found = mistakes("tangential law Rub(p, s; axis_1) { stiffness = axis_1; }");
    assert_eq!(found.len(), 1);
    assert!(found[0].starts_with("1:26 `axis_1` is reserved for a parameter that elements add"));
}

#[test]
fn what_a_law_becomes() {
    let model = accept(
        "/// Doc.
         tangential law Rub(p, s; eps: \"force/length\" in (0, inf), mu) {
             let worn = mu*exp(-s);
             stiffness = [eps, 2*eps];
             bound = [worn*p, 0.5*worn*p];
         }
         tangential law Tie(p, s; eps) { stiffness = eps; }",
    );
    let [rub, tie] = model.tangential_laws.as_slice() else {
        panic!()
    };
    assert_eq!((&*rub.docs, rub.built_in), ("Doc.", false));
    assert_eq!(
        (rub.pressure.to_string(), rub.slip.to_string()),
        ("p".into(), "s".into())
    );
    assert_eq!(
        (rub.stiffness.len(), rub.bound.len(), rub.bindings.len()),
        (2, 2, 1)
    );
    assert_eq!(rub.parameters[0].unit, "force/length");
    assert_eq!((tie.stiffness.len(), tie.bound.len()), (1, 0));
    assert!(model.laws.is_empty());
}

/// Law and axis of the only element of `model`.
fn chosen(model: &Model) -> Option<(String, Option<Axis>)> {
    let tangential = model.elements[0].tangential.as_ref()?;
    Some((tangential.law.name.to_string(), tangential.axis))
}

#[test]
fn what_an_element_becomes() {
    let orthotropic = "tangential: CoulombOrthotropic; axis";
    let cases = [
        ("slave: point; master: Quad4", None),
        (
            "slave: point; master: Quad4; tangential: Coulomb",
            Some(("Coulomb", None)),
        ),
        (
            "slave: point; master: Line2; tangential: Stick",
            Some(("Stick", None)),
        ),
        (
            "dimension: 2; slave: point; master: Line2; tangential: Later",
            Some(("Later", None)),
        ),
        (
            "slave: Line2; master: Hermite; gap: distance; tangential: Coulomb",
            Some(("Coulomb", None)),
        ),
    ];
    for (entries, expected) in cases {
        let model = accept(&format!(
            "element E {{ {entries}; normal: Penalty; }}
             tangential law Later(p, s; e) {{ stiffness = e; bound = p; }}"
        ));
        let expected = expected.map(|(law, axis): (&str, Option<Axis>)| (law.to_string(), axis));
        assert_eq!(chosen(&model), expected, "{entries}");
    }
    let axes = [
        (
            format!("slave: point; master: Torus placed; {orthotropic}: convected"),
            Axis::Convected,
        ),
        (
            format!("slave: Line2; master: Line2; gap: signed; {orthotropic}: convected"),
            Axis::Convected,
        ),
        (
            format!("slave: Hermite at given; master: Quad4; {orthotropic}: slave"),
            Axis::Slave,
        ),
        (
            format!("slave: Line2 at gauss(2); master: Cylinder; {orthotropic}: slave"),
            Axis::Slave,
        ),
    ];
    for (entries, axis) in axes {
        let model = accept(&format!("element E {{ {entries}; normal: Penalty; }}"));
        let expected = Some(("CoulombOrthotropic".to_string(), Some(axis)));
        assert_eq!(chosen(&model), expected, "{entries}");
    }
}
