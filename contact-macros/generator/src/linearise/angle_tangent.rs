//! Tangent of contact weighted by the angle, beyond w (N' δg Δg + N D²g). [eq:angle-tangent]
//!
//! ```text
//! K    = w' N (δg Δq + δq Δg) + W w'' δq Δq + W w' D²q ,   D²q = −2 δc Δc − 2c D²c
//! D²c  = Σ_c [ a_c·D²u_c/|u_c| − T_c⊙A_c − c x_c·x_c ] + x_1⊙x_2
//! D²u_c = δr_,cc⊙δζ^c + r_,ccc δζ^c Δζ^c + r_,cc D²ζ^c
//! ```
//!
//! U_c = Du_c/|u_c|, T_c = τ_c·U_c, A_c = a_c·U_c, x_c = U_c − τ_c T_c, A⊙B = A⊗B + B⊗A. The program gives pairs A, B of A⊙B.

use super::angle::{Bends, NO_CURVATURE, Pair};
use super::motion::Motion;
use crate::ir::{Graph, NodeId, Program, Vector};

const NO_THIRD: &str = "no projected curve has a third derivative";

/// Number of pairs with `p` projected parameters.
pub const fn pairs(p: usize) -> usize {
    10 + p
}

/// The contact point, N, W, w', w'' → pairs A, B of A⊙B. [eq:angle-tangent]
pub fn tangent_program(bends: &Bends) -> Program {
    let mut program = Program::new("angle_tangent");
    let pair = Pair::new(&mut program, bends, true);
    let slope = program.input("weight_slope");
    let energy = program.input("energy");
    let curvature = program.input("weight_curvature");
    let traction = program.input("traction");
    let graph = &mut program.graph;
    let factor = graph.multiply(energy, slope);
    let lever = pair.by_cosine(graph, factor);
    let turns = [0, 1].map(|c| Turn::new(graph, &pair, c));
    let cosine = first_variation(graph, &turns);
    let mut forms = vec![main(
        &mut program,
        &pair,
        cosine,
        [slope, curvature, traction, energy],
    )];
    // −½ c e: A⊙A is 2 A⊗A
    let graph = &mut program.graph;
    let half = graph.constant(-0.5);
    let own = graph.multiply(half, pair.cosine);
    let own = graph.multiply(own, lever);
    let slave = program.term("angle-slave-turn", own, "");
    let master = program.term("angle-master-turn", own, "");
    forms.extend(stretch(&mut program, &turns, lever, slave));
    forms.extend(turn(&mut program, &turns, lever, [slave, master]));
    forms.extend(second_variation(&mut program, &pair, lever));
    for (k, [left, right]) in forms.iter().enumerate() {
        left.output_lower(&mut program, &format!("left_{k}"));
        right.output_lower(&mut program, &format!("right_{k}"));
    }
    program.settle_terms();
    program
}

/// Forms of the total variation of one unit tangent.
struct Turn {
    /// T_c
    along: Motion,
    /// A_c
    across: Motion,
    /// n·x_c and (n×τ_2)·x_c; the rest of x_1 is A_1 τ_2, x_2 has no more.
    sideways: [Motion; 2],
}

impl Turn {
    fn new(graph: &mut Graph, pair: &Pair, c: usize) -> Self {
        let curve = &pair.curves[c];
        // a·Du_c/|u_c|
        let of = |graph: &mut Graph, a: &Vector| {
            let mut form = Motion::zero(graph);
            form.turning[c] = a.scale(graph, curve.inverse);
            let bent = a.dot(graph, &curve.second);
            let bent = graph.multiply(bent, curve.inverse);
            form.add_scaled(graph, bent, &curve.shift);
            form
        };
        let along = of(graph, &curve.tau);
        let across = of(graph, &curve.across);
        let last = &pair.curves[1].tau;
        let axes = [pair.n.clone(), pair.n.cross(graph, last)];
        let sideways = axes.map(|axis| {
            let share = axis.dot(graph, &curve.tau);
            let back = curve.tau.scale(graph, share);
            let minus = graph.constant(-1.0);
            let back = back.scale(graph, minus);
            let part = axis.add(graph, &back);
            of(graph, &part)
        });
        Self {
            along,
            across,
            sideways,
        }
    }
}

/// δc = A_1 + A_2
fn first_variation(graph: &mut Graph, turns: &[Turn; 2]) -> Motion {
    let one = graph.constant(1.0);
    let mut form = turns[0].across.clone();
    form.add_scaled(graph, one, &turns[1].across);
    form
}

