//! An optimised program and the name of the function that is emitted for it.

use super::digest::Digest;
use crate::ir::Program;
use crate::ir::passes::optimise;

/// A program after all passes.
#[derive(Debug)]
pub struct Routine {
    /// The program.
    pub program: Program,
    /// Name of the emitted function.
    pub function: String,
}

impl Routine {
    /// Optimises `program`; its function has the name of the program.
    pub fn new(program: &Program) -> Self {
        Self {
            program: optimise(program),
            function: program.name.clone(),
        }
    }

    /// A program whose function several elements share: its name holds a hash of the operations.
    pub fn shared(program: &Program) -> Self {
        let mut routine = Self::new(program);
        let mut digest = Digest::new();
        digest.program(&routine.program);
        routine.function = format!("{}_{:016x}", program.name, digest.finish());
        routine
    }

    /// Operations of one call.
    pub fn operations(&self) -> usize {
        self.program.operations()
    }
}

#[cfg(test)]
mod tests {
    use crate::ir::passes::PASSES;
    use crate::ir::{Program, interpret};
    use crate::linearise::normal::{gap, tangent};
    use crate::linearise::shared::Kinematics;
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
            tangent::tangent_program(&kinematics),
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
