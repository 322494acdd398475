//! One case per message: text in, message, hint and place out.

mod angle;
mod element;
mod geometry;
mod law;
mod library;
mod names;
mod pair;
mod rolling;
mod tangential;

use crate::diagnostics::testing::{accept, mistakes};

#[test]
fn every_mistake_is_reported_in_one_go() {
    let text = "\
surface Bad(xi, eta) in square {
    N = [1 - xi, 1 + zeta];
}
normal law Soft(g; eps_n) {
    W = eps_n*g*g/2;
}
element First {
    slave: Line2 at gauss(2, 2);
    master: Quad5;
    normal: Quad4;
}
element Fourth { slave: Line2; master: Line2; normal: Quad4; }
elemnt Second { slave: point; }
element Third {
    slave: point at gauss(2);
    master: Bad;
    normal: Soft;
    measure: current;
}";
    let expected = [
        "2:22 unknown variable `zeta`\nhint: did you mean `eta`?",
        "4:12 normal law needs an entry `N`\nhint: add `N = ..;`",
        "8:21 `Line2` is a curve: its rule has 1 number\nhint: write `Line2 at gauss(2)`",
        "9:13 unknown geometry `Quad5`\nhint: did you mean `Quad4`?",
        "10:13 `Quad4` is a surface, but `normal` must be a normal law\n\
         hint: name a law, such as `Penalty`",
        "12:9 curve to curve needs an entry `gap`\n\
         hint: add `gap: distance;` for beams (no sign, radii in r0) or `gap: signed;` for edges",
        "12:55 `Quad4` is a surface, but `normal` must be a normal law\n\
         hint: name a law, such as `Penalty`",
        "13:1 unknown item `elemnt`\nhint: did you mean `element`?",
        "15:21 a slave that is `point` takes no `at`\n\
         hint: remove it, or name the curve or surface to integrate over",
        "18:14 `measure: current` needs a slave with its own integration points\n\
         hint: write `slave: NAME at gauss(..);`, or remove `measure`",
    ];
    assert_eq!(mistakes(text), expected);
}

#[test]
fn items_may_be_declared_after_they_are_used() {
    let model = accept(
        "element E { slave: point; master: Later; normal: Also; }
         curve Later(t) in interval(0, 2) { N = [1 - t/2, t/2]; }
         normal law Also(g; stiffness) { N = stiffness*g; }
         element F { dimension: 2; slave: point; master: Later; normal: Also; }",
    );
    assert_eq!(model.elements.len(), 2);
    assert_eq!((model.geometries.len(), model.laws.len()), (1, 1));
    assert!(!model.geometries[0].built_in);
}

#[test]
fn the_file_comes_before_the_library() {
    let model = accept(
        "curve Line2(t) in unit_line { N = [1 - t, t]; }
         element E { slave: point; master: Line2; normal: Penalty; }",
    );
    let master = model.elements[0].master.geometry().unwrap();
    assert_eq!(master.coordinates[0], "t");
    assert!(model.elements[0].law.built_in);
}

#[test]
fn doc_comments_are_kept() {
    let model = accept(
        "/// First line.\n///\n/// Second: `N`.\nelement E { slave: point; master: point; normal: Penalty; }",
    );
    assert_eq!(model.elements[0].docs, "First line.\n\nSecond: `N`.");
}
