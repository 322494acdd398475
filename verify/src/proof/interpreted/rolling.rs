//! Moments about two curves of an interpreted element: from its tables to R and K, written out entry by entry.

use contact_elements::runtime::{Receiver, Write};
use contact_elements::table::RollingDescription;

use super::assembly::Assembly;
use super::friction::{Contact, LawOfElement, Load, State};
use super::rows::Point;
use super::site::TermSite;
use crate::interpret::interpret;

/// Moments and their slopes.
struct Moments {
    value: Vec<f64>,
    stiffness: Vec<f64>,
    by_pressure: Vec<f64>,
    energy: f64,
}

/// Entries of a form of two curves: vectors of s_A, s_A,i, s_A,ii, s_A,iii.
const FORM: usize = 21;
/// Pairs A⊙B, then pairs A⊗B.
const SYMMETRIC: usize = 9;
const PAIRS: usize = 11;

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
    /// Adds the contributions of the moments except their share of the tangential force, which goes to `state`.
    pub(super) fn rolling(
        &mut self,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        state: &mut State,
    ) {
        let Some(rolling) = self.subject.description.rolling else {
            return;
        };
        let moments = self.moments(rolling, point, contact);
        state.energy += moments.energy;
        let mut inputs = self.contact_inputs(point, contact, &state.frame);
        inputs.extend(self.third(contact.zeta));
        inputs.extend(self.directors(rolling));
        inputs.extend(&moments.value);
        let change = self.change(TermSite::RollingResidual);
        let values = interpret(&rolling.residual, &inputs, change);
        for (force, share) in state.force.iter_mut().zip(&values) {
            *force += share;
        }
        let third = self.third_rows(contact.zeta);
        for (i, entry) in self
            .motion(&values[2..], point, &third)
            .into_iter()
            .enumerate()
        {
            self.force((i / D, i % D), contact.weight * entry, Write::Add);
        }
        let Some(program) = &rolling.tangent else {
            return;
        };
        inputs.extend(moments.stiffness.iter().chain(&moments.by_pressure));
        inputs.push(contact.slope);
        let values = interpret(program, &inputs, self.change(TermSite::RollingTangent));
        let forms: Vec<Vec<f64>> = values
            .chunks_exact(FORM)
            .map(|form| self.motion(form, point, &third))
            .collect();
        let n = self.result.residual.len();
        for pair in 0..PAIRS {
            let (left, right) = (&forms[2 * pair], &forms[2 * pair + 1]);
            for i in 0..n {
                for j in 0..n {
                    let mut entry = left[i] * right[j];
                    if pair < SYMMETRIC {
                        entry += right[i] * left[j];
                    }
                    self.result.tangent[i * n + j] += contact.weight * entry;
                }
            }
        }
    }

    fn directors(&self, rolling: &RollingDescription) -> Vec<f64> {
        let at = rolling.layout.directors;
        at.map_or(vec![], |at| self.parameters[at..at + 6].to_vec())
    }

    /// The law at both angles, with the history of a contact that continues.
    fn moments(
        &self,
        rolling: &RollingDescription,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
    ) -> Moments {
        let mut inputs = contact.n.to_vec();
        inputs.extend(point.b.iter().flatten());
        match rolling.layout.directors {
            Some(_) => inputs.extend(self.directors(rolling)),
            None => inputs.extend(point.second[0].iter().chain(&point.second[2])),
        }
        let angles = interpret(&rolling.angle, &inputs, None);
        let size = self.subject.description.descriptor.point_history();
        let own = &self.history[contact.number * size + 2 + 2 * P..];
        let mut moments = Moments {
            value: vec![],
            stiffness: vec![],
            by_pressure: vec![],
            energy: 0.0,
        };
        for c in 0..2 {
            let turned = (angles[c] - own[c]).sin().atan2((angles[c] - own[c]).cos());
            let law = LawOfElement {
                law: rolling.law,
                parameters: rolling.layout.law,
                friction: TermSite::RollingLaw,
                sliding: TermSite::RollingSliding,
            };
            let load = Load {
                pressure: -contact.traction,
                path: own[2 + c],
                slips: contact.slips[1 + c],
            };
            let moment = self.force_of(&law, &[turned], &load);
            moments.value.extend(moment.t);
            moments.stiffness.extend(moment.c);
            moments.by_pressure.extend(moment.h);
            moments.energy += moment.energy;
        }
        moments
    }

    /// A form of two curves over all unknowns.
    fn motion(&self, form: &[f64], point: &Point<D, P>, third: &[Vec<f64>; 2]) -> Vec<f64> {
        let mut row = vec![0.0; self.result.residual.len()];
        for a in 0..point.s.len() {
            let rows = [
                point.s[a],
                point.ds[0][a],
                point.ds[P - 1][a],
                point.bend[0][a],
                point.bend[P][a],
                third[0][a],
                third[1][a],
            ];
            for k in 0..D {
                row[a * D + k] = (0..7).map(|v| rows[v] * form[3 * v + k]).sum();
            }
        }
        row
    }
}
