//! Tangent of tangential contact in covariant closed form. [eq:tangential-tangent]
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

use super::form::{Form, Variation, symmetric_row, variations};
use super::point::{Contact, Sliding};
use crate::ir::{Program, Scalar, Sheet, Vector, pairs};
use crate::linearise::shared::Kinematics;
use crate::model::Axis;

const NO_ROTATION: &str = "the tangents do not rotate with any unknown";

/// n, L, b_i, r_,ij, E, r_,ijk, s, t, C, h, N' → forms Z, −P, G and the factors of the cross term; with `rolls` also the
/// factor of δζ̂, t with the share of the moments [eq:rolling-share].
pub fn tangent_program(kinematics: &Kinematics, axis: Option<Axis>, rolls: bool) -> Program {
    let sheet = Sheet::new("tangential_tangent");
    write(&sheet, kinematics, axis, rolls);
    sheet.finish()
}

fn write(sheet: &Sheet, kinematics: &Kinematics, axis: Option<Axis>, rolls: bool) {
    let at = Contact::new(sheet, kinematics);
    let sliding = Sliding::new(kinematics, &at, axis, rolls);
    let minus = at.minus_raised(&sliding.force);
    let z = variations(&at, kinematics);
    let axes = axes(&at, &sliding, metric(&at), axis);
    let second = second_variation(kinematics, &at, &minus);
    let mut g = elastic(&at, &sliding, &axes);
    pressure(&at, &sliding, &mut g);
    let one = sheet.one();
    for (g, p) in g.iter_mut().zip(&second) {
        g.add_scaled(one, p);
    }
    hessian(&at, &sliding, &minus, &mut g);
    let cross = cross(&at, &minus);
    output_variations(sheet, &z);
    for (q, form) in second.iter().enumerate() {
        let name = format!("p_{q}");
        output_declared(&at, form, &z, kinematics, &name);
        sheet.outputs(&format!("{name}_bending"), &form.bending);
    }
    for (q, form) in g.iter().enumerate() {
        let name = format!("g_{q}");
        output_declared(&at, form, &z, kinematics, &name);
        sheet.outputs(&format!("{name}_slave"), &form.slave);
    }
    for (i, &value) in cross.iter().enumerate() {
        let moving = kinematics.moving[i];
        let value = if moving { value } else { sheet.zero() };
        sheet.output(format!("cross_{i}"), value);
    }
}

/// Δa_qr = e_r·Δr_,q + e_q·Δr_,r + (r_,qk·e_r + r_,rk·e_q) Z_k [eq:metric-change], entries 11, 12, 22.
fn metric<'s>(at: &Contact<'s>) -> Vec<Form<'s>> {
    let one = at.sheet.one();
    let entry = |(q, r)| {
        let mut form = Form::zero(at);
        form.add_along(r, q, one);
        form.add_along(q, r, one);
        for k in 0..at.p {
            form.variation[k] = at.second(q, k).dot(at.e[r]) + at.second(r, k).dot(at.e[q]);
        }
        form
    };
    pairs(at.p).map(entry).collect()
}

/// M as factors of forms: entry (q, r) lists which form enters M_qr with which factor.
struct Axes<'s> {
    forms: Vec<Form<'s>>,
    entries: Vec<Vec<Vec<(usize, f64)>>>,
}

/// M_qr: Δa/2 where the law has no axes; convected axes M_12 = Δa_12, M_21 = 0; along the slave curve
/// M_12 = e_2·Δd/(d·e_1), M_21 = Δa_12 − M_12. [eq:axes]
fn axes<'s>(
    at: &Contact<'s>,
    sliding: &Sliding<'s>,
    strain: Vec<Form<'s>>,
    axis: Option<Axis>,
) -> Axes<'s> {
    let mut forms = strain;
    if at.p == 1 {
        let entries = vec![vec![vec![(0, 0.5)]]];
        return Axes { forms, entries };
    }
    let (right, left) = match (axis, sliding.slave_tangent) {
        (Some(Axis::Convected), _) => (vec![(1, 1.0)], vec![]),
        (Some(Axis::Slave), Some(tangent)) => {
            forms.push(slave_turn(at, tangent));
            (vec![(3, 1.0)], vec![(1, 1.0), (3, -1.0)])
        }
        _ => (vec![(1, 0.5)], vec![(1, 0.5)]),
    };
    let (first, last) = (vec![(0, 0.5)], vec![(2, 0.5)]);
    let entries = vec![vec![first, right], vec![left, last]];
    Axes { forms, entries }
}

/// (e_2·Δd + d·Δb_2)/(d·e_1) with the slave's tangent d and Δb_2 = Δr_,2 + r_,2k Z_k. [eq:axes]
fn slave_turn<'s>(at: &Contact<'s>, tangent: Vector<'s>) -> Form<'s> {
    let one = at.sheet.one();
    let inverse = one / tangent.dot(at.e[0]);
    let inverse = at.sheet.term("axis-turn", inverse, "");
    let mut form = Form::zero(at);
    form.slave = inverse * at.e[1];
    let turned = inverse * tangent;
    for q in 0..at.p {
        form.add_along(q, 1, turned.dot(at.e[q]));
    }
    form.lift[1] = turned.dot(at.n);
    for k in 0..at.p {
        form.variation[k] = turned.dot(at.second(1, k));
    }
    form
}