/// δc ⊙ (−2c w' N δg + 2c² W w'' Δc − W w' Δc) [eq:angle-force] [eq:angle-bend] [eq:angle-square]
fn main(
    program: &mut Program,
    pair: &Pair,
    cosine: Motion,
    [slope, curvature, traction, energy]: [NodeId; 4],
) -> [Motion; 2] {
    let graph = &mut program.graph;
    let force = graph.multiply(traction, slope);
    let force = pair.by_cosine(graph, force);
    let bend = graph.multiply(energy, curvature);
    let bend = pair.by_cosine(graph, bend);
    let minus = graph.negate(pair.cosine);
    let bend = graph.multiply(minus, bend);
    let square = graph.multiply(energy, slope);
    let square = graph.negate(square);
    let force = program.term("angle-force", force, "");
    let bend = program.term("angle-bend", bend, "");
    let square = program.term("angle-square", square, "");
    let graph = &mut program.graph;
    let both = graph.add(bend, square);
    let mut right = cosine.scaled(graph, both);
    let pressed = pair.n.scale(graph, force);
    right.position = right.position.add(graph, &pressed);
    [cosine, right]
}

/// −e A_c⊙T_c, and what of −e c x_1·x_1 lies along τ_2: −e c A_1⊗A_1. [eq:angle-stretch] [eq:angle-slave-turn]
fn stretch(
    program: &mut Program,
    turns: &[Turn; 2],
    lever: NodeId,
    own: NodeId,
) -> [[Motion; 2]; 2] {
    let minus = program.graph.negate(lever);
    let stretch = program.term("angle-stretch", minus, "");
    let graph = &mut program.graph;
    [0, 1].map(|c| {
        let Turn { along, across, .. } = &turns[c];
        let mut right = along.scaled(graph, stretch);
        if c == 0 {
            right.add_scaled(graph, own, across);
        }
        [across.clone(), right]
    })
}

/// e (x_1⊙x_2 − c x_1·x_1 − c x_2·x_2) along n and n×τ_2. [eq:angle-slave-turn] [eq:angle-master-turn]
/// [eq:angle-mutual-turn]
fn turn(
    program: &mut Program,
    turns: &[Turn; 2],
    lever: NodeId,
    [slave, master]: [NodeId; 2],
) -> Vec<[Motion; 2]> {
    let mutual = program.term("angle-mutual-turn", lever, "");
    let graph = &mut program.graph;
    let mut pairs = Vec::new();
    for axis in 0..2 {
        let [first, last] = [0, 1].map(|c| &turns[c].sideways[axis]);
        let mut right = last.scaled(graph, mutual);
        right.add_scaled(graph, slave, first);
        pairs.push([first.clone(), right]);
        pairs.push([last.clone(), last.scaled(graph, master)]);
    }
    pairs
}

/// e a_c·D²u_c/|u_c|: the part with δζ^c, and the part of D²ζ^c without it.
fn second_variation(program: &mut Program, pair: &Pair, lever: NodeId) -> Vec<[Motion; 2]> {
    let transport = program.term("angle-transport", lever, NO_CURVATURE);
    let third = program.term("angle-third", lever, NO_THIRD);
    let shift = program.term("angle-shift", lever, NO_CURVATURE);
    let graph = &mut program.graph;
    let half = graph.constant(0.5);
    let mut own = Vec::new();
    let mut force = Vec::new();
    for &c in &pair.projected {
        let curve = &pair.curves[c];
        let mut form = Motion::zero(graph);
        if !curve.second.vanishes(graph) {
            let scale = graph.multiply(transport, curve.inverse);
            form.bending[c] = curve.across.scale(graph, scale);
        }
        let bent = curve.bend(graph, &curve.third);
        let bent = graph.multiply(third, bent);
        let bent = graph.multiply(half, bent);
        form.add_scaled(graph, bent, &curve.shift);
        own.push(form);
        let bent = curve.bend(graph, &curve.second);
        force.push(graph.multiply(shift, bent));
    }
    // τ^i = m^ij T_j
    let raised: Vec<NodeId> = pair
        .m
        .iter()
        .map(|row| product(graph, row, &force))
        .collect();
    let moved = projection(program, pair, &raised);
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    let mut pairs = cross(program, pair, &raised);
    let graph = &mut program.graph;
    for ((k, mut form), moved) in own.into_iter().enumerate().zip(moved) {
        form.add_scaled(graph, one, &moved);
        pairs.push([pair.curves[pair.projected[k]].shift.clone(), form]);
    }
    pairs
}

