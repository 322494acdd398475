//! Drops what no output needs and renumbers the rest in the old order.

use crate::ir::{NodeId, Program};

/// The program without unneeded nodes.
pub fn prune(program: &Program) -> Program {
    let needed = program.needed();
    let mut result = Program {
        graph: Default::default(),
        outputs: Vec::new(),
        ..program.clone()
    };
    let mut map = vec![NodeId(u32::MAX); needed.len()];
    for (index, &node) in program.graph.nodes().iter().enumerate() {
        if needed[index] {
            map[index] = result.graph.rebuild(node, |id| map[id.0 as usize]);
        }
    }
    result.outputs = program
        .outputs
        .iter()
        .map(|(name, id)| (name.clone(), map[id.0 as usize]))
        .collect();
    result
}
