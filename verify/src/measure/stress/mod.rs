//! Numerical stability: one parameter at a time is driven from harmless to extreme, and the errors of residual
//! and tangent are measured in units of their *spread*, the change that half a unit in the last place of every
//! coordinate makes ([`errors`]). Truth and spread are evaluated in octuple precision ([`truth`]).
//!
//! [`sweeps`] lists what is swept, [`scene`] makes the states, [`report`] writes curves, tables and diagrams.

pub mod errors;
pub mod exact;
pub mod friction;
pub mod kinematics;
pub mod report;
pub mod scene;
pub mod sweeps;
pub mod truth;

use rayon::prelude::*;

use crate::configurations::Stream;
use crate::subject::Subject;
use errors::{Measurement, measure};
use scene::Scene;
use sweeps::{Series, Sweep};

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Values of the parameter per sweep.
    pub points: usize,
    /// States per value and element.
    pub copies: u64,
}

impl Extent {
    /// Seconds.
    pub const QUICK: Self = Self {
        points: 4,
        copies: 1,
    };

    /// Two states for each of so many values.
    pub fn of(points: u16) -> Self {
        Self {
            points: usize::from(points),
            copies: 2,
        }
    }
}

/// One curve of a sweep.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Element and load.
    pub series: Series,
    /// Value of the parameter and outcome, in the order of the sweep; several for one value.
    pub points: Vec<(f64, Measurement)>,
}

/// All curves of a sweep.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What was swept.
    pub sweep: Sweep,
    /// One for each element and load.
    pub curves: Vec<Curve>,
}

/// Seed of the states.
const SEED: u64 = 4711;

/// Runs one sweep with the elements among `subjects`; `done` is called after every state.
pub fn run(
    sweep: &Sweep,
    subjects: &[Subject],
    extent: Extent,
    done: &(dyn Fn() + Sync),
) -> Outcome {
    let known = |series: &Series| subjects.iter().find(|s| s.name() == series.element);
    let curves = sweep
        .series
        .iter()
        .filter_map(|series| known(series).map(|subject| (series, subject)))
        .collect::<Vec<_>>()
        .into_par_iter()
        .map(|(series, subject)| Curve {
            series: *series,
            points: curve(sweep, *series, subject, extent, done),
        });
    Outcome {
        sweep: *sweep,
        curves: curves.collect(),
    }
}

fn curve(
    sweep: &Sweep,
    series: Series,
    subject: &Subject,
    extent: Extent,
    done: &(dyn Fn() + Sync),
) -> Vec<(f64, Measurement)> {
    let one = |value: f64, copy: u64| {
        // the same scene for every value, so that a curve shows the parameter alone
        let mut stream = Stream::new(SEED, copy, 0);
        let mut scene = Scene::typical(&subject.template, series.load, &mut stream);
        (sweep.deform)(&mut scene, value)?;
        let case = scene.case(&mut stream)?;
        let measured = measure(subject, &case, &mut stream)?;
        Some(if series.is_beyond(sweep, value) {
            measured.beyond()
        } else {
            measured
        })
    };
    let all = sweep.values(extent.points).into_iter();
    let all: Vec<(f64, u64)> = all
        .flat_map(|value| (0..extent.copies).map(move |copy| (value, copy)))
        .collect();
    all.into_par_iter()
        .map(|(value, copy)| {
            let measured = one(value, copy).unwrap_or_else(Measurement::missing);
            done();
            (value, measured)
        })
        .collect()
}

#[cfg(test)]
mod tests;
