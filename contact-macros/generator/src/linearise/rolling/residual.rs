//! Moments about two curves: R = M_c δφ_c. [eq:rolling-residual]
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

use super::curves::{Curves, NO_CURVATURE, NO_THIRD, NOT_TURNED, Pair, signed};
use super::form::Motion;
use crate::ir::{Program, Scalar, Sheet};
use crate::linearise::shared::Kinematics;

const OWN: &str = "the reference is the second derivative itself";

/// The contact point and M_c → share of the moments in the factor of δζ̂^q, E^i_q M_c φ_c,i, and the explicit
/// part of M_c δφ_c: vectors of s_A, s_A,i, s_A,ii. [eq:rolling-residual] [eq:rolling-share]
pub fn residual_program(kinematics: &Kinematics, curves: Curves) -> Program {
    let sheet = Sheet::new("rolling_residual");
    write(&sheet, kinematics, curves);
    sheet.finish()
}

fn write(sheet: &Sheet, kinematics: &Kinematics, curves: Curves) {
    let pair = Pair::new(sheet, kinematics, curves);
    let moments = signed(&sheet.input_vector("moment", 2));
    let form = explicit(&pair, &moments);
    let along = share(&pair, &moments);
    for q in 0..2 {
        let sum = sheet.sum(0..2, |i| pair.contact.frame[i][q] * along[i]);
        sheet.output(format!("share_{q}"), sum);
    }
    form.output(sheet, "explicit");
}

/// M̂_c (p_r·δr + p_u·δr_,c + p_w·δr_,cc) [eq:rolling-arm] [eq:rolling-axis] [eq:rolling-bend]
fn explicit<'s>(pair: &Pair<'s>, moments: &[Scalar<'s>]) -> Motion<'s> {
    let sheet = pair.contact.sheet;
    let mut form = Motion::zero(sheet);
    let arm = sheet.terms("rolling-arm", moments, "");
    let axis = sheet.terms("rolling-axis", moments, "");
    let bend = sheet.terms("rolling-bend", moments, NOT_TURNED);
    for (c, curve) in pair.curves.iter().enumerate() {
        form.position = form.position + arm[c] * curve.by_position;
        form.turning[c] = axis[c] * curve.by_tangent;
        if pair.frenet {
            form.bending[c] = bend[c] * curve.by_reference;
        }
    }
    form
}

/// M̂_c ψ_c,i = M̂_c p_r·r_,i + M̂_i (p_u·r_,ii + p_w·r_,iii) [eq:rolling-share]
fn share<'s>(pair: &Pair<'s>, moments: &[Scalar<'s>]) -> [Scalar<'s>; 2] {
    let sheet = pair.contact.sheet;
    let without_axis = if pair.frenet { OWN } else { NO_CURVATURE };
    let without_bend = if pair.frenet { NO_THIRD } else { NOT_TURNED };
    let arm = sheet.terms("rolling-arm-share", moments, "");
    let axis = sheet.terms("rolling-axis-share", moments, without_axis);
    let bend = sheet.terms("rolling-bend-share", moments, without_bend);
    [0, 1].map(|i| {
        // its own tangent stands across: p_r·r_,c = 0
        let other = 1 - i;
        let swept = arm[other] * pair.curves[other].by_position.dot(pair.tangents[i]);
        let curve = &pair.curves[i];
        swept
            + match pair.frenet {
                true => bend[i] * curve.by_reference.dot(pair.third[i]),
                false => axis[i] * curve.by_tangent.dot(pair.second[i]),
            }
    })
}
