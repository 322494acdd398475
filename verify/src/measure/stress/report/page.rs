//! `index.html`: the table of verdicts and every diagram.

use std::fmt::Write as _;
use std::path::Path;

use super::summary::Summary;
use super::table;
use crate::measure::stress::Outcome;

const STYLE: &str = "body{font-family:sans-serif;margin:2em}td,th{padding:.2em .7em;text-align:left;\
border-bottom:1px solid #ccc}.FAIL{color:#b00;font-weight:bold}li{color:#b00}";

/// Writes the page.
pub fn write(path: &Path, outcomes: &[Outcome], summaries: &[Summary]) -> std::io::Result<()> {
    let mut html = String::from("<!doctype html><meta charset=\"utf-8\"><title>Stress</title>");
    let mut put = |text: String| {
        html.push_str(&text);
        html.push('\n');
    };
    put(format!(
        "<style>{STYLE}</style><h1>Numerical stability</h1>"
    ));
    put(format!(
        "<table><tr>{}</tr>",
        cells("th", &table::HEAD.map(String::from))
    ));
    for summary in summaries {
        let class = if summary.passed() { "PASS" } else { "FAIL" };
        put(format!(
            "<tr class={class}>{}</tr>",
            cells("td", &table::row(summary))
        ));
    }
    put("</table>".into());
    for (outcome, summary) in outcomes.iter().zip(summaries) {
        let name = outcome.sweep.name;
        put(format!(
            "<h2 id=\"{name}\">{}</h2>",
            escaped(outcome.sweep.parameter)
        ));
        put(format!(
            "<img src=\"{name}.svg\" alt=\"{name}\"><p><a href=\"{name}.csv\">{name}.csv</a></p>"
        ));
        if !summary.passed() {
            let items = summary
                .failures
                .iter()
                .map(|text| format!("<li>{}</li>", escaped(text)));
            put(format!("<ul>{}</ul>", items.collect::<String>()));
        }
    }
    std::fs::write(path, html)
}

fn cells(tag: &str, values: &[String]) -> String {
    values.iter().fold(String::new(), |mut row, value| {
        // writing to a string cannot fail
        let _ = write!(row, "<{tag}>{}</{tag}>", escaped(value));
        row
    })
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
