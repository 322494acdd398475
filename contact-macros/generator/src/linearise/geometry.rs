//! Declared geometries and their derivatives to third order.

use super::{second_derivatives, third_derivatives};
use crate::ir::{NodeId, Program, Scope, differentiate, interpret, lower};
use crate::model::{Body, Geometry, Parameter};

/// ζ, weights → N_A, N_A,i, N_A,ij in the order `n`, `d1` (i, A), `d2` (ij, A).
pub fn shape_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("rows");
    let (functions, p) = shape_functions(&mut program, geometry);
    let first = derivatives(&mut program, &functions, p);
    let second = higher(&mut program, &first, p);
    emit_rows(&mut program, "n", &[functions]);
    emit_rows(&mut program, "d1", &first);
    emit_rows(&mut program, "d2", &second);
    program
}

/// ζ, weights → N_A,ijk in the order 111 (112 122 222), A fastest.
pub fn shape_third_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("rows_third");
    let (functions, p) = shape_functions(&mut program, geometry);
    let third = third(&mut program, &functions, p);
    emit_rows(&mut program, "d3", &third);
    program
}

/// ζ, parameters → ρ, ρ_i, ρ_ij of a rigid geometry.
pub fn rigid_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("position");
    let (position, p) = rigid_position(&mut program, geometry);
    let first = derivatives(&mut program, &position, p);
    let second = higher(&mut program, &first, p);
    emit_rows(&mut program, "rho", &[position]);
    emit_rows(&mut program, "rho_i", &first);
    emit_rows(&mut program, "rho_ij", &second);
    program
}

/// ζ, parameters → ρ_ijk of a rigid geometry.
pub fn rigid_third_program(geometry: &Geometry) -> Program {
    let mut program = Program::new("position_third");
    let (position, p) = rigid_position(&mut program, geometry);
    let third = third(&mut program, &position, p);
    emit_rows(&mut program, "rho_ijk", &third);
    program
}

/// x, parameters → ζ in closed form, where the geometry declares it.
pub fn projection_program(geometry: &Geometry) -> Option<Program> {
    let Body::Rigid {
        projection: Some(closed),
        ..
    } = &geometry.body
    else {
        return None;
    };
    let mut program = Program::new("projection");
    let mut scope = Scope::default();
    for name in &closed.coordinates {
        let node = program.input(name.to_string());
        scope.define(name, node);
    }
    for parameter in &geometry.parameters {
        let node = program.input(parameter.name.to_string());
        scope.define(&parameter.name, node);
    }
    for (index, value) in closed.values.iter().enumerate() {
        let value = lower(&mut program.graph, &scope, value);
        program.output(format!("zeta_{index}"), value);
    }
    Some(program)
}

/// Which second derivatives (11, 12, 22) can be non-zero, from the program of rows or positions.
pub fn curved(geometry: &Geometry, program: &Program) -> Vec<bool> {
    if matches!(geometry.body, Body::Distance { .. }) {
        return vec![];
    }
    let p = geometry.coordinates.len();
    let rows = remaining(program, 1 + p + second_derivatives(p));
    rows[1 + p..].to_vec()
}

/// Which third derivatives (111, 112, 122, 222) can be non-zero, from their program.
pub fn third_remaining(geometry: &Geometry, program: &Program) -> Vec<bool> {
    remaining(program, third_derivatives(geometry.coordinates.len()))
}

/// Which of the rows that the outputs consist of do not vanish identically.
fn remaining(program: &Program, rows: usize) -> Vec<bool> {
    let width = program.outputs.len() / rows;
    program
        .outputs
        .chunks_exact(width)
        .map(|row| row.iter().any(|&(_, id)| !program.graph.is(id, 0.0)))
        .collect()
}

/// The period of each parameter of a rigid geometry: 2π where the position at a few samples repeats, else 0.
/// A closed projection gives an angle up to whole turns; with the period the turn nearest to the start is
/// found.
pub fn periods(geometry: &Geometry, program: &Program) -> Vec<f64> {
    let p = geometry.coordinates.len();
    if !matches!(geometry.body, Body::Rigid { .. }) {
        return vec![0.0; p];
    }
    let d = program.outputs.len() / (1 + p + second_derivatives(p));
    let parameters: Vec<f64> = geometry.parameters.iter().map(sample).collect();
    let position = |zeta: &[f64]| {
        let inputs: Vec<f64> = zeta.iter().chain(&parameters).copied().collect();
        interpret(program, &inputs)[..d].to_vec()
    };
    let repeats = |i: usize| {
        [[0.3, 0.7], [1.9, 0.2], [-2.2, 1.1]].iter().all(|sample| {
            let mut turned = sample[..p].to_vec();
            turned[i] += std::f64::consts::TAU;
            let (first, last) = (position(&sample[..p]), position(&turned));
            let size = first.iter().fold(1e-300, |size: f64, v| size.max(v.abs()));
            let mut pairs = first.iter().zip(last);
            pairs.all(|(a, b)| (a - b).abs() <= 1e-12 * size)
        })
    };
    (0..p)
        .map(|i| {
            if repeats(i) {
                std::f64::consts::TAU
            } else {
                0.0
            }
        })
        .collect()
}

