//! Passes over programs, in the order they run. Each keeps the meaning: the interpreter agrees before
//! and after up to the rounding of the operations that a pass says it changes.

mod prune;
mod reciprocal;

use crate::ir::Program;

/// A pass: its name and what it does to a program.
pub type Pass = (&'static str, fn(&Program) -> Program);

/// All passes in order.
pub const PASSES: [Pass; 2] = [
    ("reciprocal", reciprocal::share_reciprocals),
    ("prune", prune::prune),
];

/// Runs all passes.
pub fn optimise(program: &Program) -> Program {
    PASSES
        .iter()
        .fold(program.clone(), |program, (_, pass)| pass(&program))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::interpret;
    use crate::linearise::{Kinematics, gap, normal};
    use crate::model::{Gap, Linearisation};

    fn divisions(program: &Program) -> usize {
        let needed = program.needed();
        let nodes = program.graph.nodes().iter().zip(&needed);
        nodes
            .filter(|(node, needed)| **needed && matches!(node, crate::ir::Node::Divide(..)))
            .count()
    }

    /// Every pass leaves the outputs of the closed forms as they were, to 1e-14, and adds no division.
    #[test]
    fn passes_keep_the_meaning() {
        let kinematics = Kinematics {
            dimension: 3,
            moving: vec![true, true],
            curved: vec![true, true, true],
            third: vec![true; 4],
            gap: Gap::Signed,
            linearisation: Linearisation::Exact,
        };
        for program in [
            normal::tangent_program(&kinematics),
            gap::gap_program(&kinematics),
        ] {
            let inputs: Vec<f64> = (0..program.inputs.len())
                .map(|k| 0.3 + ((k * 7) % 11) as f64 / 10.0)
                .collect();
            let expected = interpret(&program, &inputs);
            let mut current = program.clone();
            for (name, pass) in PASSES {
                current = pass(&current);
                for (value, reference) in interpret(&current, &inputs).iter().zip(&expected) {
                    let scale = reference.abs().max(1.0);
                    assert!((value - reference).abs() <= 1e-14 * scale, "pass {name}");
                }
            }
            assert!(divisions(&current) <= divisions(&program));
            assert_eq!(current.outputs.len(), program.outputs.len());
        }
    }
}
