//! Checks that put numbers in: they find slips that other checks cannot see.

use std::collections::HashMap;

use syn::Ident;

use super::expression::Expr;
use super::types::{Body, Bound, Domain, Geometry, Law, Parameter};
use crate::diagnostics::{Diagnostic, geometry, law, short};

/// Values of names.
type Values = HashMap<String, f64>;

/// A typical value of each parameter, inside its range.
fn typical(parameters: &[Parameter]) -> Values {
    let value = |(index, parameter): (usize, &Parameter)| {
        let step = 1.7 / (1.0 + index as f64);
        let value = match (parameter.lower.is_finite(), parameter.upper.is_finite()) {
            (true, true) => 0.63 * parameter.lower + 0.37 * parameter.upper,
            (true, false) => parameter.lower + step,
            (false, true) => parameter.upper - step,
            (false, false) => step,
        };
        (parameter.name.to_string(), value)
    };
    parameters.iter().enumerate().map(value).collect()
}

fn evaluate(expr: &Expr, values: &Values) -> f64 {
    expr.evaluate(&|name| values.get(&name.to_string()).copied())
}

/// Adds coordinates, then the bindings that depend on them.
fn extend(values: &mut Values, names: &[Ident], point: &[f64], bindings: &[(Ident, Expr)]) {
    for (name, value) in names.iter().zip(point) {
        values.insert(name.to_string(), *value);
    }
    for (name, value) in bindings {
        let value = evaluate(value, values);
        values.insert(name.to_string(), value);
    }
}

/// `xi = 0.2, eta = 0.4`.
fn place(names: &[Ident], point: &[f64]) -> String {
    let parts: Vec<String> = names
        .iter()
        .zip(point)
        .map(|(name, value)| format!("{name} = {}", short(*value)))
        .collect();
    parts.join(", ")
}

/// Shape functions of positions sum to one at every point: otherwise a translation would strain.
pub(super) fn partition_of_unity(shape: &Geometry) -> Option<Diagnostic> {
    let Body::Shape {
        functions, vectors, ..
    } = &shape.body
    else {
        return None;
    };
    for point in shape.domain.samples(shape.coordinates.len()) {
        let mut values = Values::new();
        extend(&mut values, &shape.coordinates, &point, &shape.bindings);
        let positions = functions
            .iter()
            .enumerate()
            .filter(|(index, _)| !vectors.contains(index));
        let terms: Vec<f64> = positions
            .map(|(_, function)| evaluate(function, &values))
            .collect();
        let sum: f64 = terms.iter().sum();
        let scale = terms
            .iter()
            .fold(1.0, |scale: f64, term| scale.max(term.abs()));
        if sum.is_nan() || (sum - 1.0).abs() > 1e-10 * scale {
            let point = place(&shape.coordinates, &point);
            return Some(geometry::no_partition_of_unity(
                &short(sum),
                &point,
                !vectors.is_empty(),
            ));
        }
    }
    None
}

/// A closed projection leaves a point of the geometry where it is.
pub(super) fn projection(rigid: &Geometry) -> Option<Diagnostic> {
    let Body::Rigid {
        position,
        projection: Some(closed),
    } = &rigid.body
    else {
        return None;
    };
    let parameters = typical(&rigid.parameters);
    let locate = |point: &[f64]| -> Vec<f64> {
        let mut values = parameters.clone();
        extend(&mut values, &rigid.coordinates, point, &rigid.bindings);
        position
            .iter()
            .map(|component| evaluate(component, &values))
            .collect()
    };
    for point in rigid.domain.samples(rigid.coordinates.len()) {
        let start = locate(&point);
        let mut values = parameters.clone();
        extend(&mut values, &closed.coordinates, &start, &[]);
        let found: Vec<f64> = closed
            .values
            .iter()
            .map(|value| evaluate(value, &values))
            .collect();
        let end = locate(&found);
        let square: f64 = start.iter().zip(&end).map(|(a, b)| (a - b) * (a - b)).sum();
        let scale = start.iter().fold(1.0, |scale: f64, x| scale.max(x.abs()));
        if square.sqrt() > 1e-6 * scale {
            let point = place(&rigid.coordinates, &point);
            return Some(geometry::projection_moves_point(
                &point,
                &short(square.sqrt()),
            ));
        }
    }
    None
}

/// A linear spring: without contact at no gap, N proportional to g on both sides.
pub(super) fn is_spring(law: &Law) -> bool {
    let parameters = typical(&law.parameters);
    let begins_at_zero = match &law.active {
        Bound::Below(limit) => evaluate(limit, &parameters) == 0.0,
        Bound::Above(_) => false,
    };
    let traction = |gap: f64| {
        let mut values = parameters.clone();
        let gap_name = std::slice::from_ref(&law.gap);
        extend(&mut values, gap_name, &[gap], &law.bindings);
        evaluate(&law.traction, &values)
    };
    let slope = traction(1.0);
    let is_linear = |gap: f64| (traction(gap) - slope * gap).abs() <= 1e-12 * (slope * gap).abs();
    begins_at_zero
        && law.valid.is_none()
        && slope > 0.0
        && [-2.7, -1.3, -0.4, -0.01, 0.3, 1.9]
            .into_iter()
            .all(is_linear)
}

