//! Calls of an element from Rust, with the checks of the C interface.

use contact_elements::{Error, Evaluation, OUTPUT_SIZE, Status, Summary, evaluate};

use super::Subject;
use crate::oracle::solve::Couplings;

impl Subject {
    /// Calls the element.
    pub fn call(&self, input: &Input<'_>, wanted: Wanted) -> Answer {
        let descriptor = self.description.descriptor;
        let d = descriptor.dimension;
        let positions = input.reference.len();
        let nodes = positions / d + descriptor.multipliers();
        let unknowns = descriptor.unknowns(nodes);
        let tangent = if wanted.tangent && descriptor.tangent {
            unknowns * unknowns
        } else {
            0
        };
        let (mut x, mut u) = (input.reference.to_vec(), input.displacement.to_vec());
        for q in 0..descriptor.multipliers() {
            // the coordinates of a multiplier's node are not read
            let value = input.multipliers.get(q).copied().unwrap_or(0.0);
            x.extend(vec![UNTOUCHED; d]);
            u.push(value);
            u.extend(vec![UNTOUCHED; d - 1]);
        }
        let mut answer = Answer {
            residual: vec![UNTOUCHED; unknowns],
            tangent: vec![UNTOUCHED; tangent],
            output: vec![UNTOUCHED; descriptor.points * OUTPUT_SIZE],
            energy: vec![UNTOUCHED; usize::from(descriptor.energy)],
            history: vec![UNTOUCHED; descriptor.history()],
            couplings: Couplings::default(),
            outcome: None,
        };
        let mut workspace = vec![0.0; descriptor.workspace(nodes)];
        let outcome = evaluate(
            descriptor,
            &mut Evaluation {
                x: &x,
                u: &u,
                parameters: input.parameters,
                history: input.history,
                slave_row: input.slave_row,
                residual: if wanted.residual {
                    &mut answer.residual
                } else {
                    &mut []
                },
                tangent: &mut answer.tangent,
                output: &mut answer.output,
                trial: &mut answer.history,
                energy: &mut answer.energy,
                workspace: &mut workspace,
                bits: wanted.bits,
            },
        );
        answer.outcome = Some(outcome);
        answer.split(positions);
        answer
    }
}

/// Value of an entry that the element did not write.
pub const UNTOUCHED: f64 = -7.25e77;

/// Inputs of a call.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// X.
    pub reference: &'a [f64],
    /// u.
    pub displacement: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// History: start of the projection; with friction anchors and paths.
    pub history: &'a [f64],
    /// Row of an interpolated slave.
    pub slave_row: &'a [f64],
    /// Multipliers that are unknowns.
    pub multipliers: &'a [f64],
}

/// Outputs that a call requests.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Residual.
    pub residual: bool,
    /// Tangent.
    pub tangent: bool,
    /// Further request bits.
    pub bits: u32,
}

impl Wanted {
    /// Residual and tangent.
    pub const BOTH: Self = Self {
        residual: true,
        tangent: true,
        bits: 0,
    };
}

/// Outputs of a call.
#[derive(Clone, Debug)]
pub struct Answer {
    /// R.
    pub residual: Vec<f64>,
    /// K, row-major; empty where not offered or not requested.
    pub tangent: Vec<f64>,
    /// Output per contact point.
    pub output: Vec<f64>,
    /// Energy.
    pub energy: Vec<f64>,
    /// Trial history per contact point.
    pub history: Vec<f64>,
    /// What belongs to multipliers that are unknowns.
    pub couplings: Couplings,
    /// What the call returned.
    pub outcome: Option<Result<Summary, Error>>,
}

impl Answer {
    /// Takes what belongs to multipliers out of residual and tangent.
    fn split(&mut self, positions: usize) {
        let all = self.residual.len();
        if all == positions {
            return;
        }
        self.couplings.residual = self.residual.split_off(positions);
        let whole = std::mem::take(&mut self.tangent);
        let at = |i: usize, j: usize| whole[all * i + j];
        let (inner, outer) = (0..positions, positions..all);
        if whole.is_empty() {
            return;
        }
        for i in inner.clone() {
            self.tangent.extend(inner.clone().map(|j| at(i, j)));
        }
        for q in outer.clone() {
            self.couplings
                .columns
                .extend(inner.clone().map(|i| at(i, q)));
            self.couplings.rows.extend(inner.clone().map(|j| at(q, j)));
            self.couplings.block.extend(outer.clone().map(|p| at(q, p)));
        }
    }

    /// Status of the element.
    pub fn status(&self) -> Option<Status> {
        match self.outcome? {
            Ok(summary) => Some(summary.status),
            Err(error) => error.status,
        }
    }

    /// True where no output was written.
    pub fn is_untouched(&self) -> bool {
        let mut entries = self
            .residual
            .iter()
            .chain(&self.tangent)
            .chain(&self.energy)
            .chain(&self.history)
            .chain(&self.couplings.residual)
            .chain(&self.couplings.block);
        entries.all(|&value| value == UNTOUCHED)
    }

    /// True where residual and tangent are exactly zero.
    pub fn is_zero(&self) -> bool {
        self.residual
            .iter()
            .chain(&self.tangent)
            .all(|&value| value == 0.0)
    }
}
