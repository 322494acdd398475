//! The sums of an interpreted element: its state, its inputs in the frame of the geometry, what it adds up.

use contact_elements::runtime::{Enforcement, Placement, Receiver, Report, Write};
use contact_elements::table::MasterDescription;

use super::site::{Mutation, TermSite};
use crate::interpret::Change;
use crate::subject::{Input, Subject};

/// Residual, tangent and energy of an interpreted element.
#[derive(Clone, Debug)]
pub struct Interpreted {
    /// R
    pub residual: Vec<f64>,
    /// K
    pub tangent: Vec<f64>,
    /// W
    pub energy: f64,
}

/// The sums of an element in D dimensions with P projected parameters.
pub(super) struct Assembly<'a, const D: usize, const P: usize> {
    pub(super) subject: &'a Subject,
    pub(super) parameters: &'a [f64],
    pub(super) slave_row: &'a [f64],
    pub(super) history: &'a [f64],
    pub(super) multipliers: &'a [f64],
    pub(super) mutation: Option<Mutation>,
    /// Positions, in the frame of a placed geometry.
    pub(super) x: Vec<[f64; D]>,
    /// Global positions and reference positions, for the measure.
    pub(super) global: Vec<[f64; D]>,
    pub(super) reference: Vec<[f64; D]>,
    pub(super) placement: Placement<D>,
    pub(super) result: Interpreted,
}

impl<const D: usize, const P: usize> Receiver for Assembly<'_, D, P> {
    fn open(&mut self, _: usize) {}
    fn force(&mut self, (node, component): (usize, usize), value: f64, _: Write) {
        self.result.residual[node * D + component] += value;
    }
    fn row(&mut self, unknown: usize, row: &[f64], _: Write) {
        let n = self.result.residual.len();
        for (entry, value) in self.result.tangent[unknown * n..].iter_mut().zip(row) {
            *entry += value;
        }
    }
    // the contraction calls neither
    fn multiplier(&mut self, _: (usize, usize), _: f64) {}
    fn coupling(&mut self, _: usize, _: usize, _: f64) {}
    fn clear(&mut self, _: usize) {}
    fn report(&mut self, _: usize, _: &Report) {}
    fn energy(&mut self, energy: f64) {
        self.result.energy += energy;
    }
}

impl<'a, const D: usize, const P: usize> Assembly<'a, D, P> {
    pub(super) fn new(subject: &'a Subject, input: &Input<'a>, mutation: Option<Mutation>) -> Self {
        let placement = match subject.description.layout.placement {
            Some(at) => Placement::from_parameters(&input.parameters[at..]),
            None => Placement::identity(),
        };
        let (reference, _) = input.reference.as_chunks::<D>();
        let (displacement, _) = input.displacement.as_chunks::<D>();
        let global: Vec<[f64; D]> = reference
            .iter()
            .zip(displacement)
            .map(|(x, u)| std::array::from_fn(|k| x[k] + u[k]))
            .collect();
        let flags = subject.description.descriptor.vectors;
        let first = global.len() - flags.len();
        let local = |(a, x): (usize, &[f64; D])| {
            let is_vector = a >= first && flags[a - first];
            placement.vector_to_local(&std::array::from_fn(|k| {
                x[k] - if is_vector { 0.0 } else { placement.origin[k] }
            }))
        };
        let x = global.iter().enumerate().map(local).collect();
        let n = input.reference.len();
        Self {
            subject,
            parameters: input.parameters,
            slave_row: input.slave_row,
            history: input.history,
            multipliers: input.multipliers,
            mutation,
            x,
            global,
            reference: reference.to_vec(),
            placement,
            result: Interpreted {
                residual: vec![0.0; n],
                tangent: vec![0.0; n * n],
                energy: 0.0,
            },
        }
    }

    pub(super) fn change(&self, site: TermSite) -> Option<Change> {
        self.mutation
            .filter(|(at, _)| *at == site)
            .map(|(_, change)| change)
    }

    /// The multiplier beside the law of a point, where there is one.
    pub(super) fn multiplier_of(&self, number: usize) -> Option<f64> {
        let descriptor = self.subject.description.descriptor;
        let size = descriptor.point_history();
        match descriptor.enforcement {
            Enforcement::Penalty => None,
            Enforcement::Augmented => self.history.get((number + 1) * size - 1).copied(),
            Enforcement::Multiplier => self.multipliers.get(number).copied(),
        }
    }

    /// Parameters of a distance function.
    pub(super) fn own_parameters(&self) -> Vec<f64> {
        let MasterDescription::Distance(geometry) = &self.subject.description.master else {
            return vec![];
        };
        let count = geometry.values.inputs.len() - D - 2;
        let at = self.subject.description.layout.geometry;
        self.parameters[at..at + count].to_vec()
    }

    pub(super) fn orientation(&self) -> f64 {
        match self.subject.description.layout.orientation {
            Some(at) if self.parameters[at] < 0.0 => -1.0,
            _ => 1.0,
        }
    }
}
