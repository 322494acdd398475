//! Vectors of three numbers. Two-dimensional problems leave the third at zero.

use num_dual::DualNum;

/// `a + b`.
#[inline]
pub fn add<D: DualNum<Primitive = f64> + Copy>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a - b`.
#[inline]
pub fn sub<D: DualNum<Primitive = f64> + Copy>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `-a`.
#[inline]
pub fn neg<D: DualNum<Primitive = f64> + Copy>(a: [D; 3]) -> [D; 3] {
    [-a[0], -a[1], -a[2]]
}

/// `s a`.
#[inline]
pub fn scale<D: DualNum<Primitive = f64> + Copy>(a: [D; 3], s: D) -> [D; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// `a · b`.
#[inline]
pub fn dot<D: DualNum<Primitive = f64> + Copy>(a: [D; 3], b: [D; 3]) -> D {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a × b`.
#[inline]
pub fn cross<D: DualNum<Primitive = f64> + Copy>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Length of `a`. Its derivatives do not exist at zero.
#[inline]
pub fn norm<D: DualNum<Primitive = f64> + Copy>(a: [D; 3]) -> D {
    dot(a, a).sqrt()
}

/// `a / |a|`.
#[inline]
pub fn unit<D: DualNum<Primitive = f64> + Copy>(a: [D; 3]) -> [D; 3] {
    scale(a, norm(a).recip())
}

/// The numbers of a plain vector as constants.
#[inline]
pub fn constant<D: DualNum<Primitive = f64> + Copy>(a: [f64; 3]) -> [D; 3] {
    a.map(D::from)
}
