//! States for projections: well-conditioned ones of the generator, torn apart.

use super::effort::Extent;
use crate::configurations::{Configuration, Generator, Stream, Wanted};
use crate::proof::random;
use crate::subject::Subject;

/// Largest shift of the slave and of single nodes, in sizes.
const SHIFT: f64 = 1.5;
const DEFORM: f64 = 0.5;
/// Largest shift of the slave from a state to its neighbour, in sizes.
const STEP: f64 = 0.02;

/// Purposes of the streams.
const TORN: u64 = 44;
const BESIDE: u64 = 45;

/// All states of a run.
pub(super) struct States {
    generator: Generator,
    extent: Extent,
}

impl States {
    pub(super) fn new(subject: &Subject, extent: Extent) -> Self {
        Self {
            generator: random::generator(subject, extent.seed),
            extent,
        }
    }

    /// The states of a family with their numbers.
    pub(super) fn family(
        &self,
        number: u64,
    ) -> Result<impl Iterator<Item = (u64, Configuration)>, String> {
        let parent = self.generator.generate(Wanted::Open, number);
        let parent = parent.map_err(|error| format!("state {number} not made: {error}"))?;
        let Extent { family, seed, .. } = self.extent;
        let members = number * family..(number + 1) * family;
        Ok(members.map(move |index| (index, torn(&parent, seed, index))))
    }
}

/// The slave anywhere and all nodes shifted by up to half the size.
fn torn(parent: &Configuration, seed: u64, index: u64) -> Configuration {
    let mut stream = Stream::new(seed, index, TORN);
    let (shift, deform) = (SHIFT * parent.size, DEFORM * parent.size);
    let shift = stream.cube(shift);
    moved(parent, |is_slave_position| {
        let own = stream.cube(deform);
        let along = if is_slave_position { shift } else { [0.0; 3] };
        [0, 1, 2].map(|k| along[k] + own[k])
    })
}

/// The slave as a whole shifted by up to [`STEP`] sizes.
pub(super) fn neighbour(configuration: &Configuration, seed: u64, index: u64) -> Configuration {
    let mut stream = Stream::new(seed, index, BESIDE);
    let shift = stream.cube(STEP * configuration.size);
    moved(configuration, |is_slave_position| {
        if is_slave_position { shift } else { [0.0; 3] }
    })
}

/// Displaces all nodes by `change`, which learns whether the node is a position of the slave.
fn moved(from: &Configuration, mut change: impl FnMut(bool) -> [f64; 3]) -> Configuration {
    let mut configuration = from.clone();
    let pair = &from.pair;
    let d = pair.dimension;
    for (node, u) in configuration.displacement.chunks_mut(d).enumerate() {
        let is_slave_position = node < pair.slave_nodes() && pair.slave_is_position(node);
        for (u, change) in u.iter_mut().zip(change(is_slave_position)) {
            *u += change;
        }
    }
    configuration
}
