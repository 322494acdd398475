//! Curves as CSV: one row per state.

use std::path::Path;

use crate::measure::stress::Outcome;
use crate::measure::stress::errors::{Deviation, Verdict};

/// Writes `<sweep>.csv`.
pub fn write(outcome: &Outcome, folder: &Path) -> Result<(), csv::Error> {
    let mut file = csv::Writer::from_path(folder.join(format!("{}.csv", outcome.sweep.name)))?;
    file.write_record([
        outcome.sweep.parameter,
        "element",
        "status",
        "status in truth",
        "iterations",
        "residual: error",
        "residual: spread",
        "residual: error/spread",
        "tangent: error",
        "tangent: spread",
        "tangent: error/spread",
        "verdict",
    ])?;
    for curve in &outcome.curves {
        for (value, measured) in &curve.points {
            let mut row = vec![format!("{value:e}"), curve.series.label()];
            row.push(
                measured
                    .status
                    .map_or("refused".into(), |s| format!("{s:?}")),
            );
            row.push(measured.truth.map_or("none".into(), |s| format!("{s:?}")));
            row.push(measured.iterations.map_or(String::new(), |v| v.to_string()));
            for deviation in [measured.residual, measured.tangent] {
                row.extend(numbers(deviation));
            }
            row.push(match &measured.verdict {
                Verdict::Exact => "exact".into(),
                Verdict::Undecided => "undecided".into(),
                Verdict::Beyond(reason) => format!("beyond the limit of the sweep: {reason}"),
                Verdict::Failed(reason) => format!("failed: {reason}"),
            });
            file.write_record(row)?;
        }
    }
    file.flush()?;
    Ok(())
}

fn numbers(deviation: Option<Deviation>) -> [String; 3] {
    deviation.map_or_else(Default::default, |d| {
        [d.error, d.spread, d.spreads()].map(|v| format!("{v:.3e}"))
    })
}
