//! One state: the element's answer against the truth, in units of what half a unit in the last place of the
//! coordinates does to the truth.

use contact_elements::runtime::Status;
use num_dual::DualNum;
use num_traits::{Signed, Zero};

use super::scene::Case;
use super::truth::{State, Truth, evaluate};
use crate::configurations::Stream;
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::Master;
use crate::subject::{Answer, Input, Subject, UNTOUCHED, Wanted};
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS};

/// An error, and the change of the truth that the rounding of the coordinates brings about; both relative to the
/// largest entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Error of the element.
    pub error: f64,
    /// Change of the truth; infinite where the disturbed states have another status.
    pub spread: f64,
}

impl Deviation {
    /// Error over spread; a spread below the floor counts as that.
    pub fn spreads(self) -> f64 {
        let floor = REFERENCE / REFERENCE_SPREADS;
        self.error / self.spread.max(floor)
    }

    fn within(self) -> bool {
        self.spreads() <= REFERENCE_SPREADS
    }
}

/// Verdict on a state.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The status is right, and the error within the limit.
    Exact,
    /// The data decide nothing, or there is no unique answer: any finite or refused answer passes.
    Undecided,
    /// Would have failed, but lies beyond the documented limit of the sweep; still finite.
    Beyond(String),
    /// Wrong.
    Failed(String),
}

/// The outcome of one state.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// Status of the element; `None` where the call was refused.
    pub status: Option<Status>,
    /// True status; `None` where no state could be made.
    pub truth: Option<Status>,
    /// Error of the residual; `None` where either has no answer.
    pub residual: Option<Deviation>,
    /// Error of the tangent, likewise.
    pub tangent: Option<Deviation>,
    /// Newton steps of the projection of the first point; `None` where nothing was written.
    pub iterations: Option<f64>,
    /// Judgement.
    pub verdict: Verdict,
}

impl Measurement {
    /// The same outcome, judged as beyond the limit of a sweep: neither error nor a wrong refusal counts.
    pub fn beyond(mut self) -> Self {
        if let Verdict::Failed(reason) = &self.verdict
            && (self.status.is_some() && !reason.contains(NOT_FINITE))
        {
            self.verdict = Verdict::Beyond(reason.clone());
        }
        self
    }

    /// The outcome where no state could be made.
    pub fn missing() -> Self {
        Self {
            status: None,
            truth: None,
            residual: None,
            tangent: None,
            iterations: None,
            verdict: Verdict::Failed("no such state".into()),
        }
    }

    /// The larger error over spread of residual and tangent.
    pub fn spreads(&self) -> Option<f64> {
        let both = self.residual.into_iter().chain(self.tangent);
        both.map(Deviation::spreads).reduce(f64::max)
    }
}

const NOT_FINITE: &str = "is not finite";
/// Below this a projection is refused as not unique or degenerate; the limit of the elements, with room for the
/// rounding of the quantity that is compared with it.
const LEAST_MARGIN: f64 = 2e-13;
/// Data that move the answer by more than this do not determine it.
const DECIDED: f64 = 0.05;
/// Number of disturbed states, the same as for the reference cases.
const DISTURBED: usize = 4;
/// Entry of the Newton steps in the output of a point.
const ITERATIONS: usize = 9;

/// Calls the element and judges its answer.
pub fn measure(subject: &Subject, case: &Case, stream: &mut Stream) -> Option<Measurement> {
    let answer = call(subject, case);
    judge(case, &answer, stream)
}

/// The element's answer.
pub fn call(subject: &Subject, case: &Case) -> Answer {
    subject.call(
        &Input {
            reference: &case.positions,
            displacement: &vec![0.0; case.positions.len()],
            parameters: &subject.parameters(&case.pair),
            history: &subject.history(&[case.start], &case.friction, &case.pair.multipliers),
            slave_row: &subject.slave_row(&case.pair),
            multipliers: &[],
        },
        Wanted::BOTH,
    )
}

/// Judges an answer; `None` for a pair that cannot be evaluated in octuple precision.
pub fn judge(case: &Case, answer: &Answer, stream: &mut Stream) -> Option<Measurement> {
    let start = [case.target];
    let state = case.state(&start);
    let truth = evaluate(&state)?;
    let disturbed: Vec<Truth> = (0..DISTURBED)
        .map(|_| evaluate(&disturb(&state, case.is_projection_data, stream)))
        .collect::<Option<_>>()?;
    let status = answer.status();
    let both = truth.status.is_closed() && status.is_some_and(Status::is_closed);
    let deviation = |found: &[f64], of: fn(&Truth) -> &Vec<Octuple>| {
        both.then(|| Deviation {
            error: difference(&exactly(found), of(&truth), of(&truth)),
            spread: spread(&truth, &disturbed, of),
        })
    };
    let residual = deviation(&answer.residual, |truth| &truth.residual);
    let tangent = deviation(&answer.tangent, |truth| &truth.tangent);
    let mut measurement = Measurement {
        status,
        truth: Some(truth.status),
        residual,
        tangent,
        iterations: answer
            .output
            .get(ITERATIONS)
            .copied()
            .filter(|&v| v != UNTOUCHED),
        verdict: Verdict::Exact,
    };
    measurement.verdict = verdict(case, &measurement, answer, &truth, &disturbed);
    Some(measurement)
}

