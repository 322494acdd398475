//! What an element divides by.

use super::routine::Routine;
use crate::ir::Program;
use crate::ir::passes::divisor_program;

/// The values that must not vanish before an evaluation.
#[derive(Default)]
pub struct Divisors {
    /// In the gap and the tangent of a distance function.
    pub distance: Option<Routine>,
    /// In the variation of a moving measure.
    pub measure: Option<Routine>,
}

impl Divisors {
    /// What the tangent of a distance function and a moving measure divide by, where there are such.
    pub fn new(distance: Option<&Program>, measure: Option<&Program>) -> Self {
        let of = |program: Option<&Program>, name: &str| {
            divisor_program(program?, name).map(|program| Routine::new(&program))
        };
        Self {
            distance: of(distance, "distance_divisors"),
            measure: of(measure, "measure_divisors"),
        }
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        self.distance.iter().chain(&self.measure)
    }
}
