//! Global projection of random points and curves onto strongly deformed geometries, against the nearest of many
//! projections from a regular grid.

use contact_elements::abi::{Projection, Query, code, project};
use contact_elements::runtime::Domain;
use rayon::prelude::*;
use serde::Serialize;

use super::Finding;
use crate::configurations::{Configuration, Generator, Stream, Wanted};
use crate::oracle::kinematics::Frame;
use crate::oracle::projection::{self, Projection as Found};
use crate::oracle::solve::search_window;
use crate::oracle::vector::{dot, norm};
use crate::subject::Subject;
use crate::tolerance::{FOOT, STATIONARY};

/// Points of the grid along each of one or two parameters, and how many of them are projected.
const GRID: [usize; 2] = [400, 40];
const REFINED: usize = 6;
/// Largest shift of the slave and of single nodes, in sizes.
const SHIFT: f64 = 1.5;
const DEFORM: f64 = 0.5;

/// What was found for one element.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Global {
    /// Contact points projected, by verdict: inside, held by the boundary, not unique, beyond, undecided.
    pub verdicts: [u64; 5],
    /// Boxes looked at: sum and most.
    pub boxes: (u64, i32),
    /// Newton steps: sum and most.
    pub steps: (u64, i32),
    /// States tried and failed.
    pub finding: Finding,
}

impl Global {
    fn merge(mut self, other: Self) -> Self {
        for (verdict, count) in self.verdicts.iter_mut().zip(other.verdicts) {
            *verdict += count;
        }
        self.boxes = (
            self.boxes.0 + other.boxes.0,
            self.boxes.1.max(other.boxes.1),
        );
        self.steps = (
            self.steps.0 + other.steps.0,
            self.steps.1.max(other.steps.1),
        );
        self.finding.merge(other.finding);
        self
    }
}

/// Tries `states` states; `None` where nothing is projected. `compared`: every how many-th is compared with the grid.
pub fn prove(subject: &Subject, states: u64, compared: u64, seed: u64) -> Option<Global> {
    if subject.template.parameters() == 0 {
        return None;
    }
    let generator = super::random::generator(subject, seed);
    let one = |index: u64| one(subject, &generator, index, index.is_multiple_of(compared));
    let all = (0..states).into_par_iter().map(one);
    Some(all.reduce(Global::default, Global::merge))
}

fn one(subject: &Subject, generator: &Generator, index: u64, compared: bool) -> Global {
    let mut global = Global::default();
    let Some(configuration) = disturbed(generator, index) else {
        global
            .finding
            .fail(format!("state {index} could not be made"));
        return global;
    };
    let mut results = vec![Projection::default(); subject.description.descriptor.points];
    let d = subject.description.descriptor.dimension;
    let mut x = configuration.reference.clone();
    let mut u = configuration.displacement.clone();
    for list in [&mut x, &mut u] {
        list.extend(vec![0.0; d * subject.description.descriptor.multipliers()]);
    }
    let outcome = project(
        subject.description.descriptor,
        &Query {
            x: &x,
            u: &u,
            parameters: &subject.parameters(&configuration.pair),
            slave_row: &subject.slave_row(&configuration.pair),
            reach: 0.0,
        },
        &mut results,
        &mut [],
    );
    if outcome.code != code::SUCCESS {
        global.finding.fail(format!("state {index}: {outcome:?}"));
        return global;
    }
    for (q, found) in results.iter().enumerate() {
        global.verdicts[found.verdict as usize] += 1;
        global.boxes = (
            global.boxes.0 + found.boxes as u64,
            global.boxes.1.max(found.boxes),
        );
        global.steps = (
            global.steps.0 + found.steps as u64,
            global.steps.1.max(found.steps),
        );
        match judge(subject, &configuration, q, found, compared) {
            Ok(()) => global.finding.pass(),
            Err(wrong) => global
                .finding
                .fail(format!("state {index}, point {q}: {wrong}")),
        }
    }
    global
}

