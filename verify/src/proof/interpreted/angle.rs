//! Contact weighted by the angle of two curves in an interpreted element: from its tables to R and K, written out
//! entry by entry.

use contact_elements::runtime::{Receiver, Write};
use contact_elements::table::{AngleDescription, SlaveDescription};

use super::assembly::Assembly;
use super::friction::Contact;
use super::rows::Point;
use super::site::TermSite;
use crate::interpret::interpret;

/// Entries of a form: vectors of s_A, of both rows N_A,1 and of both rows N_A,11.
const FORM: usize = 15;

/// What the weight makes of the law at a point.
pub(super) struct Blend {
    /// w, w', w''.
    weight: [f64; 3],
    /// N and W of the law.
    load: [f64; 2],
    /// Tangents of slave and master.
    tangents: [Vec<f64>; 2],
    /// Rows N_A,1 of the slave, where its parameter is fixed.
    slave: Vec<f64>,
}

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
    /// The weight of a point, applied to N, N' and W; `None` for an element that acts at any angle.
    pub(super) fn weigh(
        &self,
        number: usize,
        point: &Point<D, P>,
        law: &mut [f64],
    ) -> Option<Blend> {
        let angle = self.subject.description.angle?;
        let slave = self.fixed_slopes(number);
        let u = match slave.is_empty() {
            true => point.b[0].to_vec(),
            false => (0..D)
                .map(|k| slave.iter().zip(&self.x).map(|(n, x)| n * x[k]).sum())
                .collect(),
        };
        let tangents = [u, point.b[P - 1].to_vec()];
        let mut inputs = tangents.concat();
        inputs.extend(&self.parameters[angle.window..angle.window + 2]);
        let position = interpret(&angle.position, &inputs, None);
        let position = [position[0].clamp(0.0, 1.0), position[1]];
        let weight = interpret(&angle.weight, &position, self.change(TermSite::AngleWeight));
        let load = [law[0], law[2]];
        for value in law.iter_mut() {
            *value *= weight[0];
        }
        Some(Blend {
            weight: std::array::from_fn(|k| weight[k]),
            load,
            tangents,
            slave,
        })
    }

    /// Adds W w' δq and what comes with it to K.
    pub(super) fn blended(
        &mut self,
        blend: Option<Blend>,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
    ) {
        let (Some(angle), Some(blend)) = (self.subject.description.angle, blend) else {
            return;
        };
        let mut inputs = contact.n.to_vec();
        inputs.push(contact.distance);
        inputs.extend(blend.tangents.iter().flatten());
        let second = if P == 2 { vec![0, 2] } else { vec![0] };
        inputs.extend(second.iter().flat_map(|&h| point.second[h]));
        let [_, slope, curvature] = blend.weight;
        let [traction, energy] = blend.load;
        let mut of_residual = inputs.clone();
        of_residual.extend([slope, energy]);
        let change = self.change(TermSite::AngleResidual);
        let values = interpret(&angle.residual, &of_residual, change);
        let rows = self.angle_rows(&blend, point);
        for (i, entry) in self.form(&values, &rows).into_iter().enumerate() {
            self.force((i / D, i % D), contact.weight * entry, Write::Add);
        }
        let third = self.third(contact.zeta);
        let third = third.chunks_exact(D).enumerate();
        let own = third.filter(|(h, _)| P == 1 || *h == 0 || *h == 3);
        inputs.extend(own.flat_map(|(_, vector)| vector.to_vec()));
        inputs.extend([slope, energy, curvature, traction]);
        self.blended_tangent(angle, &inputs, &rows, contact.weight);
    }

    fn blended_tangent(
        &mut self,
        angle: &AngleDescription,
        inputs: &[f64],
        rows: &[Vec<f64>; 5],
        weight: f64,
    ) {
        let Some(program) = &angle.tangent else {
            return;
        };
        let values = interpret(program, inputs, self.change(TermSite::AngleTangent));
        let forms: Vec<Vec<f64>> = values
            .chunks_exact(FORM)
            .map(|form| self.form(form, rows))
            .collect();
        let n = self.result.residual.len();
        for pair in forms.chunks_exact(2) {
            for i in 0..n {
                for j in 0..n {
                    let entry = pair[0][i] * pair[1][j] + pair[1][i] * pair[0][j];
                    self.result.tangent[i * n + j] += weight * entry;
                }
            }
        }
    }

    /// N_A,1 of the slave at an integration point; empty for a curve whose parameter is projected.
    fn fixed_slopes(&self, number: usize) -> Vec<f64> {
        match &self.subject.description.slave {
            SlaveDescription::Integrated(geometry, points) => {
                self.slopes(geometry, points[number].0[0])
            }
            SlaveDescription::Given(geometry) => {
                let at = self.subject.description.layout.point;
                self.slopes(geometry, self.parameters[at])
            }
            _ => vec![],
        }
    }

    /// The rows of a form, over all nodes.
    fn angle_rows(&self, blend: &Blend, point: &Point<D, P>) -> [Vec<f64>; 5] {
        let n = point.s.len();
        let mut slave = blend.slave.clone();
        slave.resize(n, 0.0);
        if P == 2 {
            let (slave, master) = (point.ds[0].clone(), point.ds[1].clone());
            let (bend, last) = (point.bend[0].clone(), point.bend[2].clone());
            [point.s.clone(), slave, master, bend, last]
        } else {
            let (master, bend) = (point.ds[0].clone(), point.bend[0].clone());
            [point.s.clone(), slave, master, vec![0.0; n], bend]
        }
    }

    /// A form over all unknowns.
    fn form(&self, form: &[f64], rows: &[Vec<f64>; 5]) -> Vec<f64> {
        let entry = |a: usize, k: usize| (0..5).map(|v| rows[v][a] * form[3 * v + k]).sum();
        let nodes = self.result.residual.len() / D;
        (0..nodes)
            .flat_map(|a| (0..D).map(move |k| (a, k)))
            .map(|(a, k)| entry(a, k))
            .collect()
    }
}
