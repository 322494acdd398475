//! Rigid distance functions d(x): no projection at all. [eq:distance]
//!
//! g = ±d − r0, δg = n·δr with n = ±∇d, D²g = ±δr·∇∇d·Δr. The generator derives gradient and Hessian of the
//! declared function.

use crate::ir::{Program, Scalar, Sheet, Symmetric, Vector};
use crate::linearise::shared::lower::Scope;
use crate::model::{Body, Geometry};

/// x, parameters, orientation, r0 → n = ±∇d, distance ±d, gap.
pub fn gap_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("gap");
    let value = declared(&sheet, geometry);
    let orientation = sheet.input("orientation");
    let r0 = sheet.input("r0");
    let gradient = gradient(value, geometry.coordinates.len());
    let n = orientation * gradient;
    let distance = orientation * value;
    let gap = distance - r0;
    sheet.outputs("n", &n);
    sheet.output("distance", distance);
    sheet.output("gap", gap);
    sheet.finish()
}

/// x, parameters, orientation, N, N' → p = N' n⊗n ± N ∇∇d. [eq:12-main] [eq:distance-curvature]
pub fn tangent_program(geometry: &Geometry) -> Program {
    let sheet = Sheet::new("tangent");
    let value = declared(&sheet, geometry);
    let orientation = sheet.input("orientation");
    let traction = sheet.input("traction");
    let slope = sheet.input("slope");
    let d = geometry.coordinates.len();
    let gradient = gradient(value, d);
    let main = sheet.term("12-main", slope * orientation.square(), "");
    let curvature = sheet.term(
        "distance-curvature",
        orientation * traction,
        "the distance function is linear",
    );
    let p = Symmetric::new(&sheet, d, |(k, l)| {
        let second = gradient[k].derivative(l);
        main * (gradient[k] * gradient[l]) + curvature * second
    });
    for (k, l) in (0..d).flat_map(|k| (0..d).map(move |l| (k, l))) {
        sheet.output(format!("p_{k}_{l}"), p[(k, l)]);
    }
    sheet.finish()
}

/// The declared distance at the inputs x, parameters.
fn declared<'s>(sheet: &'s Sheet, geometry: &Geometry) -> Scalar<'s> {
    let Body::Distance { value } = &geometry.body else {
        unreachable!("called for distance functions only")
    };
    Scope::of_geometry(sheet, geometry).lower(value)
}

fn gradient(value: Scalar<'_>, d: usize) -> Vector<'_> {
    Vector::new(value.sheet(), (0..d).map(|k| value.derivative(k)))
}
