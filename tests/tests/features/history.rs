//! A history of zeros is a beginning of every built-in element: the outputs have the bits of those with the initial
//! history, and of those without a history.

use contact_elements::{code, initial_history};
use contact_verify::configurations::{Configuration, Generator, Wanted as State};
use contact_verify::subject::{self, Answer, Input, Subject, Wanted};

/// States of each kind per element.
const STATES: u64 = 20;

fn initial(subject: &Subject) -> Vec<f64> {
    let descriptor = subject.description.descriptor;
    let mut history = vec![f64::NAN; descriptor.history()];
    initial_history(descriptor, &mut history).expect("room for the history");
    history
}

fn evaluate(subject: &Subject, state: &Configuration, history: &[f64]) -> Answer {
    let multipliers: Vec<f64> = (0..subject.description.descriptor.points)
        .map_while(|q| state.pair.multipliers.at(q))
        .collect();
    subject.call(
        &Input {
            reference: &state.reference,
            displacement: &state.displacement,
            parameters: &subject.parameters(&state.pair),
            history,
            slave_row: &subject.slave_row(&state.pair),
            multipliers: &multipliers,
        },
        Wanted::BOTH,
    )
}

fn bits(answer: &Answer) -> Vec<u64> {
    let couplings = &answer.couplings;
    let arrays = [
        &answer.residual,
        &answer.tangent,
        &answer.output,
        &answer.energy,
        &answer.history,
        &couplings.residual,
        &couplings.rows,
        &couplings.columns,
        &couplings.block,
    ];
    let values = arrays.into_iter().flatten();
    values.map(|value| value.to_bits()).collect()
}

#[test]
fn zeros_are_a_beginning_of_every_element() {
    let subjects = subject::built_in().expect("the oracle knows the built-in elements");
    assert_eq!(subjects.len(), contact_library::ELEMENTS.len());
    for subject in &subjects {
        let zeros = vec![0.0; subject.description.descriptor.history()];
        let initial = initial(subject);
        let generator = Generator::new(subject.template.clone(), 7);
        let mut closed = 0;
        for wanted in [State::Closed, State::Open] {
            for index in 0..STATES {
                let state = generator.generate(wanted, index).expect("a state");
                let of_zeros = evaluate(subject, &state, &zeros);
                let name = subject.name();
                // a state may be too far from the centre, a fault of the history it is not
                match of_zeros.outcome.expect("an outcome") {
                    Ok(summary) => closed += summary.closed,
                    Err(error) => assert_eq!(error.code, code::CUT_BACK, "{name}, state {index}"),
                }
                let others = [("initial history", &initial[..]), ("no history", &[])];
                for (what, history) in others {
                    let other = evaluate(subject, &state, history);
                    assert_eq!(
                        of_zeros.outcome, other.outcome,
                        "{name}, state {index}: {what}"
                    );
                    assert!(
                        bits(&of_zeros) == bits(&other),
                        "{name}, state {index}: not as with {what}"
                    );
                }
            }
        }
        assert!(closed > 0, "{}: no state in contact", subject.name());
    }
}
