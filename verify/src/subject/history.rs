//! The history of an element for what the oracle's points remember.

use super::Subject;
use crate::configurations::Configuration;
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::multiplier::Multipliers;

impl Subject {
    /// History of the element that matches the oracle's state. It holds status and ζ per point, with friction anchor and
    /// path, and the multipliers that are held. Edges start without a side; a point without a state is open.
    pub fn history(
        &self,
        start: &[[f64; 2]],
        friction: &[FrictionHistory],
        multipliers: &Multipliers,
    ) -> Vec<f64> {
        let descriptor = self.description.descriptor;
        let mut history = Vec::with_capacity(descriptor.history());
        for q in 0..descriptor.points {
            let start = start.get(q).or(start.first()).copied().unwrap_or([0.0; 2]);
            let remembered = friction.get(q).copied().unwrap_or(FORGOTTEN);
            history.push(match remembered.status {
                Accepted::Open => 0.0,
                Accepted::Stick => 2.0,
                Accepted::Slip => 3.0,
            });
            history.extend(&start[..descriptor.projected]);
            if descriptor.friction {
                history.extend(&remembered.anchor[..descriptor.projected]);
                history.push(remembered.slip);
            }
            if descriptor.rolling {
                history.extend(remembered.rolling.anchor);
                history.extend(remembered.rolling.path);
                history.push(0.0);
            }
            if descriptor.keeps_side {
                history.extend([0.0; 3]);
            }
            if let Multipliers::Held(_) = multipliers {
                history.extend(multipliers.at(q));
            }
        }
        history
    }

    /// The history of a configuration.
    pub fn history_of(&self, configuration: &Configuration) -> Vec<f64> {
        self.history(
            &configuration.start,
            &configuration.friction,
            &configuration.pair.multipliers,
        )
    }
}

/// History of a point that remembers nothing.
const FORGOTTEN: FrictionHistory = FrictionHistory {
    status: Accepted::Open,
    anchor: [0.0; 2],
    slip: 0.0,
    rolling: RollingHistory {
        anchor: [0.0; 2],
        path: [0.0; 2],
    },
};