/// C_qr (Z_r + M_rk s_k) + t_r M_rq [eq:slip-change] [eq:slip-metric] [eq:traction-metric]
fn elastic<'s>(at: &Contact<'s>, sliding: &Sliding<'s>, axes: &Axes<'s>) -> Vec<Form<'s>> {
    let (sheet, p) = (at.sheet, at.p);
    let direct = sheet.terms("slip-change", &sliding.c, "");
    let metric = sheet.terms("slip-metric", &sliding.c, "the metric is constant");
    let traction = sheet.terms("traction-metric", &sliding.t, "the metric is constant");
    let row = |q: usize| {
        let mut form = Form::zero(at);
        form.variation.copy_from_slice(&direct[q * p..(q + 1) * p]);
        let mut factors = vec![sheet.zero(); axes.forms.len()];
        for (r, k) in (0..p).flat_map(|r| (0..p).map(move |k| (r, k))) {
            let mut factor = metric[q * p + r] * sliding.slip[k];
            if k == q {
                factor = factor + traction[r];
            }
            for &(index, share) in &axes.entries[r][k] {
                factors[index] = factors[index] + share * factor;
            }
        }
        for (&factor, other) in factors.iter().zip(&axes.forms) {
            form.add_scaled(factor, other);
        }
        form
    };
    (0..p).map(row).collect()
}

/// h_q Δp with Δp = −N' n·Δr [eq:pressure-change]
fn pressure<'s>(at: &Contact<'s>, sliding: &Sliding<'s>, g: &mut [Form<'s>]) {
    let h = at
        .sheet
        .terms("pressure-change", &sliding.h, "the law has no bound");
    let minus = -sliding.slope;
    for (form, h) in g.iter_mut().zip(h) {
        form.normal = form.normal + h * minus;
    }
}

/// −P_k = −τ_i Q_ik, Q_ik = r_,ik·δr + e_i·δr_,k + e_k·δr_,i + L n·δr_,ik [eq:Q]
fn second_variation<'s>(
    kinematics: &Kinematics,
    at: &Contact<'s>,
    minus: &[Scalar<'s>],
) -> Vec<Form<'s>> {
    let (sheet, p) = (at.sheet, at.p);
    let position = sheet.terms("Q-position", minus, "no curvature along the projection");
    let outer = sheet.terms("Q-tangent", minus, NO_ROTATION);
    let inner = sheet.terms("Q-turning", minus, NO_ROTATION);
    let bending = sheet.terms(
        "Q-bending",
        minus,
        "no s_A,ij differs from zero, or linearised on the tangent plane L = 0",
    );
    let levers: Vec<Scalar> = (0..p)
        .map(|i| at.distance * at.on_declared(&bending, i))
        .collect();
    let form = |k: usize| {
        let mut form = Form::zero(at);
        form.position = sheet.sum_vectors(at.d, 0..p, |i| position[i] * at.second(i, k));
        for i in 0..p {
            form.add_along(i, k, outer[i]);
            form.add_along(k, i, inner[i]);
        }
        let row = symmetric_row(at, &levers, k);
        for (h, (i, j)) in pairs(p).enumerate() {
            if kinematics.curved[h] && kinematics.moving[i] && kinematics.moving[j] {
                form.bending[h] = row[h];
            }
        }
        form
    };
    (0..p).map(form).collect()
}

/// −τ_i Y_iqj Z_j, Y_iqj = r_,iq·e_j + r_,ij·e_q + r_,qj·e_i + L n·r_,iqj [eq:Y]
fn hessian<'s>(at: &Contact<'s>, sliding: &Sliding<'s>, minus: &[Scalar<'s>], g: &mut [Form<'s>]) {
    let (sheet, p) = (at.sheet, at.p);
    let second = sheet.terms("Y-second", minus, "no curvature within the tangent plane");
    let third = sheet.terms("Y-third", minus, "no third derivative along the normal");
    let levers: Vec<Scalar> = (0..p)
        .map(|i| at.distance * at.on_declared(&third, i))
        .collect();
    for (q, j) in pairs(p) {
        let mut sum = at.framed_third(&sliding.third, &levers, (q, j));
        for i in 0..p {
            sum = sum + second[i] * bends(at, [i, q, j]);
        }
        g[q].variation[j] = g[q].variation[j] + sum;
        if q != j {
            g[j].variation[q] = g[j].variation[q] + sum;
        }
    }
}

/// r_,iq·e_j + r_,ij·e_q + r_,qj·e_i, the same in any order of the indices.
fn bends<'s>(at: &Contact<'s>, mut indices: [usize; 3]) -> Scalar<'s> {
    indices.sort_unstable();
    let [i, q, j] = indices;
    let one = at.second(i, q).dot(at.e[j]);
    let two = at.second(i, j).dot(at.e[q]);
    let three = at.second(q, j).dot(at.e[i]);
    one + two + three
}

/// −τ_i (δr·Δr_,i + δr_,i·Δr): one factor −τ^i for each declared parameter. [eq:cross]
fn cross<'s>(at: &Contact<'s>, minus: &[Scalar<'s>]) -> Vec<Scalar<'s>> {
    let minus = at.sheet.terms("cross", minus, NO_ROTATION);
    (0..at.p).map(|i| at.on_declared(&minus, i)).collect()
}

fn output_variations(sheet: &Sheet, variations: &[Variation<'_>]) {
    for (q, z) in variations.iter().enumerate() {
        sheet.outputs(&format!("z_{q}_position"), &z.position);
        sheet.outputs(&format!("z_{q}_turning"), &z.turning);
    }
}

/// A form over the declared parameters. G has the same factors of δr_,ij as −P.
fn output_declared<'s>(
    at: &Contact<'s>,
    form: &Form<'s>,
    variations: &[Variation<'s>],
    kinematics: &Kinematics,
    name: &str,
) {
    let declared = form.declared(at, variations, &kinematics.moving);
    at.sheet
        .outputs(&format!("{name}_position"), &declared.position);
    for (i, vector) in declared.turning.iter().enumerate() {
        at.sheet.outputs(&format!("{name}_turning_{i}"), vector);
    }
}
