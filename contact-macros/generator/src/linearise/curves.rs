//! Two curves at their contact point: the triads about their tangents and the derivatives of their angles.
//! [eq:rolling-angle]

use super::Kinematics;
use super::contact::Contact;
use super::rolling::Curves;
use crate::ir::{Graph, NodeId, Program, Vector};
use crate::model::Reference;

/// σ_c: the shortest distance leaves curve c along −σ_c n.
pub(super) const SIGNS: [f64; 2] = [1.0, -1.0];

/// One curve's triads and derivatives of its angle ψ.
pub(super) struct Curve {
    /// 1/|u|
    pub(super) inverse: NodeId,
    pub(super) tau: Vector,
    /// g of r: τ×n.
    pub(super) across: Vector,
    /// f, g of w.
    pub(super) normal: Vector,
    pub(super) binormal: Vector,
    /// 1/h of w.
    pub(super) lever: NodeId,
    /// c/|u| of w.
    pub(super) slope: NodeId,
    /// ∂ψ/∂r, ∂ψ/∂u, ∂ψ/∂w.
    pub(super) by_position: Vector,
    pub(super) by_tangent: Vector,
    pub(super) by_reference: Vector,
}

/// g = u×w/|u×w|, f = g×τ: no cancellation where w is nearly along u.
pub(super) fn triad(graph: &mut Graph, u: &Vector, w: &Vector) -> [(Vector, NodeId); 2] {
    let one = graph.constant(1.0);
    let length = u.norm(graph);
    let inverse = graph.divide(one, length);
    let tau = u.scale(graph, inverse);
    let area = u.cross(graph, w);
    let size = area.norm(graph);
    let inverse_size = graph.divide(one, size);
    let binormal = area.scale(graph, inverse_size);
    [(tau, inverse), (binormal, size)]
}

impl Curve {
    pub(super) fn new(
        graph: &mut Graph,
        n: &Vector,
        distance: NodeId,
        u: &Vector,
        w: &Vector,
    ) -> Self {
        let one = graph.constant(1.0);
        let [(tau, inverse), (binormal, area)] = triad(graph, u, w);
        let normal = binormal.cross(graph, &tau);
        let length = u.norm(graph);
        let lever = graph.divide(length, area);
        let along = w.dot(graph, &tau);
        let slope = graph.multiply(along, inverse);
        let across = tau.cross(graph, n);
        let arm = graph.divide(one, distance);
        let minus = graph.negate(lever);
        let tilt = graph.multiply(slope, lever);
        Self {
            by_position: across.scale(graph, arm),
            by_tangent: binormal.scale(graph, tilt),
            by_reference: binormal.scale(graph, minus),
            inverse,
            tau,
            across,
            normal,
            binormal,
            lever,
            slope,
        }
    }
}

/// w_c as inputs: r_,cc, or σ_c times the director.
pub(super) fn references(program: &mut Program, reference: Reference) -> [Vector; 2] {
    [0, 1].map(|c| match reference {
        Reference::PrincipalNormal => program.input_vector(&format!("w_{c}"), 3),
        Reference::Director => {
            let director = program.input_vector(&format!("director_{c}"), 3);
            let sign = program.graph.constant(SIGNS[c]);
            director.scale(&mut program.graph, sign)
        }
    })
}

/// The contact point with both curves.
pub(super) struct Pair {
    pub(super) contact: Contact,
    pub(super) curves: [Curve; 2],
    pub(super) tangents: [Vector; 2],
    /// r_,cc and r_,ccc.
    pub(super) second: [Vector; 2],
    pub(super) third: [Vector; 2],
    /// Which of them can be non-zero, and with them the rows s_A,cc and s_A,ccc.
    pub(super) bends: [bool; 2],
    pub(super) twists: [bool; 2],
    pub(super) frenet: bool,
}

impl Pair {
    /// n, L, b_i, r_,ij, E, r_,ijk and, where given, the directors.
    pub(super) fn new(program: &mut Program, kinematics: &Kinematics, curves: Curves) -> Self {
        let contact = Contact::new(program, kinematics);
        let graph = &mut program.graph;
        let none = Vector::zero(graph, 3);
        let tangents = [0, 1].map(|c| named(program, &format!("b_{c}")));
        let second = [0, 1].map(|c| match kinematics.curved[2 * c] {
            true => named(program, &format!("r_{}", 2 * c)),
            false => none.clone(),
        });
        let third: Vec<Vector> = (0..4)
            .map(|k| program.input_vector(&format!("third_{k}"), 3))
            .collect();
        let third = [0, 1].map(|c| match curves.third[c] {
            true => third[3 * c].clone(),
            false => none.clone(),
        });
        let frenet = curves.reference == Reference::PrincipalNormal;
        let twists = curves.third;
        let references = match curves.reference {
            Reference::PrincipalNormal => second.clone(),
            Reference::Director => references(program, curves.reference),
        };
        let distance = contact.distance;
        let graph = &mut program.graph;
        let curves =
            [0, 1].map(|c| Curve::new(graph, &contact.n, distance, &tangents[c], &references[c]));
        Self {
            contact,
            curves,
            tangents,
            second,
            third,
            bends: [kinematics.curved[0], kinematics.curved[2]],
            twists,
            frenet,
        }
    }
}

/// The inputs `name_0 …` that exist already.
pub(super) fn named(program: &mut Program, name: &str) -> Vector {
    let first = format!("{name}_0");
    let at = program.inputs.iter().position(|input| *input == first);
    let at = at.expect("an input of the contact point");
    Vector((at..at + 3).map(|k| program.graph.input(k)).collect())
}

/// σ_c x_c
pub(super) fn signed(graph: &mut Graph, values: &[NodeId]) -> Vec<NodeId> {
    let pairs = values.iter().zip(SIGNS);
    pairs
        .map(|(&value, sign)| {
            let sign = graph.constant(sign);
            graph.multiply(sign, value)
        })
        .collect()
}
