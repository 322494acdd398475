//! Run time against the number of nodes, in units of the time to store residual and tangent.

use std::hint::black_box;

use contact_bench_elements as own;
use contact_elements::Registered;
use contact_library as elements;
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::Failure;
use crate::case::{Answer, Case, Request};
use crate::iterations::pass;
use crate::report::{Chart, Section, Series, number, spread};
use crate::timing::{Contender, Effort, in_turns};

/// Slave nodes of the interpolated slave.
const INTERPOLATED: [usize; 5] = [4, 9, 23, 46, 78];
/// States of one element.
const STATES: usize = 16;
/// Position of the point in the parameters of slave and master.
const PLACE: [f64; 2] = [0.1, -0.2];

/// The slave's nodes.
#[derive(Clone, Copy)]
enum Slave {
    Point,
    /// Two nodes of an edge.
    Edge,
    /// So many nodes of a facet.
    Facet(usize),
    /// So many with a row of their own.
    Interpolated(usize),
}

/// One section.
///
/// # Errors
/// Where an element refuses a state.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let fixed = [
        (elements::PointQuad4::DESCRIPTOR, Slave::Point),
        (elements::Quad4Quad4AtPoint::DESCRIPTOR, Slave::Facet(4)),
        (elements::PointQuad9::DESCRIPTOR, Slave::Point),
        (own::PointQuad16::DESCRIPTOR, Slave::Point),
        (elements::Quad9Quad9AtPoint::DESCRIPTOR, Slave::Facet(9)),
        (own::PointQuad25::DESCRIPTOR, Slave::Point),
        (own::Line2Quad25Multiplier::DESCRIPTOR, Slave::Edge),
    ];
    let interpolated = INTERPOLATED.map(Slave::Interpolated);
    let interpolated = interpolated.map(|slave| (elements::InterpolatedQuad4::DESCRIPTOR, slave));
    let mut groups = vec![];
    for (descriptor, slave) in fixed.into_iter().chain(interpolated) {
        let cases = cases(descriptor, slave)?;
        groups.push((label(&cases[0]), cases));
    }
    Ok(vec![section(&groups, effort)])
}

fn section(groups: &[(String, Vec<Case>)], effort: &Effort) -> Section {
    let mut contenders = vec![];
    for (name, cases) in groups {
        contenders.push(pass(name, cases, Request::GIVEN));
        contenders.push(store(name, cases));
    }
    let timing = in_turns(contenders, effort);
    let mut section = Section::new(
        "growth",
        "Growth with the number of nodes",
        &[
            "element",
            "nodes",
            "unknowns",
            "operations",
            "ns",
            "quartiles",
            "ns to store",
            "ratio",
            "quartiles of the ratio",
            "ratio of the least",
        ],
    );
    let mut lines = [
        Series::points("elements of fixed size", vec![]),
        Series::line("interpolated slave".into(), vec![]),
        Series::line("storing R and K".into(), vec![]),
    ];
    for (name, cases) in groups {
        let unknowns = Answer::of(&cases[0]).residual.len();
        let (time, stored) = (timing.time(name), timing.time(&stored(name)));
        let mut row = vec![name.clone(), (cases[0].x.len() / 3).to_string()];
        row.extend([unknowns, cases[0].descriptor.operations].map(|n| n.to_string()));
        row.extend(spread(time));
        row.push(number(stored.median));
        row.extend(spread(timing.ratio(name, &self::stored(name))));
        row.push(number(timing.ratio_of_least(name, &self::stored(name))));
        section.row(row);
        let interpolated = usize::from(cases[0].descriptor.interpolated);
        lines[interpolated]
            .points
            .push((unknowns as f64, time.median));
        lines[2].points.push((unknowns as f64, stored.median));
    }
    lines[2].points.sort_by(|a, b| a.0.total_cmp(&b.0));
    section.note(
        "R and K, projection given, one closed contact point. Storing: the same entries filled with one number, same buffers. Nodes of multipliers have one unknown.",
    );
    section.chart(Chart {
        name: "growth".into(),
        caption: "Time against unknowns, with the time to store R and K".into(),
        x: "unknowns".into(),
        y: "ns".into(),
        series: lines.into(),
    });
    section
}

/// Fills residual and tangent.
fn store<'a>(name: &str, cases: &'a [Case]) -> Contender<'a> {
    let mut answer = Answer::of(&cases[0]);
    Contender::new(stored(name), cases.len(), move || {
        for _ in cases {
            let value = black_box(1.0);
            answer.residual.fill(value);
            answer.tangent.fill(value);
            black_box(&mut answer);
        }
    })
}

fn stored(name: &str) -> String {
    format!("{name}: store")
}

fn label(case: &Case) -> String {
    match case.slave_row.len() {
        0 => case.name().to_string(),
        row => format!("{}, {} slave nodes", case.name(), row - 1),
    }
}

fn cases(descriptor: &'static Registered, slave: Slave) -> Result<Vec<Case>, Failure> {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    (0..STATES)
        .map(|_| state(descriptor, slave, &mut random))
        .collect()
}

/// A closed state near a plane one.
fn state(
    descriptor: &'static Registered,
    slave: Slave,
    random: &mut Pcg64Mcg,
) -> Result<Case, Failure> {
    let [a, b] = PLACE;
    let at = |[x, y]: [f64; 2]| [x, y, -0.1];
    let mut nodes: Vec<[f64; 3]> = match slave {
        Slave::Point => vec![at(PLACE)],
        Slave::Edge => vec![at([a - 1.0, b]), at([a + 1.0, b])],
        Slave::Facet(n) => facet(n).into_iter().map(at).collect(),
        Slave::Interpolated(n) => vec![at(PLACE); n],
    };
    let master = facet(descriptor.master_nodes);
    nodes.extend(master.into_iter().map(|[x, y]| [x, y, 0.0]));
    let near = |x: &f64| x + random.random_range(-0.02..0.02);
    let mut x: Vec<f64> = nodes.as_flattened().iter().map(near).collect();
    x.extend(vec![0.0; 3 * descriptor.multipliers()]);
    let mut parameters = vec![1000.0, 0.0, 1.0];
    let mut slave_row = vec![];
    match slave {
        Slave::Point => {}
        Slave::Edge => parameters.extend([0.0, 1.0]),
        Slave::Facet(_) => parameters.extend([a, b, 1.0]),
        Slave::Interpolated(n) => slave_row = [vec![1.0 / n as f64; n], vec![1.0]].concat(),
    }
    let case = Case {
        descriptor,
        x,
        u: vec![],
        parameters,
        history: vec![],
        slave_row,
    };
    let case = case.projected()?;
    let outcome = case.evaluate(Request::GIVEN, &mut Answer::of(&case));
    if outcome.is_ok_and(|summary| summary.closed == 1) {
        Ok(case)
    } else {
        Err(format!("{}: {outcome:?}", case.name()).into())
    }
}

/// Nodes of a facet in the order of its shape functions.
fn facet(nodes: usize) -> Vec<[f64; 2]> {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let middles = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
    match nodes {
        4 => corners.to_vec(),
        9 => [&corners[..], &middles].concat(),
        _ => {
            let side = nodes.isqrt();
            let at = |i: usize| 2.0 * i as f64 / (side - 1) as f64 - 1.0;
            (0..nodes).map(|n| [at(n % side), at(n / side)]).collect()
        }
    }
}
