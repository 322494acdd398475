//! Jacobian of the slave at an integration point and its variation. [eq:measure]

use crate::ir::{Program, Sheet, Vector};

/// t_i (tangents of the slave) → J; with `variation` also ∂J/∂t_i.
///
/// Curve: J = |t|, ∂J/∂t = t/J. Surface: J = |t_1×t_2|, ν = t_1×t_2/J, ∂J/∂t_1 = t_2×ν, ∂J/∂t_2 = ν×t_1.
pub fn measure_program(dimension: usize, parameters: usize, variation: bool) -> Program {
    let name = match variation {
        true => "measure_current",
        false => "measure_reference",
    };
    let sheet = Sheet::new(name);
    let t: Vec<Vector> = (0..parameters)
        .map(|i| sheet.input_vector(&format!("t_{i}"), dimension))
        .collect();
    let area = match *t {
        [only] => only,
        [first, second] => first.cross(second),
        _ => unreachable!("a slave with a measure is a curve or a surface"),
    };
    let jacobian = area.norm();
    sheet.output("jacobian", jacobian);
    if variation {
        let inverse = 1.0 / jacobian;
        for (i, slope) in slopes(&t, area).into_iter().enumerate() {
            let tag = ["measure-variation-1", "measure-variation-2"][i];
            let slope = sheet.term(tag, inverse, "") * slope;
            sheet.outputs(&format!("variation_{i}"), &slope);
        }
    }
    sheet.finish()
}

/// J ∂J/∂t_i [eq:measure-variation-1] [eq:measure-variation-2]
fn slopes<'s>(t: &[Vector<'s>], area: Vector<'s>) -> Vec<Vector<'s>> {
    match *t {
        [first, second] => vec![second.cross(area), area.cross(first)],
        _ => vec![area],
    }
}
