//! Judges a foot by the oracle's positions and tangents: the conditions of a minimum within the domain,
//! random points and a grid of it.

use contact_elements::runtime::Domain;
use contact_elements::{Closest, Verdict};

use crate::configurations::{Configuration, Stream};
use crate::oracle::kinematics::Frame;
use crate::oracle::projection::{self, Projection as Found};
use crate::oracle::solve::search_window;
use crate::oracle::vector::{dot, norm};
use crate::subject::Subject;
use crate::tolerance::{FOOT, STATIONARY};

/// Points of the grid along each of one or two parameters, and how many of them are projected.
const GRID: [usize; 2] = [400, 40];
const REFINED: usize = 6;
/// Number of random points of the domain, none of which may be nearer than a closest point.
const SAMPLES: usize = 16;
/// How far a foot may lie beside the boundary that holds it, in extents.
const ON_SIDE: f64 = 1e-12;
/// Purpose of the stream of random points.
const SAMPLED: u64 = 46;

/// ξ + η = 1 of a triangle, among the numbers of sides.
const DIAGONAL: usize = 4;
/// The sides that each feature lies on, as the interface numbers features: curves, quadrilaterals, triangles, two curves.
const CURVE: [&[usize]; 9] = [&[], &[], &[], &[], &[], &[0], &[1], &[], &[]];
const RECTANGLE: [&[usize]; 9] = [
    &[],
    &[2],
    &[1],
    &[3],
    &[0],
    &[0, 2],
    &[1, 2],
    &[1, 3],
    &[0, 3],
];
const TRIANGLE: [&[usize]; 9] = [
    &[],
    &[2],
    &[DIAGONAL],
    &[0],
    &[],
    &[0, 2],
    &[2, DIAGONAL],
    &[0, DIAGONAL],
    &[],
];
const TWO_CURVES: [&[usize]; 9] = [
    &[],
    &[0],
    &[1],
    &[2],
    &[3],
    &[0, 2],
    &[1, 2],
    &[0, 3],
    &[1, 3],
];

/// n·ζ ≤ offset: one side of a domain.
#[derive(Clone, Copy, Debug)]
struct Side {
    normal: [f64; 2],
    offset: f64,
    extent: f64,
}

impl Side {
    /// How far ζ lies beyond it, in extents.
    fn excess(&self, zeta: [f64; 2]) -> f64 {
        let along = self.normal[0] * zeta[0] + self.normal[1] * zeta[1];
        (along - self.offset) / self.extent
    }
}

/// The contact points of one state.
pub(super) struct Judge<'a> {
    frames: Vec<Frame<'a>>,
    domains: [Domain; 2],
    seed: u64,
    index: u64,
}

impl<'a> Judge<'a> {
    pub(super) fn new(
        subject: &Subject,
        configuration: &'a Configuration,
        seed: u64,
        index: u64,
    ) -> Self {
        let Configuration {
            pair,
            reference,
            displacement,
            ..
        } = configuration;
        let frame = |q: usize| Frame::new(pair, q, reference, displacement);
        Self {
            frames: (0..pair.points()).map(frame).collect(),
            domains: subject.description.descriptor.domains,
            seed,
            index,
        }
    }

    /// Largest coordinate of the point's problem.
    pub(super) fn size(&self, q: usize) -> f64 {
        self.frames[q].size
    }

    /// What is wrong with a closest point.
    pub(super) fn global(
        &self,
        q: usize,
        found: &Closest,
        is_compared: bool,
    ) -> Result<(), String> {
        let frame = &self.frames[q];
        if matches!(found.verdict, Verdict::Beyond | Verdict::Undecided) {
            return Err(format!("undecided: {found:?}"));
        }
        let complain = |wrong: String| format!("{wrong}: {found:?}");
        let feature = found.feature as usize;
        let distance = self.held(frame, found.zeta, feature).map_err(complain)?;
        if (distance - found.distance).abs() > FOOT * frame.size {
            return Err(complain(format!(
                "the distance at the foot is {distance:e}"
            )));
        }
        if found.verdict == Verdict::Inside {
            is_minimum(frame, found.zeta).map_err(complain)?;
        }
        let mut nearest = self.sampled(q);
        if is_compared {
            nearest = nearest.min(self.nearest(frame));
        }
        if distance > nearest + FOOT * frame.size {
            return Err(complain(format!("a nearer point is {nearest:e} away")));
        }
        Ok(())
    }

