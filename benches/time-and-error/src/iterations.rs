//! Newton iterations of the projection against the error of residual and tangent.

use crate::Failure;
use crate::case::{Answer, Case, Request};
use crate::pairs::{Line2Line2Beams, Pair, PointQuad4, PointQuad9, iterates};
use crate::report::{Chart, Section, Series, number, spread};
use crate::states::{Catalogue, State};
use crate::timing::{Contender, Effort, in_turns};
use crate::ways::{GENERATED, GIVEN, largest_and_median};

/// Iterations at most.
const STEPS: usize = 6;

/// One section for all pairs.
///
/// # Errors
/// Where a state cannot be made.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let all = Catalogue::new()?;
    let mut section = Section::new(
        "newton-iterations",
        "Newton iterations of the projection against the error",
        &[
            "element",
            "iterations",
            "largest error of R",
            "of K",
            "median error of R",
            "of K",
            "time from this iterate / from the start",
            "quartiles",
            "of the least",
        ],
    );
    let mut lines = vec![];
    let states = State::all(&all, "PointQuad4", effort.states)?;
    add::<PointQuad4, 5>(&mut section, &mut lines, &states, effort);
    let states = State::all(&all, "PointQuad9", effort.states)?;
    add::<PointQuad9, 10>(&mut section, &mut lines, &states, effort);
    let states = State::all(&all, "Line2Line2Beams", effort.states)?;
    add::<Line2Line2Beams, 4>(&mut section, &mut lines, &states, effort);
    section.note(
        "Iterates come from a Newton method of the benchmark, which starts up to 7 % of the domain away in each parameter; each of them is handed to the element \
         as its projection (`CTE_PROJECTION_GIVEN`). Time: of the element's own projection from that iterate, R and K included; `given`: no projection.",
    );
    section.chart(Chart {
        name: "newton-iterations".into(),
        caption: "Error after so many Newton iterations (median of the states)".into(),
        x: "iterations".into(),
        y: "median error".into(),
        series: lines,
    });
    Ok(vec![section])
}

fn add<P: Pair<N>, const N: usize>(
    section: &mut Section,
    lines: &mut Vec<Series>,
    states: &[State<N>],
    effort: &Effort,
) {
    let name = states[0].case.name();
    let histories: Vec<Vec<[f64; 2]>> = states
        .iter()
        .map(|state| iterates::<P, N>(&state.x, state.start, STEPS))
        .collect();
    let cases: Vec<Vec<Case>> = (0..=STEPS)
        .map(|step| {
            let both = states.iter().zip(&histories);
            both.map(|(state, z)| from(&state.case, z[step])).collect()
        })
        .collect();
    let mut contenders = vec![];
    for (step, cases) in cases.iter().enumerate() {
        contenders.push(pass(&step.to_string(), cases, Request::BOTH));
    }
    contenders.push(pass(GIVEN, &cases[STEPS], Request::GIVEN));
    contenders.push(pass(GENERATED, &cases[0], Request::BOTH));
    let timing = in_turns(contenders, effort);
    let mut medians = [vec![], vec![]];
    for (step, cases) in cases.iter().enumerate() {
        let [r, k] = largest_and_median(errors(states, cases));
        let mut row = vec![name.to_string(), step.to_string()];
        row.extend([r[0], k[0], r[1], k[1]].map(|error| format!("{error:.1e}")));
        row.extend(spread(timing.ratio(&step.to_string(), GENERATED)));
        row.push(number(timing.ratio_of_least(&step.to_string(), GENERATED)));
        section.row(row);
        for (line, error) in medians.iter_mut().zip([r[1], k[1]]) {
            line.push((step as f64, error.max(1e-17)));
        }
    }
    let mut row = vec![name.to_string(), "given".to_string()];
    row.extend(vec!["–".to_string(); 4]);
    row.extend(spread(timing.ratio(GIVEN, GENERATED)));
    row.push(number(timing.ratio_of_least(GIVEN, GENERATED)));
    section.row(row);
    let [residual, tangent] = medians;
    lines.push(Series::line(format!("{name}, R"), residual));
    lines.push(Series::line(format!("{name}, K"), tangent));
}

fn from(case: &Case, z: [f64; 2]) -> Case {
    let mut case = case.clone();
    case.history[1..3].copy_from_slice(&z);
    case
}

fn errors<const N: usize>(states: &[State<N>], cases: &[Case]) -> Vec<[f64; 2]> {
    let one = |(state, case): (&State<N>, &Case)| {
        let mut answer = Answer::of(case);
        let outcome = case.evaluate(Request::GIVEN, &mut answer);
        if outcome.is_err() {
            return [f64::INFINITY; 2];
        }
        state.truth.errors(&answer.residual, &answer.tangent)
    };
    states.iter().zip(cases).map(one).collect()
}

/// A contender that evaluates all cases.
pub fn pass<'a>(name: &str, cases: &'a [Case], request: Request) -> Contender<'a> {
    let mut answer = Answer::of(&cases[0]);
    Contender::new(name, cases.len(), move || {
        for case in cases {
            case.evaluate(request, &mut answer);
        }
    })
}
