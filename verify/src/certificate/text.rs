//! The certificate as text: a short table for the terminal, a table with all columns for the file.

use comfy_table::{CellAlignment, Table, presets};

use super::{Certificate, ElementCertificate};
use crate::proof::Finding;
use crate::proof::slopes::Slopes;
use crate::tolerance::{REFERENCE, REFERENCE_SPREADS};

/// Heads of the columns of the file.
const HEADS: [&str; 11] = [
    "element",
    "unknowns",
    "ops",
    "source kB",
    "states",
    "error R",
    "error K",
    "at state",
    "mutants",
    "terms left out",
    "verdict",
];
/// The columns that the terminal shows too, with short heads.
const SHORT: [(usize, &str); 8] = [
    (0, "element"),
    (1, "dof"),
    (2, "ops"),
    (4, "states"),
    (5, "error R"),
    (6, "error K"),
    (8, "mutants"),
    (10, "verdict"),
];
/// The columns that hold numbers: all but the first and the last two.
const NUMBERS: std::ops::Range<usize> = 1..9;

impl Certificate {
    /// The certificate with all columns.
    pub fn to_text(&self) -> String {
        let mut table = Table::new();
        table.load_style(presets::ASCII_MARKDOWN);
        table.set_header(HEADS);
        for element in &self.elements {
            table.add_row(row(element));
        }
        align(&mut table, NUMBERS);
        let (slopes, summary) = (self.slope_lines(), self.summary());
        format!("{table}\n\n{slopes}\n{summary}{}", self.failures())
    }

    /// What fits on a terminal of 100 columns: the table without sources, states and terms left out.
    pub fn to_short_text(&self) -> String {
        let mut table = Table::new();
        table.load_style(presets::NOTHING);
        table.set_header(SHORT.map(|(_, head)| head));
        for element in &self.elements {
            let row = row(element);
            table.add_row(SHORT.map(|(column, _)| row[column].clone()));
        }
        align(&mut table, 1..SHORT.len() - 1);
        for column in table.column_iter_mut() {
            column.set_padding((0, 1));
        }
        format!("{table}\n\n{}{}", self.summary(), self.failures())
    }

    /// A line for every failure that is listed.
    fn failures(&self) -> String {
        let of_elements = self.elements.iter().flat_map(|element| {
            let lines = element.failures().into_iter();
            lines.map(|failure| format!("FAILED {}: {failure}\n", element.name))
        });
        let of_all = self
            .whole()
            .into_iter()
            .flat_map(|finding| &finding.failures);
        of_elements
            .chain(of_all.map(|failure| format!("FAILED {failure}\n")))
            .collect()
    }

    fn summary(&self) -> String {
        let (killed, made) = self.mutants();
        let states: u64 = self.elements.iter().map(ElementCertificate::states).sum();
        let (r, k) = self.worst();
        let lines = [
            format!("elements                       {}", self.elements.len()),
            format!(
                "random states                  {states} ({} per element and status and the hardest, seed {})",
                self.states, self.seed
            ),
            format!("largest relative error         residual {r:.1e}, tangent {k:.1e}"),
            format!("mutants noticed                {killed} of {made}"),
            format!("steps of frictional sequences  {}", self.sequences()),
            format!("error orders, tangent_plane    {}", self.orders()),
            format!("tables                         {}", share(&self.tables)),
            format!("edge cases                     {}", share(&self.edges)),
            format!(
                "reference cases                {} within {REFERENCE_SPREADS} spreads or {REFERENCE:.0e}",
                share(&self.reference)
            ),
            format!("branches seen                  {}", share(&self.coverage)),
            match self.failed() {
                0 => "PROVEN: every comparison within its tolerance".to_string(),
                n => format!("NOT PROVEN: {n} comparisons failed"),
            },
        ];
        lines.join("\n") + "\n"
    }

