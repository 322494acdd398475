//! Integration points per facet against the error of the resultant of a pressure.
//!
//! Facets of the plane z = 0 on a rigid sphere or cylinder that reaches δ above it. With N = ε d and c = radius - δ
//! the resultant is `π ε c δ²` (sphere) and `2 ε c (radius asinh(a/c) - a)` per length (cylinder, a: half width).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use contact_bench_elements as own;
use contact_elements::Registered;
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::Failure;
use crate::case::{Answer, Case, Request};
use crate::iterations::pass;
use crate::report::{Chart, Section, Series, spread};
use crate::timing::{Effort, Spread, in_turns};

/// Elements by points per direction.
const SPHERE: [(usize, &Registered); 8] = [
    (1, own::Quad4Sphere1::DESCRIPTOR),
    (2, own::Quad4Sphere2::DESCRIPTOR),
    (3, own::Quad4Sphere3::DESCRIPTOR),
    (4, own::Quad4Sphere4::DESCRIPTOR),
    (5, own::Quad4Sphere5::DESCRIPTOR),
    (6, own::Quad4Sphere6::DESCRIPTOR),
    (8, own::Quad4Sphere8::DESCRIPTOR),
    (10, own::Quad4Sphere10::DESCRIPTOR),
];
const CYLINDER: [(usize, &Registered); 8] = [
    (1, own::Quad4Cylinder1::DESCRIPTOR),
    (2, own::Quad4Cylinder2::DESCRIPTOR),
    (3, own::Quad4Cylinder3::DESCRIPTOR),
    (4, own::Quad4Cylinder4::DESCRIPTOR),
    (5, own::Quad4Cylinder5::DESCRIPTOR),
    (6, own::Quad4Cylinder6::DESCRIPTOR),
    (8, own::Quad4Cylinder8::DESCRIPTOR),
    (10, own::Quad4Cylinder10::DESCRIPTOR),
];
/// Facets per direction.
const MESHES: [usize; 3] = [1, 4, 16];
const RADIUS: f64 = 1.0;
const EPS: f64 = 1000.0;

/// A body and what of it is covered.
#[derive(Clone, Copy)]
enum Body {
    /// The edge of contact is inside the mesh.
    Sphere,
    /// The same, straight.
    Cylinder,
    /// All of the mesh is in contact.
    Covered,
}

impl Body {
    fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Cylinder => "cylinder",
            Self::Covered => "cylinder, all in contact",
        }
    }

    fn elements(self) -> &'static [(usize, &'static Registered)] {
        match self {
            Self::Sphere => &SPHERE,
            Self::Cylinder | Self::Covered => &CYLINDER,
        }
    }

    /// Half the side of the mesh, a little more than half the contact's width or much less.
    fn half(self, penetration: f64) -> f64 {
        let width = contact_half(penetration);
        match self {
            Self::Sphere | Self::Cylinder => 1.6 * width,
            Self::Covered => 0.6 * width,
        }
    }

    /// Exact resultant along z.
    fn resultant(self, penetration: f64, x: f64) -> f64 {
        let (c, half) = (RADIUS - penetration, self.half(penetration));
        let to = |a: f64| EPS * c * (RADIUS * (a / c).asinh() - a);
        match self {
            Self::Sphere => PI * EPS * c * penetration * penetration,
            Self::Cylinder => 4.0 * half * to(contact_half(penetration)),
            Self::Covered => 2.0 * half * (to(half - x) + to(half + x)),
        }
    }

    /// Parameters with the body's centre at (x, y): a cylinder along y.
    fn parameters(self, penetration: f64, x: f64, y: f64) -> Vec<f64> {
        let quaternion = match self {
            Self::Sphere => [1.0, 0.0, 0.0, 0.0],
            Self::Cylinder | Self::Covered => [FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0, 0.0],
        };
        let origin = [x, y, penetration - RADIUS];
        let first = [EPS, 0.0, 1.0, RADIUS];
        [&first[..], &origin, &quaternion].concat()
    }
}

/// Half the width of a contact.
fn contact_half(penetration: f64) -> f64 {
    (penetration * (2.0 * RADIUS - penetration)).sqrt()
}

