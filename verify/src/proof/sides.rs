//! Which side two edges are on: at first that of the parameter, then that of the remembered normal.
//!
//! Other evidence proves the result on either side. Here the question is only which of the two an evaluation takes, bit for bit.

use contact_elements::code;
use contact_elements::runtime::Status;

use super::{Finding, random};
use crate::configurations::{Configuration, Stream, Wanted};
use crate::oracle::pair::{GapKind, Slave};
use crate::oracle::vector::dot;
use crate::subject::{self, Answer, Input, Subject};

/// States per status.
const STATES: u64 = 12;
/// Remembered normals per state.
const NORMALS: usize = 12;
/// Cosines between remembered and present normal at which the side is decided, and at which it is not.
const DECIDED: f64 = 0.11;
const UNDECIDED: f64 = 0.09;
/// Entries of the output.
const GAP: usize = 1;
const NORMAL: usize = 6;

/// What the element makes of a history that says on which side the edges were, for the check of the check.
type Told = fn([f64; 3]) -> [f64; 3];

/// Tries an element, where it is one of two edges.
pub fn prove(subject: &Subject, seed: u64) -> Option<Finding> {
    let template = &subject.template;
    let is_edges = template.gap == GapKind::Signed
        && matches!(template.slave, Slave::Curve(_))
        && template.dimension == 3;
    is_edges.then(|| prove_told(subject, seed, |normal| normal))
}

fn prove_told(subject: &Subject, seed: u64, told: Told) -> Finding {
    let mut finding = Finding::default();
    let generator = random::generator(subject, seed);
    let loaded = match subject.template.tangential {
        Some(_) => [Wanted::Stick, Wanted::Slip].as_slice(),
        None => [Wanted::Closed].as_slice(),
    };
    for &wanted in loaded.iter().chain(&[Wanted::Open, Wanted::Outside]) {
        for index in 0..STATES {
            match generator.generate(wanted, index) {
                Ok(configuration) => {
                    let edges = Edges {
                        subject,
                        configuration: &configuration,
                        told,
                    };
                    let mut stream = Stream::new(seed, index, 67);
                    let outcome = match wanted {
                        Wanted::Outside => edges.apart(&mut stream),
                        _ => edges.remembered(&mut stream).and_then(|()| edges.first()),
                    };
                    match outcome {
                        Ok(()) => finding.pass(),
                        Err(wrong) => finding.fail(format!("side, {wanted:?} {index}: {wrong}")),
                    }
                }
                Err(error) => finding.fail(format!("side, {wanted:?} {index}: {error}")),
            }
        }
    }
    finding
}

/// A state of two edges.
struct Edges<'a> {
    subject: &'a Subject,
    configuration: &'a Configuration,
    told: Told,
}

