//! Normal, signed distance and gap of a projected pair. [eq:2-normal] [eq:gap]

use super::Kinematics;
use super::basis::orthogonal_direction;
use crate::ir::{Program, Vector};
use crate::model::Gap;

/// r, b_i, orientation, r0 → n, L, g.
///
/// Signed: n = ± b_1×b_2/|b_1×b_2|, taken of b_1 and a_11 b_2 − a_12 b_1 so that n·b_1 vanishes to rounding even where
/// the tangents are nearly parallel [eq:orthogonal-basis]; in 2D ± (b_y, −b_x)/|b|, L = r·n. Distance: L = |r|, n = r/L.
/// Oriented: L = ± |r|, n = r/L. [eq:oriented]
/// The caller has made sure that the divisor is not zero.
pub fn gap_program(kinematics: &Kinematics) -> Program {
    let (d, p) = (kinematics.dimension, kinematics.projected());
    let mut program = Program::new("gap");
    let r = program.input_vector("r", d);
    let b: Vec<Vector> = (0..p)
        .map(|i| program.input_vector(&format!("b_{i}"), d))
        .collect();
    let orientation = program.input("orientation");
    let r0 = program.input("r0");
    let (n, distance) = if kinematics.gap == Gap::Signed {
        signed(&mut program, &r, &b, orientation)
    } else {
        let graph = &mut program.graph;
        let mut distance = r.norm(graph);
        if kinematics.gap == Gap::Oriented {
            distance = graph.multiply(orientation, distance);
        }
        let one = graph.constant(1.0);
        let inverse = graph.divide(one, distance);
        (r.scale(graph, inverse), distance)
    };
    let gap = program.graph.subtract(distance, r0);
    program.output_vector("n", &n);
    program.output("distance", distance);
    program.output("gap", gap);
    program
}

fn signed(
    program: &mut Program,
    r: &Vector,
    b: &[Vector],
    orientation: crate::ir::NodeId,
) -> (Vector, crate::ir::NodeId) {
    let graph = &mut program.graph;
    let normal = match b {
        [first, second] => {
            let across = orthogonal_direction(graph, first, second);
            first.cross(graph, &across)
        }
        [only] => Vector(vec![only.0[1], graph.negate(only.0[0])]),
        _ => unreachable!("a signed gap has one tangent in 2D and two in 3D"),
    };
    let length = normal.norm(graph);
    let factor = graph.divide(orientation, length);
    let n = normal.scale(graph, factor);
    let distance = r.dot(graph, &n);
    (n, distance)
}
