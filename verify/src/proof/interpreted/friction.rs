//! Tangential contact of one point of an interpreted element: from its tables to R and K, written out entry by
//! entry.

use contact_elements::runtime::{Receiver, Write};
use contact_elements::table::{AxisDescription, SlaveDescription, Table, TangentialLawPrograms};

use super::assembly::Assembly;
use super::rows::Point;
use super::site::TermSite;
use crate::interpret::interpret;

/// Results of the normal contact of the point that friction needs.
pub(super) struct Contact<'a, const D: usize> {
    pub(super) number: usize,
    pub(super) zeta: [f64; 2],
    /// Whether the point slides, and whether each curve rolls.
    pub(super) slips: [bool; 3],
    /// Normal in the frame of the geometry.
    pub(super) n: &'a [f64; D],
    pub(super) distance: f64,
    pub(super) traction: f64,
    pub(super) slope: f64,
    pub(super) weight: f64,
    /// w ∂J/∂x per unknown, where the measure moves.
    pub(super) variation: &'a [f64],
}

/// A tangential law in an element.
pub(super) struct LawOfElement<'a> {
    pub(super) law: &'a TangentialLawPrograms,
    /// Where its parameters begin.
    pub(super) parameters: usize,
    /// Sites of its terms.
    pub(super) friction: TermSite,
    pub(super) sliding: TermSite,
}

/// What a force depends on, besides the slip.
pub(super) struct Load {
    pub(super) pressure: f64,
    pub(super) path: f64,
    pub(super) slips: bool,
}

/// t, ∂t/∂s, ∂t/∂p and the stored energy.
pub(super) struct Force {
    pub(super) t: Vec<f64>,
    pub(super) c: Vec<f64>,
    pub(super) h: Vec<f64>,
    pub(super) energy: f64,
}

