//! Declared geometries and their derivatives to third order.

use super::lower::Scope;
use super::{second_derivatives, third_derivatives};
use crate::ir::{Program, Scalar, Sheet, interpret};
use crate::model::{Body, Geometry, Parameter};

/// A row of values: one per node, or one per component of a position.
type Row<'s> = Vec<Scalar<'s>>;

/// ζ, weights → N_A, N_A,i, N_A,ij in the order `n`, `d1` (i, A), `d2` (ij, A).
pub fn shape_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("rows");
    let functions = shape_functions(&sheet, geometry);
    lower_orders(&sheet, geometry, functions, ["n", "d1", "d2"]);
    sheet.finish()
}

/// ζ, weights → N_A,ijk in the order 111 (112 122 222), A fastest.
pub fn shape_third_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("rows_third");
    let functions = shape_functions(&sheet, geometry);
    third_order(&sheet, geometry, functions, "d3");
    sheet.finish()
}

/// ζ, parameters → ρ, ρ_i, ρ_ij of a rigid geometry.
pub fn rigid_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("position");
    let position = rigid_position(&sheet, geometry);
    lower_orders(&sheet, geometry, position, ["rho", "rho_i", "rho_ij"]);
    sheet.finish()
}

/// ζ, parameters → ρ_ijk of a rigid geometry.
pub fn rigid_third_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("position_third");
    let position = rigid_position(&sheet, geometry);
    third_order(&sheet, geometry, position, "rho_ijk");
    sheet.finish()
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
    let sheet = Sheet::new("projection");
    let mut scope = Scope::new(&sheet);
    scope.inputs(&closed.coordinates);
    scope.inputs(geometry.parameters.iter().map(|parameter| &parameter.name));
    for (index, value) in closed.values.iter().enumerate() {
        sheet.output(format!("zeta_{index}"), scope.lower(value));
    }
    drop(scope);
    Some(sheet.finish())
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
fn shape_functions<'s>(sheet: &'s Sheet, geometry: &Geometry) -> Row<'s> {
    let Body::Shape {
        functions,
        rational,
        ..
    } = &geometry.body
    else {
        unreachable!("called for shape functions only")
    };
    let mut scope = Scope::new(sheet);
    scope.inputs(&geometry.coordinates);
    let count = if *rational { functions.len() } else { 0 };
    let weights: Row = (0..count)
        .map(|a| sheet.input(format!("weight_{a}")))
        .collect();
    scope.bind(&geometry.bindings);
    let mut values = scope.lower_all(functions);
    if *rational {
        let mut total = sheet.zero();
        for (value, weight) in values.iter_mut().zip(weights) {
            *value = *value * weight;
            total = total + *value;
        }
        for value in &mut values {
            *value = *value / total;
        }
    }
    values
}

/// ρ(ζ; parameters). [eq:rigid]
fn rigid_position<'s>(sheet: &'s Sheet, geometry: &Geometry) -> Row<'s> {
    let Body::Rigid { position, .. } = &geometry.body else {
        unreachable!("called for rigid geometries only")
    };
    Scope::of_geometry(sheet, geometry).lower_all(position)
}

/// The outputs of value, first and second derivatives under three names.
fn lower_orders<'s>(sheet: &'s Sheet, geometry: &Geometry, values: Row<'s>, names: [&str; 3]) {
    let p = geometry.coordinates.len();
    let first = first(&values, p);
    let second = higher(&first, p);
    for (name, rows) in names.into_iter().zip([vec![values], first, second]) {
        output_rows(sheet, name, &rows);
    }
}

/// The outputs of the third derivatives.
fn third_order<'s>(sheet: &'s Sheet, geometry: &Geometry, values: Row<'s>, name: &str) {
    let p = geometry.coordinates.len();
    let second = higher(&first(&values, p), p);
    output_rows(sheet, name, &higher(&second, p));
}

/// First derivatives, one row per parameter.
fn first<'s>(values: &[Scalar<'s>], p: usize) -> Vec<Row<'s>> {
    (0..p).map(|i| derivative(values, i)).collect()
}

/// Rows of the next order from rows in the order 1.. (or 11, 12, 22): for p = 2 the last row of each
/// parameter's block gives the new one, so 1, 2 → 11, 12, 22 → 111, 112, 122, 222.
fn higher<'s>(rows: &[Row<'s>], p: usize) -> Vec<Row<'s>> {
    let mut next: Vec<Row> = rows.iter().map(|row| derivative(row, 0)).collect();
    if p == 2 {
        let last = rows.last().expect("two parameters have derivatives");
        next.push(derivative(last, 1));
    }
    next
}

fn derivative<'s>(row: &[Scalar<'s>], parameter: usize) -> Row<'s> {
    row.iter()
        .map(|value| value.derivative(parameter))
        .collect()
}

fn output_rows(sheet: &Sheet, name: &str, rows: &[Row<'_>]) {
    for (i, row) in rows.iter().enumerate() {
        sheet.outputs(&format!("{name}_{i}"), row);
    }
}
