//! Properties that shape functions and rigid geometries must have.

use num_dual::Dual64;

use super::{Interpolation, MAX_NODES, Placement, RigidDistance, RigidParametric, Shape};
use crate::configurations::Stream;

fn row(shape: &Interpolation, z: [f64; 2]) -> Vec<f64> {
    let mut out = [0.0; MAX_NODES];
    shape.row(z, &mut out);
    out[..shape.shape.nodes()].to_vec()
}

/// Shapes that interpolate, with the parameters of their nodes.
fn interpolating() -> Vec<(Shape, Vec<[f64; 2]>)> {
    let corners = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut all = corners.clone();
    all.extend([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]]);
    let triangle = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut six = triangle.clone();
    six.extend([[0.5, 0.0], [0.5, 0.5], [0.0, 0.5]]);
    vec![
        (Shape::Line2, vec![[-1.0, 0.0], [1.0, 0.0]]),
        (Shape::Line3, vec![[-1.0, 0.0], [1.0, 0.0], [0.0, 0.0]]),
        (Shape::Tri3, triangle),
        (Shape::Tri6, six),
        (Shape::Quad4, corners),
        (Shape::Quad9, all),
    ]
}

#[test]
fn lagrange_shapes_interpolate() {
    for (shape, points) in interpolating() {
        let shape = Interpolation::new(shape);
        for (a, &z) in points.iter().enumerate() {
            for (b, value) in row(&shape, z).into_iter().enumerate() {
                let expected = f64::from(u8::from(a == b));
                assert!(
                    (value - expected).abs() < 1e-15,
                    "{:?} {a} {b}",
                    shape.shape
                );
            }
        }
    }
}

#[test]
fn positions_form_a_partition_of_unity() {
    let mut stream = Stream::new(1, 1, 1);
    let mut shapes: Vec<Shape> = interpolating()
        .into_iter()
        .map(|(shape, _)| shape)
        .collect();
    shapes.extend([
        Shape::Point,
        Shape::Hermite,
        Shape::BezierSurface(2),
        Shape::BezierSurface(4),
    ]);
    shapes.extend([1, 2, 3, 4].map(Shape::BezierCurve));
    for shape in shapes {
        let weights = (0..shape.nodes())
            .map(|_| stream.uniform(0.5, 2.0))
            .collect();
        let mut variants = vec![Interpolation::new(shape.clone())];
        if !matches!(shape, Shape::Hermite) {
            variants.push(Interpolation::rational(shape.clone(), weights));
        }
        for variant in variants {
            let z = [stream.uniform(-0.5, 1.0), stream.uniform(-0.5, 1.0)];
            let values = row(&variant, z).into_iter().enumerate();
            let sum: f64 = values
                .filter(|(a, _)| shape.is_position(*a))
                .map(|(_, v)| v)
                .sum();
            assert!((sum - 1.0).abs() < 1e-14, "{shape:?}: {sum}");
        }
    }
}

#[test]
fn hermite_curves_have_the_given_ends() {
    let shape = Interpolation::new(Shape::Hermite);
    let nodes = [
        [0.1, 0.2, 0.3],
        [1.0, -2.0, 0.5],
        [3.0, 1.0, 2.0],
        [0.7, 0.6, -0.4],
    ];
    for (end, z) in [(0, -1.0), (1, 1.0)] {
        let (value, slopes) = shape.evaluate([z, 0.0], &nodes);
        for c in 0..3 {
            assert!((value[c] - nodes[2 * end][c]).abs() < 1e-15);
            assert!((slopes[0][c] - nodes[2 * end + 1][c]).abs() < 1e-15);
        }
    }
}

#[test]
fn a_rational_quadratic_is_a_circle() {
    let nodes = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let weights = vec![1.0, 0.5f64.sqrt(), 1.0];
    let arc = Interpolation::rational(Shape::BezierCurve(2), weights);
    for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
        let (p, _) = arc.evaluate([t, 0.0], &nodes);
        assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-15);
    }
}

#[test]
fn parametric_surfaces_lie_on_the_zero_level_and_point_outward() {
    let (radius, alpha, major, minor) = (1.3, 0.4, 2.0, 0.6);
    let twins = [
        (RigidParametric::Plane, RigidDistance::Plane),
        (
            RigidParametric::Cylinder { radius },
            RigidDistance::Cylinder { radius },
        ),
        (
            RigidParametric::Sphere { radius },
            RigidDistance::Sphere { radius },
        ),
        (
            RigidParametric::Cone { alpha },
            RigidDistance::Cone { alpha },
        ),
        (
            RigidParametric::Torus { major, minor },
            RigidDistance::Torus { major, minor },
        ),
    ];
    let mut stream = Stream::new(2, 2, 2);
    for (surface, body) in twins {
        for _ in 0..20 {
            let window = surface.window();
            let z = [0, 1].map(|i| stream.uniform(window[i][0], window[i][1]));
            let (p, [t1, t2]) = surface.evaluate(z);
            assert!(body.distance(p).abs() < 1e-14, "{surface:?}");
            let n = crate::oracle::vector::unit(crate::oracle::vector::cross(t1, t2));
            let moving = [0, 1, 2].map(|c| Dual64::new(p[c], n[c]));
            assert!(
                (body.distance(moving).eps - 1.0).abs() < 1e-13,
                "{surface:?}"
            );
        }
    }
}

#[test]
fn placements_turn_by_the_normalised_rotation() {
    let half = std::f64::consts::FRAC_PI_6;
    let quaternion = [3.0 * half.cos(), 0.0, 0.0, 3.0 * half.sin()];
    let spatial = Placement::Spatial {
        origin: [1.0, 2.0, 3.0],
        quaternion,
    };
    let direction = [2.5 * (2.0 * half).cos(), 2.5 * (2.0 * half).sin()];
    let planar = Placement::Planar {
        origin: [1.0, 2.0],
        direction,
    };
    let (one, other) = (spatial.rotation(), planar.rotation());
    for i in 0..3 {
        for j in 0..3 {
            assert!((one[i][j] - other[i][j]).abs() < 1e-15);
        }
    }
    // 60 degrees about z: the x axis goes to (cos 60, sin 60)
    assert!((one[0][0] - 0.5).abs() < 1e-15 && (one[1][0] - 0.75f64.sqrt()).abs() < 1e-15);
    assert!(
        Placement::Planar {
            origin: [0.0; 2],
            direction: [0.0; 2]
        }
        .defect()
        .is_some()
    );
}