/// Slip, frame and force of the point.
pub(super) struct State {
    s: Vec<f64>,
    pub(super) frame: Vec<f64>,
    t: Vec<f64>,
    /// t and the share of the moments.
    pub(super) force: Vec<f64>,
    c: Vec<f64>,
    h: Vec<f64>,
    pub(super) energy: f64,
    /// Row and vector of the slave's tangent.
    slope: Vec<f64>,
    tangent: Vec<f64>,
}

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
    /// Adds the tangential residual, tangent and energy.
    pub(super) fn tangential(&mut self, point: &Point<D, P>, contact: &Contact<'_, D>) {
        let Some(law) = self.subject.description.tangential else {
            return;
        };
        // a contact that begins has neither force nor stiffness
        let Some(accepted) = self.accepted(contact) else {
            return;
        };
        let mut state = self.state(law, point, contact, accepted);
        self.rolling(point, contact, &mut state);
        self.energy(contact.weight * state.energy);
        let programs = self.subject.description.programs;
        if let Some(program) = &programs.tangential_residual {
            self.tangential_residual(program, point, contact, &state);
        }
        if let Some(program) = &programs.tangential_tangent {
            self.tangential_tangent(program, point, contact, &state);
        }
    }

    /// Anchor and path of the accepted history; `None` where the contact begins.
    fn accepted(&self, contact: &Contact<'_, D>) -> Option<(Vec<f64>, f64)> {
        let size = self.subject.description.descriptor.point_history();
        let history = self.history.get(contact.number * size..);
        match history.and_then(|history| history.get(..size)) {
            Some(own) if own[0] >= 1.0 && own[0] <= 3.0 => {
                Some((own[1 + P..1 + 2 * P].to_vec(), own[1 + 2 * P]))
            }
            _ => None,
        }
    }

    fn state(
        &self,
        law: &TangentialLawPrograms,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        (anchor, path): (Vec<f64>, f64),
    ) -> State {
        let (slope, tangent) = self.slave_tangent(contact.number);
        let mut inputs = contact.n.to_vec();
        inputs.extend(point.b.iter().flatten());
        inputs.extend(
            anchor
                .iter()
                .zip(contact.zeta)
                .map(|(anchor, zeta)| zeta - anchor),
        );
        match self.subject.description.axis {
            AxisDescription::None => {}
            AxisDescription::Convected => {
                let at = self.subject.description.layout.axis.unwrap_or(usize::MAX);
                inputs.extend(self.parameters.iter().skip(at).take(2));
            }
            AxisDescription::Slave => inputs.extend(&tangent),
        }
        let program = self.subject.description.programs.frame.as_ref();
        let values = program.map_or(vec![], |frame| interpret(frame, &inputs, None));
        let (s, frame) = (values[..P].to_vec(), values[P..P + P * P].to_vec());
        let law = LawOfElement {
            law,
            parameters: self.subject.description.layout.tangential,
            friction: TermSite::Friction,
            sliding: TermSite::Sliding,
        };
        let load = Load {
            pressure: -contact.traction,
            path,
            slips: contact.slips[0],
        };
        let force = self.force_of(&law, &s, &load);
        State {
            s,
            frame,
            force: force.t.clone(),
            t: force.t,
            c: force.c,
            h: force.h,
            energy: force.energy,
            slope,
            tangent,
        }
    }

    /// Force of a law at the slip s.
    pub(super) fn force_of(&self, of: &LawOfElement<'_>, s: &[f64], load: &Load) -> Force {
        let law = of.law;
        let count = s.len();
        let length = s.iter().map(|s| s * s).sum::<f64>().sqrt();
        let own = &self.parameters[of.parameters..];
        let mut inputs = vec![load.pressure, load.path + length];
        inputs.extend_from_slice(own);
        let values = interpret(&law.friction, &inputs, self.change(of.friction));
        let axes = if law.orthotropic { 2 } else { 1 };
        let stiffness = |q: usize| values[q % axes];
        let both = [s[0], s.get(1).copied().unwrap_or(0.0)];
        let mut t: Vec<f64> = (0..count).map(|q| stiffness(q) * both[q]).collect();
        let mut c = vec![0.0; count * count];
        let mut h = vec![0.0; count];
        for q in 0..count {
            c[q * count + q] = stiffness(q);
        }
        if let (true, Some(program)) = (load.slips, &law.sliding) {
            let mut inputs = both.to_vec();
            inputs.extend_from_slice(&values);
            if law.orthotropic {
                inputs.push(ellipse(both, &values));
            }
            let slide = interpret(program, &inputs, self.change(of.sliding));
            for q in 0..count {
                t[q] = slide[q];
                h[q] = slide[6 + q];
                for r in 0..count {
                    c[q * count + r] = slide[2 + 2 * q + r];
                }
            }
        }
        let energy = (0..count).map(|q| t[q] * t[q] / (2.0 * stiffness(q))).sum();
        Force { t, c, h, energy }
    }

    /// Row and vector of the slave curve's tangent, where it is an axis.
    fn slave_tangent(&self, number: usize) -> (Vec<f64>, Vec<f64>) {
        let none = (vec![0.0; self.x.len()], vec![0.0; D]);
        if self.subject.description.axis != AxisDescription::Slave {
            return none;
        }
        let layout = &self.subject.description.layout;
        let (geometry, eta) = match &self.subject.description.slave {
            SlaveDescription::Given(geometry) => (*geometry, self.parameters[layout.point]),
            SlaveDescription::Integrated(geometry, points) => (*geometry, points[number].0[0]),
            _ => return none,
        };
        let (mut row, mut vector) = none;
        for (a, slope) in self.slopes(geometry, eta).into_iter().enumerate() {
            row[a] = slope;
            for k in 0..D {
                vector[k] += slope * self.x[a][k];
            }
        }
        (row, vector)
    }

    /// n, L, b_i, r_,ij, E
    pub(super) fn contact_inputs(
        &self,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        frame: &[f64],
    ) -> Vec<f64> {
        let mut inputs = contact.n.to_vec();
        inputs.push(contact.distance);
        inputs.extend(point.b.iter().flatten());
        inputs.extend(point.second.iter().flatten());
        inputs.extend_from_slice(frame);
        inputs
    }

    fn tangential_residual(
        &mut self,
        program: &Table,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        state: &State,
    ) {
        let mut inputs = self.contact_inputs(point, contact, &state.frame);
        inputs.extend_from_slice(&state.force);
        let values = interpret(program, &inputs, self.change(TermSite::TangentialResidual));
        let force = self
            .placement
            .vector_to_global(&std::array::from_fn(|k| values[k]));
        let normal = self.placement.vector_to_global(contact.n);
        for a in 0..point.s.len() {
            let turn: f64 = (0..P).map(|i| values[D + i] * point.ds[i][a]).sum();
            for k in 0..D {
                let value = point.s[a] * force[k] + turn * normal[k];
                self.force((a, k), contact.weight * value, Write::Add);
            }
        }
    }

    fn tangential_tangent(
        &mut self,
        program: &Table,
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        state: &State,
    ) {
        let mut inputs = self.contact_inputs(point, contact, &state.frame);
        inputs.extend(self.third(contact.zeta));
        for part in [&state.s, &state.t, &state.c, &state.h] {
            inputs.extend_from_slice(part);
        }
        inputs.push(contact.slope);
        if self.subject.description.rolling.is_some() {
            inputs.extend_from_slice(&state.force);
        }
        if self.subject.description.axis == AxisDescription::Slave {
            inputs.extend_from_slice(&state.tangent);
        }
        let values = interpret(program, &inputs, self.change(TermSite::TangentialTangent));
        let (forms, cross) = self.tangential_forms(&values, point, contact, state);
        let n = self.result.residual.len();
        let sigma: Vec<f64> = (0..point.s.len())
            .map(|a| (0..P).map(|i| cross[i] * point.ds[i][a]).sum())
            .collect();
        for i in 0..n {
            for j in 0..n {
                let mut sum = 0.0;
                for q in 0..P {
                    let measure = contact.variation.get(j).copied().unwrap_or(0.0);
                    sum += contact.weight * forms[q][i] * forms[2 * P + q][j];
                    sum += contact.weight * forms[P + q][i] * forms[q][j];
                    sum += forms[q][i] * state.t[q] * measure;
                }
                if i % D == j % D {
                    let (a, b) = (i / D, j / D);
                    sum += contact.weight * (point.s[a] * sigma[b] + sigma[a] * point.s[b]);
                }
                self.result.tangent[i * n + j] += sum;
            }
        }
    }

    /// The forms Z, −P and G over all unknowns, P of each, and the coefficients of the crossed terms.
    fn tangential_forms(
        &self,
        mut values: &[f64],
        point: &Point<D, P>,
        contact: &Contact<'_, D>,
        state: &State,
    ) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut take = |count: usize| {
            let (head, tail) = values.split_at(count);
            values = tail;
            head
        };
        let none = [0.0; 3];
        let mut forms = Vec::new();
        for _ in 0..P {
            let (position, levers) = (take(D), take(P));
            let turning: Vec<f64> = levers
                .iter()
                .flat_map(|lever| contact.n.map(|n| lever * n))
                .collect();
            let form = [position, &turning, &none[..P * (P + 1) / 2], &none[..D]];
            forms.push(self.row_of(&form.concat(), point, contact.n, &state.slope));
        }
        let mut bendings = Vec::new();
        for _ in 0..P {
            let (vectors, bending) = (take(D + P * D), take(P * (P + 1) / 2));
            let form = [vectors, bending, &none[..D]];
            forms.push(self.row_of(&form.concat(), point, contact.n, &state.slope));
            bendings.push(bending);
        }
        for bending in bendings {
            let (vectors, slave) = (take(D + P * D), take(D));
            let form = [vectors, bending, slave];
            forms.push(self.row_of(&form.concat(), point, contact.n, &state.slope));
        }
        (forms, take(P).to_vec())
    }

    /// A linear form over all unknowns, in the global frame.
    fn row_of(&self, form: &[f64], point: &Point<D, P>, n: &[f64; D], slave: &[f64]) -> Vec<f64> {
        let mut row = vec![0.0; self.result.residual.len()];
        let vector = |at: usize| -> [f64; D] { std::array::from_fn(|k| form[at + k]) };
        let bending = D + P * D;
        let last = bending + P * (P + 1) / 2;
        for a in 0..point.s.len() {
            let mut sum = [0.0; D];
            let mut add = |factor: f64, vector: [f64; D]| {
                for k in 0..D {
                    sum[k] += factor * vector[k];
                }
            };
            add(point.s[a], vector(0));
            for i in 0..P {
                add(point.ds[i][a], vector(D + i * D));
            }
            for (h, bend) in point.bend.iter().enumerate() {
                add(form[bending + h] * bend[a], *n);
            }
            add(slave[a], vector(last));
            let global = self.placement.vector_to_global(&sum);
            row[a * D..(a + 1) * D].copy_from_slice(&global);
        }
        row
    }
}

/// γ with Σ (y_q/(1 + γ k_q))² = 1 by bisection; values: stiffness, bound.
pub(in crate::proof) fn ellipse(s: [f64; 2], values: &[f64]) -> f64 {
    let ratio = (values[0] / values[1]).sqrt() * (values[3] / values[2]);
    let k = [ratio, 1.0 / ratio];
    let excess = |gamma: f64| {
        let z = |q: usize| values[q] * s[q] / values[2 + q] / (1.0 + gamma * k[q]);
        z(0).hypot(z(1)) - 1.0
    };
    let (mut low, mut high) = (0.0, 1.0);
    while excess(high) > 0.0 && high < 1e300 {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
