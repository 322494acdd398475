//! From facet to edge to vertex: each point uses one pair, and forces are continuous where it changes. [eq:transition]

use contact_elements::{Evaluation, OUTPUT_SIZE, Registered, evaluate_patch};
use contact_library::{
    PointBezierCurve2Oriented, PointBezierSurface2, PointLine2, PointLine2In2d, PointLine2Oriented,
    PointLine3Oriented, PointPoint, PointPointOriented, PointPointOriented2d, PointQuad4,
    PointQuad9, PointRationalCurve2Oriented, PointRationalSurface2, PointTri3, PointTri6,
};

use crate::surface::{EPS, Surface, difference};

const QUADS: [Option<&Registered>; 3] = [
    Some(PointQuad4::DESCRIPTOR),
    Some(PointLine2Oriented::DESCRIPTOR),
    Some(PointPointOriented::DESCRIPTOR),
];

/// The three faces of a cube's corner at the origin, each 2 × 2; `inwards`: seen from inside, a box's corner.
fn corner(inwards: bool, r0: f64) -> Surface {
    let mut nodes = vec![];
    for z in [0.0, -2.0] {
        for y in [0.0, -2.0] {
            for x in [0.0, -2.0] {
                nodes.extend([x, y, z]);
            }
        }
    }
    // normals +x, +y, +z
    const OUT: [i32; 12] = [0, 2, 6, 4, 0, 4, 5, 1, 0, 1, 3, 2];
    const IN: [i32; 12] = [0, 4, 6, 2, 0, 1, 5, 4, 0, 2, 3, 1];
    Surface::new(QUADS, nodes, if inwards { &IN } else { &OUT }, r0)
}

/// The distance to a cube's corner {x, y, z ≤ 0}, from outside.
fn outside_cube(p: [f64; 3]) -> f64 {
    let beyond = p.map(|v: f64| v.max(0.0));
    (beyond[0].powi(2) + beyond[1].powi(2) + beyond[2].powi(2)).sqrt()
}

/// Around the corner of a cube with a rounding radius, and inside the corner of a box: gap and force are those of the
/// distance, whichever pair gives them.
#[test]
fn corners_have_the_distance_of_the_body() {
    for inwards in [false, true] {
        let r0 = if inwards { 0.0 } else { 0.5 };
        let surface = corner(inwards, r0);
        let mut features = std::collections::BTreeSet::new();
        for i in 0..343 {
            // -0.4 to 0.35 in every direction, some of it beyond each face
            let at = |k: i32| f64::from(k % 7) * 0.12 - 0.37;
            let p = [at(i), at(i / 7), at(i / 49)];
            if p.iter().all(|v| *v < 0.0) {
                continue;
            }
            let distance = outside_cube(p);
            let found = surface.at(&p);
            let sign = if inwards { -1.0 } else { 1.0 };
            let gap = sign * distance - r0;
            assert!(
                (found.gap() - gap).abs() < 1e-14,
                "{p:?}: {} {gap}",
                found.gap()
            );
            let direction = p.map(|v| v.max(0.0) / distance);
            for k in 0..3 {
                let force = EPS * gap.min(0.0) * sign * direction[k];
                let error = (found.residual[k] - force).abs();
                assert!(error < 1e-11, "{p:?}: {:?} {force}", found.residual);
            }
            assert!((found.energy - 0.5 * EPS * gap.min(0.0).powi(2)).abs() < 1e-12);
            assert_eq!(found.closed, i32::from(gap < 0.0));
            features.insert(found.feature() as i32);
        }
        assert!(features.contains(&0) && features.iter().any(|f| (1..5).contains(f)));
        assert!(features.iter().any(|f| *f >= 5), "{features:?}");
    }
}

/// Forces and moments balance, and K is the derivative of R, in every pair.
#[test]
fn tangents_are_derivatives() {
    for (inwards, r0) in [(false, 0.5), (true, 0.0)] {
        let surface = corner(inwards, r0);
        for p in [[0.2, -0.3, -0.4], [0.2, 0.1, -0.5], [0.2, 0.1, 0.15]] {
            let found = surface.at(&p);
            let x = [&p[..], &surface.nodes].concat();
            for k in 0..3 {
                let sum: f64 = found.residual.iter().skip(k).step_by(3).sum();
                assert!(sum.abs() < 1e-10, "{sum}");
            }
            let step = 1e-6;
            for j in 0..x.len() {
                let shifted = |by: f64| {
                    let mut y = x.clone();
                    y[j] += by;
                    let moved = Surface {
                        nodes: y[3..].to_vec(),
                        facets: surface.facets,
                        parameters: surface.parameters.clone(),
                    };
                    moved.at(&y[..3]).residual
                };
                let (low, high) = (shifted(-step), shifted(step));
                for i in 0..x.len() {
                    let slope = (high[i] - low[i]) / (2.0 * step);
                    let entry = found.tangent[i * x.len() + j];
                    assert!(
                        (slope - entry).abs() < 1e-5 * EPS,
                        "{p:?} {i} {j}: {slope} {entry}"
                    );
                }
            }
        }
    }
}