impl Edges<'_> {
    /// Evaluates with an orientation and, where one is remembered, a normal.
    fn call(&self, orientation: f64, normal: Option<[f64; 3]>) -> Answer {
        let mut pair = self.configuration.pair.clone();
        pair.orientation = orientation;
        let mut history = self.subject.history_of(self.configuration);
        let side = self.side_of(&history);
        history[side].copy_from_slice(&normal.map_or([0.0; 3], self.told));
        self.evaluate(&self.subject.parameters(&pair), &history)
    }

    fn evaluate(&self, parameters: &[f64], history: &[f64]) -> Answer {
        let input = Input {
            reference: &self.configuration.reference,
            displacement: &self.configuration.displacement,
            parameters,
            history,
            slave_row: &[],
            multipliers: self.configuration.pair.multipliers.unknowns(),
        };
        self.subject.call(&input, subject::Wanted::BOTH)
    }

    /// The last three entries, but for a multiplier.
    fn side_of(&self, history: &[f64]) -> std::ops::Range<usize> {
        let held = self.subject.description.descriptor.is_augmented();
        let end = history.len() - usize::from(held);
        end - 3..end
    }

    /// Trial histories hold the normal of the output.
    fn keeps(&self, answer: &Answer) -> Result<(), String> {
        let side = &answer.history[self.side_of(&answer.history)];
        if side == &answer.output[NORMAL..NORMAL + 3] {
            Ok(())
        } else {
            Err(format!("the history keeps {side:?}"))
        }
    }

    /// A remembered normal decides, whatever the orientation.
    fn remembered(&self, stream: &mut Stream) -> Result<(), String> {
        let own = self.configuration.pair.orientation;
        let sides = [self.call(own, None), self.call(-own, None)];
        let normal = self.configuration.points[0].normal;
        self.keeps(&sides[0])?;
        for _ in 0..NORMALS {
            let remembered = stream.direction();
            let cosine = dot(remembered, normal);
            for orientation in [-1.0, 0.0, 1.0] {
                let answer = self.call(orientation, Some(remembered));
                let what = format!("cosine {cosine}, orientation {orientation}");
                if cosine.abs() < UNDECIDED {
                    let refused =
                        answer.is_untouched() && answer.status() == Some(Status::NotUnique);
                    refused.then_some(()).ok_or(format!("{what}: decided"))?;
                } else if cosine.abs() > DECIDED {
                    let expected = &sides[usize::from(cosine < 0.0)];
                    same(&answer, expected).ok_or(format!("{what}: the other side"))?;
                }
            }
        }
        Ok(())
    }

    /// Without a remembered normal: the side of the orientation, and if that is 0 the side of a positive distance.
    fn first(&self) -> Result<(), String> {
        let sides = [self.call(1.0, None), self.call(-1.0, None)];
        let distance = sides[0].output[GAP] + self.configuration.pair.r0;
        let expected = &sides[usize::from(distance < 0.0)];
        same(&self.call(0.0, None), expected).ok_or("orientation 0: the other side".to_string())?;
        let mut pair = self.configuration.pair.clone();
        pair.orientation = 0.0;
        let answer = self.evaluate(&self.subject.parameters(&pair), &[]);
        match answer.outcome {
            Some(Err(error)) if error.code == code::NULL && answer.is_untouched() => Ok(()),
            outcome => Err(format!("orientation 0 without history: {outcome:?}")),
        }
    }

    /// Beyond an end the side is that of a positive distance.
    fn apart(&self, stream: &mut Stream) -> Result<(), String> {
        for orientation in [-1.0, 0.0, 1.0] {
            for normal in [None, Some(stream.direction())] {
                let answer = self.call(orientation, normal);
                let distance = answer.output[GAP] + self.configuration.pair.r0;
                if answer.status() != Some(Status::Outside) || distance < 0.0 {
                    return Err(format!("orientation {orientation}: distance {distance}"));
                }
                self.keeps(&answer)?;
            }
        }
        Ok(())
    }
}

/// Whether both are the same to the last bit.
fn same(a: &Answer, b: &Answer) -> Option<()> {
    let parts = |answer: &Answer| {
        [
            answer.residual.clone(),
            answer.tangent.clone(),
            answer.output.clone(),
            answer.history.clone(),
            answer.energy.clone(),
        ]
    };
    (a.outcome == b.outcome && parts(a) == parts(b)).then_some(())
}

#[cfg(test)]
mod tests {
    use super::prove_told;
    use crate::subject::built_in;

    #[test]
    fn a_side_that_is_forgotten_or_turned_is_noticed() {
        let subjects = built_in().expect("subjects");
        let edges = subjects
            .iter()
            .find(|subject| subject.name() == "Line2Line2Edges")
            .expect("an element");
        assert_eq!(prove_told(edges, 1, |normal| normal).failed, 0);
        assert!(prove_told(edges, 1, |_| [0.0; 3]).failed > 0);
        assert!(prove_told(edges, 1, |normal| normal.map(|v| -v)).failed > 0);
        assert!(prove_told(edges, 1, |[_, y, z]| [1.0, y, z]).failed > 0);
    }
}