    /// The distance at a foot of an evaluation, or what is wrong with it: a minimum inside, held by the boundary,
    /// or stationary beyond it.
    pub(super) fn local(&self, q: usize, zeta: [f64; 2], feature: usize) -> Result<f64, String> {
        let frame = &self.frames[q];
        let sides = self.sides(frame, feature);
        let is_beyond = |side: &Side| side.excess(zeta) > ON_SIDE;
        let distance = if feature != 0 && !sides.is_empty() && sides.iter().all(is_beyond) {
            stationary(frame, zeta, &[])
        } else {
            self.held(frame, zeta, feature)
        };
        let complain = |wrong: String| format!("{wrong}: zeta {zeta:?}, feature {feature}");
        let distance = distance.map_err(complain)?;
        if feature == 0 {
            is_minimum(frame, zeta).map_err(complain)?;
        }
        Ok(distance)
    }

    /// The distance at ζ, which lies in the domain, on the named sides, and is stationary but for them.
    fn held(&self, frame: &Frame<'_>, zeta: [f64; 2], feature: usize) -> Result<f64, String> {
        let sides = self.sides(frame, feature);
        if feature != 0 && sides.is_empty() {
            return Err("no such feature".into());
        }
        if sides.iter().any(|side| side.excess(zeta).abs() > ON_SIDE) {
            return Err("not on the feature".into());
        }
        if self
            .all_sides(frame)
            .any(|side| side.excess(zeta) > ON_SIDE)
        {
            return Err("outside the domain".into());
        }
        stationary(frame, zeta, &sides)
    }

