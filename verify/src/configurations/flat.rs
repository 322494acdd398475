//! Typical geometries of size about one: curves along x, surfaces near z = 0.

use crate::oracle::geometry::Shape;

/// Nodes of a typical geometry. Two-dimensional problems take x and z.
pub fn nodes(shape: &Shape) -> Vec<[f64; 3]> {
    match shape {
        Shape::Point => vec![[0.0; 3]],
        Shape::Line2 => vec![[-1.0, 0.05, 0.0], [1.0, 0.0, 0.0]],
        Shape::Line3 => vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.05, -0.04, 0.1]],
        Shape::Hermite => {
            vec![
                [-1.0, 0.0, 0.0],
                [1.1, 0.15, 0.12],
                [1.0, 0.0, 0.0],
                [0.9, -0.12, -0.1],
            ]
        }
        Shape::BezierCurve(degree) => (0..=*degree)
            .map(|i| {
                let t = i as f64 / *degree as f64;
                [2.0 * t - 1.0, 0.1 * (5.0 * t).sin(), 0.6 * t * (1.0 - t)]
            })
            .collect(),
        Shape::Tri3 => vec![[-1.0, -1.0, 0.0], [1.8, -1.0, 0.1], [-1.0, 1.8, -0.05]],
        Shape::Tri6 => tri6(),
        Shape::Quad4 => {
            vec![
                [-1.0, -1.0, 0.05],
                [1.0, -1.0, -0.08],
                [1.0, 1.0, 0.1],
                [-1.0, 1.0, 0.0],
            ]
        }
        Shape::Quad9 => quad9(),
        Shape::BezierSurface(degree) => {
            let step = |i: usize| 2.0 * i as f64 / *degree as f64 - 1.0;
            let indices = 0..(degree + 1) * (degree + 1);
            indices
                .map(|k| {
                    let (x, y) = (step(k % (degree + 1)), step(k / (degree + 1)));
                    [
                        x,
                        y,
                        0.15 * (1.0 - x * x) + 0.1 * (y * y - 1.0) - 0.05 * x * y,
                    ]
                })
                .collect()
        }
        Shape::Declared(shape) => shape.node_template(),
    }
}

fn tri6() -> Vec<[f64; 3]> {
    let corners = [[-1.0, -1.0, 0.0], [1.8, -1.0, 0.05], [-1.0, 1.8, 0.0]];
    let middle = |a: usize, lift: f64| {
        let (p, q) = (corners[a], corners[(a + 1) % 3]);
        let [x, y, z] = [0, 1, 2].map(|c| 0.5 * (p[c] + q[c]));
        [x, y, z + lift]
    };
    let mut nodes = corners.to_vec();
    nodes.extend([middle(0, 0.08), middle(1, -0.05), middle(2, 0.1)]);
    nodes
}

fn quad9() -> Vec<[f64; 3]> {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let rest = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
    let lift = |x: f64, y: f64| 0.12 * (1.0 - x * x) - 0.07 * y * y + 0.05 * x * y;
    let all = corners.into_iter().chain(rest);
    all.map(|[x, y]| [x, y, lift(x, y)]).collect()
}
