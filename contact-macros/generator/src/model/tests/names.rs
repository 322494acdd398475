//! Names of items, variables, functions and parameters.

use crate::diagnostics::testing::{assert_mistake, mistakes};

#[test]
fn two_items_of_one_name() {
    let text =
        "curve Arc(t) in line { N = [(1 - t)/2, (1 + t)/2]; }\nnormal law Arc(g; e) { N = e*g; }";
    let expected = [
        "1:7 `Arc` is declared here first\nhint: rename or remove one of the two",
        "2:12 `Arc` is declared twice\nhint: geometries, laws and elements share one set of names: choose another",
    ];
    assert_eq!(mistakes(text), expected);
}

#[test]
fn names_of_items_are_in_camel_case() {
    assert_mistake(
        "element «point_quad4 { slave: point; master: Quad4; normal: Penalty; }",
        "the name `point_quad4` is not in camel case",
        "write `PointQuad4`: ASCII letters and digits, a capital first",
    );
    assert_mistake(
        "normal law «soft(g; e) { N = e*g; }",
        "the name `soft` is not in camel case",
        "write `Soft`: ASCII letters and digits, a capital first",
    );
}

#[test]
fn unknown_variable() {
    assert_mistake(
        "normal law Soft(g; stiffness) {\n    N = «stifness*g;\n}",
        "unknown variable `stifness`",
        "did you mean `stiffness`?",
    );
    assert_mistake(
        "normal law Soft(g; stiffness) { N = stiffness*«unheard; }",
        "unknown variable `unheard`",
        "known here: `g` and `stiffness`",
    );
    assert_mistake(
        "rigid curve Arc(u; r) { rho = [r*cos(«pi*u), r*sin(u)]; }",
        "unknown variable `pi`",
        "write the number 3.141592653589793",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = «inf*e*g; }",
        "unknown variable `inf`",
        "`inf` can stand in a range only",
    );
}

#[test]
fn bindings_are_known_from_their_place_on() {
    assert_mistake(
        "normal law Soft(g; e) { let a = «b*g; let b = e; N = a; }",
        "unknown variable `b`",
        "known here: `g` and `e`",
    );
}

#[test]
fn unknown_function() {
    assert_mistake(
        "normal law Soft(g; e) { N = e*«sinn(g); }",
        "unknown function `sinn`",
        "did you mean `sin`?",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = e*«log(1 - g); }",
        "unknown function `log`",
        "did you mean `ln`?",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = e*«erf_inverse(g); }",
        "unknown function `erf_inverse`",
        "known here: `sqrt`, `sin`, `cos`, `tan`, `exp`, `ln`, `pow` and `atan2`",
    );
}

#[test]
fn wrong_argument_count() {
    assert_mistake(
        "normal law Soft(g; e) { N = -e*«pow(-g); }",
        "`pow` does not take 1 argument",
        "write `pow(x, y)`",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = e*«sin(g, e); }",
        "`sin` does not take 2 arguments",
        "write `sin(x)`",
    );
}

#[test]
fn variables_and_functions_are_told_apart() {
    assert_mistake(
        "normal law Soft(g; e) { N = e*«sin; }",
        "`sin` is a function",
        "write `sin(x)`",
    );
    assert_mistake(
        "normal law Soft(g; e) { N = «e(1 + g); }",
        "`e` is a variable, not a function",
        "write `e*(..)` for a product",
    );
}

#[test]
fn names_are_used_once_in_an_item() {
    assert_mistake(
        "rigid surface Cap(u, v; «u) { rho = [u, v, 0]; }",
        "`u` is already a coordinate here",
        "choose another name",
    );
    assert_mistake(
        "normal law Soft(g; e) { let «e = 1; N = e*g; }",
        "`e` is already a parameter here",
        "choose another name",
    );
    assert_mistake(
        "normal law Soft(g; e) { let a = 1; let «a = 2; N = a*e*g; }",
        "`a` is already a binding here",
        "choose another name",
    );
    assert_mistake(
        "normal law Soft(g; «g) { N = g; }",
        "`g` is already a gap here",
        "choose another name",
    );
}

#[test]
fn names_that_elements_keep() {
    assert_mistake(
        "normal law Soft(g; «r0: \"length\") { N = g - r0; }",
        "`r0` is reserved for a parameter that elements add",
        RESERVED_HINT,
    );
    assert_mistake(
        "normal law Soft(g; «slave_director_x) { N = slave_director_x*g; }",
        "`slave_director_x` is reserved for a parameter that elements add",
        RESERVED_HINT,
    );
    assert_mistake(
        "normal law Soft(g; «slave_weight_3) { N = slave_weight_3*g; }",
        "`slave_weight_3` is reserved for a parameter that elements add",
        RESERVED_HINT,
    );
}

const RESERVED_HINT: &str = "choose another name; reserved are `r0`, `orientation`, `weight`, \
    `eta_1`, `eta_2`, `axis_1`, `axis_2`, `angle_low`, `angle_high`, `origin_x`, `origin_y`, `origin_z`, `quaternion_w`, `quaternion_x`, \
    `quaternion_y`, `quaternion_z`, `direction_x`, `direction_y`, `master_weight_*`, \
    `slave_weight_*`, `master_director_*` and `slave_director_*`";

#[test]
fn units_are_plain_text() {
    for unit in ["", "force per length", "Ω", "a\\0"] {
        assert_mistake(
            &format!("normal law Soft(g; e: «\"{unit}\") {{ N = e*g; }}"),
            "a unit is text without spaces, of ASCII letters, digits and signs",
            "write something like `\"force/length^2\"`, or `\"1\"` for a parameter without unit",
        );
    }
}

#[test]
fn empty_ranges() {
    assert_mistake(
        "normal law Soft(g; e in («1, 1)) { N = e*g; }",
        "the range from 1 to 1 is empty",
        "the lower bound comes first and is less than the upper one",
    );
    assert_mistake(
        "normal law Soft(g; e in [«inf, -2.5]) { N = e*g; }",
        "the range from inf to -2.5 is empty",
        "the lower bound comes first and is less than the upper one",
    );
    assert_mistake(
        "curve Arc(t) in interval(«1, 0) { N = [1 - t, t]; }",
        "the range from 1 to 0 is empty",
        "the lower bound comes first and is less than the upper one",
    );
}
