//! The long run of projections: a row of efforts and outcomes per geometry, on the screen and as CSV.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use comfy_table::{Cell, CellAlignment, Table, presets};
use contact_elements::table::{MasterDescription, SlaveDescription};
use indicatif::{ProgressBar, ProgressStyle};

use crate::proof::global::{self, Effort, Extent, Global, Local};
use crate::subject::Subject;

/// Every how many-th state is compared with a grid; the others with a few random points of the domain.
const COMPARED: u64 = 1000;
/// Disturbances of one random state, and how many families are done between looks at the clock.
const FAMILY: u64 = 50;
const BLOCK: u64 = 40;

/// How long a run is.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    /// States of every element, in whole families.
    pub states: u64,
    /// Seconds after which the next element has its turn.
    pub seconds: f64,
}

/// The first subject of each geometry that points are projected onto, and of each pair of curves.
pub fn representatives(subjects: &[Subject]) -> Vec<&Subject> {
    let mut known = Vec::new();
    let mut list = Vec::new();
    for subject in subjects {
        // beyond its angles an element reports nothing about its projection
        let slave = match &subject.description.slave {
            _ if subject.description.angle.is_some() => continue,
            SlaveDescription::Point => "",
            SlaveDescription::Projected(geometry) => geometry.name,
            _ => continue,
        };
        let master = match &subject.description.master {
            MasterDescription::Shape(geometry) | MasterDescription::Rigid(geometry) => {
                geometry.name
            }
            MasterDescription::Point | MasterDescription::Distance(_) => continue,
        };
        if !known.contains(&(slave, master)) {
            known.push((slave, master));
            list.push(subject);
        }
    }
    list
}

/// Projects in random states of every subject; prints a table, writes `projections.csv` row by row. Returns how
/// many answers were wrong.
///
/// # Errors
/// A file cannot be written.
pub fn run(
    subjects: &[&Subject],
    length: Length,
    seed: u64,
    folder: &Path,
) -> Result<u64, Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let mut file = csv::Writer::from_path(folder.join("projections.csv"))?;
    let columns = columns(&Global::default());
    let names = columns.iter().map(|(name, _)| *name);
    file.write_record(["element"].into_iter().chain(names).chain(["seconds"]))?;
    let mut rows = Vec::new();
    let mut failed = 0;
    for subject in subjects {
        let Some((global, seconds)) = measured(subject, length, seed) else {
            continue;
        };
        for failure in &global.finding.failures {
            eprintln!("FAILED {}: {failure}", subject.name());
        }
        failed += global.finding.failed;
        let mut record = vec![subject.name().to_string()];
        record.extend(self::columns(&global).into_iter().map(|(_, value)| value));
        record.push(format!("{seconds:.1}"));
        file.write_record(record)?;
        file.flush()?;
        let points = global.boxes.count;
        eprintln!("{}: {points} points in {seconds:.1} s", subject.name());
        rows.push((subject.name(), global));
    }
    println!("{}", efforts(&rows));
    println!("{}", outcomes(&rows));
    Ok(failed)
}

/// Runs one subject with a bar.
fn measured(subject: &Subject, length: Length, seed: u64) -> Option<(Global, f64)> {
    let start = Instant::now();
    let families = length.states.div_ceil(FAMILY);
    let bar = ProgressBar::new(families * FAMILY);
    let template = "{bar:30} {human_pos}/{human_len} {msg} [{elapsed}, {eta} left]";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_message(subject.name());
    let mut global = Global::default();
    let mut first = 0;
    while first < families && start.elapsed().as_secs_f64() < length.seconds {
        let extent = Extent {
            first,
            families: BLOCK.min(families - first),
            family: FAMILY,
            compared: COMPARED,
            seed,
        };
        global = global.merge(global::prove(subject, extent)?);
        first += extent.families;
        bar.set_position(first * FAMILY);
    }
    bar.finish_and_clear();
    Some((global, start.elapsed().as_secs_f64()))
}