    /// Bounds of parameter `i`; only the declaration knows those that are open to one side.
    fn bounds(&self, frame: &Frame<'_>, i: usize) -> [f64; 2] {
        let own = frame.pair.slave_parameters();
        let (domain, i) = match i.checked_sub(own) {
            Some(i) => (self.domains[own], i),
            None => (self.domains[0], i),
        };
        match domain {
            Domain::Interval(low, high) => [low, high],
            Domain::Rectangle(low, high) => [low[i], high[i]],
            Domain::Triangle => [0.0, 1.0],
            Domain::Unbounded => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Side 2 i + end: parameter i at its lower (0) or upper (1) end; [`DIAGONAL`]. `None` where there is no end.
    fn side(&self, frame: &Frame<'_>, number: usize) -> Option<Side> {
        if number == DIAGONAL {
            return Some(Side {
                normal: [1.0; 2],
                offset: 1.0,
                extent: 1.0,
            });
        }
        let (i, end) = (number / 2, number % 2);
        let bounds = self.bounds(frame, i);
        let sign = if end == 0 { -1.0 } else { 1.0 };
        let mut normal = [0.0; 2];
        normal[i] = sign;
        let extent = bounds[1] - bounds[0];
        bounds[end].is_finite().then_some(Side {
            normal,
            offset: sign * bounds[end],
            extent: if extent.is_finite() { extent } else { 1.0 },
        })
    }

    fn is_triangle(&self, frame: &Frame<'_>) -> bool {
        frame.pair.slave_parameters() == 0 && self.domains[0] == Domain::Triangle
    }

    fn all_sides(&self, frame: &Frame<'_>) -> impl Iterator<Item = Side> {
        let numbers: &[usize] = match frame.parameters {
            1 => &[0, 1],
            _ if self.is_triangle(frame) => &[0, 2, DIAGONAL],
            _ => &[0, 1, 2, 3],
        };
        numbers
            .iter()
            .filter_map(|&number| self.side(frame, number))
    }

    /// The sides on which a feature of the interface lies; `None` if the pair has no such feature.
    fn sides(&self, frame: &Frame<'_>, feature: usize) -> Vec<Side> {
        let table = match (frame.parameters, frame.pair.slave_parameters()) {
            (1, _) => &CURVE,
            (_, 1) => &TWO_CURVES,
            _ if self.is_triangle(frame) => &TRIANGLE,
            _ => &RECTANGLE,
        };
        let numbers = table.get(feature).copied().unwrap_or_default();
        let sides = numbers
            .iter()
            .filter_map(|&number| self.side(frame, number));
        sides.collect()
    }

    /// The least distance of some random points.
    fn sampled(&self, q: usize) -> f64 {
        let frame = &self.frames[q];
        let mut stream = Stream::new(self.seed, self.index, SAMPLED + q as u64);
        let window = search_window(frame.pair);
        let is_triangle = self.is_triangle(frame);
        let mut least = f64::INFINITY;
        for _ in 0..SAMPLES {
            let mut zeta = window.map(|[low, high]| stream.uniform(low, high));
            if is_triangle && zeta[0] + zeta[1] > 1.0 {
                zeta = zeta.map(|zeta| 1.0 - zeta);
            }
            least = least.min(distance(frame, zeta));
        }
        least
    }

    /// The least distance of a regular grid of points and of the projections from the nearest of them.
    fn nearest(&self, frame: &Frame<'_>) -> f64 {
        let window = search_window(frame.pair);
        let count = GRID[frame.parameters - 1];
        let at = |i: usize, k: usize| {
            let [low, high] = window[i];
            low + (high - low) * k as f64 / (count - 1) as f64
        };
        let is_triangle = self.is_triangle(frame);
        let mut samples = Vec::new();
        for first in 0..count {
            for last in 0..if frame.parameters == 2 { count } else { 1 } {
                let last = if frame.parameters == 2 {
                    at(1, last)
                } else {
                    0.0
                };
                let z = [at(0, first), last];
                if !is_triangle || z[0] + z[1] <= 1.0 {
                    samples.push((distance(frame, z), z));
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
            if self.all_sides(frame).all(|side| side.excess(foot) <= 1e-9) {
                least = least.min(distance(frame, foot));
            }
        }
        least
    }
}

fn distance(frame: &Frame<'_>, zeta: [f64; 2]) -> f64 {
    norm(frame.relative(&frame.nodes, zeta).position)
}

/// The distance at ζ, where −r·r_,i is a sum of outward normals of `sides` with factors that are not negative.
fn stationary(frame: &Frame<'_>, zeta: [f64; 2], sides: &[Side]) -> Result<f64, String> {
    let relative = frame.relative(&frame.nodes, zeta);
    let distance = norm(relative.position);
    let (mut descent, mut scale) = ([0.0; 2], [0.0; 2]);
    for i in 0..frame.parameters {
        let tangent = relative.tangents[i];
        descent[i] = -dot(relative.position, tangent);
        let steepness = norm(tangent).max(bend(frame, zeta, i).abs().sqrt());
        scale[i] = STATIONARY * steepness * (distance + frame.size);
    }
    let allowed = |v: [f64; 2]| v[0].abs() * scale[0] + v[1].abs() * scale[1];
    let along = |v: [f64; 2]| v[0] * descent[0] + v[1] * descent[1];
    let across = |v: [f64; 2]| [-v[1], v[0]];
    let (free, pushed): (Vec<[f64; 2]>, Vec<[f64; 2]>) = match sides {
        [] => (vec![[1.0, 0.0], [0.0, 1.0]], vec![]),
        [one] => (vec![across(one.normal)], vec![one.normal]),
        // the factors: descent = λ m + μ n, λ = descent·n⊥/(m·n⊥)
        [one, other, ..] => {
            let toward = |m: [f64; 2], n: [f64; 2]| {
                let normal = across(n);
                let factor = m[0] * normal[0] + m[1] * normal[1];
                normal.map(|entry| entry * factor.signum())
            };
            let pushed = vec![
                toward(one.normal, other.normal),
                toward(other.normal, one.normal),
            ];
            (vec![], pushed)
        }
    };
    let moves = |v: &[f64; 2]| along(*v).abs() > allowed(*v);
    let pulls = |v: &[f64; 2]| along(*v) < -allowed(*v);
    if free.iter().any(moves) || pushed.iter().any(pulls) {
        return Err(format!("r.r falls along {descent:?}"));
    }
    Ok(distance)
}

/// F_ii by a difference of f_i.
fn bend(frame: &Frame<'_>, zeta: [f64; 2], i: usize) -> f64 {
    const STEP: f64 = 1e-5;
    let slope = |way: f64| {
        let mut zeta = zeta;
        zeta[i] += way;
        let relative = frame.relative(&frame.nodes, zeta);
        dot(relative.position, relative.tangents[i])
    };
    (slope(STEP) - slope(-STEP)) / (2.0 * STEP)
}

/// The oracle's Newton method stays at a minimum.
fn is_minimum(frame: &Frame<'_>, zeta: [f64; 2]) -> Result<(), String> {
    match projection::project(frame, zeta) {
        Found::Inside(_) | Found::Outside { .. } => Ok(()),
        Found::Degenerate { .. } => Err("no minimum".into()),
        Found::NotConverged => Err("the oracle leaves it".into()),
    }
}
