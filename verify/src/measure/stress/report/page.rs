//! `index.html`: the table of verdicts and every diagram.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::summary::Summary;
use super::table;
use crate::measure::stress::Outcome;

const STYLE: &str = "body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}\
td,th{padding:.2em .7em;text-align:left;border-bottom:1px solid #ccc}.FAIL,li{color:#b00}.FAIL{font-weight:bold}";

/// Writes the page.
pub fn write(path: &Path, outcomes: &[Outcome], summaries: &[Summary]) -> std::io::Result<()> {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { "Numerical stability" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "Numerical stability" }
                (verdicts(summaries))
                @for (outcome, summary) in outcomes.iter().zip(summaries) { (sweep(outcome, summary)) }
            }
        }
    };
    std::fs::write(path, page.into_string())
}

fn verdicts(summaries: &[Summary]) -> Markup {
    html! {
        table {
            thead { tr { @for head in table::HEAD { th { (head) } } } }
            tbody {
                @for summary in summaries {
                    tr class=(if summary.passed() { "PASS" } else { "FAIL" }) {
                        @for cell in table::row(summary) { td { (cell) } }
                    }
                }
            }
        }
    }
}

fn sweep(outcome: &Outcome, summary: &Summary) -> Markup {
    let name = outcome.sweep.name;
    html! {
        h2 id=(name) { (outcome.sweep.parameter) }
        img src=(format!("{name}.svg")) alt=(name);
        p { a href=(format!("{name}.csv")) { (name) ".csv" } }
        @if !summary.passed() {
            ul { @for failure in &summary.failures { li { (failure) } } }
        }
    }
}
