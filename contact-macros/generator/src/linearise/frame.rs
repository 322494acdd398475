//! Orthonormal frame of the tangent plane and the slip in it. [eq:frame] [eq:slip]
//!
//! A constant linear change of the projected parameters, ζ = E ζ̂, makes the metric at the contact point the
//! identity: every covariant form keeps its shape, loses its inverse metric, and its digits no longer
//! depend on how the parameters were chosen.

use super::Kinematics;
use super::basis::orthogonal;
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Axis;

/// n, b_i, (ζ − ζ_st)^i and, with an axis, w^i or the slave's tangent → s_q, E^i_q, share.
///
/// e_q = E^i_q b_i are orthonormal; e_1 points along the axis, else along b_1; e_2 = n×e_1. share: square of
/// the part of the axis in the tangent plane, relative to the whole; 1 without axis.
pub fn frame_program(kinematics: &Kinematics, axis: Option<Axis>) -> Program {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let mut program = Program::new("frame");
    let n = program.input_vector("n", d);
    let b: Vec<Vector> = (0..p)
        .map(|i| program.input_vector(&format!("b_{i}"), d))
        .collect();
    let moved: Vec<NodeId> = (0..p)
        .map(|i| program.input(format!("moved_{i}")))
        .collect();
    let axis = match axis {
        None => Direction::First,
        Some(Axis::Convected) => Direction::Convected(program.input_vector("axis", 2)),
        Some(Axis::Slave) => Direction::Along(program.input_vector("slave_tangent", d)),
    };
    let (slip, frame, share) = match moved.as_slice() {
        [only] => one_tangent(&mut program.graph, &b[0], *only),
        _ => two_tangents(&mut program.graph, &n, b, &moved, &axis),
    };
    for (q, value) in slip.into_iter().enumerate() {
        program.output(format!("s_{q}"), value);
    }
    for (i, row) in frame.into_iter().enumerate() {
        for (q, value) in row.into_iter().enumerate() {
            program.output(format!("E_{i}_{q}"), value);
        }
    }
    program.output("share", share);
    program
}

/// Where e_1 points.
enum Direction {
    /// Along b_1.
    First,
    /// Along w^i b_i.
    Convected(Vector),
    /// Along a vector's part in the tangent plane.
    Along(Vector),
}

/// s_q, E^i_q and the share.
type Framed = (Vec<NodeId>, Vec<Vec<NodeId>>, NodeId);

/// s = |b| (ζ − ζ_st), E = 1/|b|
fn one_tangent(graph: &mut Graph, b: &Vector, moved: NodeId) -> Framed {
    let length = b.norm(graph);
    let one = graph.constant(1.0);
    let inverse = graph.divide(one, length);
    let slip = graph.multiply(length, moved);
    (vec![slip], vec![vec![inverse]], one)
}

/// Along b_1 and b_2 − t b_1 first, then turned into the axis.
fn two_tangents(
    graph: &mut Graph,
    n: &Vector,
    b: Vec<Vector>,
    moved: &[NodeId],
    axis: &Direction,
) -> Framed {
    let one = graph.constant(1.0);
    let zero = graph.constant(0.0);
    let (tangents, shear) = orthogonal(graph, b);
    let lengths: Vec<NodeId> = tangents.iter().map(|b| b.norm(graph)).collect();
    let inverse: Vec<NodeId> = lengths
        .iter()
        .map(|&length| graph.divide(one, length))
        .collect();
    let unit: Vec<Vector> = (0..2)
        .map(|q| tangents[q].scale(graph, inverse[q]))
        .collect();
    // components in the unit tangents of v^i b_i: |b_1| (v^1 + t v^2), |b_2 − t b_1| v^2
    let components = |graph: &mut Graph, v: &[NodeId]| {
        let back = graph.multiply(shear, v[1]);
        let first = graph.add(v[0], back);
        [
            graph.multiply(lengths[0], first),
            graph.multiply(lengths[1], v[1]),
        ]
    };
    let slip = components(graph, moved);
    let back = graph.multiply(shear, inverse[1]);
    let frame = [[inverse[0], graph.negate(back)], [zero, inverse[1]]];
    let (direction, share) = match axis {
        Direction::First => ([one, zero], one),
        Direction::Convected(w) => {
            let whole: Vec<NodeId> = (0..2).map(|i| graph.multiply(lengths[i], w.0[i])).collect();
            let w = components(graph, &w.0);
            normalised(graph, w, &Vector(whole))
        }
        Direction::Along(t) => {
            let part = [t.dot(graph, &unit[0]), t.dot(graph, &unit[1])];
            normalised(graph, part, t)
        }
    };
    // ±1: which way n×e_1 turns
    let across = unit[0].cross(graph, &unit[1]);
    let side = n.dot(graph, &across);
    let turned = |graph: &mut Graph, v: [NodeId; 2]| turned(graph, v, direction, side);
    let slip = turned(graph, slip);
    let frame = frame.map(|row| turned(graph, row));
    (slip, frame.into(), share)
}

/// v/|v| and |v|²/|whole|²
fn normalised(graph: &mut Graph, v: [NodeId; 2], whole: &Vector) -> ([NodeId; 2], NodeId) {
    let vector = Vector(v.to_vec());
    let (part, whole) = (vector.dot(graph, &vector), whole.dot(graph, whole));
    let share = graph.divide(part, whole);
    let length = vector.norm(graph);
    (v.map(|component| graph.divide(component, length)), share)
}

/// Components along the axis (c, s) and along ±(−s, c).
fn turned(
    graph: &mut Graph,
    [first, second]: [NodeId; 2],
    [c, s]: [NodeId; 2],
    side: NodeId,
) -> Vec<NodeId> {
    let product = |graph: &mut Graph, a: NodeId, b: NodeId| graph.multiply(a, b);
    let (along, more) = (product(graph, c, first), product(graph, s, second));
    let (across, less) = (product(graph, c, second), product(graph, s, first));
    let along = graph.add(along, more);
    let across = graph.subtract(across, less);
    vec![along, graph.multiply(side, across)]
}