/// From facet to edge to vertex and on: the force is continuous.
#[test]
fn forces_go_on_where_the_pair_changes() {
    let mut worst = 0.0_f64;
    for (inwards, r0) in [(false, 0.5), (true, 0.0)] {
        let surface = corner(inwards, r0);
        for (a, b) in [
            ([-0.5, -0.4, 0.2], [0.3, -0.3, 0.05]),
            ([0.1, -0.4, 0.2], [0.15, 0.3, 0.13]),
            ([-0.3, -0.25, 0.3], [0.2, 0.3, 0.1]),
            ([-0.3, 0.2, 0.1], [0.3, -0.2, 0.12]),
        ] {
            let (jump, changes) = surface.jumps(&a, &b);
            assert!(changes >= 1, "{a:?} {b:?}");
            worst = worst.max(jump);
        }
    }
    println!("largest jump of the force, relative: {worst:.1e}");
    assert!(worst < 1e-9);
}

/// Curved facets with their own edges: biquadratic, quadratic triangles, Bezier, rational.
#[test]
fn curved_facets_have_curved_edges() {
    for (elements, connectivity, rational) in [
        (
            [PointQuad9::DESCRIPTOR, PointLine3Oriented::DESCRIPTOR],
            &[0, 2, 8, 6, 1, 5, 7, 3, 4][..],
            false,
        ),
        (
            [PointTri6::DESCRIPTOR, PointLine3Oriented::DESCRIPTOR],
            &[0, 2, 8, 1, 5, 4, 0, 8, 6, 4, 7, 3][..],
            false,
        ),
        (
            [
                PointBezierSurface2::DESCRIPTOR,
                PointBezierCurve2Oriented::DESCRIPTOR,
            ],
            &[0, 1, 2, 3, 4, 5, 6, 7, 8][..],
            false,
        ),
        (
            [
                PointRationalSurface2::DESCRIPTOR,
                PointRationalCurve2Oriented::DESCRIPTOR,
            ],
            &[0, 1, 2, 3, 4, 5, 6, 7, 8][..],
            true,
        ),
    ] {
        let mut nodes = vec![];
        for j in 0..3 {
            for i in 0..3 {
                let (x, y) = (f64::from(i) - 1.0, f64::from(j) - 1.0);
                nodes.extend([x, y, 0.2 * (1.0 - x * x) + 0.1 * x * y]);
            }
        }
        let [facet, edge] = elements.map(Some);
        let mut surface = Surface::new(
            [facet, edge, Some(PointPointOriented::DESCRIPTOR)],
            nodes,
            connectivity,
            0.6,
        );
        if rational {
            surface
                .parameters
                .extend((0..9).map(|a| 1.0 + 0.1 * f64::from(a % 4)));
        }
        // across a side, over a corner, and round the rim
        for (a, b) in [
            ([0.2, 0.1, 0.5], [1.4, 0.3, 0.1]),
            ([1.2, -0.5, 0.3], [1.3, 1.3, 0.3]),
            ([0.6, 0.7, 0.4], [1.1, 1.2, 0.2]),
        ] {
            let (jump, changes) = surface.jumps(&a, &b);
            assert!(changes >= 1, "{} {a:?}", surface.facets.facet.name);
            assert!(jump < 1e-9, "{} {a:?}: {jump:e}", surface.facets.facet.name);
        }
    }
}

/// Curves: a corner of the plane from outside and inside, and a kinked wire in space with its end.
#[test]
fn curves_end_in_points() {
    let plane = [
        Some(PointLine2In2d::DESCRIPTOR),
        None,
        Some(PointPointOriented2d::DESCRIPTOR),
    ];
    for (sign, r0) in [(1.0, 0.3), (-1.0, 0.0)] {
        // left normals: up, and to the right (outside a corner) or left (inside)
        let nodes = vec![-sign, 0.0, 0.0, 0.0, 0.0, -sign];
        let mut surface = Surface::new(plane, nodes, &[1, 0, 2, 1], r0);
        surface.parameters[2] = -sign;
        let p = [sign * 0.1, sign * 0.15];
        let distance = (0.01_f64 + 0.0225).sqrt();
        let found = surface.at(&p);
        assert!(found.feature() >= 5.0);
        assert!(
            (found.gap() - (sign * distance - r0)).abs() < 1e-15,
            "{} {sign}",
            found.gap()
        );
        for (a, b) in [([-0.3, 0.1], [0.2, 0.15]), ([0.15, 0.2], [0.1, -0.3])] {
            let (a, b) = (a.map(|v: f64| sign * v), b.map(|v: f64| sign * v));
            let (jump, changes) = surface.jumps(&a, &b);
            assert_eq!(changes, 1);
            assert!(jump < 1e-9, "{jump:e}");
        }
    }
    let wire = [
        Some(PointLine2::DESCRIPTOR),
        None,
        Some(PointPoint::DESCRIPTOR),
    ];
    let nodes = vec![-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.8, 0.3];
    let surface = Surface::new(wire, nodes, &[0, 1, 1, 2], 0.4);
    let (jump, changes) = surface.jumps(&[-0.5, -0.2, -0.1], &[0.4, -0.05, -0.05]);
    assert!(changes == 2 && jump < 1e-9, "{changes} {jump:e}");
    let (jump, changes) = surface.jumps(&[0.8, 0.5, 0.1], &[1.2, 0.9, 0.4]);
    assert!(changes == 1 && jump < 1e-9, "{changes} {jump:e}");
}

