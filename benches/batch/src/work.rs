//! Our calls.

use std::hint::black_box;

use contact_elements::abi::{Arguments, Batch, element_evaluate, element_evaluate_batch_in};
use contact_elements::runtime::Width;
use contact_elements::{OUTPUT_SIZE, request};
use contact_library::PointQuad4;

use crate::states::States;

/// What is asked for.
#[derive(Clone, Copy)]
pub struct Work {
    pub request: u32,
    pub given: bool,
}

impl Work {
    pub fn tangent() -> Self {
        Self {
            request: request::RESIDUAL | request::TANGENT,
            given: false,
        }
    }
    pub fn residual() -> Self {
        Self {
            request: request::RESIDUAL,
            given: false,
        }
    }
    pub fn given(self) -> Self {
        Self {
            request: self.request | request::PROJECTION_GIVEN,
            given: true,
        }
    }
    pub fn reported(self) -> Self {
        Self {
            request: self.request | request::HISTORY | request::OUTPUT,
            ..self
        }
    }
}

/// Outputs of so many contacts.
pub struct Workspace {
    size: usize,
    f: Vec<f64>,
    k: Vec<f64>,
    history: Vec<f64>,
    output: Vec<f64>,
    status: Vec<i32>,
}

const PARAMETERS: [f64; 3] = [1000.0, 0.0, 1.0];

impl Workspace {
    pub fn new(size: usize) -> Self {
        Self {
            size,
            f: vec![0.0; 15 * size],
            k: vec![0.0; 225 * size],
            history: vec![0.0; 3 * size],
            output: vec![0.0; OUTPUT_SIZE * size],
            status: vec![0; size],
        }
    }

    pub fn one_by_one(&mut self, states: &States, work: Work) {
        let mut call = Arguments::EMPTY;
        call.request = work.request;
        call.parameters = PARAMETERS.as_ptr();
        call.parameter_count = 3;
        for e in 0..states.count {
            let own = e % self.size;
            call.x = states.x[15 * e..].as_ptr();
            call.history_accepted = states.start(work.given)[3 * e..].as_ptr();
            call.f = self.f[15 * own..].as_mut_ptr();
            call.k = self.k[225 * own..].as_mut_ptr();
            call.history_trial = self.history[3 * own..].as_mut_ptr();
            call.output = self.output[OUTPUT_SIZE * own..].as_mut_ptr();
            // SAFETY: all arrays have the element's extents.
            let code = unsafe { element_evaluate(PointQuad4::DESCRIPTOR, &mut call) };
            assert_eq!(code, 0);
        }
        black_box(&self.k);
    }

    pub fn batches(&mut self, states: &States, work: Work, width: Width) {
        let mut batch = Batch::EMPTY;
        batch.request = work.request;
        batch.parameters = PARAMETERS.as_ptr();
        batch.parameter_count = 3;
        batch.f = self.f.as_mut_ptr();
        batch.k = self.k.as_mut_ptr();
        batch.history_trial = self.history.as_mut_ptr();
        batch.output = self.output.as_mut_ptr();
        batch.status = self.status.as_mut_ptr();
        let mut first = 0;
        while first < states.count {
            let count = self.size.min(states.count - first);
            batch.x = states.x[15 * first..].as_ptr();
            batch.history_accepted = states.start(work.given)[3 * first..].as_ptr();
            // SAFETY: all arrays have the extents of `count` elements.
            let code = unsafe {
                let n = count as i64;
                element_evaluate_batch_in(PointQuad4::DESCRIPTOR, n, &mut batch, width)
            };
            assert_eq!(code, 0);
            first += count;
        }
        black_box(&self.k);
    }
}
