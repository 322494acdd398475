//! Contact of two curves weighted by their angle: R = w N δg + W w' δq. [eq:angle-energy] [eq:angle-residual]

use super::pair::{Bends, NO_CURVATURE, Pair};
use crate::ir::{Program, Sheet};
use crate::linearise::rolling::form::Motion;

/// The contact point, w', W → vectors of s_A, N^slave_A,1 and N^master_A,1 of W w' δq. [eq:angle-residual]
pub fn residual_program(bends: &Bends) -> Program {
    let sheet = Sheet::new("angle_residual");
    write(&sheet, bends);
    sheet.finish()
}

fn write(sheet: &Sheet, bends: &Bends) {
    let pair = Pair::new(sheet, bends, false);
    let slope = sheet.input("weight_slope");
    let energy = sheet.input("energy");
    let factor = pair.by_cosine(energy * slope);
    let own = ["angle-slave", "angle-master"].map(|tag| sheet.term(tag, factor, ""));
    let shift = sheet.term("angle-shift", factor, NO_CURVATURE);
    let mut form = Motion::zero(sheet);
    for (c, curve) in pair.curves.iter().enumerate() {
        form.turning[c] = form.turning[c] + own[c] * curve.inverse * curve.across;
        form = form.plus(shift * curve.bend(curve.second), &curve.shift);
    }
    form.output_lower(sheet, "form");
}
