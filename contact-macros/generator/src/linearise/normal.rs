//! Tangent of normal contact: K = N' (n·δr)(n·Δr) + N D²g in covariant closed form. [eq:tangent]
//!
//! With α_i = b_i·δr and β_i = n·δr_,i
//!
//! ```text
//! D²g = −[ α (a⁻¹κm) α + α m β + β m α + L β m β ] + (1/L) Σ_c (c·δr)(c·Δr) ,   m = (a − Lκ)⁻¹
//! ```
//!
//! The program gives the coefficients that the contraction with shape rows needs: `p` multiplies
//! s_A s_B, `right_j` s_A s_B,j (with n on the right), `left_j` s_A,j s_B (with n on the left) and
//! `s` the product s_A,i s_B,j n⊗n.

use super::{Kinematics, pair_index, second_derivatives};
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Linearisation;

/// Quantities at the projection that the terms share.
struct Projection {
    n: Vector,
    distance: NodeId,
    b: Vec<Vector>,
    /// a_ij
    metric: Symmetric,
    /// det a
    metric_determinant: NodeId,
    /// κ_ij = −n·r_,ij
    curvature: Symmetric,
    /// m = F⁻¹ (exact) or a⁻¹ (tangent plane)
    m: Symmetric,
    traction: NodeId,
}

/// A symmetric matrix of the projected parameters, entries 11, 12, 22.
struct Symmetric(Vec<NodeId>);

impl Symmetric {
    fn at(&self, i: usize, j: usize) -> NodeId {
        self.0[pair_index(i, j)]
    }
}

/// n, L, b_i, r_,ij, N, N' → p, right, left, s.
pub fn tangent_program(kinematics: &Kinematics) -> Program {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let mut program = Program::new("tangent");
    let (projection, slope) = inputs(&mut program, kinematics);

    let mut position = main(&mut program, &projection, slope);
    let curvature = curvature(&mut program, &projection);
    let complement = complement(&mut program, &projection, kinematics);
    for (sum, (c, e)) in position.iter_mut().zip(curvature.iter().zip(&complement)) {
        *sum = program.graph.add(*sum, *c);
        *sum = program.graph.add(*sum, *e);
    }
    let right = rotational(&mut program, &projection, kinematics, "13-rotational-right");
    let left = rotational(&mut program, &projection, kinematics, "13-rotational-left");
    let rotation = quadratic_rotation(&mut program, &projection, kinematics);

    for k in 0..d {
        for l in 0..d {
            program.output(format!("p_{k}_{l}"), position[upper_index(d, k, l)]);
        }
    }
    for (name, vectors) in [("right", &right), ("left", &left)] {
        for (j, vector) in vectors.iter().enumerate() {
            program.output_vector(&format!("{name}_{j}"), vector);
        }
    }
    for i in 0..p {
        for j in 0..p {
            program.output(format!("s_{i}_{j}"), rotation.at(i, j));
        }
    }
    program.settle_terms();
    program
}

fn inputs(program: &mut Program, kinematics: &Kinematics) -> (Projection, NodeId) {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let n = program.input_vector("n", d);
    let distance = program.input("distance");
    let b: Vec<Vector> = (0..p)
        .map(|i| program.input_vector(&format!("b_{i}"), d))
        .collect();
    let second: Vec<Vector> = (0..second_derivatives(p))
        .map(|h| program.input_vector(&format!("r_{h}"), d))
        .collect();
    let traction = program.input("traction");
    let slope = program.input("slope");

    let metric = metric(&mut program.graph, &b);
    let metric_determinant = metric_determinant(&mut program.graph, &b, &metric);
    let curvature = curvature_tensor(&mut program.graph, &n, &second, &kinematics.curved);
    let m = match kinematics.linearisation {
        Linearisation::Exact => {
            let factor = program.term("F-curvature", distance, "no curvature along the projection");
            inverse_of_f(
                &mut program.graph,
                p,
                (&metric, metric_determinant),
                &curvature,
                factor,
            )
        }
        Linearisation::TangentPlane => {
            program.left_out("F-curvature", "linearised on the tangent plane L = 0");
            inverse(&mut program.graph, p, &metric, metric_determinant)
        }
    };
    let projection = Projection {
        n,
        distance,
        b,
        metric,
        metric_determinant,
        curvature,
        m,
        traction,
    };
    (projection, slope)
}

/// a_ij = b_i·b_j [eq:metric]
fn metric(graph: &mut Graph, b: &[Vector]) -> Symmetric {
    let mut entries = Vec::new();
    for i in 0..b.len() {
        for j in i..b.len() {
            entries.push(b[i].dot(graph, &b[j]));
        }
    }
    Symmetric(entries)
}

