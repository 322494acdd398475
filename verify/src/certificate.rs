//! The result: a table for people, JSON for machines.

use comfy_table::{Cell, CellAlignment, Table, presets};
use serde::Serialize;

use crate::proof::Finding;
use crate::proof::global::Global;
use crate::proof::invariance::Invariance;
use crate::proof::mutation::Mutants;
use crate::proof::random::Random;
use crate::proof::reference::CaseResult;
use crate::proof::sequences::Sequences;
use crate::proof::slopes::Slopes;

/// What was proven of one element.
#[derive(Clone, Debug, Serialize)]
pub struct ElementCertificate {
    /// Name.
    pub name: String,
    /// Unknowns of a call.
    pub unknowns: usize,
    /// Arithmetic operations of the point programs.
    pub operations: usize,
    /// Bytes of the emitted Rust source.
    pub source_bytes: usize,
    /// Random states built to be closed; without friction.
    pub closed: Option<Random>,
    /// Random states built to stick; with friction.
    pub stick: Option<Random>,
    /// Random states built to slip; with friction and a bound.
    pub slip: Option<Random>,
    /// Random states built to be open.
    pub open: Option<Random>,
    /// Random states built to lie outside; empty where there is no boundary.
    pub outside: Option<Random>,
    /// Sequences of steps; with friction.
    pub sequences: Option<Sequences>,
    /// Symmetry, balance, motion, units.
    pub invariance: Invariance,
    /// Global projection, where something is projected.
    pub global: Option<Global>,
    /// The side of edges.
    pub sides: Option<Finding>,
    /// Error orders of tangent-plane elements.
    pub slopes: Option<Slopes>,
    /// Mutation of the terms.
    pub mutants: Mutants,
}

impl ElementCertificate {
    /// Random states by the status they were built for.
    pub fn random(&self) -> impl Iterator<Item = (&'static str, &Random)> {
        let all = [
            ("closed", &self.closed),
            ("stick", &self.stick),
            ("slip", &self.slip),
            ("open", &self.open),
            ("outside", &self.outside),
        ];
        all.into_iter()
            .filter_map(|(what, random)| Some((what, random.as_ref()?)))
    }

    /// What was found beside the random states.
    fn others(&self) -> impl Iterator<Item = &Finding> {
        let slopes = self.slopes.as_ref().map(|slopes| &slopes.finding);
        let sequences = self.sequences.as_ref().map(|s| &s.finding);
        let always = [&self.invariance.finding, &self.mutants.unchanged];
        let global = self.global.as_ref().map(|global| &global.finding);
        let optional = slopes
            .into_iter()
            .chain(sequences)
            .chain(global)
            .chain(&self.sides);
        optional.chain(always)
    }

    /// Failures of all kinds.
    pub fn failed(&self) -> u64 {
        let random: u64 = self.random().map(|(_, r)| r.finding.failed).sum();
        let others: u64 = self.others().map(|finding| finding.failed).sum();
        random + others + self.mutants.survivors.len() as u64
    }

    fn failures(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.mutants.survivors.clone();
        for (what, random) in self.random() {
            let failures = random.finding.failures.iter();
            lines.extend(failures.map(|failure| format!("{what}: {failure}")));
        }
        lines.extend(self.others().flat_map(|finding| finding.failures.clone()));
        lines
    }

    fn states(&self) -> u64 {
        self.random().map(|(_, r)| r.finding.tried).sum()
    }

    /// Random states with load, and those built to lie outside, some points of which carry load too.
    fn loaded(&self) -> impl Iterator<Item = (&'static str, &Random)> {
        self.random().filter(|(what, _)| *what != "open")
    }

    /// Largest error of residual, tangent and energy over all states with load.
    pub fn worst(&self) -> (f64, f64, f64) {
        let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
        for (_, random) in self.loaded() {
            worst.0 = worst.0.max(random.residual.error);
            worst.1 = worst.1.max(random.tangent.error);
            worst.2 = worst.2.max(random.energy.error);
        }
        worst
    }

    /// Status and number of the state with the largest error of residual or tangent.
    fn worst_state(&self) -> String {
        let errors = self
            .loaded()
            .flat_map(|(what, random)| [(what, &random.residual), (what, &random.tangent)]);
        let worst = errors.max_by(|a, b| a.1.error.total_cmp(&b.1.error));
        worst.map_or(String::new(), |(what, worst)| {
            format!("{what} {}", worst.state)
        })
    }
}

/// The whole certificate.
#[derive(Clone, Debug, Serialize)]
pub struct Certificate {
    /// Version of the library.
    pub version: &'static str,
    /// Seed of the states.
    pub seed: u64,
    /// States per element and status.
    pub states: u64,
    /// One entry per element.
    pub elements: Vec<ElementCertificate>,
    /// Tables against emitted code and duals.
    pub tables: Finding,
    /// Edge cases.
    pub edges: Finding,
    /// Reference cases.
    pub reference: Finding,
    /// Reference cases, each.
    pub reference_cases: Vec<CaseResult>,
    /// Statuses, features, return codes.
    pub coverage: Finding,
}