/// Whether the intended foot no longer exists, or the data leave open where it is: it moves by more than a
/// share of the domain.
fn wanders(case: &Case, truth: &Truth, disturbed: &Truth) -> bool {
    let region = case.pair.region();
    let stays = |a: &[f64; 2], b: &[f64; 2]| {
        let within = |i: usize| (a[i] - b[i]).abs() <= DECIDED * region.extent(i);
        (0..case.pair.parameters()).all(within)
    };
    let is_meant = truth.zeta.first().is_some_and(|z| stays(z, &case.target));
    let mut both = truth.zeta.iter().zip(&disturbed.zeta);
    !is_meant || !both.all(|(a, b)| stays(a, b))
}

fn verdict(
    case: &Case,
    m: &Measurement,
    answer: &Answer,
    truth: &Truth,
    disturbed: &[Truth],
) -> Verdict {
    if let Some(what) = not_finite(answer) {
        return Verdict::Failed(format!("{what} {NOT_FINITE}"));
    }
    let Some(status) = m.status else {
        return Verdict::Failed(format!("refused with {:?}", answer.outcome));
    };
    let spreads = [&m.residual, &m.tangent].map(|d| d.map_or(0.0, |d| d.spread));
    let undecided = disturbed.iter().any(|other| other.status != truth.status)
        || disturbed.iter().any(|other| wanders(case, truth, other))
        || spreads.iter().any(|&spread| spread > DECIDED)
        || truth_spread(truth, disturbed) > DECIDED;
    let no_answer = truth.margin < LEAST_MARGIN;
    if status.is_closed() && status == truth.status {
        let fine =
            m.residual.is_some_and(Deviation::within) && m.tangent.is_some_and(Deviation::within);
        if fine {
            return Verdict::Exact;
        }
        if !undecided && !no_answer {
            return Verdict::Failed("error beyond the limit".into());
        }
    }
    if matches!(status, Status::Open | Status::Outside) {
        if !answer.is_zero() {
            return Verdict::Failed(format!("{status:?}, but not zero"));
        }
        if status == truth.status {
            return Verdict::Exact;
        }
    }
    if undecided || no_answer {
        return Verdict::Undecided;
    }
    Verdict::Failed(format!("{status:?} instead of {:?}", truth.status))
}

/// The first output that is neither finite nor untouched.
fn not_finite(answer: &Answer) -> Option<&'static str> {
    [
        ("residual", &answer.residual),
        ("tangent", &answer.tangent),
        ("output", &answer.output),
        ("energy", &answer.energy),
        ("history", &answer.history),
    ]
    .into_iter()
    .find(|(_, values)| values.iter().any(|v| !v.is_finite()))
    .map(|(what, _)| what)
}

/// The same state with every coordinate moved by half a unit in its last place, up or down at random. The
/// coordinates of a rigid master's origin count: moving it is moving the slave the other way.
fn disturb<'a>(state: &State<'a>, with_projection: bool, stream: &mut Stream) -> State<'a> {
    let half = (-53.0f64).exp2();
    let mut origin = [Octuple::zero(); 3];
    if let Master::Parametric { placement, .. } | Master::Distance { placement, .. } =
        &state.pair.master
    {
        origin = placement
            .origin()
            .map(|c| Octuple::from(c) * (half * stream.sign()));
    }
    let mut moved = state.clone();
    if with_projection {
        moved.nudge = [half * stream.sign(), half * stream.sign()];
    }
    for (i, node) in moved.nodes.iter_mut().enumerate() {
        let position = i >= state.pair.slave_nodes() || state.pair.slave_is_position(i);
        for c in 0..3 {
            node[c] += node[c] * (half * stream.sign());
            if position {
                node[c] -= origin[c];
            }
        }
    }
    moved
}

/// Spread of residual and tangent, whatever the element says.
fn truth_spread(truth: &Truth, disturbed: &[Truth]) -> f64 {
    if !truth.status.is_closed() {
        return 0.0;
    }
    let residual = spread(truth, disturbed, |truth| &truth.residual);
    residual.max(spread(truth, disturbed, |truth| &truth.tangent))
}

fn spread(truth: &Truth, disturbed: &[Truth], of: fn(&Truth) -> &Vec<Octuple>) -> f64 {
    let changes = disturbed.iter().map(|other| {
        if other.status == truth.status {
            difference(of(other), of(truth), of(truth))
        } else {
            f64::INFINITY
        }
    });
    changes.fold(0.0, f64::max)
}

/// Largest difference, relative to the largest entry of `whole`; infinite where an entry is NaN.
fn difference(found: &[Octuple], expected: &[Octuple], whole: &[Octuple]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let top = largest(whole.iter().copied());
    let worst = largest(found.iter().zip(expected).map(|(a, b)| *a - *b));
    match (worst, top) {
        (Some(worst), Some(top)) if !top.is_zero() => (worst * top.recip()).to_f64(),
        (Some(worst), Some(_)) if worst.is_zero() => 0.0,
        _ => f64::INFINITY,
    }
}

/// Largest absolute value; `None` where an entry is not finite.
fn largest(mut values: impl Iterator<Item = Octuple>) -> Option<Octuple> {
    values.try_fold(Octuple::zero(), |m, v| {
        v.is_finite().then(|| m.max(v.abs()))
    })
}

fn exactly(values: &[f64]) -> Vec<Octuple> {
    let number = |&v: &f64| Octuple::from(if v == UNTOUCHED { f64::NAN } else { v });
    values.iter().map(number).collect()
}
