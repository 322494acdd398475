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
//! M_qr e_r is the change of the axis e_q relative to the convected frame; its symmetric part is Δa/2. The forms
//! are collected as factors of Z, of e_q·δr_,r and of n·δr; vectors come last.

use super::contact::{Contact, Sliding, combination, pairs};
use super::row::{Form, Variation, symmetric_row};
use super::{Kinematics, pair_index};
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Axis;

/// n, L, b_i, r_,ij, E, t_q → coefficients of s_A and of s_A,i n in the tangential residual:
/// R = t_q Z_q = −τ_q e_q·δr − L τ_q n·δr_,q. [eq:tangential-residual]
pub fn residual_program(kinematics: &Kinematics) -> Program {
    let mut program = Program::new("tangential_residual");
    let contact = Contact::new(&mut program, kinematics);
    let t = program.input_vector("t", contact.p).0;
    let minus: Vec<NodeId> = contact.raised(&mut program.graph, &t);
    let minus: Vec<NodeId> = minus.iter().map(|&t| program.graph.negate(t)).collect();
    let direct = program.terms("tangential-direct", &minus, "");
    let rotation = program.terms(
        "tangential-rotation",
        &minus,
        "the tangents do not rotate with any unknown, or linearised on the tangent plane L = 0",
    );
    let graph = &mut program.graph;
    let along = |q: usize| (direct[q], contact.e[q].clone());
    let force = combination(graph, contact.d, &along, contact.p);
    let zero = graph.constant(0.0);
    let turns: Vec<NodeId> = (0..contact.p)
        .map(|i| {
            if !kinematics.moving[i] {
                return zero;
            }
            let sum = contact.on_declared(graph, &rotation, i);
            graph.multiply(contact.distance, sum)
        })
        .collect();
    program.output_vector("force", &force);
    for (i, value) in turns.into_iter().enumerate() {
        program.output(format!("turn_{i}"), value);
    }
    program.settle_terms();
    program
}

/// n, L, b_i, r_,ij, E, r_,ijk, s, t, C, h, N' → forms Z, −P, G and the factors of the cross term; with `rolls` also the
/// factor of δζ̂, t with the share of the moments [eq:rolling-share].
pub fn tangent_program(kinematics: &Kinematics, axis: Option<Axis>, rolls: bool) -> Program {
    let mut program = Program::new("tangential_tangent");
    let contact = Contact::new(&mut program, kinematics);
    let sliding = Sliding::new(&mut program, kinematics, &contact, axis, rolls);
    let tau = contact.raised(&mut program.graph, &sliding.force);
    let minus: Vec<NodeId> = tau.iter().map(|&t| program.graph.negate(t)).collect();
    let z = projection(&mut program.graph, &contact, kinematics);
    let strain = metric(&mut program.graph, &contact);
    let axes = axes(&mut program, &contact, &sliding, strain, axis);
    let second = second_variation(&mut program, kinematics, &contact, &minus);
    let mut g = elastic(&mut program, &contact, &sliding, &axes);
    pressure(&mut program, &contact, &sliding, &mut g);
    let one = program.graph.constant(1.0);
    for (g, p) in g.iter_mut().zip(&second) {
        g.add_scaled(&mut program.graph, one, p);
    }
    hessian(&mut program, &contact, &sliding, &minus, &mut g);
    let cross = cross(&mut program, &contact, &minus);
    outputs(
        &mut program,
        kinematics,
        &contact,
        &z,
        [&second, &g],
        &cross,
    );
    program.settle_terms();
    program
}

