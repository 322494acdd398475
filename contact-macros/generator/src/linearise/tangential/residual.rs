//! Residual of tangential contact: R = t_q δζ̂^q. [eq:tangential-residual]

use super::point::Contact;
use crate::ir::{Program, Sheet};
use crate::linearise::shared::Kinematics;

/// n, L, b_i, r_,ij, E, t_q → coefficients of s_A and of s_A,i n in the tangential residual:
/// R = t_q Z_q = −τ_q e_q·δr − L τ_q n·δr_,q. [eq:tangential-residual]
pub fn residual_program(kinematics: &Kinematics) -> Program {
    let sheet = Sheet::new("tangential_residual");
    let at = Contact::new(&sheet, kinematics);
    let t = sheet.input_vector("t", at.p);
    let minus = at.minus_raised(&t);
    let direct = sheet.terms("tangential-direct", &minus, "");
    let rotation = sheet.terms(
        "tangential-rotation",
        &minus,
        "the tangents do not rotate with any unknown, or linearised on the tangent plane L = 0",
    );
    sheet.outputs("force", &at.along_axes(|q| direct[q]));
    for i in 0..at.p {
        let turn = match kinematics.moving[i] {
            true => at.distance * at.on_declared(&rotation, i),
            false => sheet.zero(),
        };
        sheet.output(format!("turn_{i}"), turn);
    }
    drop(at);
    sheet.finish()
}