/// A state with the slave anywhere and all nodes shifted by up to half the size.
fn disturbed(generator: &Generator, index: u64) -> Option<Configuration> {
    let mut configuration = generator.generate(Wanted::Open, index).ok()?;
    let mut stream = Stream::new(index, 3, 44);
    let pair = &configuration.pair;
    let (d, size) = (pair.dimension, configuration.size);
    let shift = stream.cube(SHIFT * size);
    let nodes = pair.slave_nodes() + pair.master_nodes();
    for node in 0..nodes {
        let is_slave_position = node < pair.slave_nodes() && pair.slave_is_position(node);
        let deform = stream.cube(DEFORM * size);
        for k in 0..d {
            let along = if is_slave_position { shift[k] } else { 0.0 };
            configuration.displacement[node * d + k] += along + deform[k];
        }
    }
    Some(configuration)
}

/// What is wrong with a result.
fn judge(
    subject: &Subject,
    configuration: &Configuration,
    q: usize,
    found: &Projection,
    compared: bool,
) -> Result<(), String> {
    let pair = &configuration.pair;
    let frame = Frame::new(
        pair,
        q,
        &configuration.reference,
        &configuration.displacement,
    );
    if found.verdict > 2 {
        return Err(format!("undecided: {found:?}"));
    }
    let region = pair.region();
    let p = pair.parameters();
    for i in 0..p {
        if let Some([low, high]) = region.bounds[i]
            && !(low..=high).contains(&found.zeta[i])
        {
            return Err(format!("outside the domain: {found:?}"));
        }
    }
    let relative = frame.relative(&frame.nodes, found.zeta);
    let distance = norm(relative.position);
    if (distance - found.distance).abs() > FOOT * frame.size {
        return Err(format!(
            "the distance at the foot is {distance:e}: {found:?}"
        ));
    }
    for i in 0..p {
        let slope = dot(relative.position, relative.tangents[i]);
        let scale = norm(relative.tangents[i]) * (distance + frame.size);
        if found.verdict == 0 && slope.abs() > STATIONARY * scale {
            return Err(format!("not stationary, {:.1e}: {found:?}", slope / scale));
        }
    }
    if compared {
        let nearest = nearest(&frame, &subject.description.descriptor.domains);
        if distance > nearest + FOOT * frame.size {
            return Err(format!("a nearer point is {nearest:e} away: {found:?}"));
        }
    }
    Ok(())
}

/// The least distance of a regular grid of points and of the projections from the nearest of them. Half-bounded
/// `domains` are known to the declaration alone.
fn nearest(frame: &Frame<'_>, domains: &[Domain; 2]) -> f64 {
    let window = search_window(frame.pair);
    let region = frame.pair.region();
    let count = GRID[frame.parameters - 1];
    let at = |i: usize, k: usize| {
        let [low, high] = window[i];
        low + (high - low) * k as f64 / (count - 1) as f64
    };
    let distance = |z: [f64; 2]| norm(frame.relative(&frame.nodes, z).position);
    let mut samples = Vec::new();
    for first in 0..count {
        for last in 0..if frame.parameters == 2 { count } else { 1 } {
            let z = [
                at(0, first),
                if frame.parameters == 2 {
                    at(1, last)
                } else {
                    0.0
                },
            ];
            if !region.triangle || z[0] + z[1] <= 1.0 {
                samples.push((distance(z), z));
            }
        }
    }
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = samples.first().map_or(f64::INFINITY, |best| best.0);
    for (_, z) in samples.into_iter().take(REFINED) {
        let foot = match projection::project(frame, z) {
            Found::Inside(root) => root.z,
            Found::Outside { z, .. } => z,
            _ => continue,
        };
        if frame.pair.slave_parameters() == 1 || domains[0].feature(foot, 1e-9) == 0 {
            least = least.min(distance(foot));
        }
    }
    least
}
