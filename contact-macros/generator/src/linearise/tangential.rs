//! Tangential contact: R = t_q δζ̂^q and its tangent in covariant closed form. [eq:tangential-residual]
//! [eq:tangential-tangent]
//!
//! In the orthonormal frame e_q = E^i_q b_i of the contact point, with m = (1 − Lκ)⁻¹, τ = m t:
//!
//! ```text
//! Z_q = δζ̂^q = −m_qr (e_r·δr + L n·δr_,r)
//! P_k = τ_i Q_ik ,   Q_ik = r_,ik·δr + e_i·δr_,k + e_k·δr_,i + L n·δr_,ik
//! G_q = C_qr (Z_r + M_rk s_k) + t_r M_rq + h_q Δp − P_q − τ_i Y_iqj Z_j
//! K   = Z_q ⊗ G_q − P_q ⊗ Z_q − τ_i (δr·Δr_,i + δr_,i·Δr)
//! ```
//!
//! M_qr e_r is the change of the axis e_q relative to the convected frame; its symmetric part is Δa/2.

use super::contact::{Contact, Sliding, combination, pairs};
use super::row::Form;
use super::{Kinematics, pair_index};
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Axis;

/// n, L, b_i, r_,ij, E, t_q → coefficients of s_A and of s_A,i n in the tangential residual:
/// R = t_q Z_q = −τ_q e_q·δr − L τ_q n·δr_,q. [eq:tangential-residual]
pub fn residual_program(kinematics: &Kinematics) -> Program {
    let mut program = Program::new("tangential_residual");
    let contact = Contact::new(&mut program, kinematics);
    let t = program.input_vector("t", contact.p).0;
    let direct = program.terms("tangential-direct", &t, "");
    let rotation = program.terms(
        "tangential-rotation",
        &t,
        "the tangents do not rotate with any unknown, or linearised on the tangent plane L = 0",
    );
    let graph = &mut program.graph;
    let minus = contact.raised(graph, &direct);
    let minus: Vec<NodeId> = minus.iter().map(|&t| graph.negate(t)).collect();
    let mut form = Form::zero(graph, contact.d, contact.p);
    form.position = combination(
        graph,
        contact.d,
        &|q| (minus[q], contact.e[q].clone()),
        contact.p,
    );
    let turning = contact.raised(graph, &rotation);
    let mut along = Vec::new();
    for i in 0..contact.p {
        let mut sum = graph.constant(0.0);
        for (q, &tau) in turning.iter().enumerate() {
            let part = graph.multiply(contact.frame[i][q], tau);
            sum = graph.add(sum, part);
        }
        let back = graph.multiply(contact.distance, sum);
        let back = graph.negate(back);
        let zero = graph.constant(0.0);
        along.push(if kinematics.moving[i] { back } else { zero });
    }
    program.output_vector("force", &form.position);
    for (i, value) in along.into_iter().enumerate() {
        program.output(format!("turn_{i}"), value);
    }
    program.settle_terms();
    program
}

/// n, L, b_i, r_,ij, E, r_,ijk, s, t, C, h, N' → forms Z, P, G and τ; `rolls`: what multiplies δζ̂ comes too,
/// t with the share of the moments [eq:rolling-share].
pub fn tangent_program(kinematics: &Kinematics, axis: Option<Axis>, rolls: bool) -> Program {
    let mut program = Program::new("tangential_tangent");
    let contact = Contact::new(&mut program, kinematics);
    let sliding = Sliding::new(&mut program, &contact, axis, rolls);
    let z = projection(&mut program.graph, &contact);
    let strain = metric(&mut program.graph, &contact, &z);
    let axes = axes(&mut program, &contact, &sliding, &z, &strain, axis);
    let second = second_variation(&mut program, &contact, &sliding);
    let mut g = elastic(&mut program, &contact, &sliding, &z, &axes);
    pressure(&mut program, &contact, &sliding, &mut g);
    let minus = program.graph.constant(-1.0);
    for (g, p) in g.iter_mut().zip(&second) {
        g.add_scaled(&mut program.graph, minus, p);
    }
    hessian(&mut program, &contact, &sliding, &z, &mut g);
    let cross = cross(&mut program, &contact, &sliding);
    outputs(
        &mut program,
        kinematics,
        &contact,
        [&z, &second, &g],
        &cross,
    );
    program.settle_terms();
    program
}

/// Z_q = −m_qr (e_r·δr + L n·δr_,r) [eq:variation]
pub(super) fn projection(graph: &mut Graph, contact: &Contact) -> Vec<Form> {
    let (d, p) = (contact.d, contact.p);
    (0..p)
        .map(|q| {
            let mut form = Form::zero(graph, d, p);
            for r in 0..p {
                let minus = graph.negate(contact.m[pair_index(q, r)]);
                let along = contact.e[r].scale(graph, minus);
                form.add_position(graph, &along);
                let turn = graph.multiply(minus, contact.distance);
                let turn = contact.n.scale(graph, turn);
                form.add_turning(graph, r, &turn);
            }
            form
        })
        .collect()
}

