//! What remains of a run: a table of verdicts, curves as CSV, diagrams as SVG, all of it in `index.html`.

mod curves;
mod diagram;
mod page;
mod summary;
mod table;

use std::fmt;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};

use super::sweeps::SWEEPS;
use super::{Extent, run as sweep};
use crate::subject::Subject;
pub use summary::Summary;

/// All sweeps of a run.
#[derive(Clone, Debug)]
pub struct Report {
    summaries: Vec<Summary>,
    page: PathBuf,
}

/// Runs every sweep and writes everything to a folder.
///
/// # Errors
/// A file cannot be written or drawn.
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
