//! The long run of global projections: a table of boxes and steps per element.

use std::time::Instant;

use comfy_table::{Cell, CellAlignment, Table, presets};

use crate::proof::global::{self, Global};
use crate::subject::Subject;

/// Every how many-th state is compared with a grid; the others are judged by their verdict, foot and slopes.
const COMPARED: u64 = 100;
/// Name of a verdict, in the order of [`Global::verdicts`].
const VERDICTS: [&str; 5] = ["inside", "boundary", "not unique", "beyond", "undecided"];

/// Projects in `states` states of every subject; prints each row as it is done. Returns how many failed.
pub fn run(subjects: &[Subject], states: u64, seed: u64) -> u64 {
    let mut table = Table::new();
    table.load_style(presets::ASCII_MARKDOWN);
    let columns = [
        "element",
        "points",
        "boxes, mean",
        "most",
        "steps, mean",
        "most",
        "µs",
    ];
    table.set_header(columns.iter().chain(&VERDICTS));
    let mut failed = 0;
    for subject in subjects {
        let start = Instant::now();
        let Some(global) = global::prove(subject, states, COMPARED, seed) else {
            continue;
        };
        let seconds = start.elapsed().as_secs_f64();
        eprintln!("{}: {} states in {seconds:.1} s", subject.name(), states);
        for failure in &global.finding.failures {
            eprintln!("FAILED {}: {failure}", subject.name());
        }
        failed += global.finding.failed;
        table.add_row(row(subject, &global, seconds));
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}");
    failed
}

fn row(subject: &Subject, global: &Global, seconds: f64) -> Vec<Cell> {
    let points: u64 = global.verdicts.iter().sum();
    let mean = |sum: u64| format!("{:.1}", sum as f64 / points.max(1) as f64);
    let threads = rayon::current_num_threads() as f64;
    let each = 1e6 * seconds * threads / points.max(1) as f64;
    let values = [
        subject.name().to_string(),
        points.to_string(),
        mean(global.boxes.0),
        global.boxes.1.to_string(),
        mean(global.steps.0),
        global.steps.1.to_string(),
        format!("{each:.0}"),
    ];
    let verdicts = global.verdicts.iter().map(u64::to_string);
    values.into_iter().chain(verdicts).map(Cell::new).collect()
}
