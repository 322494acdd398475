//! Orthonormal frame of the tangent plane and the slip in it. [eq:frame] [eq:slip]
//!
//! A constant linear change of the projected parameters, ζ = E ζ̂, makes the metric at the contact point the
//! identity: every covariant form keeps its shape, loses its inverse metric, and its digits no longer
//! depend on how the parameters were chosen.

use crate::ir::{Program, Scalar, Sheet, Vector};
use crate::linearise::shared::Kinematics;
use crate::linearise::shared::basis::orthogonal;
use crate::model::Axis;

/// n, b_i, (ζ − ζ_st)^i and, with an axis, w^i or the slave's tangent → s_q, E^i_q, share.
///
/// e_q = E^i_q b_i are orthonormal; e_1 points along the axis, else along b_1; e_2 = n×e_1. share: square of
/// the part of the axis in the tangent plane, relative to the whole; 1 without axis.
pub fn frame_program(kinematics: &Kinematics, axis: Option<Axis>) -> Program {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let sheet = Sheet::new("frame");
    let n = sheet.input_vector("n", d);
    let b: Vec<Vector> = (0..p)
        .map(|i| sheet.input_vector(&format!("b_{i}"), d))
        .collect();
    let moved = sheet.input_vector("moved", p);
    let axis = match axis {
        None => Direction::First,
        Some(Axis::Convected) => Direction::Convected(sheet.input_vector("axis", 2)),
        Some(Axis::Slave) => Direction::Along(sheet.input_vector("slave_tangent", d)),
    };
    let framed = match *b {
        [b] => one_tangent(&sheet, b, moved[0]),
        _ => two_tangents(&sheet, n, &b, moved, &axis),
    };
    sheet.outputs("s", &framed.slip);
    for (i, row) in framed.frame.iter().enumerate() {
        sheet.outputs(&format!("E_{i}"), row);
    }
    sheet.output("share", framed.share);
    sheet.finish()
}

/// Where e_1 points.
enum Direction<'s> {
    /// Along b_1.
    First,
    /// Along w^i b_i.
    Convected(Vector<'s>),
    /// Along a vector's part in the tangent plane.
    Along(Vector<'s>),
}

/// What the frame program gives.
struct Framed<'s> {
    /// s_q
    slip: Vector<'s>,
    /// E^i_q, one row for each i
    frame: Vec<Vector<'s>>,
    share: Scalar<'s>,
}

/// s = |b| (ζ − ζ_st), E = 1/|b|
fn one_tangent<'s>(sheet: &'s Sheet, b: Vector<'s>, moved: Scalar<'s>) -> Framed<'s> {
    let length = b.norm();
    let share = sheet.one();
    let inverse = share / length;
    Framed {
        slip: Vector::new(sheet, [length * moved]),
        frame: vec![Vector::new(sheet, [inverse])],
        share,
    }
}

/// Along b_1 and b_2 − t b_1 first, then turned into the axis.
fn two_tangents<'s>(
    sheet: &'s Sheet,
    n: Vector<'s>,
    b: &[Vector<'s>],
    moved: Vector<'s>,
    axis: &Direction<'s>,
) -> Framed<'s> {
    let (one, zero) = (sheet.one(), sheet.zero());
    let (tangents, shear) = orthogonal(sheet, b);
    let lengths = [tangents[0].norm(), tangents[1].norm()];
    let inverse = lengths.map(|length| one / length);
    let unit = [0, 1].map(|q| inverse[q] * tangents[q]);
    // components in the unit tangents of v^i b_i: |b_1| (v^1 + t v^2), |b_2 − t b_1| v^2
    let components = |v: Vector<'s>| {
        let first = v[0] + shear * v[1];
        Vector::new(sheet, [lengths[0] * first, lengths[1] * v[1]])
    };
    let slip = components(moved);
    let frame = [[inverse[0], -(shear * inverse[1])], [zero, inverse[1]]];
    let (direction, share) = match *axis {
        Direction::First => (Vector::new(sheet, [one, zero]), one),
        Direction::Convected(w) => {
            let whole = Vector::new(sheet, [0, 1].map(|i| lengths[i] * w[i]));
            normalised(components(w), whole)
        }
        Direction::Along(t) => {
            let part = [t.dot(unit[0]), t.dot(unit[1])];
            normalised(Vector::new(sheet, part), t)
        }
    };
    // ±1: which way n×e_1 turns
    let side = n.dot(unit[0].cross(unit[1]));
    Framed {
        slip: rotated(slip, direction, side),
        frame: frame
            .map(|row| rotated(Vector::new(sheet, row), direction, side))
            .into(),
        share,
    }
}

/// v/|v| and |v|²/|whole|²
fn normalised<'s>(v: Vector<'s>, whole: Vector<'s>) -> (Vector<'s>, Scalar<'s>) {
    let share = v.dot(v) / whole.dot(whole);
    let length = v.norm();
    let direction = v.iter().map(|&component| component / length);
    (Vector::new(length.sheet(), direction), share)
}

/// Components along the axis (c, s) and along ±(−s, c).
fn rotated<'s>(v: Vector<'s>, axis: Vector<'s>, side: Scalar<'s>) -> Vector<'s> {
    let (c, s) = (axis[0], axis[1]);
    let (along, more) = (c * v[0], s * v[1]);
    let (across, less) = (c * v[1], s * v[0]);
    let along = along + more;
    Vector::new(side.sheet(), [along, side * (across - less)])
}
