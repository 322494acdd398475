//! A state as numbers for a call, and what its points remember.

use num_dual::DualNum;

use super::Load;
use crate::measure::stress::exact;
use crate::measure::stress::kinematics::Point;
use crate::measure::stress::truth::{self, State};
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::law::Law;
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::Pair;
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::vector::{add, dot, scale};

/// A state as an element is called with it.
#[derive(Clone, Debug)]
pub struct Case {
    /// The pair.
    pub pair: Pair,
    /// All coordinates, slave nodes first.
    pub positions: Vec<f64>,
    /// Start of the element's projection.
    pub start: [f64; 2],
    /// Where the projection was meant to be.
    pub target: [f64; 2],
    /// What every point remembers; empty without friction.
    pub friction: Vec<FrictionHistory>,
    /// The rounding of ζ to doubles, in which it is handed out and remembered, counts like that of the
    /// coordinates: for geometries whose parameters are singular close by.
    pub is_projection_data: bool,
}

impl Case {
    /// The state in octuple precision.
    pub fn state<'a>(&'a self, start: &'a [[f64; 2]]) -> State<'a> {
        State {
            pair: &self.pair,
            nodes: exact::nodes(&self.positions, self.pair.dimension),
            start,
            friction: &self.friction,
            nudge: [0.0; 2],
        }
    }

    /// Anchors that lie off the feet by the slip that the load asks for.
    pub(super) fn remembered(
        &self,
        load: Load,
        gap: f64,
        size: f64,
    ) -> Option<Vec<FrictionHistory>> {
        let law = &self.pair.tangential.as_ref()?.law;
        let (eps_t, mu) = match *law {
            TangentialLaw::Coulomb { eps_t, mu } => (eps_t, mu),
            TangentialLaw::Orthotropic { eps_t, mu } => (eps_t[0], mu[0]),
            _ => return None,
        };
        let Law::Penalty { eps_n } = self.pair.law else {
            return None;
        };
        let length = match load {
            Load::Normal => return None,
            Load::Slipped(length) => length * size,
            Load::Utilised(share) => share * mu * gap.abs() * (eps_n / eps_t),
        };
        let start = [self.target];
        let state = self.state(&start);
        let anchor = |q: usize| {
            let found = truth::foot(&state, q);
            let z = found.unwrap_or(self.target.map(Octuple::from));
            let k = Point::new(&self.pair, q).at(&state.nodes, z);
            let norm = |b: [Octuple; 3]| dot(b, b).sqrt().max(Octuple::from(1e-30));
            let share = [1.0, 0.6].map(Octuple::from);
            let mut step = [0, 1].map(|i| share[i] / norm(k.b[i]));
            if self.pair.parameters() == 1 {
                step[1] = Octuple::from(0.0);
            }
            let moved = add(scale(k.b[0], step[0]), scale(k.b[1], step[1]));
            let factor = Octuple::from(length) / norm(moved);
            [0, 1].map(|i| (z[i] - step[i] * factor).to_f64())
        };
        let history = |q: usize| FrictionHistory {
            status: Accepted::Stick,
            anchor: anchor(q),
            slip: 0.0,
            rolling: RollingHistory::default(),
        };
        Some((0..self.pair.points()).map(history).collect())
    }
}
