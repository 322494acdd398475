//! Run time against error of residual and tangent.

use crate::Failure;
use crate::case::Answer;
use crate::pairs::{Line2Line2Beams, PointQuad4, PointQuad9};
use crate::report::{Chart, Section, Series, number, spread};
use crate::states::{Catalogue, State};
use crate::timing::{Contender, Effort, Timing, in_turns};
use crate::ways::{ByTools, GENERATED, Way, must_be_exact};

/// One section for each pair.
///
/// # Errors
/// Where a state cannot be made or a way is wrong.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let all = Catalogue::new()?;
    Ok(vec![
        section(
            &State::all(&all, "PointQuad4", effort.states)?,
            &ByTools::<PointQuad4, 5, 15>::ways(),
            effort,
        )?,
        section(
            &State::all(&all, "PointQuad9", effort.states)?,
            &ByTools::<PointQuad9, 10, 30>::ways(),
            effort,
        )?,
        section(
            &State::all(&all, "Line2Line2Beams", effort.states)?,
            &ByTools::<Line2Line2Beams, 4, 12>::ways(),
            effort,
        )?,
    ])
}

const HEAD: [&str; 10] = [
    "way",
    "ns",
    "quartiles",
    "ratio",
    "quartiles of the ratio",
    "ratio of the least",
    "largest error of R",
    "of K",
    "median error of R",
    "of K",
];

fn section<const N: usize>(
    states: &[State<N>],
    ways: &[Way<N>],
    effort: &Effort,
) -> Result<Section, Failure> {
    let name = states[0].case.name();
    let timing = times(states, ways, effort);
    let mut section = Section::new(
        &format!("time-against-error-{name}"),
        &format!("Run time against error, {name}"),
        &HEAD,
    );
    let mut lines: Vec<Series> = vec![];
    for way in ways {
        let errors = way.errors(states);
        must_be_exact(way, errors)?;
        let (time, ratio) = (timing.time(&way.name), timing.ratio(&way.name, GENERATED));
        let [r, k] = errors;
        let mut row = vec![way.name.clone()];
        row.extend(spread(time));
        row.extend(spread(ratio));
        row.push(number(timing.ratio_of_least(&way.name, GENERATED)));
        row.extend([r[0], k[0], r[1], k[1]].map(|error| format!("{error:.1e}")));
        section.row(row);
        let point = (ratio.median, k[0].max(1e-17));
        match lines.iter_mut().find(|line| line.name == way.family) {
            Some(line) => line.points.push(point),
            None => lines.push(Series::points(way.family, vec![point])),
        }
    }
    section.note(&format!(
        "{} random closed states, all ways in turns; every way projects from the same start, unless given. Ratio: to `{GENERATED}` in the same round. \
         Errors against octuple precision, relative to the largest entry; the reference takes {} ns.",
        states.len(),
        number(timing.time(GENERATED).median),
    ));
    section.chart(Chart {
        name: format!("time-against-error-{name}"),
        caption: format!("{name}: error of K against run time"),
        x: "time / time of the generated element".into(),
        y: "largest error of K".into(),
        series: lines,
    });
    Ok(section)
}

fn times<const N: usize>(states: &[State<N>], ways: &[Way<N>], effort: &Effort) -> Timing {
    let contenders = ways.iter().map(|way| {
        let mut answer = Answer::of(&states[0].case);
        Contender::new(&way.name, states.len(), move || {
            for state in states {
                way.run(state, &mut answer);
            }
        })
    });
    in_turns(contenders.collect(), effort)
}
