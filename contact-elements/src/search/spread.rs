//! How far a facet reaches beyond its nodes.

use super::interval::{Interval, MOST_OPERATIONS, Scratch, evaluate};
use crate::arithmetic::abs;
use crate::point::domain::Domain;
use crate::table::Table;

/// Pieces of the domain along either parameter.
const PIECES: u32 = 4;

/// An upper bound of Σ|N_A| over a bounded domain of two parameters: with ΣN_A = 1 no point is farther from any centre
/// than this times the farthest node. Infinite if it is unknown. [eq:spread]
pub(crate) fn spread(program: &Table, nodes: usize, domain: &Domain) -> f64 {
    let (lower, upper, is_triangle) = match *domain {
        Domain::Interval(lower, upper) => ([lower, 0.0], [upper, 0.0], false),
        Domain::Rectangle(lower, upper) => (lower, upper, false),
        Domain::Triangle => ([0.0; 2], [1.0; 2], true),
        Domain::Unbounded => return f64::INFINITY,
    };
    let is_plain = program.inputs.len() <= 2 && program.outputs.len() >= nodes;
    if !is_plain || program.operations.len() > MOST_OPERATIONS {
        return f64::INFINITY;
    }
    let mut scratch = [Interval::ZERO; MOST_OPERATIONS];
    let piece = |i: usize, number: u32| {
        let i = i.min(1);
        let width = (upper[i] - lower[i]) / f64::from(PIECES);
        let start = lower[i] + f64::from(number) * width;
        Interval::between(start, start + width)
    };
    let mut most = 0.0_f64;
    for first in 0..PIECES {
        for last in 0..PIECES {
            if is_triangle && first + last >= PIECES {
                continue;
            }
            let inputs = [piece(0, first), piece(1, last)];
            evaluate(program, &inputs, &mut scratch);
            most = most.max(sum_of_sizes(program, nodes, &scratch));
        }
    }
    // pieces meet to rounding
    most * (1.0 + 1e-12)
}

fn sum_of_sizes(program: &Table, nodes: usize, scratch: &Scratch) -> f64 {
    let shapes = program.outputs.iter().take(nodes);
    let sizes = shapes.map(|&(_, place)| match scratch.get(usize::from(place)) {
        Some(shape) => abs(shape.lower).max(abs(shape.upper)),
        None => f64::INFINITY,
    });
    sizes.sum()
}