/// One section.
///
/// # Errors
/// Where an element refuses a state.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let mut section = Section::new(
        "integration-points",
        "Integration points per facet against the error of the resultant",
        &[
            "body",
            "facets",
            "points per facet",
            "median error",
            "quartiles",
            "ns per facet",
            "quartiles of the time",
        ],
    );
    let mut lines = vec![];
    for body in [Body::Sphere, Body::Cylinder, Body::Covered] {
        let times = times(body, effort);
        for mesh in MESHES {
            let mut line = vec![];
            for (&(points, element), &time) in body.elements().iter().zip(&times) {
                let error = Spread::of(errors(body, mesh, element, effort.states)?);
                let mut row = vec![body.name().to_string(), format!("{mesh} x {mesh}")];
                row.push(format!("{points} x {points}"));
                row.push(format!("{:.1e}", error.median));
                row.push(format!("{:.1e}–{:.1e}", error.low, error.high));
                row.extend(spread(time));
                section.row(row);
                line.push((points as f64, error.median.max(1e-17)));
            }
            let name = format!("{}, {mesh} x {mesh} facets", body.name());
            lines.push(Series::line(name, line));
        }
    }
    section.note(&format!(
        "Resultant along the axis of symmetry, relative error; {} random penetrations (2 to 6 % of the radius) and places of the body each. The integrand has a kink \
         where contact ends, unless all is in contact. Time: one facet with all points in contact, R and K.",
        effort.states
    ));
    section.chart(Chart {
        name: "integration-points".into(),
        caption: "Error of the resultant against the rule (median)".into(),
        x: "Gauss points per direction and facet".into(),
        y: "relative error".into(),
        series: lines,
    });
    Ok(vec![section])
}

/// Time of one facet by rule.
fn times(body: Body, effort: &Effort) -> Vec<Spread> {
    let penetration = 0.04;
    let case = |element| {
        facet(
            element,
            body.parameters(penetration, 0.0, 0.0),
            [-0.1, -0.1],
            0.2,
        )
    };
    let cases: Vec<(String, [Case; 1])> = body
        .elements()
        .iter()
        .map(|(points, element)| (points.to_string(), [case(*element)]))
        .collect();
    let contenders = cases
        .iter()
        .map(|(name, case)| pass(name, case, Request::BOTH));
    let timing = in_turns(contenders.collect(), effort);
    cases.iter().map(|(name, _)| timing.time(name)).collect()
}

/// A square facet.
fn facet(
    descriptor: &'static Registered,
    parameters: Vec<f64>,
    corner: [f64; 2],
    side: f64,
) -> Case {
    let [x, y] = corner;
    Case {
        descriptor,
        x: vec![
            x,
            y,
            0.0,
            x + side,
            y,
            0.0,
            x + side,
            y + side,
            0.0,
            x,
            y + side,
            0.0,
        ],
        u: vec![],
        parameters,
        history: vec![],
        slave_row: vec![],
    }
}

/// Errors of the resultant over random places of the body.
fn errors(
    body: Body,
    mesh: usize,
    element: &'static Registered,
    states: u64,
) -> Result<Vec<f64>, Failure> {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let one = |_| {
        let penetration = random.random_range(0.02..0.06);
        let half = body.half(penetration);
        let side = 2.0 * half / mesh as f64;
        let (x, y) = (
            random.random_range(-0.3..0.3) * half,
            random.random_range(-0.3..0.3) * half,
        );
        let mut total = 0.0;
        for cell in 0..mesh * mesh {
            let corner = [cell % mesh, cell / mesh].map(|at| at as f64 * side - half);
            let case = facet(element, body.parameters(penetration, x, y), corner, side);
            let mut answer = Answer::of(&case);
            let outcome = case.evaluate(Request::RESIDUAL, &mut answer);
            if outcome.is_err() {
                return Err(format!("{}: {outcome:?}", case.name()).into());
            }
            total -= answer.residual.iter().skip(2).step_by(3).sum::<f64>();
        }
        Ok((total / body.resultant(penetration, x) - 1.0).abs())
    };
    (0..states).map(one).collect()
}
