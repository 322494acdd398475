//! What remains of a run: a table of verdicts, curves as CSV, diagrams as SVG, all of it in `index.html`.

mod curves;
mod diagram;
mod page;
mod table;

use std::fmt;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};

use super::errors::{Measurement, Verdict};
use super::sweeps::{SWEEPS, Series};
use super::{Extent, Outcome, run as sweep};
use crate::subject::Subject;

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
    /// Of them: judged by error or status.
    pub exact: usize,
    /// Of them: where neither data nor theory decide.
    pub undecided: usize,
    /// Of them: what would have failed, beyond the documented limit.
    pub beyond: usize,
    /// The largest relative error of residual and tangent among those judged.
    pub largest: [f64; 2],
    /// The largest error in spreads among those judged, with element and value.
    pub worst: Option<(f64, Series, f64)>,
    /// What failed, with element and value.
    pub failures: Vec<String>,
}

/// All sweeps of a run.
#[derive(Clone, Debug)]
pub struct Report {
    summaries: Vec<Summary>,
    page: PathBuf,
}

/// Runs every sweep and writes everything to a folder.
///
/// # Errors
/// Where something cannot be written or drawn.
pub fn run(
    subjects: &[Subject],
    extent: Extent,
    folder: &Path,
) -> Result<Report, Box<dyn std::error::Error>> {
    std::fs::create_dir_all(folder)?;
    let states = |series: usize, values: usize| (series * values) as u64 * extent.copies;
    let total = SWEEPS
        .iter()
        .map(|sweep| states(sweep.series.len(), sweep.values(extent.points).len()))
        .sum();
    let bar = ProgressBar::new(total);
    bar.set_style(ProgressStyle::with_template(
        "{msg:10} {bar:40} {pos}/{len} states, {elapsed} of {duration}",
    )?);
    let mut summaries = Vec::with_capacity(SWEEPS.len());
    let mut outcomes = Vec::with_capacity(SWEEPS.len());
    for one in SWEEPS {
        bar.set_message(one.name);
        let outcome = sweep(one, subjects, extent, &|| bar.inc(1));
        if outcome.curves.is_empty() {
            continue;
        }
        curves::write(&outcome, folder)?;
        diagram::draw(&outcome, folder)?;
        summaries.push(Summary::new(&outcome));
        outcomes.push(outcome);
    }
    bar.finish_and_clear();
    let page = folder.join("index.html");
    page::write(&page, &outcomes, &summaries)?;
    Ok(Report { summaries, page })
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

impl Report {
    /// Whether every sweep passed.
    pub fn passed(&self) -> bool {
        self.summaries.iter().all(Summary::passed)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for failure in self.summaries.iter().flat_map(|summary| &summary.failures) {
            writeln!(f, "failed   {failure}")?;
        }
        writeln!(f, "{}", table::of(&self.summaries))?;
        write!(f, "stress   {}", self.page.display())
    }
}
