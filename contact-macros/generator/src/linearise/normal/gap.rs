//! Normal, signed distance and gap of a projected pair. [eq:2-normal] [eq:gap]

use crate::ir::{Program, Scalar, Sheet, Vector};
use crate::linearise::shared::Kinematics;
use crate::linearise::shared::basis::orthogonal_direction;
use crate::model::Gap;

/// r, b_i, orientation, r0 → n, L, g.
///
/// Signed: n = ± b_1×b_2/|b_1×b_2|, taken of b_1 and a_11 b_2 − a_12 b_1 so that n·b_1 vanishes to rounding even where
/// the tangents are nearly parallel [eq:orthogonal-basis]; in 2D ± (b_y, −b_x)/|b|, L = r·n. Distance: L = |r|, n = r/L.
/// Oriented: L = ± |r|, n = r/L. [eq:oriented]
/// The caller has made sure that the divisor is not zero.
pub fn gap_program(kinematics: &Kinematics) -> Program {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let sheet = Sheet::new("gap");
    let r = sheet.input_vector("r", d);
    let b: Vec<Vector> = (0..p)
        .map(|i| sheet.input_vector(&format!("b_{i}"), d))
        .collect();
    let orientation = sheet.input("orientation");
    let r0 = sheet.input("r0");
    let (n, distance) = match kinematics.gap {
        Gap::Signed => {
            let n = normal(&sheet, &b, orientation);
            (n, r.dot(n))
        }
        Gap::Distance => along(r, r.norm()),
        Gap::Oriented => along(r, orientation * r.norm()),
    };
    let gap = distance - r0;
    sheet.outputs("n", &n);
    sheet.output("distance", distance);
    sheet.output("gap", gap);
    sheet.finish()
}

/// n = r/L and L
fn along<'s>(r: Vector<'s>, distance: Scalar<'s>) -> (Vector<'s>, Scalar<'s>) {
    (1.0 / distance * r, distance)
}

/// ± the unit normal of the tangents
fn normal<'s>(sheet: &'s Sheet, b: &[Vector<'s>], orientation: Scalar<'s>) -> Vector<'s> {
    let normal = match *b {
        [first, second] => first.cross(orthogonal_direction(first, second)),
        [only] => Vector::new(sheet, [only[1], -only[0]]),
        _ => unreachable!("a signed gap has one tangent in 2D and two in 3D"),
    };
    orientation / normal.norm() * normal
}
