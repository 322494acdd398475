//! Normal laws: N as declared, N' by differentiation, W as declared. [eq:law]

use crate::ir::{NodeId, Program, Scope, differentiate, lower};
use crate::model::{Bound, Expr, Law};

/// g, parameters → N, N' (and W where the law declares it). [eq:normal-force] [eq:law-slope] [eq:energy]
pub fn law_program(law: &Law) -> Program {
    let mut program = Program::new("law");
    let scope = scope(&mut program, law);
    let traction = lower(&mut program.graph, &scope, &law.traction);
    let slope = differentiate(&mut program.graph, traction, 0);
    let traction = program.term("normal-force", traction, "");
    let slope = program.term(
        "law-slope",
        slope,
        "the traction does not depend on the gap",
    );
    program.output("traction", traction);
    program.output("slope", slope);
    if let Some(energy) = &law.energy {
        let energy = lower(&mut program.graph, &scope, energy);
        let energy = program.term("energy", energy, "");
        program.output("energy", energy);
    }
    program.settle_terms();
    program
}

/// g, parameters → the difference whose sign decides: positive means the bound holds. [eq:active]
pub fn bound_program(law: &Law, name: &str, bound: &Bound) -> Program {
    let mut program = Program::new(name);
    let scope = scope(&mut program, law);
    let gap = program.graph.input(0);
    let limit = |program: &mut Program, expression: &Expr| -> NodeId {
        lower(&mut program.graph, &scope, expression)
    };
    let difference = match bound {
        Bound::Below(expression) => {
            let limit = limit(&mut program, expression);
            program.graph.subtract(limit, gap)
        }
        Bound::Above(expression) => {
            let limit = limit(&mut program, expression);
            program.graph.subtract(gap, limit)
        }
    };
    program.output(name, difference);
    program
}

fn scope(program: &mut Program, law: &Law) -> Scope {
    let mut scope = Scope::default();
    let gap = program.input("gap");
    scope.define(&law.gap, gap);
    for parameter in &law.parameters {
        let node = program.input(parameter.name.to_string());
        scope.define(&parameter.name, node);
    }
    scope.bind(&mut program.graph, &law.bindings);
    scope
}
