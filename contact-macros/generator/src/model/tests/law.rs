//! Normal laws.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::model::{Bound, Expr};

#[test]
fn entries_of_laws() {
    assert_mistake(
        "normal law «Soft(g; e) { W = e*g*g/2; }",
        "normal law needs an entry `N`",
        "add `N = ..;`",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = e*g; «actve = g < 0; }",
        "normal law has no entry `actve`",
        "did you mean `active`?",
    );
    assert_mistake(
        "normal law Soft(g; e) { «N = g < e; }",
        "`N` must be one expression",
        "write `N = ..;`",
    );
    assert_mistake(
        "normal law «Soft(g, e) { N = e*g; }",
        "a normal law depends on one gap, found 2 names before `;`",
        "write `normal law Name(g; parameter: \"unit\")`: parameters come after `;`",
    );
}

#[test]
fn conditions() {
    assert_mistake(
        "normal law Soft(g; e, d) { «active = g - d; N = e*g; }",
        "`active` must compare the gap with a value",
        "write `active = g < ..;` or `active = g > ..;`",
    );
    assert_mistake(
        "normal law Soft(g; e, d) { active = «d > g; N = e*g; }",
        "the left side of a condition is the gap `g`",
        "write `g < ..` or `g > ..`",
    );
    assert_mistake(
        "normal law Soft(g; e) { active = g < «dd; N = e*g; }",
        "unknown variable `dd`",
        "known here: `e`",
    );
    assert_mistake(
        "normal law Soft(g; e) { valid = g > «g; N = e*g; }",
        "gap `g` cannot be used in a condition",
        "use parameters and numbers only",
    );
    assert_mistake(
        "normal law Soft(g; e) { let limit = 2*e; valid = g > «limit; N = e*g; }",
        "binding `limit` cannot be used in a condition",
        "use parameters and numbers only",
    );
}

#[test]
fn the_traction_belongs_to_the_energy() {
    assert_mistake(
        "normal law Soft(g; e in (0, inf)) {\n    N = e*g;\n    «W = e*g*g;\n}",
        "`N` is not the derivative of `W`: at g = -0.1, e = 1.7, dW/dg = -0.34 but N = -0.17",
        "check signs and factors, or leave `W` out: it is used for reporting only",
    );
}

#[test]
fn what_is_left_out() {
    let model = accept("normal law Soft(g; e) { N = e*g; }");
    let law = &model.laws[0];
    assert!(matches!(law.active, Bound::Below(Expr::Number(0.0))));
    assert!(law.valid.is_none() && law.energy.is_none() && !law.built_in);
    let parameter = &law.parameters[0];
    assert_eq!((parameter.unit.as_str(), parameter.closed), ("1", false));
    assert_eq!(
        (parameter.lower, parameter.upper),
        (f64::NEG_INFINITY, f64::INFINITY)
    );
}
