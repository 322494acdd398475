//! Tensors of the projected parameters in a basis of orthogonal tangents. [eq:orthogonal-basis]

use crate::ir::{Scalar, Sheet, Symmetric, Vector};

/// b_1 and b_2 − t b_1 with t = a_12/a_11: a basis in which the metric is diagonal, so that nothing cancels
/// where the declared parameters are skew or two curves nearly parallel. [eq:orthogonal-basis]
pub fn orthogonal<'s>(sheet: &'s Sheet, b: &[Vector<'s>]) -> (Vec<Vector<'s>>, Scalar<'s>) {
    let [first, second] = *b else {
        return (b.to_vec(), sheet.zero());
    };
    let square = first.dot(first);
    let shear = first.dot(second) / square;
    (vec![first, second - shear * first], shear)
}

/// a_11 b_2 − a_12 b_1: the direction of b_2 − t b_1 without a division in the way of the normal.
/// [eq:orthogonal-basis]
pub fn orthogonal_direction<'s>(first: Vector<'s>, second: Vector<'s>) -> Vector<'s> {
    let (square, mixed) = (first.dot(first), first.dot(second));
    let along = mixed * first;
    square * second - along
}

/// A symmetric covariant tensor in the orthogonal basis:
/// κ_12 − t κ_11 and κ_22 − 2 t κ_12 + t² κ_11. [eq:orthogonal-basis]
pub fn sheared<'s>(sheet: &'s Sheet, tensor: Symmetric<'s>, shear: Scalar<'s>) -> Symmetric<'s> {
    let [k11, k12, k22] = *tensor.entries() else {
        return tensor;
    };
    let mixed = k12 - shear * k11;
    Symmetric::two(sheet, k11, mixed, k22 - shear * (k12 + mixed))
}

/// Contravariant components in the declared basis from those in the orthogonal one:
/// m^11 − t (m^12 + m^21) + t² m^22 and m^12 − t m^22. [eq:orthogonal-basis]
pub fn contravariant<'s>(
    sheet: &'s Sheet,
    tensor: Symmetric<'s>,
    shear: Scalar<'s>,
) -> Symmetric<'s> {
    let [m11, m12, m22] = *tensor.entries() else {
        return tensor;
    };
    let mixed = m12 - shear * m22;
    Symmetric::two(sheet, m11 - shear * (m12 + mixed), mixed, m22)
}