/// An admissible value of a parameter.
fn sample(parameter: &Parameter) -> f64 {
    match (parameter.lower, parameter.upper) {
        (lower, upper) if lower.is_finite() && upper.is_finite() => 0.4 * lower + 0.6 * upper,
        (lower, _) if lower.is_finite() => lower + 1.3,
        (_, upper) if upper.is_finite() => upper - 1.3,
        _ => 1.3,
    }
}

/// N_A at ζ; rational ones are weighted and divided by their sum. [eq:rational]
fn shape_functions(program: &mut Program, geometry: &Geometry) -> (Vec<NodeId>, usize) {
    let Body::Shape {
        functions,
        rational,
        ..
    } = &geometry.body
    else {
        unreachable!("called for shape functions only")
    };
    let mut scope = Scope::default();
    for name in &geometry.coordinates {
        let node = program.input(name.to_string());
        scope.define(name, node);
    }
    let weights: Vec<NodeId> = if *rational {
        (0..functions.len())
            .map(|a| program.input(format!("weight_{a}")))
            .collect()
    } else {
        vec![]
    };
    scope.bind(&mut program.graph, &geometry.bindings);
    let mut values: Vec<NodeId> = functions
        .iter()
        .map(|function| lower(&mut program.graph, &scope, function))
        .collect();
    if *rational {
        let graph = &mut program.graph;
        let mut total = graph.constant(0.0);
        for (value, &weight) in values.iter_mut().zip(&weights) {
            *value = graph.multiply(*value, weight);
            total = graph.add(total, *value);
        }
        for value in &mut values {
            *value = graph.divide(*value, total);
        }
    }
    (values, geometry.coordinates.len())
}

/// ρ(ζ; parameters). [eq:rigid]
fn rigid_position(program: &mut Program, geometry: &Geometry) -> (Vec<NodeId>, usize) {
    let Body::Rigid { position, .. } = &geometry.body else {
        unreachable!("called for rigid geometries only")
    };
    let mut scope = Scope::default();
    for name in &geometry.coordinates {
        let node = program.input(name.to_string());
        scope.define(name, node);
    }
    for parameter in &geometry.parameters {
        let node = program.input(parameter.name.to_string());
        scope.define(&parameter.name, node);
    }
    scope.bind(&mut program.graph, &geometry.bindings);
    let values = position
        .iter()
        .map(|component| lower(&mut program.graph, &scope, component))
        .collect();
    (values, geometry.coordinates.len())
}

/// First derivatives, one row per parameter.
fn derivatives(program: &mut Program, values: &[NodeId], p: usize) -> Vec<Vec<NodeId>> {
    (0..p).map(|i| derivative(program, values, i)).collect()
}

/// Rows of the next order from rows in the order 1.. (or 11, 12, 22): for p = 2 the last row of each
/// parameter's block gives the new one, so 1, 2 → 11, 12, 22 → 111, 112, 122, 222.
fn higher(program: &mut Program, rows: &[Vec<NodeId>], p: usize) -> Vec<Vec<NodeId>> {
    let mut next: Vec<Vec<NodeId>> = rows.iter().map(|row| derivative(program, row, 0)).collect();
    if p == 2 {
        let last = rows.last().expect("two parameters have derivatives");
        next.push(derivative(program, last, 1));
    }
    next
}

fn third(program: &mut Program, values: &[NodeId], p: usize) -> Vec<Vec<NodeId>> {
    let first = derivatives(program, values, p);
    let second = higher(program, &first, p);
    higher(program, &second, p)
}

fn derivative(program: &mut Program, row: &[NodeId], parameter: usize) -> Vec<NodeId> {
    row.iter()
        .map(|&value| differentiate(&mut program.graph, value, parameter))
        .collect()
}

fn emit_rows(program: &mut Program, name: &str, rows: &[Vec<NodeId>]) {
    for (i, row) in rows.iter().enumerate() {
        for (a, &value) in row.iter().enumerate() {
            program.output(format!("{name}_{i}_{a}"), value);
        }
    }
}