fn product(graph: &mut Graph, row: &[NodeId], column: &[NodeId]) -> NodeId {
    let mut sum = graph.constant(0.0);
    for (&a, &b) in row.iter().zip(column) {
        let part = graph.multiply(a, b);
        sum = graph.add(sum, part);
    }
    sum
}

/// −τ^i (δr·Δr_,i + δr_,i·Δr), one pair per axis of space. [eq:cross]
fn cross(program: &mut Program, pair: &Pair, raised: &[NodeId]) -> Vec<[Motion; 2]> {
    let raised = program.terms("cross", raised, NO_CURVATURE);
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    (0..3)
        .map(|k| {
            let mut left = Motion::zero(graph);
            left.position.0[k] = one;
            let mut right = Motion::zero(graph);
            for (i, &c) in pair.projected.iter().enumerate() {
                right.turning[c].0[k] = graph.negate(raised[i]);
            }
            [left, right]
        })
        .collect()
}

/// −τ^i (Q_ik + ½ Y_ijk δζ^j), the forms beside δζ^k. [eq:Q] [eq:Y]
fn projection(program: &mut Program, pair: &Pair, raised: &[NodeId]) -> Vec<Motion> {
    let position = program.terms("Q-position", raised, NO_CURVATURE);
    let tangent = program.terms("Q-tangent", raised, NO_CURVATURE);
    let turning = program.terms("Q-turning", raised, NO_CURVATURE);
    let bending = program.terms("Q-bending", raised, NO_CURVATURE);
    let second = program.terms("Y-second", raised, NO_CURVATURE);
    let third = program.terms("Y-third", raised, NO_THIRD);
    let graph = &mut program.graph;
    let minus = graph.constant(-1.0);
    let mut whole = Vector::zero(graph, 3);
    for (b, &factor) in pair.tangents.iter().zip(&tangent) {
        let part = b.scale(graph, factor);
        whole = whole.add(graph, &part);
    }
    (0..raised.len())
        .map(|k| {
            let own = pair.projected[k];
            let curve = &pair.curves[own];
            let mut form = Motion::zero(graph);
            form.position = curve.second.scale(graph, position[k]);
            form.turning[own] = whole.clone();
            for (i, &c) in pair.projected.iter().enumerate() {
                let part = pair.tangents[k].scale(graph, turning[i]);
                form.turning[c] = form.turning[c].add(graph, &part);
            }
            if !curve.second.vanishes(graph) {
                form.bending[own] = pair.r.scale(graph, bending[k]);
            }
            for j in 0..raised.len() {
                let half = half_of_y(graph, pair, (&second, &third), (j, k));
                form.add_scaled(graph, half, &pair.curves[pair.projected[j]].shift);
            }
            form.scaled(graph, minus)
        })
        .collect()
}

/// ½ τ^i Y_ijk: Y_iii = 3 r_,ii·b_i + r·r_,iii, Y_iij = r_,ii·b_j. [eq:Y-second] [eq:Y-third]
fn half_of_y(
    graph: &mut Graph,
    pair: &Pair,
    (second, third): (&[NodeId], &[NodeId]),
    (j, k): (usize, usize),
) -> NodeId {
    let half = graph.constant(0.5);
    let bent = |graph: &mut Graph, i: usize, b: usize| {
        let curve = &pair.curves[pair.projected[i]];
        curve.second.dot(graph, &pair.tangents[b])
    };
    let mut sum = graph.constant(0.0);
    for i in 0..second.len() {
        let value = match (i == j, i == k) {
            (true, true) => {
                let three = graph.constant(3.0);
                let value = bent(graph, i, i);
                graph.multiply(three, value)
            }
            (true, false) => bent(graph, i, k),
            (false, true) => bent(graph, i, j),
            (false, false) => bent(graph, j, i),
        };
        let part = graph.multiply(second[i], value);
        sum = graph.add(sum, part);
    }
    if j == k {
        let curve = &pair.curves[pair.projected[k]];
        let value = pair.r.dot(graph, &curve.third);
        let part = graph.multiply(third[k], value);
        sum = graph.add(sum, part);
    }
    graph.multiply(half, sum)
}
