//! Tangential laws: stiffness and bound as declared, and the force beyond the bound. [eq:trial]
//! [eq:return-map] [eq:ellipse]
//!
//! Components along the orthonormal axes d_1, d_2 of the frame; one of them where p = 1.

use crate::ir::{Graph, NodeId, Program, Scope, differentiate, lower};
use crate::model::TangentialLaw;

/// p, slip, parameters → e_q, and with a bound B_q, ∂B_q/∂p, ∂B_q/∂slip. [eq:trial] [eq:bound]
pub fn friction_program(law: &TangentialLaw) -> Program {
    let mut program = Program::new("friction");
    let mut scope = Scope::default();
    for name in [&law.pressure, &law.slip] {
        let node = program.input(name.to_string());
        scope.define(name, node);
    }
    for parameter in &law.parameters {
        let node = program.input(parameter.name.to_string());
        scope.define(&parameter.name, node);
    }
    scope.bind(&mut program.graph, &law.bindings);
    let mut values = |expressions: &[crate::model::Expr]| -> Vec<NodeId> {
        let lowered = expressions
            .iter()
            .map(|expression| lower(&mut program.graph, &scope, expression));
        lowered.collect()
    };
    let (stiffness, bound) = (values(&law.stiffness), values(&law.bound));
    let by = |program: &mut Program, input: usize| -> Vec<NodeId> {
        let slopes = bound
            .iter()
            .map(|&bound| differentiate(&mut program.graph, bound, input));
        slopes.collect()
    };
    let (by_pressure, by_slip) = (by(&mut program, 0), by(&mut program, 1));
    let none = "the bound does not depend on it";
    for (name, tag, values) in [
        ("stiffness", "trial-stiffness", stiffness),
        ("bound", "bound-value", bound),
        ("by_pressure", "bound-by-pressure", by_pressure),
        ("by_slip", "bound-by-slip", by_slip),
    ] {
        let values = program.terms(tag, &values, none);
        for (q, value) in values.into_iter().enumerate() {
            program.output(format!("{name}_{q}"), value);
        }
    }
    program.settle_terms();
    program
}

/// Inputs of the sliding programs.
struct Sliding {
    slip: [NodeId; 2],
    stiffness: Vec<NodeId>,
    bound: Vec<NodeId>,
    by_pressure: Vec<NodeId>,
    by_slip: Vec<NodeId>,
}

fn inputs(program: &mut Program, axes: usize) -> Sliding {
    let mut values = |name: &str, count: usize| program.input_vector(name, count).0;
    let slip = values("s", 2);
    Sliding {
        slip: [slip[0], slip[1]],
        stiffness: values("stiffness", axes),
        bound: values("bound", axes),
        by_pressure: values("by_pressure", axes),
        by_slip: values("by_slip", axes),
    }
}

/// Beyond the bound: s_q, e_q, B_q and its slopes (and γ of the ellipse) → t_q, ∂t_q/∂s_r, ∂t_q/∂p.
pub fn sliding_program(law: &TangentialLaw) -> Program {
    if law.stiffness.len() == 1 {
        isotropic()
    } else {
        orthotropic()
    }
}

/// t = B u with u = s/|s|. [eq:return-map]
fn isotropic() -> Program {
    let mut program = Program::new("sliding");
    let sliding = inputs(&mut program, 1);
    let graph = &mut program.graph;
    let length = norm(graph, sliding.slip);
    let unit = sliding.slip.map(|s| graph.divide(s, length));
    let bound = program.term("sliding-traction", sliding.bound[0], "");
    let traction = unit.map(|u| program.graph.multiply(bound, u));
    let ratio = program.graph.divide(sliding.bound[0], length);
    let ratio = program.term("sliding-direction", ratio, "");
    let softening = program.term("sliding-path", sliding.by_slip[0], "");
    let pressure = program.term("sliding-pressure", sliding.by_pressure[0], "");
    let graph = &mut program.graph;
    // I − u⊗u = u'⊗u' with u' = (−u_2, u_1): nothing cancels
    let back = graph.negate(unit[1]);
    let across = [back, unit[0]];
    let mut stiffness = Vec::new();
    for q in 0..2 {
        for r in 0..2 {
            let turn = graph.multiply(across[q], across[r]);
            let turn = graph.multiply(ratio, turn);
            let along = graph.multiply(unit[q], unit[r]);
            let along = graph.multiply(softening, along);
            stiffness.push(graph.add(turn, along));
        }
    }
    let by_pressure = unit.map(|u| graph.multiply(pressure, u));
    finish(program, traction, stiffness, by_pressure)
}

/// The values of an ellipse at γ.
struct Ellipse {
    sliding: Sliding,
    /// k_q: e_q/B_q² scaled so that k_1 k_2 = 1.
    factor: [NodeId; 2],
    /// 1/(1 + γ k_q)
    shrink: [NodeId; 2],
    /// z_q = t_q/B_q: a point of the unit circle.
    point: [NodeId; 2],
    gamma: NodeId,
    /// Σ z_q² k_q/(1 + γ k_q)
    slope: NodeId,
}