/// Δa_qr = e_r·Δr_,q + e_q·Δr_,r + (r_,qk·e_r + r_,rk·e_q) Z_k [eq:metric-change], entries 11, 12, 22.
fn metric(graph: &mut Graph, contact: &Contact, z: &[Form]) -> Vec<Form> {
    let (d, p) = (contact.d, contact.p);
    let mut forms = Vec::new();
    for (q, r) in pairs(p) {
        let mut form = Form::zero(graph, d, p);
        form.add_turning(graph, q, &contact.e[r]);
        form.add_turning(graph, r, &contact.e[q]);
        for (k, z) in z.iter().enumerate() {
            let first = contact.second[pair_index(q, k)].dot(graph, &contact.e[r]);
            let last = contact.second[pair_index(r, k)].dot(graph, &contact.e[q]);
            let factor = graph.add(first, last);
            form.add_scaled(graph, factor, z);
        }
        forms.push(form);
    }
    forms
}

/// M_qr: Δa/2 where the law has no axes; convected axes M_12 = Δa_12, M_21 = 0; along the slave curve
/// M_12 = e_2·Δd/(d·e_1), M_21 = Δa_12 − M_12. [eq:axes]
fn axes(
    program: &mut Program,
    contact: &Contact,
    sliding: &Sliding,
    z: &[Form],
    strain: &[Form],
    axis: Option<Axis>,
) -> Vec<Vec<Form>> {
    let (d, p) = (contact.d, contact.p);
    let graph = &mut program.graph;
    let half = graph.constant(0.5);
    let zero = Form::zero(graph, d, p);
    let halved = |graph: &mut Graph, form: &Form| {
        let mut result = zero.clone();
        result.add_scaled(graph, half, form);
        result
    };
    if p == 1 {
        return vec![vec![halved(graph, &strain[0])]];
    }
    let (first, last) = (halved(graph, &strain[0]), halved(graph, &strain[2]));
    let (right, left) = match (axis, &sliding.slave_tangent) {
        (Some(Axis::Convected), _) => (strain[1].clone(), zero.clone()),
        (Some(Axis::Slave), Some(tangent)) => {
            let right = slave_turn(program, contact, tangent, z);
            let minus = program.graph.constant(-1.0);
            let mut left = strain[1].clone();
            left.add_scaled(&mut program.graph, minus, &right);
            (right, left)
        }
        _ => {
            let mixed = halved(graph, &strain[1]);
            (mixed.clone(), mixed)
        }
    };
    vec![vec![first, right], vec![left, last]]
}

/// (e_2·Δd + d·Δb_2)/(d·e_1) with the slave's tangent d and Δb_2 = Δr_,2 + r_,2k Z_k. [eq:axes]
fn slave_turn(program: &mut Program, contact: &Contact, tangent: &Vector, z: &[Form]) -> Form {
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    let along = tangent.dot(graph, &contact.e[0]);
    let inverse = graph.divide(one, along);
    let inverse = program.term("axis-turn", inverse, "");
    let graph = &mut program.graph;
    let mut form = Form::zero(graph, contact.d, contact.p);
    form.slave = contact.e[1].scale(graph, inverse);
    let turned = tangent.scale(graph, inverse);
    form.add_turning(graph, 1, &turned);
    for (k, z) in z.iter().enumerate() {
        let factor = turned.dot(graph, &contact.second[pair_index(1, k)]);
        form.add_scaled(graph, factor, z);
    }
    form
}

/// C_qr (Z_r + M_rk s_k) + t_r M_rq [eq:slip-change] [eq:slip-metric] [eq:traction-metric]
fn elastic(
    program: &mut Program,
    contact: &Contact,
    sliding: &Sliding,
    z: &[Form],
    axes: &[Vec<Form>],
) -> Vec<Form> {
    let p = contact.p;
    let all: Vec<NodeId> = sliding.c.iter().flatten().copied().collect();
    let direct = program.terms("slip-change", &all, "");
    let metric = program.terms("slip-metric", &all, "the metric is constant");
    let traction = program.terms("traction-metric", &sliding.t, "the metric is constant");
    let graph = &mut program.graph;
    (0..p)
        .map(|q| {
            let mut form = Form::zero(graph, contact.d, p);
            for r in 0..p {
                form.add_scaled(graph, direct[q * p + r], &z[r]);
                for k in 0..p {
                    let factor = graph.multiply(metric[q * p + r], sliding.slip[k]);
                    form.add_scaled(graph, factor, &axes[r][k]);
                }
                form.add_scaled(graph, traction[r], &axes[r][q]);
            }
            form
        })
        .collect()
}

/// h_q Δp with Δp = −N' n·Δr [eq:pressure-change]
fn pressure(program: &mut Program, contact: &Contact, sliding: &Sliding, g: &mut [Form]) {
    let coefficients = program.terms("pressure-change", &sliding.h, "the law has no bound");
    let graph = &mut program.graph;
    let minus = graph.negate(sliding.slope);
    for (form, h) in g.iter_mut().zip(coefficients) {
        let factor = graph.multiply(h, minus);
        let along = contact.n.scale(graph, factor);
        form.add_position(graph, &along);
    }
}

