//! A pair at a state, and the status it is built for.

use crate::oracle::history::FrictionHistory;
use crate::oracle::pair::Pair;
use crate::oracle::solve::{PointReport, Start, State};

/// The status a state is built for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Wanted {
    /// One point: closed. Integrated: at least one point closed.
    Closed,
    /// One point: open. Integrated: at least one point open and no point closed.
    Open,
    /// One point: beyond an edge or end. Integrated: at least one point outside.
    Outside,
    /// With friction. One point: sticks. Integrated: at least one point closed and no point slips.
    Stick,
    /// With friction. One point: slips. Integrated: at least one point slips.
    Slip,
}

impl Wanted {
    /// Whether a point must be closed.
    pub fn is_closed(self) -> bool {
        matches!(self, Self::Closed | Self::Stick | Self::Slip)
    }
}

/// A pair at a state.
#[derive(Debug, Clone)]
pub struct Configuration {
    /// The pair with all its numbers.
    pub pair: Pair,
    /// X, all unknowns (length).
    pub reference: Vec<f64>,
    /// u, all unknowns (length).
    pub displacement: Vec<f64>,
    /// A start for each contact point's projection, near the solution but not on it.
    pub start: Vec<[f64; 2]>,
    /// Typical size (length): factor by which a problem of size one was scaled.
    pub size: f64,
    /// What each contact point remembers; empty without friction.
    pub friction: Vec<FrictionHistory>,
    /// What the oracle finds at the contact points.
    pub points: Vec<PointReport>,
}

impl Configuration {
    /// The state, for the oracle.
    pub fn state(&self) -> State<'_> {
        State {
            reference: &self.reference,
            displacement: &self.displacement,
            start: Start::Given(&self.start),
            friction: &self.friction,
        }
    }

    /// Current positions `X + u`, all unknowns.
    pub fn positions(&self) -> Vec<f64> {
        self.reference
            .iter()
            .zip(&self.displacement)
            .map(|(x, u)| x + u)
            .collect()
    }
}