/// det a; for two tangents |b_1×b_2|², which keeps its digits where they are nearly parallel.
fn metric_determinant(graph: &mut Graph, b: &[Vector], metric: &Symmetric) -> NodeId {
    match b {
        [] => graph.constant(1.0),
        [_] => metric.at(0, 0),
        [first, second] => {
            let area = first.cross(graph, second);
            area.dot(graph, &area)
        }
        _ => unreachable!("at most two projected parameters"),
    }
}

/// κ_ij = −n·r_,ij [eq:curvature]; entries that vanish identically stay zero.
fn curvature_tensor(
    graph: &mut Graph,
    n: &Vector,
    second: &[Vector],
    curved: &[bool],
) -> Symmetric {
    let entries = second
        .iter()
        .zip(curved)
        .map(|(r_ij, &curved)| {
            if curved {
                let along = n.dot(graph, r_ij);
                graph.negate(along)
            } else {
                graph.constant(0.0)
            }
        })
        .collect();
    Symmetric(entries)
}

/// m = F⁻¹ with F = a − Lκ [eq:F]; det F = det a − L(κ11 a22 + κ22 a11 − 2 κ12 a12) + L² det κ
/// [eq:det-F]; the part −Lκ is a term of its own [eq:F-curvature].
fn inverse_of_f(
    graph: &mut Graph,
    p: usize,
    (metric, metric_determinant): (&Symmetric, NodeId),
    curvature: &Symmetric,
    distance: NodeId,
) -> Symmetric {
    let f = Symmetric(
        metric
            .0
            .iter()
            .zip(&curvature.0)
            .map(|(&a, &kappa)| {
                let bend = graph.multiply(distance, kappa);
                graph.subtract(a, bend)
            })
            .collect(),
    );
    if p < 2 {
        let determinant = f.0.first().copied().unwrap_or(metric_determinant);
        return inverse(graph, p, &f, determinant);
    }
    let first = graph.multiply(curvature.at(0, 0), metric.at(1, 1));
    let second = graph.multiply(curvature.at(1, 1), metric.at(0, 0));
    let mixed = graph.multiply(curvature.at(0, 1), metric.at(0, 1));
    let sum = graph.add(first, second);
    let twice = graph.add(mixed, mixed);
    let trace = graph.subtract(sum, twice);
    let product = graph.multiply(curvature.at(0, 0), curvature.at(1, 1));
    let square = graph.multiply(curvature.at(0, 1), curvature.at(0, 1));
    let gauss = graph.subtract(product, square);
    let quadratic = graph.multiply(distance, gauss);
    let change = graph.subtract(trace, quadratic);
    let change = graph.multiply(distance, change);
    let determinant = graph.subtract(metric_determinant, change);
    inverse(graph, p, &f, determinant)
}

/// Inverse of a symmetric matrix of order 0, 1 or 2 whose determinant is known.
fn inverse(graph: &mut Graph, p: usize, matrix: &Symmetric, determinant: NodeId) -> Symmetric {
    let one = graph.constant(1.0);
    let reciprocal = graph.divide(one, determinant);
    Symmetric(match p {
        0 => vec![],
        1 => vec![reciprocal],
        _ => {
            let off = graph.multiply(matrix.at(0, 1), reciprocal);
            vec![
                graph.multiply(matrix.at(1, 1), reciprocal),
                graph.negate(off),
                graph.multiply(matrix.at(0, 0), reciprocal),
            ]
        }
    })
}

/// N' (n·δr)(n·Δr) [eq:12-main]
fn main(program: &mut Program, projection: &Projection, slope: NodeId) -> Vec<NodeId> {
    let coefficient = program.term("12-main", slope, "");
    let graph = &mut program.graph;
    upper(projection.n.0.len())
        .map(|(k, l)| {
            let product = graph.multiply(projection.n.0[k], projection.n.0[l]);
            graph.multiply(coefficient, product)
        })
        .collect()
}

/// −N α_i (a⁻¹κm)^ij α_j [eq:13-curvature]
fn curvature(program: &mut Program, projection: &Projection) -> Vec<NodeId> {
    let p = projection.b.len();
    let minus = program.graph.negate(projection.traction);
    let coefficient = program.term("13-curvature", minus, "no curvature along the projection");
    let graph = &mut program.graph;
    let metric_inverse = inverse(graph, p, &projection.metric, projection.metric_determinant);
    let mut tensor = vec![vec![graph.constant(0.0); p]; p];
    for i in 0..p {
        for j in i..p {
            let mut sum = graph.constant(0.0);
            for k in 0..p {
                for l in 0..p {
                    let bend = graph.multiply(projection.curvature.at(k, l), projection.m.at(l, j));
                    let entry = graph.multiply(metric_inverse.at(i, k), bend);
                    sum = graph.add(sum, entry);
                }
            }
            tensor[i][j] = graph.multiply(coefficient, sum);
            tensor[j][i] = tensor[i][j];
        }
    }
    sandwich(graph, &projection.b, &tensor, projection.n.0.len())
}

