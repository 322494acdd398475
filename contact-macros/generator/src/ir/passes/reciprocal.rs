//! Divisions by the same value share one reciprocal: x/d, y/d → r = 1/d, x·r, y·r.
//!
//! Changes the rounding of each quotient by at most one unit in its last place.

use std::collections::HashMap;

use crate::ir::{Node, NodeId, Program};

/// The program with shared reciprocals.
pub fn share_reciprocals(program: &Program) -> Program {
    let needed = program.needed();
    let mut uses: HashMap<NodeId, usize> = HashMap::new();
    for (index, node) in program.graph.nodes().iter().enumerate() {
        if let (true, Node::Divide(_, divisor)) = (needed[index], node) {
            *uses.entry(*divisor).or_default() += 1;
        }
    }
    let mut result = Program {
        graph: Default::default(),
        outputs: Vec::new(),
        ..program.clone()
    };
    let mut map: Vec<NodeId> = Vec::with_capacity(needed.len());
    for &node in program.graph.nodes() {
        let shared = match node {
            Node::Divide(numerator, divisor) if uses.get(&divisor).is_some_and(|&n| n > 1) => {
                let one = result.graph.constant(1.0);
                let reciprocal = result.graph.divide(one, map[divisor.0 as usize]);
                result.graph.multiply(map[numerator.0 as usize], reciprocal)
            }
            other => result.graph.rebuild(other, |id| map[id.0 as usize]),
        };
        map.push(shared);
    }
    result.outputs = program
        .outputs
        .iter()
        .map(|(name, id)| (name.clone(), map[id.0 as usize]))
        .collect();
    result
}
