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

use super::basis::{Symmetric, contravariant, orthogonal, sheared, upper, upper_index};
use super::{Kinematics, pair_index, second_derivatives};
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Linearisation;

/// Quantities at the projection that the terms share.
struct Projection {
    n: Vector,
    distance: NodeId,
    /// Orthogonal tangents b_1 and b_2 − t b_1 [eq:orthogonal-basis].
    b: Vec<Vector>,
    /// t = a_12/a_11; zero for one tangent.
    shear: NodeId,
    /// Diagonal of the metric in that basis. [eq:metric]
    metric: Vec<NodeId>,
    /// κ_ij = −n·r_,ij in that basis
    curvature: Symmetric,
    /// m = F⁻¹ (exact) or a⁻¹ (tangent plane) in that basis
    m: Symmetric,
    traction: NodeId,
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

    let graph = &mut program.graph;
    let curvature = curvature_tensor(graph, &n, &second, &kinematics.curved);
    let (b, shear) = orthogonal(graph, b);
    let metric: Vec<NodeId> = b.iter().map(|b_i| b_i.dot(graph, b_i)).collect();
    let curvature = sheared(graph, curvature, shear);
    let m = match kinematics.linearisation {
        Linearisation::Exact => {
            let factor = program.term("F-curvature", distance, "no curvature along the projection");
            inverse_of_f(&mut program.graph, &metric, &curvature, factor)
        }
        Linearisation::TangentPlane => {
            program.left_out("F-curvature", "linearised on the tangent plane L = 0");
            let zero = program.graph.constant(0.0);
            inverse_of_f(&mut program.graph, &metric, &curvature, zero)
        }
    };
    let projection = Projection {
        n,
        distance,
        b,
        shear,
        metric,
        curvature,
        m,
        traction,
    };
    (projection, slope)
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

/// m = F⁻¹ with F = a − Lκ [eq:F]; a is diagonal, so det F loses nothing to cancellation of a.
fn inverse_of_f(
    graph: &mut Graph,
    metric: &[NodeId],
    curvature: &Symmetric,
    distance: NodeId,
) -> Symmetric {
    let one = graph.constant(1.0);
    let bent = |graph: &mut Graph, i: usize| {
        let bend = graph.multiply(distance, curvature.at(i, i));
        graph.subtract(metric[i], bend)
    };
    match metric.len() {
        0 => Symmetric(vec![]),
        1 => {
            let f = bent(graph, 0);
            Symmetric(vec![graph.divide(one, f)])
        }
        _ => {
            let (f11, f22) = (bent(graph, 0), bent(graph, 1));
            let off = graph.multiply(distance, curvature.at(0, 1));
            let product = graph.multiply(f11, f22);
            let square = graph.multiply(off, off);
            let determinant = graph.subtract(product, square);
            // F_12 = −L κ_12, so m^12 = L κ_12/det F
            Symmetric(vec![
                graph.divide(f22, determinant),
                graph.divide(off, determinant),
                graph.divide(f11, determinant),
            ])
        }
    }
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
    let mut tensor = vec![vec![graph.constant(0.0); p]; p];
    for i in 0..p {
        let weight = graph.divide(coefficient, projection.metric[i]);
        for j in i..p {
            let mut sum = graph.constant(0.0);
            for k in 0..p {
                let bend = graph.multiply(projection.curvature.at(i, k), projection.m.at(k, j));
                sum = graph.add(sum, bend);
            }
            tensor[i][j] = graph.multiply(weight, sum);
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

/// (N/L) Σ_c c⊗c with Σ_c c⊗c = I − n⊗n − b_i a^ij b_j [eq:complement]; zero in codimension one.
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
    let one = graph.constant(1.0);
    let mut tensor = vec![vec![graph.constant(0.0); p]; p];
    for i in 0..p {
        tensor[i][i] = graph.divide(one, projection.metric[i]);
    }
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
    let p = projection.b.len();
    let mut vectors: Vec<Vector> = (0..p)
        .map(|j| {
            let mut sum = Vector::zero(graph, d);
            for (i, b_i) in projection.b.iter().enumerate() {
                let factor = graph.multiply(coefficient, projection.m.at(i, j));
                let part = b_i.scale(graph, factor);
                sum = sum.add(graph, &part);
            }
            sum
        })
        .collect();
    if p == 2 {
        // s_,2 of the orthogonal basis is s_,2 − t s_,1
        let minus = graph.negate(projection.shear);
        let back = vectors[1].scale(graph, minus);
        vectors[0] = vectors[0].add(graph, &back);
    }
    for (vector, &moving) in vectors.iter_mut().zip(&kinematics.moving) {
        if !moving {
            *vector = Vector::zero(graph, d);
        }
    }
    vectors
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
    let entries: Vec<NodeId> = projection
        .m
        .0
        .iter()
        .map(|&m| graph.multiply(coefficient, m))
        .collect();
    let mut result = contravariant(graph, Symmetric(entries), projection.shear);
    for i in 0..p {
        for j in i..p {
            if !(kinematics.moving[i] && kinematics.moving[j]) {
                result.0[pair_index(i, j)] = zero;
            }
        }
    }
    result
}
