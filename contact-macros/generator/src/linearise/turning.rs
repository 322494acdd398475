//! The tangent of moments about two curves. [eq:rolling-tangent]

use super::Kinematics;
use super::curves::{Pair, signed};
use super::motion::{Motion, Variation};
use super::rolling::{Curves, NO_CURVATURE, NO_THIRD, NOT_TURNED};
use super::tangential::projection;
use crate::ir::{Graph, NodeId, Program, Vector};

/// The contact point, M_c, ∂M_c/∂φ_c, ∂M_c/∂p, N' → pairs A, B of A⊙B, then pairs of A⊗B. [eq:rolling-tangent]
pub fn tangent_program(kinematics: &Kinematics, curves: Curves) -> Program {
    let mut program = Program::new("rolling_tangent");
    let pair = Pair::new(&mut program, kinematics, curves);
    let moments = program.input_vector("moment", 2).0;
    let stiffness = program.input_vector("stiffness", 2).0;
    let by_pressure = program.input_vector("by_pressure", 2).0;
    let slope = program.input("slope");
    let moments = signed(&mut program.graph, &moments);
    let forms = Forms::new(&mut program.graph, kinematics, &pair);
    let mut symmetric = vec![distance(&mut program, &pair, &forms, &moments)];
    symmetric.extend(tilt(&mut program, &forms, &moments));
    symmetric.extend(reference(&mut program, &forms, &moments));
    symmetric.extend(transport(&mut program, &pair, &forms, &moments));
    let moved = moment(&mut program, &pair, &forms, &stiffness, &by_pressure, slope);
    for (k, [left, right]) in symmetric.iter().enumerate() {
        left.output(&mut program, &format!("symmetric_{k}_left"));
        right.output(&mut program, &format!("symmetric_{k}_right"));
    }
    for (k, [left, right]) in moved.iter().enumerate() {
        left.output(&mut program, &format!("moment_{k}_left"));
        right.output(&mut program, &format!("moment_{k}_right"));
    }
    program.settle_terms();
    program
}

/// Forms of the total variations of one curve.
struct Turning {
    /// Dψ
    angle: Motion,
    /// Forms of r: X_g, U_f, U_g.
    arm: Motion,
    tilt: Motion,
    swing: Motion,
    /// Forms of w: X_f, X_g, X_τ + ½ U_f, U_g.
    stretch: Motion,
    turn: Motion,
    axial: Motion,
    twist: Motion,
}

/// δζ^i, and the forms of both curves.
struct Forms {
    shifts: [Motion; 2],
    /// n·Dr
    approach: Motion,
    curves: [Turning; 2],
}

impl Forms {
    fn new(graph: &mut Graph, kinematics: &Kinematics, pair: &Pair) -> Self {
        let z = projection(graph, &pair.contact, kinematics);
        let axes = (pair.contact.frame.as_slice(), &pair.contact.n);
        let shifts = [0, 1].map(|i| Motion::of_parameter(graph, axes, &z, i));
        let [b1, b2] = &pair.tangents;
        let moved = [(b1, &shifts[0]), (b2, &shifts[1])];
        let position = Variation::new(graph, |form, _| &mut form.position, 0, &moved);
        let mut approach = Motion::zero(graph);
        approach.position = pair.contact.n.clone();
        let curves = [0, 1].map(|c| Turning::new(graph, pair, c, &position, &shifts[c]));
        Self {
            shifts,
            approach,
            curves,
        }
    }
}

impl Turning {
    fn new(graph: &mut Graph, pair: &Pair, c: usize, position: &Variation, shift: &Motion) -> Self {
        let curve = &pair.curves[c];
        let moved = [(&pair.second[c], shift)];
        let tangent = Variation::new(graph, |form, c| &mut form.turning[c], c, &moved);
        let reference = if pair.frenet {
            let moved = [(&pair.third[c], shift)];
            Variation::new(graph, |form, c| &mut form.bending[c], c, &moved)
        } else {
            Variation::none(graph)
        };
        let one = graph.constant(1.0);
        let arm = graph.divide(one, pair.contact.distance);
        let back = graph.negate(curve.slope);
        let relative = |graph: &mut Graph, a: &Vector| {
            let mut form = reference.along(graph, a);
            let other = tangent.along(graph, a);
            form.add_scaled(graph, back, &other);
            form.scaled(graph, curve.lever)
        };
        let of_tangent = |graph: &mut Graph, a: &Vector| {
            let form = tangent.along(graph, a);
            form.scaled(graph, curve.inverse)
        };
        let half = graph.constant(0.5);
        let along_normal = of_tangent(graph, &curve.normal);
        let mut axial = relative(graph, &curve.tau);
        axial.add_scaled(graph, half, &along_normal);
        let swept = position.along(graph, &curve.across);
        let swept = swept.scaled(graph, arm);
        let turn = relative(graph, &curve.binormal);
        let minus = graph.constant(-1.0);
        let mut angle = swept.clone();
        angle.add_scaled(graph, minus, &turn);
        Self {
            angle,
            arm: swept,
            tilt: of_tangent(graph, &pair.contact.n),
            swing: of_tangent(graph, &curve.across),
            stretch: relative(graph, &curve.normal),
            turn,
            axial,
            twist: of_tangent(graph, &curve.binormal),
        }
    }
}

