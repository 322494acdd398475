//! What remains of a run: tables on the terminal, CSV, SVG, and one page with all of it.

mod diagram;
mod page;

use std::path::Path;

use comfy_table::{Table, presets};

use crate::Failure;
use crate::timing::Spread;

pub use diagram::{Chart, Series};

/// A table with its diagrams.
#[derive(Clone, Debug)]
pub struct Section {
    /// Name of the files.
    pub name: String,
    /// Title.
    pub title: String,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    notes: Vec<String>,
    charts: Vec<Chart>,
}

impl Section {
    /// An empty table.
    pub fn new(name: &str, title: &str, head: &[&str]) -> Self {
        Self {
            name: name.into(),
            title: title.into(),
            head: head.iter().map(ToString::to_string).collect(),
            rows: vec![],
            notes: vec![],
            charts: vec![],
        }
    }

    /// Adds a row.
    pub fn row(&mut self, row: Vec<String>) {
        self.rows.push(row);
    }

    /// Adds a remark.
    pub fn note(&mut self, note: &str) {
        self.notes.push(note.into());
    }

    /// Adds a diagram.
    pub fn chart(&mut self, chart: Chart) {
        self.charts.push(chart);
    }

    /// The table as text.
    pub fn table(&self) -> Table {
        let mut table = Table::new();
        table.load_style(presets::ASCII_MARKDOWN);
        table.set_header(&self.head);
        for row in &self.rows {
            table.add_row(row);
        }
        table
    }

    fn write(&self, folder: &Path) -> Result<(), Failure> {
        let mut file = csv::Writer::from_path(folder.join(format!("{}.csv", self.name)))?;
        file.write_record(&self.head)?;
        for row in &self.rows {
            file.write_record(row)?;
        }
        file.flush()?;
        for chart in &self.charts {
            diagram::draw(chart, folder)?;
        }
        Ok(())
    }
}

/// Writes everything into a folder.
///
/// # Errors
/// Where something cannot be written or drawn.
pub fn write(sections: &[Section], about: &str, folder: &Path) -> Result<(), Failure> {
    for section in sections {
        section.write(folder)?;
    }
    page::write(&folder.join("index.html"), sections, about, folder)
}

/// Median, and the quartiles as a range.
pub fn spread(spread: Spread) -> [String; 2] {
    let [low, high] = [spread.low, spread.high].map(number);
    [number(spread.median), format!("{low}–{high}")]
}

/// Three digits.
pub fn number(value: f64) -> String {
    match value.abs() {
        0.0..10.0 => format!("{value:.2}"),
        10.0..100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