impl Certificate {
    /// Failures of all kinds.
    pub fn failed(&self) -> u64 {
        let elements: u64 = self.elements.iter().map(ElementCertificate::failed).sum();
        let whole = [&self.tables, &self.edges, &self.reference, &self.coverage];
        elements + whole.iter().map(|finding| finding.failed).sum::<u64>()
    }

    /// The certificate as text.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}\n\n", self.table());
        text.push_str(&self.summary());
        for element in &self.elements {
            for failure in element.failures() {
                text.push_str(&format!("FAILED {}: {failure}\n", element.name));
            }
        }
        for finding in [&self.tables, &self.edges, &self.reference, &self.coverage] {
            for failure in &finding.failures {
                text.push_str(&format!("FAILED {failure}\n"));
            }
        }
        text
    }

    fn table(&self) -> Table {
        let mut table = Table::new();
        table.load_style(presets::ASCII_MARKDOWN);
        table.set_header([
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
        ]);
        for element in &self.elements {
            table.add_row(row(element));
        }
        for index in 1..9 {
            if let Some(column) = table.column_mut(index) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        table
    }

    fn summary(&self) -> String {
        let made: u64 = self.elements.iter().map(|e| e.mutants.made).sum();
        let killed: u64 = self.elements.iter().map(|e| e.mutants.killed).sum();
        let states: u64 = self.elements.iter().map(ElementCertificate::states).sum();
        let (mut r, mut k) = (0.0_f64, 0.0_f64);
        for element in &self.elements {
            let worst = element.worst();
            (r, k) = (r.max(worst.0), k.max(worst.1));
        }
        let share =
            |finding: &Finding| format!("{} of {}", finding.tried - finding.failed, finding.tried);
        let mut text = format!(
            "{} elements, {states} random states ({} per element and status, seed {})\n\
             largest relative error: residual {r:.1e}, tangent {k:.1e}\n\
             mutants noticed: {killed} of {made}\n\
             tables against emitted code and duals: {}\nedge cases: {}\n\
             reference cases within {} spreads or {:.0e}: {}\nbranches of the interface and kernels: {}\n",
            self.elements.len(),
            self.states,
            self.seed,
            share(&self.tables),
            share(&self.edges),
            crate::tolerance::REFERENCE_SPREADS,
            crate::tolerance::REFERENCE,
            share(&self.reference),
            share(&self.coverage),
        );
        text.push_str(&self.sequence_line());
        for element in &self.elements {
            if let Some(slopes) = &element.slopes {
                text.push_str(&slope_line(&element.name, slopes));
            }
        }
        let verdict = match self.failed() {
            0 => "PROVEN: every comparison within its tolerance".to_string(),
            n => format!("NOT PROVEN: {n} comparisons failed"),
        };
        text.push_str(&format!("{verdict}\n"));
        text
    }
}

impl Certificate {
    fn sequence_line(&self) -> String {
        let found = || self.elements.iter().filter_map(|e| e.sequences.as_ref());
        let steps: u64 = found().map(|s| s.finding.tried).sum();
        let failed: u64 = found().map(|s| s.finding.failed).sum();
        let worst = found().map(|s| s.worst.error).fold(0.0, f64::max);
        format!(
            "steps of frictional sequences: {} of {steps}, largest error {worst:.1e}\n",
            steps - failed
        )
    }
}

fn row(element: &ElementCertificate) -> Vec<Cell> {
    let (residual, tangent, _) = element.worst();
    let has_tangent = element.slopes.is_none() && !element.name.ends_with("Residual");
    let left_out: Vec<&str> = element
        .mutants
        .left_out
        .iter()
        .map(|(tag, _)| tag.as_str())
        .collect();
    let tangent = match (&element.slopes, has_tangent) {
        (Some(_), _) => "see orders".to_string(),
        (None, true) => format!("{tangent:.1e}"),
        (None, false) => "none".to_string(),
    };
    let verdict = match element.failed() {
        0 => "proven".to_string(),
        n => format!("{n} FAILED"),
    };
    vec![
        Cell::new(&element.name),
        Cell::new(element.unknowns),
        Cell::new(element.operations),
        Cell::new(element.source_bytes.div_ceil(1000)),
        Cell::new(element.states()),
        Cell::new(format!("{residual:.1e}")),
        Cell::new(tangent),
        Cell::new(element.worst_state()),
        Cell::new(format!(
            "{}/{}",
            element.mutants.killed, element.mutants.made
        )),
        Cell::new(left_out.join(" ")),
        Cell::new(verdict),
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
