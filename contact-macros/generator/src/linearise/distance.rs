//! Rigid distance functions d(x): no projection at all. [eq:distance]
//!
//! g = ±d − r0, δg = n·δr with n = ±∇d, D²g = ±δr·∇∇d·Δr. The generator derives gradient and Hessian of the
//! declared function.

use super::basis::upper_index;
use crate::ir::{NodeId, Program, Scope, Vector, differentiate, lower};
use crate::model::{Body, Geometry};

/// x, parameters, orientation, r0 → n = ±∇d, distance ±d, gap.
pub fn gap_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("gap");
    let (value, x) = lowered(&mut program, geometry);
    let orientation = program.input("orientation");
    let r0 = program.input("r0");
    let gradient = gradient(&mut program, value, x.0.len());
    let graph = &mut program.graph;
    let n = gradient.scale(graph, orientation);
    let distance = graph.multiply(orientation, value);
    let gap = graph.subtract(distance, r0);
    program.output_vector("n", &n);
    program.output("distance", distance);
    program.output("gap", gap);
    program
}

/// x, parameters, orientation, N, N' → p = N' n⊗n ± N ∇∇d. [eq:12-main] [eq:distance-curvature]
pub fn tangent_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("tangent");
    let (value, x) = lowered(&mut program, geometry);
    let orientation = program.input("orientation");
    let traction = program.input("traction");
    let slope = program.input("slope");
    let d = x.0.len();
    let gradient = gradient(&mut program, value, d);
    let square = program.graph.multiply(orientation, orientation);
    let main = program.graph.multiply(slope, square);
    let main = program.term("12-main", main, "");
    let signed = program.graph.multiply(orientation, traction);
    let curvature = program.term(
        "distance-curvature",
        signed,
        "the distance function is linear",
    );
    let mut entries: Vec<NodeId> = Vec::new();
    for k in 0..d {
        for l in k..d {
            let second = differentiate(&mut program.graph, gradient.0[k], l);
            let graph = &mut program.graph;
            let product = graph.multiply(gradient.0[k], gradient.0[l]);
            let stretch = graph.multiply(main, product);
            let bend = graph.multiply(curvature, second);
            entries.push(graph.add(stretch, bend));
        }
    }
    for k in 0..d {
        for l in 0..d {
            program.output(format!("p_{k}_{l}"), entries[upper_index(d, k, l)]);
        }
    }
    program.settle_terms();
    program
}

/// The declared distance at the inputs x, parameters.
fn lowered(program: &mut Program, geometry: &Geometry) -> (NodeId, Vector) {
    let mut scope = Scope::default();
    let mut x = Vec::new();
    for name in &geometry.coordinates {
        let node = program.input(name.to_string());
        scope.define(name, node);
        x.push(node);
    }
    for parameter in &geometry.parameters {
        let node = program.input(parameter.name.to_string());
        scope.define(&parameter.name, node);
    }
    let Body::Distance { value } = &geometry.body else {
        unreachable!("called for distance functions only")
    };
    scope.bind(&mut program.graph, &geometry.bindings);
    let value = lower(&mut program.graph, &scope, value);
    (value, Vector(x))
}

fn gradient(program: &mut Program, value: NodeId, d: usize) -> Vector {
    Vector(
        (0..d)
            .map(|k| differentiate(&mut program.graph, value, k))
            .collect(),
    )
}
