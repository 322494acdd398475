//! Jacobian of the slave at an integration point and its variation. [eq:measure]

use crate::ir::{Program, Vector};

/// t_i (tangents of the slave) → J; with `variation` also ∂J/∂t_i.
///
/// Curve: J = |t|, ∂J/∂t = t/J. Surface: J = |t_1×t_2|, ν = t_1×t_2/J, ∂J/∂t_1 = t_2×ν, ∂J/∂t_2 = ν×t_1.
pub fn measure_program(dimension: usize, parameters: usize, variation: bool) -> Program {
    let name = if variation {
        "measure_current"
    } else {
        "measure_reference"
    };
    let mut program = Program::new(name);
    let t: Vec<Vector> = (0..parameters)
        .map(|i| program.input_vector(&format!("t_{i}"), dimension))
        .collect();
    let area = match t.as_slice() {
        [only] => only.clone(),
        [first, second] => first.cross(&mut program.graph, second),
        _ => unreachable!("a slave with a measure is a curve or a surface"),
    };
    let jacobian = area.norm(&mut program.graph);
    program.output("jacobian", jacobian);
    if variation {
        let one = program.graph.constant(1.0);
        let inverse = program.graph.divide(one, jacobian);
        for (i, slope) in slopes(&mut program, &t, &area).into_iter().enumerate() {
            let tag = ["measure-variation-1", "measure-variation-2"][i];
            let coefficient = program.term(tag, inverse, "");
            let slope = slope.scale(&mut program.graph, coefficient);
            program.output_vector(&format!("variation_{i}"), &slope);
        }
    }
    program.settle_terms();
    program
}

/// J ∂J/∂t_i [eq:measure-variation-1] [eq:measure-variation-2]
fn slopes(program: &mut Program, t: &[Vector], area: &Vector) -> Vec<Vector> {
    let graph = &mut program.graph;
    match t {
        [first, second] => vec![second.cross(graph, area), area.cross(graph, first)],
        _ => vec![area.clone()],
    }
}
