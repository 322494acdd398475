//! The judgement of one sweep.

use crate::measure::stress::Outcome;
use crate::measure::stress::errors::{Measurement, Verdict};
use crate::measure::stress::sweeps::Series;

/// The judgement of one sweep.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Name of the sweep.
    pub name: &'static str,
    /// Its parameter.
    pub parameter: &'static str,
    /// Elements with their loads.
    pub curves: usize,
    /// States.
    pub states: usize,
    /// Number of states judged by error or status.
    pub exact: usize,
    /// Number of states where neither data nor theory decide.
    pub undecided: usize,
    /// Number of states that would have failed, but lie beyond the documented limit.
    pub beyond: usize,
    /// The largest relative error of residual and tangent among those judged.
    pub largest: [f64; 2],
    /// The largest error in spreads among those judged, with element and value.
    pub worst: Option<(f64, Series, f64)>,
    /// What failed, with element and value.
    pub failures: Vec<String>,
}

impl Summary {
    /// Judges a sweep.
    pub fn new(outcome: &Outcome) -> Self {
        let mut summary = Self {
            name: outcome.sweep.name,
            parameter: outcome.sweep.parameter,
            curves: outcome.curves.len(),
            states: 0,
            exact: 0,
            undecided: 0,
            beyond: 0,
            largest: [0.0; 2],
            worst: None,
            failures: vec![],
        };
        for curve in &outcome.curves {
            for (value, measured) in &curve.points {
                summary.add(curve.series, *value, measured);
            }
        }
        summary
    }

    fn add(&mut self, series: Series, value: f64, measured: &Measurement) {
        self.states += 1;
        match &measured.verdict {
            Verdict::Exact => self.exact += 1,
            Verdict::Undecided => {
                self.undecided += 1;
                return;
            }
            Verdict::Beyond(_) => {
                self.beyond += 1;
                return;
            }
            Verdict::Failed(reason) => self.failures.push(format!(
                "{}, {} at {value:.3e}: {reason}",
                self.name,
                series.label()
            )),
        }
        for (largest, found) in self
            .largest
            .iter_mut()
            .zip([measured.residual, measured.tangent])
        {
            *largest = largest.max(found.map_or(0.0, |found| found.error));
        }
        if let Some(spreads) = measured.spreads()
            && self.worst.is_none_or(|(worst, ..)| spreads > worst)
        {
            self.worst = Some((spreads, series, value));
        }
    }

    /// Whether nothing failed.
    pub fn passed(&self) -> bool {
        self.failures.is_empty()
    }
}
