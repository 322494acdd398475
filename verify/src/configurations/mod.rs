//! Random states and edge cases on which elements are compared with the oracle.
//!
//! A [`Generator`] turns a template [`Pair`] into reproducible random [`Configuration`]s: state
//! `index` of seed `seed` is always the same, whatever was generated before. The flow of one
//! attempt: [`recipe`] draws the numbers of the pair, [`build`] sets the geometries so that the
//! requested status should hold, [`motion`] moves, turns and scales everything, [`multipliers`] and [`friction`] add what the
//! points remember, `angle` adds a window of angles, and the oracle's own projection confirms status and conditioning; otherwise the attempt is repeated.
//! [`edge_cases`] lists the states where elements tend to fail, with what must come out.

mod angle;
pub mod build;
pub mod edge_cases;
mod error;
pub mod flat;
pub mod friction;
mod margin;
pub mod motion;
pub mod multipliers;
pub mod random;
pub mod recipe;
mod rolling;
mod state;

pub use error::GenerateError;
pub use random::Stream;
pub use recipe::Freedom;
pub use state::{Configuration, Wanted};

use crate::oracle::pair::Pair;
use crate::oracle::solve::{self, PointReport, PointStatus, Start, State};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::tangential::return_map::Regime;

/// Makes random states of one pair.
#[derive(Debug, Clone)]
pub struct Generator {
    /// Geometries, gap and law; its numbers are replaced as far as `freedom` allows.
    pub template: Pair,
    /// Which numbers are drawn.
    pub freedom: Freedom,
    /// Seed of all states.
    pub seed: u64,
}

/// Attempts per state.
const ATTEMPTS: usize = 400;
/// Least eigenvalue of `a⁻¹F` and largest cosine between tangents of an accepted state.
const LEAST_EIGENVALUE: f64 = 0.1;
const LARGEST_COSINE: f64 = 0.98;

impl Generator {
    /// A generator that draws everything.
    pub fn new(template: Pair, seed: u64) -> Self {
        Self {
            template,
            freedom: Freedom::ALL,
            seed,
        }
    }

    /// State number `index` with the requested status.
    pub fn generate(&self, wanted: Wanted, index: u64) -> Result<Configuration, GenerateError> {
        self.template.validate().map_err(GenerateError::Template)?;
        let bounded = self.template.region().bounds[..self.template.parameters()]
            .iter()
            .any(Option::is_some);
        if wanted == Wanted::Outside && !bounded {
            return Err(GenerateError::NeverOutside);
        }
        let law = self.template.tangential.as_ref().map(|t| &t.law);
        let possible = match wanted {
            Wanted::Stick => law.is_some(),
            Wanted::Slip => law.is_some_and(TangentialLaw::is_bounded),
            Wanted::Closed | Wanted::Open | Wanted::Outside => true,
        };
        if !possible {
            return Err(GenerateError::NeverSlips);
        }
        let mut stream = Stream::new(self.seed, index, wanted as u64);
        for _ in 0..ATTEMPTS {
            if let Some(configuration) = self.attempt(wanted, &mut stream) {
                return Ok(configuration);
            }
        }
        Err(GenerateError::Exhausted { attempts: ATTEMPTS })
    }

    fn attempt(&self, wanted: Wanted, stream: &mut Stream) -> Option<Configuration> {
        // open because of the angle: penetrating without weight
        let silent =
            self.template.angle.is_some() && wanted == Wanted::Open && stream.index(2) == 0;
        let depth = if silent { Wanted::Closed } else { wanted };
        let mut recipe = recipe::draw(&self.template, &self.freedom, depth, stream);
        let angle = recipe.pair.angle.take();
        let built = build::build(&recipe, wanted, stream)?;
        let mut moved = motion::apply(&recipe, built, &self.freedom, stream);
        moved.start = starts(&moved, stream)?;
        moved.points = solve::reports(&moved.pair, &moved.state()).ok()?;
        moved.pair.angle = angle;
        angle::equip(&mut moved, silent, stream)?;
        moved.points = solve::reports(&moved.pair, &moved.state()).ok()?;
        multipliers::equip(&mut moved, wanted, stream)?;
        moved.points = solve::reports(&moved.pair, &moved.state()).ok()?;
        friction::equip(&mut moved, wanted, &self.freedom, stream)?;
        (accepted(&moved.points, wanted) && is_deep(&moved)).then_some(moved)
    }

    /// A closed state that is as well conditioned as generated ones.
    pub fn is_sound(configuration: &Configuration) -> bool {
        accepted(&configuration.points, Wanted::Closed)
            && is_deep(configuration)
            && friction::is_clear(configuration)
    }
}

/// Least depth of the deepest closed point, in sizes: shallower gaps keep too few digits to judge by.
const LEAST_DEPTH: f64 = 1e-2;

/// No point is closed, or the deepest one is deep enough.
fn is_deep(configuration: &Configuration) -> bool {
    let closed = |point: &&PointReport| point.status == PointStatus::Closed;
    let depths = configuration
        .points
        .iter()
        .filter(closed)
        .map(|point| point.gap.abs());
    depths
        .reduce(f64::max)
        .is_none_or(|depth| depth >= 0.99 * LEAST_DEPTH * configuration.size)
}

/// Starts near the solutions, which are searched.
fn starts(configuration: &Configuration, stream: &mut Stream) -> Option<Vec<[f64; 2]>> {
    let pair = &configuration.pair;
    let search = State {
        start: Start::Search,
        ..configuration.state()
    };
    let found = solve::reports(pair, &search).ok()?;
    let region = pair.region();
    let near = |point: &PointReport, stream: &mut Stream| {
        let mut z = [0.0; 2];
        for i in 0..pair.parameters() {
            z[i] = point.zeta[i] + 0.07 * region.extent(i) * stream.uniform(-1.0, 1.0);
            if let Some([low, high]) = region.bounds[i] {
                z[i] = z[i].clamp(low, high);
            }
        }
        let sum = z[0] + z[1];
        if region.triangle && sum > 1.0 {
            z.map(|v| v / sum)
        } else {
            z
        }
    };
    let starts: Vec<_> = found.iter().map(|point| near(point, stream)).collect();
    starts
        .iter()
        .flatten()
        .all(|v| v.is_finite())
        .then_some(starts)
}

fn accepted(points: &[PointReport], wanted: Wanted) -> bool {
    let sound = |point: &PointReport| match point.status {
        PointStatus::Open | PointStatus::Closed => point.conditioning.is_some_and(|c| {
            c.smallest_eigenvalue >= LEAST_EIGENVALUE && c.tangent_cosine <= LARGEST_COSINE
        }),
        PointStatus::Outside(_) => true,
        PointStatus::Degenerate | PointStatus::NotConverged => false,
    };
    let any = |test: fn(&PointStatus) -> bool| points.iter().any(|point| test(&point.status));
    points.iter().all(sound)
        && match wanted {
            Wanted::Closed => any(|s| *s == PointStatus::Closed),
            Wanted::Open => any(|s| *s == PointStatus::Open) && !any(|s| *s == PointStatus::Closed),
            Wanted::Outside => any(|s| matches!(s, PointStatus::Outside(_))),
            Wanted::Stick => any(|s| *s == PointStatus::Closed) && !slips(points),
            Wanted::Slip => slips(points),
        }
}

fn slips(points: &[PointReport]) -> bool {
    let mut friction = points.iter().filter_map(|point| point.friction);
    friction.any(|friction| friction.regime == Regime::Slip)
}

#[cfg(test)]
mod tests;