/// Z_q = −m_qr (e_r·δr + L n·δr_,r) [eq:variation]
pub(super) fn projection(
    graph: &mut Graph,
    contact: &Contact,
    kinematics: &Kinematics,
) -> Vec<Variation> {
    let (d, p) = (contact.d, contact.p);
    let zero = graph.constant(0.0);
    (0..p)
        .map(|q| {
            let minus: Vec<NodeId> = (0..p)
                .map(|r| graph.negate(contact.m[pair_index(q, r)]))
                .collect();
            let position = combination(graph, d, &|r| (minus[r], contact.e[r].clone()), p);
            let levers: Vec<NodeId> = minus
                .iter()
                .map(|&minus| graph.multiply(minus, contact.distance))
                .collect();
            let turning = (0..p)
                .map(|i| match kinematics.moving[i] {
                    true => contact.on_declared(graph, &levers, i),
                    false => zero,
                })
                .collect();
            Variation { position, turning }
        })
        .collect()
}

/// Δa_qr = e_r·Δr_,q + e_q·Δr_,r + (r_,qk·e_r + r_,rk·e_q) Z_k [eq:metric-change], entries 11, 12, 22.
fn metric(graph: &mut Graph, contact: &Contact) -> Vec<Form> {
    let (d, p) = (contact.d, contact.p);
    let one = graph.constant(1.0);
    let mut forms = Vec::new();
    for (q, r) in pairs(p) {
        let mut form = Form::zero(graph, d, p);
        form.add_along(graph, (r, q), one);
        form.add_along(graph, (q, r), one);
        for k in 0..p {
            let first = contact.second[pair_index(q, k)].dot(graph, &contact.e[r]);
            let last = contact.second[pair_index(r, k)].dot(graph, &contact.e[q]);
            form.variation[k] = graph.add(first, last);
        }
        forms.push(form);
    }
    forms
}

/// M as factors of forms: entry (q, r) lists which form enters M_qr with which factor.
struct Axes {
    forms: Vec<Form>,
    entries: Vec<Vec<Vec<(usize, f64)>>>,
}

/// M_qr: Δa/2 where the law has no axes; convected axes M_12 = Δa_12, M_21 = 0; along the slave curve
/// M_12 = e_2·Δd/(d·e_1), M_21 = Δa_12 − M_12. [eq:axes]
fn axes(
    program: &mut Program,
    contact: &Contact,
    sliding: &Sliding,
    strain: Vec<Form>,
    axis: Option<Axis>,
) -> Axes {
    let mut forms = strain;
    if contact.p == 1 {
        let entries = vec![vec![vec![(0, 0.5)]]];
        return Axes { forms, entries };
    }
    let (right, left) = match (axis, &sliding.slave_tangent) {
        (Some(Axis::Convected), _) => (vec![(1, 1.0)], vec![]),
        (Some(Axis::Slave), Some(tangent)) => {
            forms.push(slave_turn(program, contact, tangent));
            (vec![(3, 1.0)], vec![(1, 1.0), (3, -1.0)])
        }
        _ => (vec![(1, 0.5)], vec![(1, 0.5)]),
    };
    let (first, last) = (vec![(0, 0.5)], vec![(2, 0.5)]);
    let entries = vec![vec![first, right], vec![left, last]];
    Axes { forms, entries }
}

/// (e_2·Δd + d·Δb_2)/(d·e_1) with the slave's tangent d and Δb_2 = Δr_,2 + r_,2k Z_k. [eq:axes]
fn slave_turn(program: &mut Program, contact: &Contact, tangent: &Vector) -> Form {
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    let along = tangent.dot(graph, &contact.e[0]);
    let inverse = graph.divide(one, along);
    let inverse = program.term("axis-turn", inverse, "");
    let graph = &mut program.graph;
    let mut form = Form::zero(graph, contact.d, contact.p);
    form.slave = contact.e[1].scale(graph, inverse);
    let turned = tangent.scale(graph, inverse);
    for q in 0..contact.p {
        let part = turned.dot(graph, &contact.e[q]);
        form.add_along(graph, (q, 1), part);
    }
    form.lift[1] = turned.dot(graph, &contact.n);
    for k in 0..contact.p {
        form.variation[k] = turned.dot(graph, &contact.second[pair_index(1, k)]);
    }
    form
}

