//! Geometries.

use crate::diagnostics::testing::{accept, assert_mistake};
use crate::model::{Body, Domain};

#[test]
fn entries_of_geometries() {
    assert_mistake(
        "curve «Arc(t) in line { let a = t; }",
        "curve needs an entry `N`",
        "add `N = [.., ..];`",
    );
    assert_mistake(
        "curve Arc(t) in line { N = [(1 - t)/2, (1 + t)/2]; «vector = [1]; }",
        "curve has no entry `vector`",
        "did you mean `vectors`?",
    );
    assert_mistake(
        "rigid distance Ball(x, y; r) { d = sqrt(x*x + y*y) - r; «unheard = 1; }",
        "distance function has no entry `unheard`",
        "distance function has the entries `d`",
    );
    assert_mistake(
        "rigid distance Ball(x, y; r) { d = sqrt(x*x + y*y) - r; «d = r; }",
        "`d` is given twice",
        "keep one of the two",
    );
    assert_mistake(
        "rigid distance Ball(x, y) { «d = [x, y]; }",
        "`d` must be one expression",
        "write `d = ..;`",
    );
    assert_mistake(
        "curve Arc(t) in line { «N = t; }",
        "`N` must be a list",
        "write `N = [.., ..];`",
    );
    assert_mistake(
        "curve Arc(t) in line { «N(t) = [(1 - t)/2, (1 + t)/2]; }",
        "`N` takes no arguments",
        "write `N = ..`; its variables are those of the item",
    );
}

#[test]
fn coordinates() {
    assert_mistake(
        "curve «Arc(t, s) in line { N = [(1 - t)/2, (1 + t)/2]; }",
        "a curve has one coordinate, found 2",
        "write `Arc(u)`",
    );
    assert_mistake(
        "rigid surface «Cap(u) { rho = [u, 0, 0]; }",
        "a rigid surface has two coordinates, found 1",
        "write `Cap(u, v)`",
    );
    assert_mistake(
        "rigid distance «Ball(x) { d = x; }",
        "a distance function has two or three coordinates, found 1",
        "write `Ball(x, y, z)`",
    );
}

#[test]
fn domains() {
    assert_mistake(
        "surface «Facet(u, v) { N = [1 - u - v, u, v]; }",
        "this surface needs a domain",
        "write `in square`, `in unit_square` or `in triangle` after the coordinates",
    );
    assert_mistake(
        "curve «Arc(t) { N = [1 - t, t]; }",
        "this curve needs a domain",
        "write `in line`, `in unit_line` or `in interval(a, b)` after the coordinates",
    );
    assert_mistake(
        "surface Facet(u, v) in «tringle { N = [1 - u - v, u, v]; }",
        "unknown domain `tringle`",
        "did you mean `triangle`?",
    );
    assert_mistake(
        "surface Facet(u, v) in «hexagon { N = [1 - u - v, u, v]; }",
        "unknown domain `hexagon`",
        "a surface lies in `square`, `unit_square`, `triangle` or `rectangle`",
    );
    assert_mistake(
        "surface Facet(u, v) in «line { N = [1 - u - v, u, v]; }",
        "`line` is not a domain of a surface",
        "a surface lies in `square`, `unit_square`, `triangle` or `rectangle`",
    );
    assert_mistake(
        "curve Arc(t) in «triangle { N = [1 - t, t]; }",
        "`triangle` is not a domain of a curve",
        "a curve lies in `line`, `unit_line` or `interval`",
    );
    assert_mistake(
        "curve Arc(t) in «interval(1) { N = [1 - t, t]; }",
        "`interval` does not take 1 bound",
        "write `interval(a, b)`",
    );
    assert_mistake(
        "curve Arc(t) in «line(0, 1) { N = [1 - t, t]; }",
        "`line` does not take 2 bounds",
        "write `line`",
    );
    assert_mistake(
        "curve Arc(t) in interval(0, «inf) { N = [1 - t, t]; }",
        "the domain of a deformable geometry is finite",
        "write numbers; `inf` is for rigid geometries",
    );
    assert_mistake(
        "rigid distance Ball(x, y) in «square { d = x; }",
        "a distance function has no domain",
        "remove it: the distance is defined at every point of space",
    );
}

#[test]
fn domains_mean_numbers() {
    let model = accept(
        "rigid surface Free(u, v) { rho = [u, v, 0]; }
         rigid surface Half(u, v) in rectangle(-inf, inf, 0, 2.5) { rho = [u, v, 0]; }
         rigid curve Piece(u) in interval(-1, 2) { rho = [u, 0]; }
         surface Tri(u, v) in triangle { N = [1 - u - v, u, v]; }",
    );
    let domains: Vec<Domain> = model
        .geometries
        .iter()
        .map(|geometry| geometry.domain)
        .collect();
    let expected = [
        Domain::Unbounded,
        Domain::Rectangle([f64::NEG_INFINITY, 0.0], [f64::INFINITY, 2.5]),
        Domain::Interval(-1.0, 2.0),
        Domain::Triangle,
    ];
    assert_eq!(domains, expected);
}