const VERDICTS: [&str; 5] = ["inside", "boundary", "not_unique", "beyond", "undecided"];
const FEATURES: [&str; 9] = [
    "no_feature",
    "feature_1",
    "feature_2",
    "feature_3",
    "feature_4",
    "feature_5",
    "feature_6",
    "feature_7",
    "feature_8",
];
const EFFORTS: [&str; 4] = ["boxes", "boxes_most", "steps", "steps_most"];
const COLD: [&str; 10] = [
    "cold_inside",
    "cold_outside",
    "cold_not_converged",
    "cold_not_unique",
    "cold_degenerate",
    "cold_answers",
    "cold_iterations",
    "cold_iterations_most",
    "cold_at_most_3",
    "cold_elsewhere",
];
const WARM: [&str; 9] = [
    "warm_inside",
    "warm_outside",
    "warm_not_converged",
    "warm_not_unique",
    "warm_degenerate",
    "warm_answers",
    "warm_iterations",
    "warm_iterations_most",
    "warm_at_most_3",
];

/// Names and values of the CSV.
fn columns(global: &Global) -> Vec<(&'static str, String)> {
    let (boxes, steps) = (&global.boxes, &global.steps);
    let efforts = [boxes.sum, boxes.most, steps.sum, steps.most];
    let local = |local: &Local| {
        let Effort {
            count,
            sum,
            most,
            few,
        } = local.iterations;
        let mut counters = local.outcomes.to_vec();
        counters.extend([count, sum, most, few, local.elsewhere]);
        counters
    };
    let judged = [global.finding.tried, global.finding.failed];
    let blocks: [(&[&'static str], Vec<u64>); 6] = [
        (&VERDICTS, global.verdicts.to_vec()),
        (&FEATURES, global.features.to_vec()),
        (&EFFORTS, efforts.to_vec()),
        (&COLD, local(&global.cold)),
        (&WARM, local(&global.warm)),
        (&["judged", "wrong"], judged.to_vec()),
    ];
    let columns = blocks.into_iter().flat_map(|(names, counters)| {
        let values = counters.into_iter().map(|counter| counter.to_string());
        names.iter().copied().zip(values)
    });
    columns.collect()
}

/// Work of the three projections.
fn efforts(rows: &[(&str, Global)]) -> Table {
    let mut table = table(&[
        "element", "points", "boxes", "most", "steps", "most", "cold", "most", "warm", "most",
        "≤ 3", "judged", "wrong",
    ]);
    for (name, global) in rows {
        let pair = |effort: &Effort| [format!("{:.2}", effort.mean()), effort.most.to_string()];
        let warm = &global.warm.iterations;
        let mut row = vec![(*name).to_string(), global.boxes.count.to_string()];
        row.extend(pair(&global.boxes));
        row.extend(pair(&global.steps));
        row.extend(pair(&global.cold.iterations));
        row.extend(pair(warm));
        row.push(percent(warm.few, warm.count));
        row.extend([global.finding.tried, global.finding.failed].map(|n| n.to_string()));
        table.add_row(row.into_iter().map(Cell::new));
    }
    aligned(table)
}

/// Outcomes.
fn outcomes(rows: &[(&str, Global)]) -> Table {
    let mut table = table(&[
        "element",
        "inside",
        "edge",
        "vertex",
        "not unique",
        "undecided",
        "cold: inside",
        "elsewhere",
        "outside",
        "no answer",
        "warm: inside",
        "outside",
        "no answer",
    ]);
    for (name, global) in rows {
        let [inside, _, not_unique, _, undecided] = global.verdicts;
        let edges: u64 = global.features[1..5].iter().sum();
        let vertices: u64 = global.features[5..].iter().sum();
        let none = |local: &Local| local.outcomes[2..].iter().sum::<u64>();
        let (cold, warm) = (&global.cold, &global.warm);
        let values = [
            inside,
            edges,
            vertices,
            not_unique,
            undecided,
            cold.outcomes[0],
            cold.elsewhere,
            cold.outcomes[1],
            none(cold),
            warm.outcomes[0],
            warm.outcomes[1],
            none(warm),
        ];
        let cells = values.iter().map(u64::to_string);
        table.add_row([(*name).to_string()].into_iter().chain(cells));
    }
    aligned(table)
}

fn percent(part: u64, whole: u64) -> String {
    format!("{:.1} %", 100.0 * part as f64 / whole.max(1) as f64)
}

fn table(columns: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::ASCII_MARKDOWN);
    table.set_header(columns);
    table
}

fn aligned(mut table: Table) -> Table {
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

#[cfg(test)]
mod tests;