/// P_k = τ_i Q_ik, Q_ik = r_,ik·δr + e_i·δr_,k + e_k·δr_,i + L n·δr_,ik [eq:Q]
fn second_variation(program: &mut Program, contact: &Contact, sliding: &Sliding) -> Vec<Form> {
    let (d, p) = (contact.d, contact.p);
    let still = "the tangents do not rotate with any unknown";
    let position = program.terms(
        "Q-position",
        &sliding.force,
        "no curvature along the projection",
    );
    let outer = program.terms("Q-tangent", &sliding.force, still);
    let inner = program.terms("Q-turning", &sliding.force, still);
    let bending = program.terms("Q-bending", &sliding.force, still);
    let graph = &mut program.graph;
    let [position, outer, inner, bending] =
        [position, outer, inner, bending].map(|t| contact.raised(graph, &t));
    (0..p)
        .map(|k| {
            let mut form = Form::zero(graph, d, p);
            for i in 0..p {
                let bent = contact.second[pair_index(i, k)].scale(graph, position[i]);
                form.add_position(graph, &bent);
                let along = contact.e[i].scale(graph, outer[i]);
                form.add_turning(graph, k, &along);
                let along = contact.e[k].scale(graph, inner[i]);
                form.add_turning(graph, i, &along);
                let at = pair_index(i, k);
                let lever = graph.multiply(contact.distance, bending[i]);
                form.bending[at] = graph.add(form.bending[at], lever);
            }
            form
        })
        .collect()
}

/// −τ_i Y_iqj Z_j, Y_iqj = r_,iq·e_j + r_,ij·e_q + r_,qj·e_i + L n·r_,iqj [eq:Y]
fn hessian(
    program: &mut Program,
    contact: &Contact,
    sliding: &Sliding,
    z: &[Form],
    g: &mut [Form],
) {
    let p = contact.p;
    let second = program.terms(
        "Y-second",
        &sliding.force,
        "no curvature within the tangent plane",
    );
    let third = program.terms(
        "Y-third",
        &sliding.force,
        "no third derivative along the normal",
    );
    let graph = &mut program.graph;
    let [second, third] = [second, third].map(|t| contact.raised(graph, &t));
    for q in 0..p {
        for j in 0..p {
            let mut sum = graph.constant(0.0);
            for i in 0..p {
                let one = contact.second[pair_index(i, q)].dot(graph, &contact.e[j]);
                let two = contact.second[pair_index(i, j)].dot(graph, &contact.e[q]);
                let three = contact.second[pair_index(q, j)].dot(graph, &contact.e[i]);
                let bends = graph.add(one, two);
                let bends = graph.add(bends, three);
                let bends = graph.multiply(second[i], bends);
                let along = graph.multiply(contact.distance, sliding.third[i + q + j]);
                let along = graph.multiply(third[i], along);
                let part = graph.add(bends, along);
                sum = graph.add(sum, part);
            }
            let minus = graph.negate(sum);
            g[q].add_scaled(graph, minus, &z[j]);
        }
    }
}

/// −τ_i (δr·Δr_,i + δr_,i·Δr): one factor −τ^i for each declared parameter. [eq:cross]
fn cross(program: &mut Program, contact: &Contact, sliding: &Sliding) -> Vec<NodeId> {
    let t = program.terms(
        "cross",
        &sliding.force,
        "the tangents do not rotate with any unknown",
    );
    let graph = &mut program.graph;
    let tau = contact.raised(graph, &t);
    (0..contact.p)
        .map(|i| {
            let mut sum = graph.constant(0.0);
            for (q, &tau) in tau.iter().enumerate() {
                let part = graph.multiply(contact.frame[i][q], tau);
                sum = graph.add(sum, part);
            }
            graph.negate(sum)
        })
        .collect()
}

/// Z, P and G over the declared parameters, and the cross factors.
fn outputs(
    program: &mut Program,
    kinematics: &Kinematics,
    contact: &Contact,
    forms: [&[Form]; 3],
    cross: &[NodeId],
) {
    for (name, forms) in ["z", "p", "g"].into_iter().zip(forms) {
        for (q, form) in forms.iter().enumerate() {
            let form = form.declared(&mut program.graph, &contact.frame, &kinematics.moving);
            program.output_vector(&format!("{name}_{q}_position"), &form.position);
            for (i, vector) in form.turning.iter().enumerate() {
                program.output_vector(&format!("{name}_{q}_turning_{i}"), vector);
            }
            for (h, &value) in form.bending.iter().enumerate() {
                program.output(format!("{name}_{q}_bending_{h}"), value);
            }
            program.output_vector(&format!("{name}_{q}_slave"), &form.slave);
        }
    }
    let zero = program.graph.constant(0.0);
    for (i, &value) in cross.iter().enumerate() {
        let value = if kinematics.moving[i] { value } else { zero };
        program.output(format!("cross_{i}"), value);
    }
}
