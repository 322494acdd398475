//! Passes over programs, in the order they run. Each keeps the meaning: the interpreter agrees before
//! and after up to the rounding of the operations that a pass says it changes.

mod divisors;
mod prune;
mod reciprocal;

pub use divisors::divisor_program;

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