/// t_q = B_q z_q, z_q = (e_q s_q/B_q)/(1 + γ k_q), |z| = 1: the closest point in the energy norm.
/// [eq:ellipse]
fn orthotropic() -> Program {
    let mut program = Program::new("sliding");
    let sliding = inputs(&mut program, 2);
    let gamma = program.input("gamma");
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    let ratio = graph.divide(sliding.stiffness[0], sliding.stiffness[1]);
    let ratio = graph.unary(crate::ir::Unary::Sqrt, ratio);
    let bounds = graph.divide(sliding.bound[1], sliding.bound[0]);
    let first = graph.multiply(ratio, bounds);
    let factor = [first, graph.divide(one, first)];
    let shrink = factor.map(|k| {
        let step = graph.multiply(gamma, k);
        let sum = graph.add(one, step);
        graph.divide(one, sum)
    });
    let mut point = [one; 2];
    let mut slope = graph.constant(0.0);
    for q in 0..2 {
        let trial = graph.multiply(sliding.stiffness[q], sliding.slip[q]);
        let trial = graph.divide(trial, sliding.bound[q]);
        point[q] = graph.multiply(trial, shrink[q]);
        let square = graph.multiply(point[q], point[q]);
        let part = graph.multiply(factor[q], shrink[q]);
        let part = graph.multiply(square, part);
        slope = graph.add(slope, part);
    }
    let ellipse = Ellipse {
        sliding,
        factor,
        shrink,
        point,
        gamma,
        slope,
    };
    on_ellipse(program, &ellipse)
}

fn on_ellipse(mut program: Program, ellipse: &Ellipse) -> Program {
    let Sliding {
        slip,
        stiffness,
        bound,
        by_pressure,
        by_slip,
    } = &ellipse.sliding;
    let scale = program.terms("sliding-traction", bound, "");
    let traction = [0, 1].map(|q| program.graph.multiply(scale[q], ellipse.point[q]));
    let elastic = program.terms("sliding-direction", stiffness, "");
    let path = program.terms("sliding-path", by_slip, "");
    let pressure = program.terms("sliding-pressure", by_pressure, "");
    let graph = &mut program.graph;
    let zero = graph.constant(0.0);
    let length = norm(graph, *slip);
    let mut columns = Vec::new();
    for r in 0..2 {
        let unit = graph.divide(slip[r], length);
        let bound_change = [0, 1].map(|q| graph.multiply(path[q], unit));
        let mut trial_change = [zero; 2];
        trial_change[r] = elastic[r];
        columns.push(change(graph, ellipse, trial_change, bound_change));
    }
    let by_pressure = change(graph, ellipse, [zero; 2], [pressure[0], pressure[1]]);
    let rows = vec![columns[0][0], columns[1][0], columns[0][1], columns[1][1]];
    finish(program, traction, rows, by_pressure)
}

/// Change of t_q for changes of the trial force e_q s_q and of the bounds B_q. [eq:ellipse-slope]
fn change(
    graph: &mut Graph,
    ellipse: &Ellipse,
    trial: [NodeId; 2],
    bound: [NodeId; 2],
) -> [NodeId; 2] {
    let relative = [0, 1].map(|q| graph.divide(bound[q], ellipse.sliding.bound[q]));
    // dk_1/k_1 = dB_2/B_2 − dB_1/B_1 = −dk_2/k_2
    let spread = graph.subtract(relative[1], relative[0]);
    let spreads = [spread, graph.negate(spread)];
    // at fixed γ: dz_q = (dt_q/B_q)/(1 + γ k_q) − z_q (dB_q/B_q + γ dk_q/(1 + γ k_q))
    let fixed = [0, 1].map(|q| {
        let first = graph.divide(trial[q], ellipse.sliding.bound[q]);
        let first = graph.multiply(first, ellipse.shrink[q]);
        let step = graph.multiply(ellipse.gamma, ellipse.factor[q]);
        let step = graph.multiply(step, ellipse.shrink[q]);
        let step = graph.multiply(step, spreads[q]);
        let sum = graph.add(relative[q], step);
        let second = graph.multiply(ellipse.point[q], sum);
        graph.subtract(first, second)
    });
    // dγ keeps the point on the circle: z·dz = 0
    let mut along = graph.constant(0.0);
    for q in 0..2 {
        let part = graph.multiply(ellipse.point[q], fixed[q]);
        along = graph.add(along, part);
    }
    let step = graph.divide(along, ellipse.slope);
    [0, 1].map(|q| {
        let back = graph.multiply(ellipse.factor[q], ellipse.shrink[q]);
        let back = graph.multiply(back, ellipse.point[q]);
        let back = graph.multiply(back, step);
        let turned = graph.subtract(fixed[q], back);
        let turned = graph.multiply(ellipse.sliding.bound[q], turned);
        let grown = graph.multiply(ellipse.point[q], bound[q]);
        graph.add(turned, grown)
    })
}

fn norm(graph: &mut Graph, slip: [NodeId; 2]) -> NodeId {
    crate::ir::Vector(slip.to_vec()).norm(graph)
}

fn finish(
    mut program: Program,
    traction: [NodeId; 2],
    stiffness: Vec<NodeId>,
    by_pressure: [NodeId; 2],
) -> Program {
    for (q, value) in traction.into_iter().enumerate() {
        program.output(format!("t_{q}"), value);
    }
    for (index, value) in stiffness.into_iter().enumerate() {
        program.output(format!("c_{}_{}", index / 2, index % 2), value);
    }
    for (q, value) in by_pressure.into_iter().enumerate() {
        program.output(format!("h_{q}"), value);
    }
    program.settle_terms();
    program
}
