//! Normal contact of one point of an interpreted element: gap, coefficients, measure and contraction.

use contact_elements::runtime::{Coefficients, NormalContraction, Temporaries, Write, contract};
use contact_elements::table::MasterDescription;

use super::assembly::Assembly;
use super::friction::Contact;
use super::rows::{Point, fill};
use super::site::TermSite;
use crate::interpret::interpret;

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
    /// n, L, g in the frame of the geometry.
    pub(super) fn gap(&self, point: &Point<D, P>) -> ([f64; D], f64, f64) {
        let layout = &self.subject.description.layout;
        let mut inputs = point.r.to_vec();
        inputs.extend(self.own_parameters());
        inputs.extend(point.b.iter().flatten());
        inputs.push(self.orientation());
        inputs.push(self.parameters[layout.r0]);
        let values = interpret(&self.subject.description.programs.gap, &inputs, None);
        (std::array::from_fn(|k| values[k]), values[D], values[D + 1])
    }

    pub(super) fn coefficients(
        &self,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
    ) -> Coefficients<D, P> {
        let mut result = Coefficients::default();
        let Some(program) = &self.subject.description.programs.tangent else {
            return result;
        };
        let mut inputs;
        if matches!(
            self.subject.description.master,
            MasterDescription::Distance(_)
        ) {
            inputs = point.r.to_vec();
            inputs.extend(self.own_parameters());
            inputs.push(self.orientation());
        } else {
            inputs = contact.n.to_vec();
            inputs.push(contact.distance);
            inputs.extend(point.b.iter().flatten());
            inputs.extend(point.second.iter().flatten());
        }
        inputs.extend([contact.traction, contact.slope]);
        let values = interpret(program, &inputs, self.change(TermSite::Tangent));
        let values: Vec<f64> = values.iter().map(|v| contact.weight * v).collect();
        let (p, rest) = values.split_at(D * D);
        fill(result.p.as_flattened_mut(), p.iter().copied());
        if !rest.is_empty() {
            fill(result.right.as_flattened_mut(), rest.iter().copied());
            fill(
                result.left.as_flattened_mut(),
                rest[P * D..].iter().copied(),
            );
            fill(
                result.s.as_flattened_mut(),
                rest[2 * P * D..].iter().copied(),
            );
        }
        result.p = self.placement.tensor_to_global(&result.p);
        for vector in result.right.iter_mut().chain(&mut result.left) {
            *vector = self.placement.vector_to_global(vector);
        }
        result
    }

    /// Weight times Jacobian, and its variation per unknown where the measure moves.
    pub(super) fn measure(&self, slopes: &[Vec<f64>], rule_weight: f64) -> (f64, Vec<f64>) {
        let Some(program) = &self.subject.description.programs.measure else {
            return (rule_weight, vec![]);
        };
        let current = self.subject.description.current;
        let x = if current {
            &self.global
        } else {
            &self.reference
        };
        let mut inputs = vec![0.0; slopes.len() * D];
        for (i, slopes) in slopes.iter().enumerate() {
            for (slope, x) in slopes.iter().zip(x) {
                for k in 0..D {
                    inputs[i * D + k] += slope * x[k];
                }
            }
        }
        let values = interpret(program, &inputs, self.change(TermSite::Measure));
        let mut variation = vec![0.0; self.result.residual.len()];
        if current {
            for (i, slopes) in slopes.iter().enumerate() {
                for (a, slope) in slopes.iter().enumerate() {
                    for k in 0..D {
                        variation[a * D + k] += rule_weight * slope * values[1 + i * D + k];
                    }
                }
            }
        }
        (rule_weight * values[0], variation)
    }

    pub(super) fn contract(
        &mut self,
        point: &Point<D, P>,
        n: &[f64; D],
        coefficients: &Coefficients<D, P>,
        variation: &[f64],
    ) {
        let unknowns = self.result.residual.len();
        let mut u: [Vec<f64>; D] = std::array::from_fn(|_| vec![0.0; unknowns]);
        let mut g: [Vec<f64>; P] = std::array::from_fn(|_| vec![0.0; unknowns]);
        let (mut h, mut row) = (vec![0.0; unknowns], vec![0.0; unknowns]);
        let moving = self.subject.description.moving;
        contract(
            &NormalContraction {
                s: &point.s,
                ds: std::array::from_fn(|j| &*point.ds[j]),
                n,
                coefficients,
                measure: if self.subject.description.current {
                    variation
                } else {
                    &[]
                },
                moving,
                write: Write::Add,
            },
            &mut Temporaries {
                u: u.each_mut().map(Vec::as_mut_slice),
                g: g.each_mut().map(Vec::as_mut_slice),
                h: &mut h,
                row: &mut row,
            },
            self,
        );
    }
}
