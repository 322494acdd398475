//! How much is tried, and what it cost.

use serde::Serialize;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The first family.
    pub first: u64,
    /// Families of states.
    pub families: u64,
    /// States of a family, disturbances of one random state: drawing that takes longer than most projections.
    pub family: u64,
    /// Every how many-th is compared with a grid.
    pub compared: u64,
    /// See [`crate::configurations::Generator`].
    pub seed: u64,
}

/// How many of something were needed, over many projections.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Effort {
    /// Projections.
    pub count: u64,
    /// All together.
    pub sum: u64,
    /// The worst projection.
    pub most: u64,
    /// Projections that needed at most three.
    pub few: u64,
}

impl Effort {
    pub(super) fn add(&mut self, value: u64) {
        self.count += 1;
        self.sum += value;
        self.most = self.most.max(value);
        self.few += u64::from(value <= 3);
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.count += other.count;
        self.sum += other.sum;
        self.most = self.most.max(other.most);
        self.few += other.few;
    }

    /// 0 without projections.
    pub fn mean(&self) -> f64 {
        self.sum as f64 / self.count.max(1) as f64
    }
}

/// Adds counters.
pub(super) fn add(counters: &mut [u64], others: &[u64]) {
    for (counter, other) in counters.iter_mut().zip(others) {
        *counter += other;
    }
}
