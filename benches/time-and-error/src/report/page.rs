//! `index.html`: all tables, the diagrams inside.

use std::path::Path;

use super::Section;
use crate::Failure;

const STYLE: &str = "body{font-family:sans-serif;margin:2em}td,th{padding:.2em .7em;text-align:right;\
border-bottom:1px solid #ccc}td:first-child,th:first-child{text-align:left}";

/// Writes the page; the diagrams are in `folder` already.
pub fn write(path: &Path, sections: &[Section], about: &str, folder: &Path) -> Result<(), Failure> {
    let mut html = format!(
        "<!doctype html><meta charset=\"utf-8\"><title>Benchmarks</title><style>{STYLE}</style>\n\
         <h1>Run time and error</h1><p>{}</p>\n",
        escaped(about)
    );
    for section in sections {
        let name = &section.name;
        html += &format!("<h2 id=\"{name}\">{}</h2>\n", escaped(&section.title));
        for chart in &section.charts {
            html += &std::fs::read_to_string(folder.join(format!("{}.svg", chart.name)))?;
        }
        html += &format!("<table>\n{}", row("th", &section.head));
        for cells in &section.rows {
            html += &row("td", cells);
        }
        html += "</table>\n";
        for note in &section.notes {
            html += &format!("<p>{}</p>\n", escaped(note));
        }
        html += &format!("<p><a href=\"{name}.csv\">{name}.csv</a></p>\n");
    }
    std::fs::write(path, html)?;
    Ok(())
}

fn row(tag: &str, cells: &[String]) -> String {
    let cell = |text: &String| format!("<{tag}>{}</{tag}>", escaped(text));
    format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>())
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
