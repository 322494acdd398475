//! An element assembled from its tables, with one term of a linearisation changed on request.
//!
//! The tables give rows, kinematics, gap, law and coefficients; the library's level 2 contracts them. The
//! projection is the one that the compiled element found.

mod angle;
mod assembly;
mod friction;
mod normal;
mod rolling;
mod rows;
mod site;

use contact_elements::OUTPUT_SIZE;
use contact_elements::runtime::{Receiver, Write};

use crate::interpret::interpret;
use crate::subject::{Answer, Input, Subject};
use assembly::Assembly;
pub use assembly::Interpreted;
use friction::Contact;
pub(super) use friction::ellipse;
pub use site::{Mutation, TermSite, program};

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

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
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

    fn closed(&mut self, number: usize, zeta: [f64; 2], slips: [bool; 3]) {
        let (row, slopes, rule_weight) = self.slave(number);
        let point = self.kinematics(&row, zeta);
        let (n, distance, gap) = self.gap(&point);
        let law = &self.subject.description.law.law;
        let mut inputs = vec![gap];
        inputs.extend_from_slice(self.parameters);
        let mut law = interpret(law, &inputs, self.change(TermSite::Law));
        let blend = self.weigh(number, &point, &mut law);
        let multiplier = self.multiplier_of(number);
        let (traction, slope) = (law[0] + multiplier.unwrap_or(0.0), law[1]);
        let (weight, variation) = self.measure(&slopes, rule_weight);
        let normal = self.placement.vector_to_global(&n);
        for (a, &s) in point.s.iter().enumerate() {
            for k in 0..D {
                self.force((a, k), weight * traction * s * normal[k], Write::Add);
            }
        }
        self.energy(match multiplier {
            None => weight * law.get(2).copied().unwrap_or(f64::NAN),
            Some(_) => weight * traction * traction / (2.0 * slope), // less what `constants` adds
        });
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
        let coefficients = self.coefficients(&point, &contact);
        let moved: Vec<f64> = variation.iter().map(|v| v * traction).collect();
        self.contract(&point, &normal, &coefficients, &moved);
        self.tangential(&point, &contact);
        self.blended(blend, &point, &contact);
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
            let slope = interpret(law, &inputs, self.change(TermSite::Law))[1];
            self.result.energy -= weight * multiplier * multiplier / (2.0 * slope);
        }
    }
}
