//! An element put together from its tables, with one term of a linearisation changed if wanted.
//!
//! The tables give rows, kinematics, gap, law and coefficients; the library's level 2 contracts them. The
//! projection is the one that the compiled element found.

mod angle;
mod friction;
mod rolling;
mod rows;

use contact_elements::abi::OUTPUT_SIZE;
use contact_elements::program::{MasterDescription, Program};
use contact_elements::runtime::{
    Coefficients, Enforcement, Placement, Receiver, Report, Temporaries, contract,
};

use crate::interpret::{Change, interpret};
use crate::subject::{Answer, Input, Subject};
use friction::Contact;
pub(super) use friction::ellipse;
use rows::{Point, fill};

/// Program of an element that holds terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Law.
    Law,
    /// Coefficients of the tangent.
    Tangent,
    /// Measure.
    Measure,
    /// Stiffness and bound of the tangential law.
    Friction,
    /// Force beyond the bound.
    Sliding,
    /// Coefficients of the tangential residual.
    TangentialResidual,
    /// Coefficients of the tangential tangent.
    TangentialTangent,
    /// Stiffness and bound of the law of rolling.
    RollingLaw,
    /// Moment beyond the bound.
    RollingSliding,
    /// Coefficients of the residual of the moments.
    RollingResidual,
    /// Coefficients of the tangent of the moments.
    RollingTangent,
    /// Weight by the angle and its derivatives.
    AngleWeight,
    /// Form of the residual that the weight adds.
    AngleResidual,
    /// Pairs of forms of the tangent that the weight adds.
    AngleTangent,
}

impl Place {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Law,
        Self::Tangent,
        Self::Measure,
        Self::Friction,
        Self::Sliding,
        Self::TangentialResidual,
        Self::TangentialTangent,
        Self::RollingLaw,
        Self::RollingSliding,
        Self::RollingResidual,
        Self::RollingTangent,
        Self::AngleWeight,
        Self::AngleResidual,
        Self::AngleTangent,
    ];
}

/// A changed term: where, which, how.
pub type Mutation = (Place, Change);

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

/// The program of a subject at a place.
pub fn program(subject: &Subject, place: Place) -> Option<&'static Program> {
    match place {
        Place::Law => Some(&subject.description.law.law),
        Place::Tangent => subject.description.programs.tangent.as_ref(),
        Place::Measure => subject.description.programs.measure.as_ref(),
        Place::Friction => subject.description.tangential.map(|law| &law.friction),
        Place::Sliding => subject.description.tangential?.sliding.as_ref(),
        Place::TangentialResidual => subject.description.programs.tangential_residual.as_ref(),
        Place::TangentialTangent => subject.description.programs.tangential_tangent.as_ref(),
        Place::RollingLaw => subject.description.rolling.map(|own| &own.law.friction),
        Place::RollingSliding => subject.description.rolling?.law.sliding.as_ref(),
        Place::RollingResidual => subject.description.rolling.map(|own| &own.residual),
        Place::RollingTangent => subject.description.rolling?.tangent.as_ref(),
        Place::AngleWeight => subject.description.angle.map(|own| &own.weight),
        Place::AngleResidual => subject.description.angle.map(|own| &own.residual),
        Place::AngleTangent => subject.description.angle?.tangent.as_ref(),
    }
}

/// Evaluates the closed points that `answer` reports.
pub fn evaluate(
    subject: &Subject,
    input: &Input<'_>,
    answer: &Answer,
    mutation: Option<Mutation>,
) -> Interpreted {
    match (
        subject.description.descriptor.dimension,
        subject.description.descriptor.projected,
    ) {
        (2, 0) => Assembly::<2, 0>::new(subject, input, mutation).all(answer),
        (2, _) => Assembly::<2, 1>::new(subject, input, mutation).all(answer),
        (_, 0) => Assembly::<3, 0>::new(subject, input, mutation).all(answer),
        (_, 1) => Assembly::<3, 1>::new(subject, input, mutation).all(answer),
        _ => Assembly::<3, 2>::new(subject, input, mutation).all(answer),
    }
}

/// The sums of an element in D dimensions with P projected parameters.
struct Assembly<'a, const D: usize, const P: usize> {
    subject: &'a Subject,
    parameters: &'a [f64],
    slave_row: &'a [f64],
    history: &'a [f64],
    multipliers: &'a [f64],
    mutation: Option<Mutation>,
    /// Positions, in the frame of a placed geometry.
    x: Vec<[f64; D]>,
    /// Global positions and reference positions, for the measure.
    global: Vec<[f64; D]>,
    reference: Vec<[f64; D]>,
    placement: Placement<D>,
    result: Interpreted,
}

