//! Moments about two curves: R = M_c δφ_c and its tangent in closed form. [eq:rolling-residual]
//! [eq:rolling-tangent]
//!
//! With σ = (1, −1) for slave and master, u = r_,c and w = r_,cc (or σ_c times the director), φ_c = σ_c ψ_c,
//! ψ the angle about u from w to −r. Either vector v = r, w has its own triad: τ = u/|u|, f = v_⊥/h, g = τ×f
//! with h = |v_⊥|, c = v·τ, and the forms of its total variation relative to that of u
//!
//! ```text
//! X_a = a·(Dv − (c/|u|) Du)/h ,   U_a = a·Du/|u| ,   a = f, g, τ
//! Dψ  = X_g(r) − X_g(w)
//! D²ψ = H(w) − H(r) + p_r·D²r + p_u·D²u + p_w·D²w ,   H = X_f⊙X_g + X_τ⊙U_g + ½ U_f⊙U_g
//! ```
//!
//! A⊙B = A⊗B + B⊗A; p_r, p_u, p_w are the derivatives of ψ. The factor of D²ζ joins the tangential force.

use super::Kinematics;
use super::curves::{Pair, SIGNS, references, signed, triad};
use super::motion::Motion;
use crate::ir::{Binary, Graph, NodeId, Program, Vector};
use crate::model::Reference;

/// What is known of the two curves when the code is made.
#[derive(Clone, Copy, Debug)]
pub struct Curves {
    /// The directions from which the angles are measured.
    pub reference: Reference,
    /// Whether r_,111 and r_,222 can be non-zero.
    pub third: [bool; 2],
}

pub(super) const NOT_TURNED: &str = "the reference direction does not move with the curve";
pub(super) const NO_CURVATURE: &str = "no curve has a second derivative";
pub(super) const NO_THIRD: &str = "no curve has a third derivative";
pub(super) const OWN: &str = "the reference is the second derivative itself";

/// n, b_i, r_,ii or directors → φ_c [rad]; |w_⊥|²/|w|² and |w_⊥|/|u|, which tell how well the reference is
/// known. [eq:rolling-angle]
pub fn angle_program(reference: Reference) -> Program {
    let mut program = Program::new("rolling_angle");
    let n = program.input_vector("n", 3);
    let tangents = [0, 1].map(|c| program.input_vector(&format!("b_{c}"), 3));
    let references = references(&mut program, reference);
    let graph = &mut program.graph;
    let mut outputs = Vec::new();
    for c in 0..2 {
        let (u, w) = (&tangents[c], &references[c]);
        let [(tau, inverse), (binormal, area)] = triad(graph, u, w);
        let normal = binormal.cross(graph, &tau);
        let (sine, cosine) = (n.dot(graph, &binormal), n.dot(graph, &normal));
        // σ atan2(−n·g, −n·f)
        let sign = graph.constant(-SIGNS[c]);
        let sine = graph.multiply(sign, sine);
        let cosine = graph.negate(cosine);
        let angle = graph.binary(Binary::Atan2, sine, cosine);
        let width = graph.multiply(area, inverse);
        let square = graph.multiply(width, width);
        let whole = w.dot(graph, w);
        let share = graph.divide(square, whole);
        let bend = graph.multiply(width, inverse);
        outputs.push([("angle", angle), ("share", share), ("bend", bend)]);
    }
    for which in 0..3 {
        for (c, values) in outputs.iter().enumerate() {
            let (name, value) = values[which];
            program.output(format!("{name}_{c}"), value);
        }
    }
    program
}

/// The contact point and M_c → share of the moments in the factor of δζ̂^q, E^i_q M_c φ_c,i, and the explicit
/// part of M_c δφ_c: vectors of s_A, s_A,i, s_A,ii. [eq:rolling-residual] [eq:rolling-share]
pub fn residual_program(kinematics: &Kinematics, curves: Curves) -> Program {
    let mut program = Program::new("rolling_residual");
    let pair = Pair::new(&mut program, kinematics, curves);
    let moments = program.input_vector("moment", 2).0;
    let moments = signed(&mut program.graph, &moments);
    let mut form = Motion::zero(&mut program.graph);
    explicit(&mut program, &pair, &moments, &mut form);
    let along = share(&mut program, &pair, &moments);
    for q in 0..2 {
        let graph = &mut program.graph;
        let mut sum = graph.constant(0.0);
        for (i, &value) in along.iter().enumerate() {
            let part = graph.multiply(pair.contact.frame[i][q], value);
            sum = graph.add(sum, part);
        }
        program.output(format!("share_{q}"), sum);
    }
    form.output(&mut program, "explicit");
    program.settle_terms();
    program
}

/// M̂_c (p_r·δr + p_u·δr_,c + p_w·δr_,cc) [eq:rolling-arm] [eq:rolling-axis] [eq:rolling-bend]
fn explicit(program: &mut Program, pair: &Pair, moments: &[NodeId], form: &mut Motion) {
    let arm = program.terms("rolling-arm", moments, "");
    let axis = program.terms("rolling-axis", moments, "");
    let bend = program.terms("rolling-bend", moments, NOT_TURNED);
    let graph = &mut program.graph;
    for (c, curve) in pair.curves.iter().enumerate() {
        let position = curve.by_position.scale(graph, arm[c]);
        form.position = form.position.add(graph, &position);
        form.turning[c] = curve.by_tangent.scale(graph, axis[c]);
        if pair.frenet {
            form.bending[c] = curve.by_reference.scale(graph, bend[c]);
        }
    }
}

/// M̂_c ψ_c,i = M̂_c p_r·r_,i + M̂_i (p_u·r_,ii + p_w·r_,iii) [eq:rolling-share]
fn share(program: &mut Program, pair: &Pair, moments: &[NodeId]) -> Vec<NodeId> {
    let arm = program.terms("rolling-arm-share", moments, "");
    let axis = program.terms(
        "rolling-axis-share",
        moments,
        if pair.frenet { OWN } else { NO_CURVATURE },
    );
    let bend = program.terms(
        "rolling-bend-share",
        moments,
        if pair.frenet { NO_THIRD } else { NOT_TURNED },
    );
    let graph = &mut program.graph;
    (0..2)
        .map(|i| {
            let mut sum = graph.constant(0.0);
            let mut add = |graph: &mut Graph, factor, first: &Vector, last: &Vector| {
                let product = first.dot(graph, last);
                let product = graph.multiply(factor, product);
                sum = graph.add(sum, product);
            };
            // its own tangent stands across: p_r·r_,c = 0
            let other = 1 - i;
            let by_position = &pair.curves[other].by_position;
            add(graph, arm[other], by_position, &pair.tangents[i]);
            let curve = &pair.curves[i];
            if pair.frenet {
                add(graph, bend[i], &curve.by_reference, &pair.third[i]);
            } else {
                add(graph, axis[i], &curve.by_tangent, &pair.second[i]);
            }
            sum
        })
        .collect()
}
