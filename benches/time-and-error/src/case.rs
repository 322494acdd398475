//! A state of an element, ready to be evaluated as a host would.

use std::hint::black_box;

use contact_elements::{Error, Evaluation, Registered, Summary, evaluate, request};
use contact_verify::configurations::Configuration;
use contact_verify::subject::Subject;

use crate::Failure;

/// Inputs of a call.
#[derive(Clone, Debug)]
pub struct Case {
    /// The element.
    pub descriptor: &'static Registered,
    /// Positions of all nodes.
    pub x: Vec<f64>,
    /// Displacements; empty: zero.
    pub u: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
    /// Start of the projection, or the projection itself.
    pub history: Vec<f64>,
    /// Row of an interpolated slave.
    pub slave_row: Vec<f64>,
}

/// What a call asks for.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Tangent beside the residual.
    pub tangent: bool,
    /// Further bits.
    pub bits: u32,
}

impl Request {
    /// R and K; the projection starts from the history.
    pub const BOTH: Self = Self {
        tangent: true,
        bits: 0,
    };
    /// R alone.
    pub const RESIDUAL: Self = Self {
        tangent: false,
        bits: 0,
    };
    /// R and K with the projection of the history.
    pub const GIVEN: Self = Self {
        tangent: true,
        bits: request::PROJECTION_GIVEN,
    };
    /// R and K; in a batch what is certainly open is not projected.
    pub const SCREENED: Self = Self {
        tangent: true,
        bits: request::SCREEN,
    };
}

/// Outputs of a call.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    /// R.
    pub residual: Vec<f64>,
    /// K by rows.
    pub tangent: Vec<f64>,
    workspace: Vec<f64>,
}

impl Answer {
    /// Room for the outputs of a case.
    pub fn of(case: &Case) -> Self {
        let nodes = case.x.len() / case.descriptor.dimension;
        let unknowns = case.descriptor.unknowns(nodes);
        let tangent = if case.descriptor.tangent {
            unknowns * unknowns
        } else {
            0
        };
        Self {
            residual: vec![0.0; unknowns],
            tangent: vec![0.0; tangent],
            workspace: vec![0.0; case.descriptor.workspace(nodes)],
        }
    }
}

impl Case {
    /// A random state; displacements are part of the positions.
    pub fn new(subject: &Subject, configuration: &Configuration) -> Self {
        Self {
            descriptor: subject.description.descriptor,
            x: configuration.positions(),
            u: vec![],
            parameters: subject.parameters(&configuration.pair),
            history: subject.history_of(configuration),
            slave_row: subject.slave_row(&configuration.pair),
        }
    }

    /// Evaluates; the outputs are kept from the optimiser.
    pub fn evaluate(&self, request: Request, answer: &mut Answer) -> Result<Summary, Error> {
        let outcome = evaluate(
            self.descriptor,
            &mut Evaluation {
                x: &self.x,
                u: &self.u,
                parameters: &self.parameters,
                history: &self.history,
                slave_row: &self.slave_row,
                residual: &mut answer.residual,
                tangent: if request.tangent {
                    &mut answer.tangent
                } else {
                    &mut []
                },
                workspace: &mut answer.workspace,
                bits: request.bits,
                ..Evaluation::default()
            },
        );
        black_box(answer);
        outcome
    }

    /// The same case with the projection that the element finds as its history.
    ///
    /// # Errors
    /// Where the element refuses the state.
    pub fn projected(&self) -> Result<Self, Failure> {
        let mut history = vec![0.0; self.descriptor.history()];
        let mut answer = Answer::of(self);
        let outcome = evaluate(
            self.descriptor,
            &mut Evaluation {
                x: &self.x,
                u: &self.u,
                parameters: &self.parameters,
                history: &self.history,
                slave_row: &self.slave_row,
                trial: &mut history,
                residual: &mut answer.residual,
                workspace: &mut answer.workspace,
                ..Evaluation::default()
            },
        );
        if let Err(error) = outcome {
            return Err(format!("{}: {error}", self.name()).into());
        }
        // friction is judged from what was accepted, only the projection is taken over
        let mut projected = self.clone();
        if projected.history.is_empty() {
            projected.history = history;
            return Ok(projected);
        }
        let size = self.descriptor.point_history();
        for q in 0..self.descriptor.points {
            let entries = q * size + 1..q * size + 1 + self.descriptor.projected;
            projected.history[entries.clone()].copy_from_slice(&history[entries]);
        }
        Ok(projected)
    }

    /// Name of the element.
    pub fn name(&self) -> &'static str {
        self.descriptor.name.trim_end_matches('\0')
    }
}