/// The energy of a law vanishes where its contact begins: the product with a weight that moves has no jump.
pub(super) fn energy_begins_at_zero(law: &Law) -> bool {
    let Some(energy) = &law.energy else {
        return false;
    };
    let parameters = typical(&law.parameters);
    let (Bound::Below(limit) | Bound::Above(limit)) = &law.active;
    let limit = evaluate(limit, &parameters);
    let at = |gap: f64| {
        let mut values = parameters.clone();
        let gap_name = std::slice::from_ref(&law.gap);
        extend(&mut values, gap_name, &[gap], &law.bindings);
        evaluate(energy, &values)
    };
    let inside = match law.active {
        Bound::Below(_) => limit - 0.1,
        Bound::Above(_) => limit + 0.1,
    };
    at(limit).abs() <= 1e-12 * at(inside).abs()
}

/// Degree of a curve by shape functions as a polynomial of its coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Degree {
    /// At most linear: its second derivative vanishes.
    Straight,
    /// Its fourth derivative vanishes.
    Cubic,
    /// Anything else, rational curves too.
    Higher,
}

/// The least degree whose interpolation meets the shape functions at points in between.
pub(super) fn degree(curve: &Geometry) -> Degree {
    let (
        Body::Shape {
            functions,
            rational: false,
            ..
        },
        Domain::Interval(lower, upper),
    ) = (&curve.body, curve.domain)
    else {
        return Degree::Higher;
    };
    let at = |function: &Expr, t: f64| {
        let mut values = Values::new();
        let point = [lower + (upper - lower) * t];
        extend(&mut values, &curve.coordinates, &point, &curve.bindings);
        evaluate(function, &values)
    };
    let meets = |function: &Expr, nodes: &[f64]| {
        [0.07, 0.31, 0.58, 0.83].into_iter().all(|t| {
            let weight = |a: f64| {
                let others = nodes.iter().filter(|&&b| b != a);
                others.map(|b| (t - b) / (a - b)).product::<f64>()
            };
            let terms: Vec<f64> = nodes.iter().map(|&a| weight(a) * at(function, a)).collect();
            let scale = terms.iter().fold(1e-300, |s: f64, term| s.max(term.abs()));
            (terms.iter().sum::<f64>() - at(function, t)).abs() <= 1e-10 * scale
        })
    };
    let all = |nodes: &[f64]| functions.iter().all(|function| meets(function, nodes));
    if all(&[0.1, 0.9]) {
        Degree::Straight
    } else if all(&[0.02, 0.22, 0.69, 0.98]) {
        Degree::Cubic
    } else {
        Degree::Higher
    }
}

/// The traction is the derivative of the energy.
pub(super) fn energy(declared: &Law) -> Option<Diagnostic> {
    let energy = declared.energy.as_ref()?;
    let parameters = typical(&declared.parameters);
    let at = |expr: &Expr, gap: f64| {
        let mut values = parameters.clone();
        extend(
            &mut values,
            std::slice::from_ref(&declared.gap),
            &[gap],
            &declared.bindings,
        );
        evaluate(expr, &values)
    };
    let within = |bound: &Bound, gap: f64| match bound {
        Bound::Below(limit) => gap < evaluate(limit, &parameters),
        Bound::Above(limit) => gap > evaluate(limit, &parameters),
    };
    let (limit, sign) = match &declared.active {
        Bound::Below(limit) => (evaluate(limit, &parameters), -1.0),
        Bound::Above(limit) => (evaluate(limit, &parameters), 1.0),
    };
    for depth in [0.1, 0.35, 0.8, 1.5] {
        let gap = limit + sign * depth;
        if declared
            .valid
            .as_ref()
            .is_some_and(|valid| !within(valid, gap - 0.01) || !within(valid, gap + 0.01))
        {
            continue;
        }
        let slope = |h: f64| (at(energy, gap + h) - at(energy, gap - h)) / (2.0 * h);
        let (coarse, fine, traction) = (slope(2e-5), slope(1e-5), at(&declared.traction, gap));
        let scale = fine.abs().max(traction.abs());
        let trusted = (coarse - fine).abs() <= 1e-4 * scale;
        if trusted && (fine - traction).abs() > 1e-3 * scale {
            let mut point = vec![format!("{} = {}", declared.gap, short(gap))];
            for parameter in &declared.parameters {
                let value = parameters[&parameter.name.to_string()];
                point.push(format!("{} = {}", parameter.name, short(value)));
            }
            return Some(law::energy_mismatch(
                &point.join(", "),
                &short(fine),
                &short(traction),
            ));
        }
    }
    None
}