/// Inside a convex edge both facets are as near on the bisector: there the direction changes, by the angle between the
/// normals, and only there.
#[test]
fn the_bisector_of_a_convex_edge_turns_the_force() {
    let surface = corner(false, 0.0);
    let (jump, changes) = surface.jumps(&[-0.1, -0.9, -0.3], &[-0.3, -0.9, -0.1]);
    assert_eq!(changes, 1);
    // N n_1 - N n_2, and the same at the nodes: the largest entry is N
    assert!((jump - 1.0).abs() < 1e-9, "{jump}");
    // the history keeps the facet that the point was on while both are as near
    let on_bisector = [-0.2, -0.9, -0.2];
    for facet in [1.0, 3.0] {
        let kept = surface.evaluate(&on_bisector, &[1.0, facet, 0.0, 0.0, 0.0]);
        assert_eq!(kept.history[1], facet);
    }
}

/// Each point acts once: over a seam of coplanar facets the sum is that of one facet.
#[test]
fn nothing_is_counted_twice() {
    let nodes = vec![
        0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0, 0.0,
    ];
    let surface = Surface::new(QUADS, nodes, &[0, 1, 4, 3, 1, 2, 5, 4], 0.0);
    let points = [
        0.5, 0.5, -0.1, 1.0, 0.5, -0.1, 1.0, 0.25, -0.2, 1.7, 0.2, -0.1, 0.9, 0.4, 0.3,
    ];
    let found = surface.evaluate(&points, &[]);
    assert_eq!(found.closed, 4);
    let force: f64 = found.residual.iter().take(15).skip(2).step_by(3).sum();
    assert!((force + EPS * 0.5).abs() < 1e-11, "{force}");
    let all: f64 = found.residual.iter().skip(2).step_by(3).sum();
    assert!(all.abs() < 1e-11);
    let statuses: Vec<f64> = found.output.iter().step_by(OUTPUT_SIZE).copied().collect();
    assert_eq!(statuses, [1.0, 1.0, 1.0, 1.0, 0.0]);
}

/// One facet is a patch too: beyond its rim the gap is the distance, and without lower pairs the point is outside.
#[test]
fn one_facet_is_a_patch() {
    let nodes = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let mut surface = Surface::new(QUADS, nodes, &[0, 1, 2, 3], 0.3);
    let found = surface.at(&[1.1, 0.5, 0.1]);
    assert_eq!((found.status, found.feature()), (1, 2.0));
    assert!((found.gap() - (0.02_f64.sqrt() - 0.3)).abs() < 1e-15);
    surface.facets.edge = None;
    let found = surface.at(&[1.1, 0.5, 0.1]);
    assert_eq!((found.status, found.closed), (4, 0));
    assert!(found.residual.iter().all(|v| *v == 0.0));
}

/// A flat triangle and a quadrilateral have the same straight edges.
#[test]
fn triangles_share_straight_edges() {
    let elements = [
        Some(PointTri3::DESCRIPTOR),
        Some(PointLine2Oriented::DESCRIPTOR),
        Some(PointPointOriented::DESCRIPTOR),
    ];
    // a valley: two triangles that meet in the y axis
    let nodes = vec![0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.5, 1.0, 0.0, 0.5];
    let surface = Surface::new(elements, nodes, &[0, 1, 2, 1, 0, 3], 0.0);
    let found = surface.at(&[0.02, 0.1, -0.2]);
    assert!(found.feature() >= 1.0 && found.status == 1);
    assert!(
        (found.gap() + (0.02_f64.powi(2) + 0.04).sqrt()).abs() < 1e-15,
        "{}",
        found.gap()
    );
    let (jump, changes) = surface.jumps(&[-0.5, 0.1, -0.1], &[0.5, 0.1, -0.1]);
    assert!(changes == 2 && jump < 1e-9, "{changes} {jump:e}");
}

/// Positions are x + u: displacements that undo a shift of the reference leave everything as it was.
#[test]
fn displacements_count() {
    let surface = corner(false, 0.5);
    let point = [0.2, 0.1, -0.5];
    let found = surface.at(&point);
    let shift = 0.125; // exact
    let x: Vec<f64> = point
        .iter()
        .chain(&surface.nodes)
        .map(|v| v - shift)
        .collect();
    let mut residual = vec![0.0; x.len()];
    let workspace = surface.facets.sizes().workspace;
    let result = evaluate_patch(
        &surface.facets,
        &mut Evaluation {
            x: &x,
            u: &vec![shift; x.len()],
            parameters: &surface.parameters,
            residual: &mut residual,
            workspace: &mut vec![0.0; workspace],
            ..Evaluation::default()
        },
    );
    assert_eq!(result.map(|summary| summary.closed), Ok(1));
    assert!(difference(&residual, &found.residual) < 1e-14);
}
