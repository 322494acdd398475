//! One state and what must come out; beginnings of pairs.

use crate::oracle::geometry::{Feature, Interpolation, Shape};
use crate::oracle::history::FrictionHistory;
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::solve::{Start, State};

/// What must come out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Expected {
    /// Projected, the law acts.
    Closed,
    /// Closed and sticking.
    Stick,
    /// Closed and slipping.
    Slip,
    /// Projected, the law does not act.
    Open,
    /// Projected exactly onto this part of the boundary, which belongs to the region: closed, or
    /// outside with this feature, but with the same force either way.
    OnBoundary(Feature),
    /// Beyond this part of the boundary.
    Outside(Feature),
    /// No unique projection or no normal: an error is reported, never NaN.
    Degenerate,
    /// NaN or infinity in the input: an error is reported.
    BadInput,
}

/// One state and what must come out.
#[derive(Debug, Clone)]
pub struct EdgeCase {
    /// What is special.
    pub name: &'static str,
    /// The pair.
    pub pair: Pair,
    /// Current positions, all unknowns (displacements are zero).
    pub positions: Vec<f64>,
    /// Start of the projection.
    pub start: [[f64; 2]; 1],
    /// What the point remembers; empty: contact begins.
    pub friction: Vec<FrictionHistory>,
    /// What must come out.
    pub expected: Expected,
}

impl EdgeCase {
    /// The state, for the oracle. `zeros` must be as long as the unknowns.
    pub fn state<'s>(&'s self, zeros: &'s [f64]) -> State<'s> {
        State {
            reference: &self.positions,
            displacement: zeros,
            start: Start::Given(&self.start),
            friction: &self.friction,
        }
    }
}

/// A pair with the penalty law, without anything else.
pub(super) fn pair(dimension: usize, slave: Slave, master: Master, gap: GapKind, r0: f64) -> Pair {
    let law = Law::Penalty { eps_n: 1000.0 };
    Pair {
        dimension,
        slave,
        master,
        gap,
        orientation: 1.0,
        r0,
        law,
        tangential: None,
        angle: None,
        multipliers: Multipliers::None,
    }
}

/// A master with nodes.
pub(super) fn shape(shape: Shape) -> Master {
    Master::Shape(Interpolation::new(shape))
}