/// Σ_ij b_i[k] t_ij b_j[l] for k ≤ l.
fn sandwich(graph: &mut Graph, b: &[Vector], tensor: &[Vec<NodeId>], d: usize) -> Vec<NodeId> {
    let mixed: Vec<Vector> = (0..b.len())
        .map(|i| {
            let mut sum = Vector::zero(graph, d);
            for (j, b_j) in b.iter().enumerate() {
                let part = b_j.scale(graph, tensor[i][j]);
                sum = sum.add(graph, &part);
            }
            sum
        })
        .collect();
    upper(d)
        .map(|(k, l)| {
            let mut sum = graph.constant(0.0);
            for (b_i, t_i) in b.iter().zip(&mixed) {
                let product = graph.multiply(b_i.0[k], t_i.0[l]);
                sum = graph.add(sum, product);
            }
            sum
        })
        .collect()
}

/// (N/L) Σ_c c⊗c with Σ_c c⊗c = I − n⊗n − b_i a^ij b_j [eq:complement]; none in codimension one.
fn complement(
    program: &mut Program,
    projection: &Projection,
    kinematics: &Kinematics,
) -> Vec<NodeId> {
    let d = kinematics.dimension;
    if kinematics.complement() == 0 {
        program.left_out("complement", "codimension one: no direction is left over");
        let zero = program.graph.constant(0.0);
        return vec![zero; d * (d + 1) / 2];
    }
    let graph = &mut program.graph;
    let ratio = graph.divide(projection.traction, projection.distance);
    let coefficient = program.term("complement", ratio, "");
    let graph = &mut program.graph;
    let p = projection.b.len();
    let a = inverse(graph, p, &projection.metric, projection.metric_determinant);
    let tensor: Vec<Vec<NodeId>> = (0..p)
        .map(|i| (0..p).map(|j| a.at(i, j)).collect())
        .collect();
    let tangential = sandwich(graph, &projection.b, &tensor, d);
    upper(d)
        .zip(tangential)
        .map(|((k, l), tangential)| {
            let identity = graph.constant(if k == l { 1.0 } else { 0.0 });
            let normal = graph.multiply(projection.n.0[k], projection.n.0[l]);
            let rest = graph.subtract(identity, normal);
            let rest = graph.subtract(rest, tangential);
            graph.multiply(coefficient, rest)
        })
        .collect()
}

/// −N α_i m^ij β_j (right) or −N β_i m^ij α_j (left) [eq:13-rotational-right] [eq:13-rotational-left]:
/// one vector −N m^ij b_i for each moving parameter j.
fn rotational(
    program: &mut Program,
    projection: &Projection,
    kinematics: &Kinematics,
    tag: &'static str,
) -> Vec<Vector> {
    let minus = program.graph.negate(projection.traction);
    let coefficient = program.term(tag, minus, "the tangents do not rotate with any unknown");
    let graph = &mut program.graph;
    let d = kinematics.dimension;
    (0..projection.b.len())
        .map(|j| {
            let mut sum = Vector::zero(graph, d);
            if kinematics.moving[j] {
                for (i, b_i) in projection.b.iter().enumerate() {
                    let factor = graph.multiply(coefficient, projection.m.at(i, j));
                    let part = b_i.scale(graph, factor);
                    sum = sum.add(graph, &part);
                }
            }
            sum
        })
        .collect()
}

/// −N L β_i m^ij β_j [eq:quadratic-rotation]: absent on the tangent plane.
fn quadratic_rotation(
    program: &mut Program,
    projection: &Projection,
    kinematics: &Kinematics,
) -> Symmetric {
    let p = projection.b.len();
    let zero = program.graph.constant(0.0);
    if kinematics.linearisation == Linearisation::TangentPlane {
        program.left_out(
            "quadratic-rotation",
            "linearised on the tangent plane L = 0",
        );
        return Symmetric(vec![zero; second_derivatives(p)]);
    }
    let graph = &mut program.graph;
    let product = graph.multiply(projection.traction, projection.distance);
    let minus = graph.negate(product);
    let coefficient = program.term(
        "quadratic-rotation",
        minus,
        "the tangents do not rotate with any unknown",
    );
    let graph = &mut program.graph;
    let mut entries = Vec::new();
    for i in 0..p {
        for j in i..p {
            entries.push(if kinematics.moving[i] && kinematics.moving[j] {
                graph.multiply(coefficient, projection.m.at(i, j))
            } else {
                zero
            });
        }
    }
    Symmetric(entries)
}

/// Index pairs k ≤ l of a symmetric matrix.
fn upper(d: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..d).flat_map(move |k| (k..d).map(move |l| (k, l)))
}

/// Position of (k, l) in the order of [`upper`].
pub(super) fn upper_index(d: usize, k: usize, l: usize) -> usize {
    let (k, l) = (k.min(l), k.max(l));
    k * d - k * (k + 1) / 2 + l
}
