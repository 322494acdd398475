//! Elastic slip taken along from element to element: known answers, and what is refused.

use contact_elements::runtime::TangentPlane;
use contact_elements::{
    Entered, Error, Evaluation, Left, OUTPUT_SIZE, Registered, Status, argument, code, evaluate,
    transfer,
};
use contact_library::{
    Line2Line2BeamsCoulomb, Line2Line2BeamsRolling, PointHermiteCoulomb, PointLine2Coulomb2d,
    PointQuad4, PointQuad4Coulomb,
};

/// Relative: |s| is of size 1e-2 beside parameters of size 1.
const TOLERANCE: f64 = 1e-13;

/// One evaluated contact point.
struct Point {
    element: &'static Registered,
    status: Option<Status>,
    force: Vec<f64>,
    output: Vec<f64>,
    history: Vec<f64>,
}

impl Point {
    /// `old`: accepted history; empty: contact begins.
    fn new(element: &'static Registered, x: &[f64], parameters: &[f64], old: &[f64]) -> Self {
        let mut point = Self {
            element,
            status: None,
            force: vec![0.0; x.len()],
            output: vec![0.0; OUTPUT_SIZE],
            history: vec![0.0; element.history()],
        };
        let result = evaluate(
            element,
            &mut Evaluation {
                x,
                parameters,
                history: old,
                residual: &mut point.force,
                output: &mut point.output,
                trial: &mut point.history,
                ..Evaluation::default()
            },
        );
        point.status = Some(result.expect("evaluated").status);
        point
    }

    /// Takes over what `from` remembers.
    fn receive(&mut self, from: &Point) -> Result<Status, Error> {
        let left = Left {
            element: from.element,
            output: &from.output,
            history: &from.history,
        };
        let entered = Entered {
            element: self.element,
            output: &self.output,
            history: &mut self.history,
        };
        transfer(left, entered)
    }

    /// s = b_i (ζ − ζ_st)^i
    fn slip(&self) -> [f64; 3] {
        let p = self.element.projected;
        let moved = |i: usize| self.history[1 + i] - self.history[1 + p + i];
        std::array::from_fn(|k| (0..p).map(|i| self.output[13 + 3 * i + k] * moved(i)).sum())
    }

    fn tangential(&self) -> f64 {
        length(&[self.output[11], self.output[12], 0.0])
    }
}

fn length(v: &[f64; 3]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// eps_n, eps_t, mu, r0, orientation
const FACET: [f64; 5] = [100.0, 50.0, 0.25, 0.0, 1.0];

/// A slave and a facet.
fn quad(slave: [f64; 3], nodes: [[f64; 3]; 4], old: &[f64]) -> Point {
    let x: Vec<f64> = [slave].into_iter().chain(nodes).flatten().collect();
    Point::new(PointQuad4Coulomb::DESCRIPTOR, &x, &FACET, old)
}

const SQUARE: [[f64; 3]; 4] = [
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

/// A parallelogram beside the square, its nodes from another corner, turned about the common edge.
fn beside(angle: f64) -> [[f64; 3]; 4] {
    let (s, c) = angle.sin_cos();
    [
        [1.0, 1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0 + 3.0 * c, -0.6, 3.0 * s],
        [1.0 + 3.0 * c, 1.4, 3.0 * s],
    ]
}

/// A point that slid on the square up to (x, 0.35).
fn slid(x: f64) -> Point {
    let begins = quad([0.85, 0.3, -0.05], SQUARE, &[]);
    let slid = quad([x, 0.35, -0.05], SQUARE, &begins.history);
    assert_eq!(slid.status, Some(Status::Slip));
    slid
}

fn assert_near(found: &[f64], expected: &[f64]) {
    let scale = expected.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() <= TOLERANCE * scale,
            "{found} {expected}"
        );
    }
}

#[test]
fn coplanar_facets_have_the_same_force_on_their_edge() {
    let from = slid(1.0);
    let mut to = quad([1.0, 0.35, -0.05], beside(0.0), &[]);
    assert_eq!(to.receive(&from), Ok(Status::Slip));
    assert_near(&to.slip(), &from.slip());
    let after = quad([1.0, 0.35, -0.05], beside(0.0), &to.history);
    assert_near(&after.force[..3], &from.force[..3]);
    assert_eq!(to.history[5], from.history[5], "the slip path");
}

