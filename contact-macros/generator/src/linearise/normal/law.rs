//! Normal laws: N as declared, N' by differentiation, W as declared. [eq:law]

use crate::ir::{Program, Scalar, Sheet};
use crate::linearise::shared::lower::Scope;
use crate::model::{Bound, Law};

/// g, parameters → N, N' (and W where the law declares it). [eq:normal-force] [eq:law-slope] [eq:energy]
pub fn law_program(law: &Law) -> Program {
    let sheet = Sheet::new("law");
    let (scope, _) = scope(&sheet, law);
    let traction = scope.lower(&law.traction);
    let slope = traction.derivative(0);
    let traction = sheet.term("normal-force", traction, "");
    let slope = sheet.term(
        "law-slope",
        slope,
        "the traction does not depend on the gap",
    );
    sheet.output("traction", traction);
    sheet.output("slope", slope);
    if let Some(energy) = &law.energy {
        let energy = sheet.term("energy", scope.lower(energy), "");
        sheet.output("energy", energy);
    }
    sheet.finish()
}

/// g, parameters → the difference whose sign decides: positive means the bound holds. [eq:active]
pub fn bound_program(law: &Law, name: &str, bound: &Bound) -> Program {
    let sheet = Sheet::new(name);
    let (scope, gap) = scope(&sheet, law);
    let difference = match bound {
        Bound::Below(limit) => scope.lower(limit) - gap,
        Bound::Above(limit) => gap - scope.lower(limit),
    };
    sheet.output(name, difference);
    sheet.finish()
}

/// The names of a law, and its gap.
fn scope<'s>(sheet: &'s Sheet, law: &Law) -> (Scope<'s>, Scalar<'s>) {
    let mut scope = Scope::new(sheet);
    let gap = sheet.input("gap");
    scope.define(&law.gap, gap);
    scope.inputs(law.parameters.iter().map(|parameter| &parameter.name));
    scope.bind(&law.bindings);
    (scope, gap)
}