/// −M̂_c X_f⊙X_g of r: X_f = n·Dr/L for both curves. [eq:rolling-distance]
fn distance(program: &mut Program, pair: &Pair, forms: &Forms, moments: &[NodeId]) -> [Motion; 2] {
    let moments = program.terms("rolling-distance", moments, "");
    let graph = &mut program.graph;
    let mut right = Motion::zero(graph);
    for (curve, &moment) in forms.curves.iter().zip(&moments) {
        let minus = graph.negate(moment);
        let factor = graph.divide(minus, pair.contact.distance);
        right.add_scaled(graph, factor, &curve.arm);
    }
    [forms.approach.clone(), right]
}

/// −M̂ (X_τ⊙U_g + ½ U_f⊙U_g) of r = ½ M̂ U_f⊙U_g, because r·u = 0 makes X_τ = −U_f. [eq:rolling-tilt]
fn tilt(program: &mut Program, forms: &Forms, moments: &[NodeId]) -> Vec<[Motion; 2]> {
    let moments = program.terms("rolling-tilt", moments, "");
    let graph = &mut program.graph;
    let half = graph.constant(0.5);
    let curves = forms.curves.iter().zip(moments);
    curves
        .map(|(curve, moment)| {
            let factor = graph.multiply(half, moment);
            [curve.tilt.scaled(graph, factor), curve.swing.clone()]
        })
        .collect()
}

/// M̂ (X_f⊙X_g + (X_τ + ½ U_f)⊙U_g) of w. [eq:rolling-normal] [eq:rolling-twist]
fn reference(program: &mut Program, forms: &Forms, moments: &[NodeId]) -> Vec<[Motion; 2]> {
    let normal = program.terms("rolling-normal", moments, "");
    let twist = program.terms("rolling-twist", moments, "");
    let graph = &mut program.graph;
    let mut pairs = Vec::new();
    for (c, curve) in forms.curves.iter().enumerate() {
        pairs.push([curve.stretch.scaled(graph, normal[c]), curve.turn.clone()]);
        pairs.push([curve.axial.scaled(graph, twist[c]), curve.twist.clone()]);
    }
    pairs
}

/// δζ^i ⊙ M̂_c (p_r·δr_,i + ½ p_r·r_,ii δζ^i) + δζ^i ⊙ M̂_i (p_u·δr_,ii + p_w·δr_,iii + ½ p_u·r_,iii δζ^i):
/// the second variations of r, u, w without D²ζ. [eq:rolling-arm-turn] [eq:rolling-arm-curvature]
/// [eq:rolling-axis-turn] [eq:rolling-axis-curvature] [eq:rolling-bend-turn]
fn transport(
    program: &mut Program,
    pair: &Pair,
    forms: &Forms,
    moments: &[NodeId],
) -> Vec<[Motion; 2]> {
    let arm = program.terms("rolling-arm-turn", moments, "");
    let curvature = program.terms("rolling-arm-curvature", moments, NO_CURVATURE);
    let axis = program.terms("rolling-axis-turn", moments, NO_CURVATURE);
    let third = program.terms("rolling-axis-curvature", moments, NO_THIRD);
    let bend = program.terms(
        "rolling-bend-turn",
        moments,
        if pair.frenet { NO_THIRD } else { NOT_TURNED },
    );
    let graph = &mut program.graph;
    let half = graph.constant(0.5);
    (0..2)
        .map(|i| {
            let mut form = Motion::zero(graph);
            let mut own = graph.constant(0.0);
            for (c, curve) in pair.curves.iter().enumerate() {
                let lever = curve.by_position.scale(graph, arm[c]);
                form.turning[i] = form.turning[i].add(graph, &lever);
                let bent = curve.by_position.dot(graph, &pair.second[i]);
                let bent = graph.multiply(curvature[c], bent);
                own = graph.add(own, bent);
            }
            let curve = &pair.curves[i];
            if pair.bends[i] {
                form.bending[i] = curve.by_tangent.scale(graph, axis[i]);
            }
            let bent = curve.by_tangent.dot(graph, &pair.third[i]);
            let bent = graph.multiply(third[i], bent);
            own = graph.add(own, bent);
            if pair.frenet && pair.twists[i] {
                form.third[i] = curve.by_reference.scale(graph, bend[i]);
            }
            let own = graph.multiply(half, own);
            form.add_scaled(graph, own, &forms.shifts[i]);
            [form, forms.shifts[i].clone()]
        })
        .collect()
}

/// Dφ_c ⊗ (∂M_c/∂φ_c Dφ_c + ∂M_c/∂p Δp), Δp = −N' n·Δr. [eq:rolling-stiffness] [eq:rolling-pressure]
fn moment(
    program: &mut Program,
    pair: &Pair,
    forms: &Forms,
    stiffness: &[NodeId],
    by_pressure: &[NodeId],
    slope: NodeId,
) -> Vec<[Motion; 2]> {
    let stiffness = program.terms("rolling-stiffness", stiffness, "");
    let by_pressure = program.terms("rolling-pressure", by_pressure, "");
    let graph = &mut program.graph;
    let by_pressure = signed(graph, &by_pressure);
    let minus = graph.negate(slope);
    (0..2)
        .map(|c| {
            let angle = &forms.curves[c].angle;
            let mut right = angle.scaled(graph, stiffness[c]);
            let factor = graph.multiply(by_pressure[c], minus);
            let pressed = pair.contact.n.scale(graph, factor);
            right.position = right.position.add(graph, &pressed);
            [angle.clone(), right]
        })
        .collect()
}