impl<const D: usize, const P: usize> Receiver for Assembly<'_, D, P> {
    fn open(&mut self, _: usize) {}
    fn force(&mut self, (node, component): (usize, usize), value: f64, _: bool) {
        self.result.residual[node * D + component] += value;
    }
    fn row(&mut self, unknown: usize, row: &[f64], _: bool) {
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
    fn new(subject: &'a Subject, input: &Input<'a>, mutation: Option<Mutation>) -> Self {
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

    fn all(mut self, answer: &Answer) -> Interpreted {
        let points: Vec<Vec<f64>> = answer
            .output
            .chunks_exact(OUTPUT_SIZE)
            .map(<[f64]>::to_vec)
            .collect();
        let size = self.subject.description.descriptor.point_history();
        let bit = |regime: Option<&f64>, bit: u8| regime.is_some_and(|&r| r as u8 & bit != 0);
        for (number, output) in points.iter().enumerate() {
            if (1.0..=3.0).contains(&output[0]) {
                let rolled = answer.history.get(number * size + 6 + 4);
                let rolled = rolled.filter(|_| self.subject.description.rolling.is_some());
                let slips = [output[0] == 3.0, bit(rolled, 1), bit(rolled, 2)];
                self.closed(number, [output[4], output[5]], slips);
            }
        }
        self.constants();
        self.result
    }

    fn change(&self, place: Place) -> Option<Change> {
        self.mutation
            .filter(|(where_, _)| *where_ == place)
            .map(|(_, change)| change)
    }

    fn closed(&mut self, number: usize, zeta: [f64; 2], slips: [bool; 3]) {
        let (row, slopes, rule_weight) = self.slave(number);
        let point = self.kinematics(&row, zeta);
        let (n, distance, gap) = self.gap(&point);
        let law = &self.subject.description.law.law;
        let mut inputs = vec![gap];
        inputs.extend_from_slice(self.parameters);
        let mut law = interpret(law, &inputs, self.change(Place::Law));
        let blend = self.weigh(number, &point, &mut law);
        let multiplier = self.multiplier_of(number);
        let (traction, slope) = (law[0] + multiplier.unwrap_or(0.0), law[1]);
        let (weight, variation) = self.measure(&slopes, rule_weight);
        let normal = self.placement.vector_to_global(&n);
        for (a, &s) in point.s.iter().enumerate() {
            for k in 0..D {
                self.force((a, k), weight * traction * s * normal[k], false);
            }
        }
        self.energy(match multiplier {
            None => weight * law.get(2).copied().unwrap_or(f64::NAN),
            Some(_) => weight * traction * traction / (2.0 * slope), // less what `constants` adds
        });
        let coefficients = self.coefficients(&point, &n, distance, (traction, slope), weight);
        let moved: Vec<f64> = variation.iter().map(|v| v * traction).collect();
        self.contract(&point, &normal, &coefficients, &moved);
        let contact = Contact {
            number,
            zeta,
            slips,
            n: &n,
            distance,
            traction,
            slope,
            weight,
            variation: &variation,
        };
        self.tangential(&point, &contact);
        self.blended(blend, &point, (&n, distance, weight), zeta);
    }

    /// The multiplier beside the law of a point, where there is one.
    fn multiplier_of(&self, number: usize) -> Option<f64> {
        let descriptor = self.subject.description.descriptor;
        let size = descriptor.point_history();
        match descriptor.enforcement {
            Enforcement::Penalty => None,
            Enforcement::Augmented => self.history.get((number + 1) * size - 1).copied(),
            Enforcement::Multiplier => self.multipliers.get(number).copied(),
        }
    }

    /// The constant energy of the multipliers that are unknowns.
    fn constants(&mut self) {
        if self.multipliers.is_empty() {
            return;
        }
        for (number, multiplier) in self.multipliers.iter().enumerate() {
            let (_, slopes, rule_weight) = self.slave(number);
            let (weight, _) = self.measure(&slopes, rule_weight);
            let law = &self.subject.description.law.law;
            let mut inputs = vec![0.0];
            inputs.extend_from_slice(self.parameters);
            let slope = interpret(law, &inputs, self.change(Place::Law))[1];
            self.result.energy -= weight * multiplier * multiplier / (2.0 * slope);
        }
    }

    /// n, L, g in the frame of the geometry.
    fn gap(&self, point: &Point<D, P>) -> ([f64; D], f64, f64) {
        let layout = &self.subject.description.layout;
        let mut inputs = point.r.to_vec();
        inputs.extend(self.own_parameters());
        inputs.extend(point.b.iter().flatten());
        inputs.push(self.orientation());
        inputs.push(self.parameters[layout.r0]);
        let values = interpret(&self.subject.description.programs.gap, &inputs, None);
        (std::array::from_fn(|k| values[k]), values[D], values[D + 1])
    }

    /// Parameters of a distance function.
    fn own_parameters(&self) -> Vec<f64> {
        let MasterDescription::Distance(geometry) = &self.subject.description.master else {
            return vec![];
        };
        let count = geometry.values.inputs.len() - D - 2;
        let at = self.subject.description.layout.geometry;
        self.parameters[at..at + count].to_vec()
    }

    fn orientation(&self) -> f64 {
        match self.subject.description.layout.orientation {
            Some(at) if self.parameters[at] < 0.0 => -1.0,
            _ => 1.0,
        }
    }

    fn coefficients(
        &self,
        point: &Point<D, P>,
        n: &[f64; D],
        distance: f64,
        (traction, slope): (f64, f64),
        weight: f64,
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
            inputs = n.to_vec();
            inputs.push(distance);
            inputs.extend(point.b.iter().flatten());
            inputs.extend(point.second.iter().flatten());
        }
        inputs.extend([traction, slope]);
        let values = interpret(program, &inputs, self.change(Place::Tangent));
        let values: Vec<f64> = values.iter().map(|v| weight * v).collect();
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
    fn measure(&self, slopes: &[Vec<f64>], rule_weight: f64) -> (f64, Vec<f64>) {
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
        let values = interpret(program, &inputs, self.change(Place::Measure));
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

    fn contract(
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
            &point.s,
            std::array::from_fn(|j| &*point.ds[j]),
            n,
            coefficients,
            if self.subject.description.current {
                variation
            } else {
                &[]
            },
            moving,
            false,
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
