//! The table of verdicts for the terminal.

use comfy_table::{Table, presets};

use super::summary::Summary;

/// One row per sweep.
pub fn of(summaries: &[Summary]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::ASCII_MARKDOWN);
    table.set_header(HEAD);
    for summary in summaries {
        table.add_row(row(summary));
    }
    table
}

/// Heads of the columns.
pub const HEAD: [&str; 10] = [
    "sweep",
    "parameter",
    "curves",
    "states",
    "undecided",
    "beyond limit",
    "largest error of R, K",
    "worst error / spread",
    "where",
    "verdict",
];

/// One row.
pub fn row(summary: &Summary) -> [String; 10] {
    let (worst, place) = match summary.worst {
        Some((spreads, series, value)) => (
            format!("{spreads:.2}"),
            format!("{} at {value:.1e}", series.label()),
        ),
        None => ("–".into(), "–".into()),
    };
    let verdict = if summary.passed() {
        "PASS".to_string()
    } else {
        format!("FAIL ({})", summary.failures.len())
    };
    [
        summary.name.into(),
        summary.parameter.into(),
        summary.curves.to_string(),
        summary.states.to_string(),
        summary.undecided.to_string(),
        summary.beyond.to_string(),
        format!("{:.0e}, {:.0e}", summary.largest[0], summary.largest[1]),
        worst,
        place,
        verdict,
    ]
}