#[test]
fn words_of_other_kinds() {
    assert_mistake(
        "rigid curve Arc(u; r) «rational { rho = [r*cos(u), r*sin(u)]; }",
        "`rational` is for deformable geometries",
        "remove it: write a rigid geometry's quotient in `rho`",
    );
    assert_mistake(
        "curve Arc(t; «tension) in unit_line { N = [1 - t, t]; }",
        "a deformable geometry cannot have the parameter `tension`",
        "write its value as a number, or declare a `rigid` geometry",
    );
    assert_mistake(
        "curve Arc(t) in unit_line rational { N = [1 - t, t, t]; «vectors = [2]; }",
        "a rational geometry cannot have `vectors`",
        "remove `vectors` or `rational`: weights apply to positions only",
    );
}

#[test]
fn shape_functions_sum_to_one() {
    assert_mistake(
        "curve Arc(t) in unit_line { «N = [1 - t, 2*t]; }",
        "the shape functions sum to 1.21 instead of 1 at t = 0.21",
        "a translation must move every point alike: check signs and factors in `N`",
    );
    assert_mistake(
        "surface Facet(u, v) in square {\n    «N = [(1-u)*(1-v)/4, (1+u)*(1-v)/4, (1+u)*(1+v)/4, (1-u)*(1-v)/4];\n}",
        "the shape functions sum to 2 instead of 1 at u = -1, v = -1",
        "a translation must move every point alike: check signs and factors in `N`",
    );
    assert_mistake(
        "curve Arc(t) in unit_line { «N = [1 - t, t, t]; vectors = [0]; }",
        "the shape functions of the positions sum to 0 instead of 1 at t = 0",
        "a translation must move every point alike: check signs and factors in `N` and `vectors`",
    );
    assert_mistake(
        "curve Arc(t) in unit_line { «N = [1 - ln(t), ln(t)]; }",
        "the shape functions sum to NaN instead of 1 at t = 0",
        "a translation must move every point alike: check signs and factors in `N`",
    );
}

#[test]
fn vectors_are_indices() {
    let bad = [("«4", "4"), ("«1.5", "1.5"), ("«-1", "this")];
    for (written, shown) in bad {
        assert_mistake(
            &format!("curve Arc(t) in unit_line {{ N = [1 - t, t]; vectors = [{written}]; }}"),
            &format!("{shown} is not the index of a control"),
            "`N` has 2 functions: indices run from 0 to 1",
        );
    }
    assert_mistake(
        "curve Arc(t) in unit_line { N = [1 - t, t, t, t]; vectors = [3, «2]; }",
        "the indices in `vectors` are not ascending",
        "name each index once, in order",
    );
}

#[test]
fn components() {
    assert_mistake(
        "rigid surface Flat(u, v) { «rho = [u, v]; }",
        "the position of a surface cannot have 2 components",
        "a surface lies in 3D: write `rho = [x, y, z];`",
    );
    assert_mistake(
        "rigid curve Line(u) { «rho = [u]; }",
        "the position of a curve cannot have 1 component",
        "write `rho = [x, y];` for a curve in 2D, `rho = [x, y, z];` in 3D",
    );
}

#[test]
fn closed_projections() {
    assert_mistake(
        "rigid surface Flat(u, v) { rho = [u, v, 0]; «projection = [u, v]; }",
        "`projection` needs the names of the point's components",
        "write `projection(x, y, z) = [..];`",
    );
    assert_mistake(
        "rigid surface Flat(u, v) { rho = [u, v, 0]; «projection(x, y) = [x, y]; }",
        "`projection` takes a point with 2 components, but `rho` has 3",
        "write `projection(x, y, z) = [..];`",
    );
    assert_mistake(
        "rigid surface Flat(u, v) { rho = [u, v, 0]; «projection(x, y, z) = [x]; }",
        "`projection` gives 1 values for 2 coordinates",
        "give one value for each of (u, v)",
    );
    assert_mistake(
        "rigid surface Flat(u, v) { rho = [u, v, 0]; projection(x, y, z) = [x, «v]; }",
        "coordinate `v` cannot be used in a projection",
        "use the point and the parameters only",
    );
    assert_mistake(
        "rigid surface Flat(u, v) { rho = [u, v, 0]; projection(x, «u, z) = [x, z]; }",
        "`u` is already a coordinate here",
        "choose another name",
    );
    assert_mistake(
        "rigid curve Arc(u; r in (0, inf)) {\n    rho = [r*cos(u), r*sin(u)];\n    «projection(x, y) = [atan2(x, y)];\n}",
        "`projection` does not return the point at u = 0.3: it lands 1.586306 away",
        "a point of the geometry is its own closest point: check `projection` against `rho`",
    );
}

#[test]
fn what_a_geometry_is() {
    let model = accept(
        "curve Arc(t) in unit_line { N = [1 - t, t, t*t]; vectors = [2]; }
         rigid curve Wire(u) { rho = [u, 0]; }
         rigid distance Ball(x, y, z; r: \"length\" in [1, inf]) { let s = x*x + y*y + z*z; d = sqrt(s) - r; }",
    );
    let [arc, wire, ball] = model.geometries.as_slice() else {
        panic!()
    };
    assert!(arc.is_curve() && arc.space().is_none() && arc.controls() == 3);
    assert!(wire.is_curve() && !wire.is_surface() && wire.space() == Some(2));
    assert!(!ball.is_curve() && !ball.is_surface() && ball.space() == Some(3));
    let radius = &ball.parameters[0];
    assert_eq!(
        (radius.unit.as_str(), radius.lower, radius.closed),
        ("length", 1.0, true)
    );
    assert_eq!(ball.bindings[0].0, "s");
    assert!(matches!(&ball.body, Body::Distance { .. }));
}