#[test]
fn a_sliding_point_crosses_the_edge_as_on_one_plane() {
    let from = slid(0.97);
    let mut to = quad([0.97, 0.35, -0.05], beside(0.0), &[]);
    assert_eq!(to.status, Some(Status::Outside));
    to.receive(&from).expect("carried");
    let long = [
        [-1.0, -1.0, 0.0],
        [3.0, -1.0, 0.0],
        [3.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let mut whole = quad([0.97, 0.35, -0.05], long, &[]);
    whole.receive(&from).expect("carried");
    let crossed = quad([1.17, 0.25, -0.05], beside(0.0), &to.history);
    let expected = quad([1.17, 0.25, -0.05], long, &whole.history);
    assert_eq!(crossed.status, Some(Status::Slip));
    assert_near(&crossed.force[..3], &expected.force[..3]);
    assert_near(&crossed.history[5..], &expected.history[5..]);
}

#[test]
fn turned_facets_keep_the_length() {
    for angle in [0.3, -0.7, 1.5, 3.0] {
        let from = slid(0.999);
        let mut to = quad([0.999, 0.35, -0.05], beside(angle), &[]);
        to.receive(&from).expect("carried");
        let (old, new) = (from.slip(), to.slip());
        let (s, c) = angle.sin_cos();
        assert_near(&new, &[old[0] * c, old[1], old[0] * s]);
        assert_near(&[length(&new)], &[length(&old)]);
        assert_near(&[50.0 * length(&new)], &[from.tangential()]);
    }
}

/// From a segment along x to one turned by an angle, running forwards or backwards.
#[test]
fn segments_of_the_plane() {
    let element = PointLine2Coulomb2d::DESCRIPTOR;
    let (s, c) = 2.0_f64.sin_cos();
    let first = [-1.0, 0.0, 1.0, 0.0];
    let point = |x: f64, master: &[f64], orientation: f64, old: &[f64]| {
        let mut parameters = FACET;
        parameters[4] = orientation;
        let x = [&[x, -0.02], master].concat();
        Point::new(element, &x, &parameters, old)
    };
    let begins = point(0.95, &first, 1.0, &[]);
    let from = point(0.954, &first, 1.0, &begins.history);
    for (next, orientation) in [
        ([1.0, 0.0, 1.0 + c, s], 1.0),
        ([1.0 + c, s, 1.0, 0.0], -1.0),
    ] {
        let mut to = point(0.954, &next, orientation, &[]);
        assert_eq!(to.receive(&from), Ok(Status::Stick));
        assert_near(&to.slip(), &[-0.004 * c, -0.004 * s, 0.0]);
    }
}

/// A wire with a kink of 0.5 in the plane normal to the contact: the force stays along the wire.
#[test]
fn a_kinked_wire_keeps_the_force() {
    let element = PointHermiteCoulomb::DESCRIPTOR;
    let (s, c) = 0.5_f64.sin_cos();
    let first = [
        -2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0_f64,
    ];
    let next = [0.0, 0.0, 0.0, c, s, 0.0, 2.0 * c, 2.0 * s, 0.0, c, s, 0.0];
    let parameters = [100.0, 50.0, 0.5, 0.2]; // eps_n, eps_t, mu, r0
    let point = |x: f64, master: &[f64], old: &[f64]| {
        let x = [&[x, 0.0, 0.15], master].concat();
        Point::new(element, &x, &parameters, old)
    };
    let begins = point(-0.01, &first, &[]);
    let from = point(0.0, &first, &begins.history);
    assert_eq!(from.status, Some(Status::Stick));
    let mut to = point(0.0, &next, &[]);
    to.receive(&from).expect("carried");
    assert_near(&to.slip(), &[-0.01 * c, -0.01 * s, 0.0]);
    let after = point(0.0, &next, &to.history);
    assert_near(&[after.tangential()], &[from.tangential()]);
}

#[test]
fn what_is_refused_is_named_and_not_written() {
    let fresh = || quad([0.97, 0.35, -0.05], beside(0.3), &[]);
    let refused = |change: fn(&mut Point, &mut Point)| {
        let (mut from, mut to) = (slid(0.97), fresh());
        change(&mut from, &mut to);
        let before: Vec<u64> = to.history.iter().map(|v| v.to_bits()).collect();
        let result = to.receive(&from);
        let after: Vec<u64> = to.history.iter().map(|v| v.to_bits()).collect();
        assert_eq!(before, after, "written");
        let error = result.expect_err("refused");
        (error.code, error.argument, error.index)
    };
    assert_eq!(
        refused(|from, _| from.output[14] = f64::NAN),
        (code::NOT_FINITE, argument::FROM_OUTPUT, 14)
    );
    assert_eq!(
        refused(|_, to| to.history[3] = f64::INFINITY),
        (code::NOT_FINITE, argument::TO_HISTORY, 3)
    );
    assert_eq!(
        refused(|from, _| from.history[5] = -1.0),
        (code::HISTORY, argument::FROM_HISTORY, 5)
    );
    assert_eq!(
        refused(|_, to| to.output.truncate(18)),
        (code::NULL, argument::TO_OUTPUT, 0)
    );
    assert_eq!(
        refused(|_, to| to.output[13..16].fill(0.0)),
        (code::CUT_BACK, argument::TO_OUTPUT, 13)
    );
    assert_eq!(
        refused(|_, to| to.element = PointQuad4::DESCRIPTOR),
        (code::ELEMENT, argument::TO, 0)
    );
    let mut open = slid(0.97);
    open.history[0] = f64::from(Status::Outside as i32);
    let (mut to, expected) = (fresh(), fresh());
    to.receive(&open).expect("carried");
    assert_eq!(to.history, expected.history, "nothing to carry");
}

#[test]
fn planes_and_slips() {
    let e = |k: usize| std::array::from_fn(|i| f64::from(u8::from(i == k)));
    let plane = |b, n, p| TangentPlane::new(b, n, p);
    let floor = plane([e(0), [0.6, 0.8, 0.0]], e(2), 2).expect("a plane");
    let wall = plane([e(1), e(2)], e(0), 2).expect("a plane");
    // skew tangents: parameters and slip are inverse to each other
    let s = floor.slip([0.3, -0.2]);
    assert_near(&floor.parameters(&s).expect("parameters"), &[0.3, -0.2]);
    // from z to x: what lay along x points down
    let turned = floor
        .turned(&[2.0, 3.0, 0.0], &wall)
        .expect("no opposite normals");
    assert_near(&turned, &[0.0, 3.0, -2.0]);
    // no rotation, no plane
    let ceiling = plane([e(1), e(0)], [0.0, 0.0, -1.0], 2).expect("a plane");
    assert!(floor.turned(&s, &ceiling).is_none());
    assert!(plane([e(0), e(0)], e(2), 2).is_none());
    assert!(plane([e(0), [0.0; 3]], e(2), 2).is_none());
    assert!(plane([e(0), e(1)], [0.0; 3], 2).is_none());
    assert!(plane([e(0), e(1)], e(2), 0).is_none());
    // along a curve the length counts, across it there is no sense
    let curve = plane([[0.0, -2.0, 0.0], [0.0; 3]], e(2), 1).expect("a curve");
    assert_near(
        &curve.parameters(&[3.0, 4.0, 0.0]).expect("a sense"),
        &[-2.5, 0.0],
    );
    assert!(curve.parameters(&e(0)).is_none());
    assert_eq!(curve.parameters(&[0.0; 3]), Some([0.0; 2]));
}

/// A beam along x above two collinear ones along y: angles and their paths go along unchanged, and with them the
/// moments; an element without rolling gives and takes friction alone.
#[test]
fn angles_about_curves() {
    let beams = |end: f64, turn: f64| {
        let slave = [-1.0, 0.01, 0.29 - turn, 1.0, 0.01, 0.29 + turn];
        [&slave[..], &[0.0, end - 1.0, 0.0, 0.0, end, 0.0]].concat()
    };
    // eps_n, eps_t, mu, eps_phi, mu_phi, r0, directors
    let parameters = [
        100.0, 50.0, 0.5, 0.2, 0.003, 0.3, 0.0, 0.3, 1.0, 0.1, 0.0, 1.0,
    ];
    let rolling = Line2Line2BeamsRolling::DESCRIPTOR;
    let mut from = Point::new(rolling, &beams(0.3, 0.0), &parameters, &[]);
    for turn in [0.02, 0.05] {
        let old = from.history.clone();
        from = Point::new(rolling, &beams(0.3, turn), &parameters, &old);
    }
    assert!(
        from.output[22].abs() > 1e-4 && from.history[9] > 0.0,
        "{:?}",
        from.output
    );
    let initial = [0.0; 11];
    let mut to = Point::new(rolling, &beams(0.5, 0.05), &parameters, &initial);
    to.receive(&from).expect("carried");
    assert_eq!(to.history[6..], from.history[6..]);
    let history = to.history.clone();
    let again = Point::new(rolling, &beams(0.5, 0.05), &parameters, &history);
    for entry in 19..23 {
        assert!((again.output[entry] - from.output[entry]).abs() < TOLERANCE);
    }
    let plain = Line2Line2BeamsCoulomb::DESCRIPTOR;
    let own = [100.0, 50.0, 0.5, 0.3];
    let mut frictional = Point::new(plain, &beams(0.5, 0.05), &own, &[0.0; 6]);
    frictional.receive(&from).expect("carried");
    assert_eq!(frictional.history[5], from.history[5]);
    let mut to = Point::new(rolling, &beams(0.5, 0.05), &parameters, &initial);
    let begun = to.history.clone();
    to.receive(&frictional).expect("carried");
    assert_eq!(to.history[6..], begun[6..]);
    from.history[10] = 5.0;
    let error = to.receive(&from).expect_err("refused");
    let expected = (code::HISTORY, argument::FROM_HISTORY, 10);
    assert_eq!((error.code, error.argument, error.index), expected);
}