/// C_qr (Z_r + M_rk s_k) + t_r M_rq [eq:slip-change] [eq:slip-metric] [eq:traction-metric]
fn elastic(program: &mut Program, contact: &Contact, sliding: &Sliding, axes: &Axes) -> Vec<Form> {
    let p = contact.p;
    let all: Vec<NodeId> = sliding.c.iter().flatten().copied().collect();
    let direct = program.terms("slip-change", &all, "");
    let metric = program.terms("slip-metric", &all, "the metric is constant");
    let traction = program.terms("traction-metric", &sliding.t, "the metric is constant");
    let graph = &mut program.graph;
    let mut result = Vec::new();
    for q in 0..p {
        let mut form = Form::zero(graph, contact.d, p);
        form.variation.copy_from_slice(&direct[q * p..(q + 1) * p]);
        let mut factors = vec![graph.constant(0.0); axes.forms.len()];
        for (r, k) in (0..p).flat_map(|r| (0..p).map(move |k| (r, k))) {
            let mut factor = graph.multiply(metric[q * p + r], sliding.slip[k]);
            if k == q {
                factor = graph.add(factor, traction[r]);
            }
            for &(index, share) in &axes.entries[r][k] {
                let share = graph.constant(share);
                let part = graph.multiply(share, factor);
                factors[index] = graph.add(factors[index], part);
            }
        }
        for (&factor, other) in factors.iter().zip(&axes.forms) {
            form.add_scaled(graph, factor, other);
        }
        result.push(form);
    }
    result
}

/// h_q Δp with Δp = −N' n·Δr [eq:pressure-change]
fn pressure(program: &mut Program, contact: &Contact, sliding: &Sliding, g: &mut [Form]) {
    let coefficients = program.terms("pressure-change", &sliding.h, "the law has no bound");
    let graph = &mut program.graph;
    let minus = graph.negate(sliding.slope);
    for (form, h) in g.iter_mut().zip(coefficients).take(contact.p) {
        let factor = graph.multiply(h, minus);
        form.normal = graph.add(form.normal, factor);
    }
}

/// −P_k = −τ_i Q_ik, Q_ik = r_,ik·δr + e_i·δr_,k + e_k·δr_,i + L n·δr_,ik [eq:Q]
fn second_variation(
    program: &mut Program,
    kinematics: &Kinematics,
    contact: &Contact,
    minus: &[NodeId],
) -> Vec<Form> {
    let (d, p) = (contact.d, contact.p);
    let still = "the tangents do not rotate with any unknown";
    let position = program.terms("Q-position", minus, "no curvature along the projection");
    let outer = program.terms("Q-tangent", minus, still);
    let inner = program.terms("Q-turning", minus, still);
    let bending = program.terms(
        "Q-bending",
        minus,
        "no s_A,ij differs from zero, or linearised on the tangent plane L = 0",
    );
    let graph = &mut program.graph;
    let levers: Vec<NodeId> = (0..p)
        .map(|i| {
            let along = contact.on_declared(graph, &bending, i);
            graph.multiply(contact.distance, along)
        })
        .collect();
    let mut result = Vec::new();
    for k in 0..p {
        let mut form = Form::zero(graph, d, p);
        let bent = |i: usize| (position[i], contact.second[pair_index(i, k)].clone());
        form.position = combination(graph, d, &bent, p);
        for i in 0..p {
            form.add_along(graph, (i, k), outer[i]);
            form.add_along(graph, (k, i), inner[i]);
        }
        let row = symmetric_row(graph, &contact.frame, &levers, k);
        for (h, (i, j)) in pairs(p).enumerate() {
            if kinematics.curved[h] && kinematics.moving[i] && kinematics.moving[j] {
                form.bending[h] = row[h];
            }
        }
        result.push(form);
    }
    result
}