    fn sequences(&self) -> String {
        let found = || self.elements.iter().filter_map(|e| e.sequences.as_ref());
        let steps: u64 = found().map(|s| s.finding.tried).sum();
        let failed: u64 = found().map(|s| s.finding.failed).sum();
        let worst = found().map(|s| s.worst.error).fold(0.0, f64::max);
        format!("{} of {steps}, largest error {worst:.1e}", steps - failed)
    }

    fn orders(&self) -> String {
        let found = || self.elements.iter().filter_map(|e| e.slopes.as_ref());
        let right = found().filter(|slopes| slopes.finding.failed == 0).count();
        format!("{right} of {} elements", found().count())
    }

    /// Error orders of every tangent-plane element.
    fn slope_lines(&self) -> String {
        let found = self.elements.iter();
        let found = found.filter_map(|e| Some(slope_line(&e.name, e.slopes.as_ref()?)));
        found.collect()
    }
}

/// Passed of tried.
fn share(finding: &Finding) -> String {
    format!("{} of {}", finding.tried - finding.failed, finding.tried)
}

/// Numbers stand at the right.
fn align(table: &mut Table, columns: std::ops::Range<usize>) {
    for index in columns {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

fn row(element: &ElementCertificate) -> Vec<String> {
    let left_out: Vec<&str> = element.mutants.left_out().collect();
    let verdict = match element.failed() {
        0 => "proven".to_string(),
        n => format!("{n} FAILED"),
    };
    let (killed, made) = (element.mutants.killed, element.mutants.made);
    vec![
        element.name.clone(),
        element.unknowns.to_string(),
        element.operations.to_string(),
        element.source_bytes.div_ceil(1000).to_string(),
        element.states().to_string(),
        format!("{:.1e}", element.worst().0),
        element.tangent_error(),
        element.worst_state(),
        format!("{killed}/{made}"),
        left_out.join(" "),
        verdict,
    ]
}

fn slope_line(name: &str, slopes: &Slopes) -> String {
    let range = |range: Option<(f64, f64)>| match range {
        Some((low, high)) => format!("{low:.3} to {high:.3}"),
        None => "not defined (r0 > 0)".to_string(),
    };
    let mut line = format!(
        "{name}: order of the error in L: D²g {}, whole tangent {}",
        range(slopes.hessian),
        range(slopes.tangent)
    );
    if slopes.friction.is_some() {
        let (tangent, moment) = (range(slopes.friction), range(slopes.moment));
        line.push_str(&format!(
            "; with friction: tangent {tangent}, balance of moment {moment}"
        ));
    }
    line.push('\n');
    line
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::random::RandomStates;
    use crate::subject::built_in;

    /// The widest rows of all built-in elements fit.
    #[test]
    fn the_summary_fits_a_terminal_of_100_columns() {
        let subjects = built_in().unwrap_or_else(|unknown| panic!("{unknown}"));
        let mut certificate = Certificate {
            version: "0",
            seed: 20_150,
            states: 100_000,
            elements: vec![],
            tables: Finding::default(),
            edges: Finding::default(),
            reference: Finding::default(),
            reference_cases: vec![],
            coverage: Finding::default(),
            stages: vec![],
        };
        for subject in &subjects {
            let mut random = RandomStates::default();
            let mut found = crate::proof::random::Random::default();
            found.finding.tried = 400_000;
            found.residual.error = 1.2e-13;
            random.stick = Some(found);
            let mut element = ElementCertificate::new(subject, 359_000, random);
            (element.mutants.killed, element.mutants.made) = (333, 333);
            certificate.elements.push(element);
        }
        let text = certificate.to_short_text();
        assert_eq!(
            text.lines().take_while(|line| !line.is_empty()).count(),
            subjects.len() + 1
        );
        for line in text.lines() {
            assert!(line.chars().count() <= 100, "{line}");
        }
        assert!(certificate.to_text().contains("terms left out"));
    }
}