/// −τ_i Y_iqj Z_j, Y_iqj = r_,iq·e_j + r_,ij·e_q + r_,qj·e_i + L n·r_,iqj [eq:Y]
fn hessian(
    program: &mut Program,
    contact: &Contact,
    sliding: &Sliding,
    minus: &[NodeId],
    g: &mut [Form],
) {
    let p = contact.p;
    let second = program.terms("Y-second", minus, "no curvature within the tangent plane");
    let third = program.terms("Y-third", minus, "no third derivative along the normal");
    let graph = &mut program.graph;
    let levers: Vec<NodeId> = (0..p)
        .map(|i| {
            let along = contact.on_declared(graph, &third, i);
            graph.multiply(contact.distance, along)
        })
        .collect();
    for (q, j) in pairs(p) {
        let mut sum = contact.framed_third(graph, &sliding.third, &levers, (q, j));
        for i in 0..p {
            let bends = bends(graph, contact, [i, q, j]);
            let part = graph.multiply(second[i], bends);
            sum = graph.add(sum, part);
        }
        g[q].variation[j] = graph.add(g[q].variation[j], sum);
        if q != j {
            g[j].variation[q] = graph.add(g[j].variation[q], sum);
        }
    }
}

/// r_,iq·e_j + r_,ij·e_q + r_,qj·e_i, the same in any order of the indices.
fn bends(graph: &mut Graph, contact: &Contact, mut indices: [usize; 3]) -> NodeId {
    indices.sort_unstable();
    let [i, q, j] = indices;
    let one = contact.second[pair_index(i, q)].dot(graph, &contact.e[j]);
    let two = contact.second[pair_index(i, j)].dot(graph, &contact.e[q]);
    let three = contact.second[pair_index(q, j)].dot(graph, &contact.e[i]);
    let sum = graph.add(one, two);
    graph.add(sum, three)
}

/// −τ_i (δr·Δr_,i + δr_,i·Δr): one factor −τ^i for each declared parameter. [eq:cross]
fn cross(program: &mut Program, contact: &Contact, minus: &[NodeId]) -> Vec<NodeId> {
    let minus = program.terms(
        "cross",
        minus,
        "the tangents do not rotate with any unknown",
    );
    let graph = &mut program.graph;
    (0..contact.p)
        .map(|i| contact.on_declared(graph, &minus, i))
        .collect()
}

/// Z, −P and G over the declared parameters, and the cross factors. G has the same of δr_,ij as −P.
fn outputs(
    program: &mut Program,
    kinematics: &Kinematics,
    contact: &Contact,
    variations: &[Variation],
    forms: [&[Form]; 2],
    cross: &[NodeId],
) {
    for (q, z) in variations.iter().enumerate() {
        program.output_vector(&format!("z_{q}_position"), &z.position);
        for (i, &value) in z.turning.iter().enumerate() {
            program.output(format!("z_{q}_turning_{i}"), value);
        }
    }
    for (name, forms) in ["p", "g"].into_iter().zip(forms) {
        for (q, form) in forms.iter().enumerate() {
            let graph = &mut program.graph;
            let declared = form.declared(graph, contact, variations, &kinematics.moving);
            program.output_vector(&format!("{name}_{q}_position"), &declared.position);
            for (i, vector) in declared.turning.iter().enumerate() {
                program.output_vector(&format!("{name}_{q}_turning_{i}"), vector);
            }
            if name == "p" {
                for (h, &value) in form.bending.iter().enumerate() {
                    program.output(format!("{name}_{q}_bending_{h}"), value);
                }
            } else {
                program.output_vector(&format!("{name}_{q}_slave"), &form.slave);
            }
        }
    }
    let zero = program.graph.constant(0.0);
    for (i, &value) in cross.iter().enumerate() {
        let value = if kinematics.moving[i] { value } else { zero };
        program.output(format!("cross_{i}"), value);
    }
}
