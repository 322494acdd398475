//! `certificate.html`: the result in numbers, and a table of all elements that sorts and filters.

use maud::{Markup, PreEscaped, html};

use super::frame;
use super::plot::{self, PlotError};
use crate::certificate::{Certificate, ElementCertificate};
use crate::proof::Finding;

/// Folder of the pages of elements.
pub(super) const ELEMENTS: &str = "certificate";

/// Sorts by the column whose head is pressed, and shows the rows whose name contains the text of the field.
const SCRIPT: &str = "
const table = document.getElementById('elements');
const body = table.tBodies[0];
const value = (row, column) => row.cells[column].dataset.value ?? row.cells[column].textContent;
table.querySelectorAll('th button').forEach((button, column) => button.addEventListener('click', () => {
  const head = button.parentElement;
  const down = head.getAttribute('aria-sort') === 'ascending';
  table.querySelectorAll('th').forEach(other => other.removeAttribute('aria-sort'));
  head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  const numeric = head.classList.contains('number');
  const compare = (a, b) => numeric ? Number(value(a, column)) - Number(value(b, column))
                                    : value(a, column).localeCompare(value(b, column));
  const rows = [...body.rows].sort((a, b) => down ? compare(b, a) : compare(a, b));
  body.append(...rows);
}));
document.getElementById('filter').addEventListener('input', event => {
  const text = event.target.value.toLowerCase();
  for (const row of body.rows) row.hidden = !row.cells[0].textContent.toLowerCase().includes(text);
});
";

/// The page.
pub(super) fn page(certificate: &Certificate) -> Result<Markup, PlotError> {
    let growth = plot::growth(&certificate.growth())?;
    let body = html! {
        h1 { "Certificate of the contact elements " (certificate.version) }
        (summary(certificate))
        h2 { "Elements" }
        input #filter type="search" placeholder="part of a name" aria-label="part of a name";
        (elements(certificate))
        h2 { "Largest errors and the number of states" }
        div.plots { (growth) }
        h2 { "Time" }
        table {
            @for stage in &certificate.stages {
                tr { td { (stage.name) } td.number { (format!("{:.1} s", stage.seconds)) } }
            }
        }
        script { (PreEscaped(SCRIPT)) }
    };
    Ok(frame::page("Certificate of the contact elements", body))
}

fn summary(certificate: &Certificate) -> Markup {
    let (killed, made) = certificate.mutants();
    let (residual, tangent) = certificate.worst();
    let states: u64 = certificate
        .elements
        .iter()
        .map(ElementCertificate::states)
        .sum();
    let whole = ["tables", "edge cases", "reference cases", "branches seen"];
    html! {
        table {
            tr { td { "verdict" } td { (frame::verdict(certificate.failed())) } }
            tr { td { "elements" } td { (certificate.elements.len()) } }
            tr { td { "random states" } td {
                (states) " (" (certificate.states) " per element and status and the hardest, seed " (certificate.seed) ")"
            } }
            tr { td { "largest relative error" } td {
                "residual " (format!("{residual:.1e}")) ", tangent " (format!("{tangent:.1e}"))
            } }
            tr { td { "mutants noticed" } td { (killed) " of " (made) } }
            @for (name, finding) in whole.into_iter().zip(certificate.whole()) {
                tr { td { (name) } td { (share(finding)) } }
            }
        }
        @for failure in certificate.whole().into_iter().flat_map(|finding| &finding.failures) {
            p.bad { (failure) }
        }
    }
}

fn share(finding: &Finding) -> Markup {
    html! {
        @if finding.tried == 0 { "not judged" } @else { (finding.tried - finding.failed) " of " (finding.tried) }
    }
}

fn elements(certificate: &Certificate) -> Markup {
    let heads = [
        ("element", false),
        ("unknowns", true),
        ("operations", true),
        ("source kB", true),
        ("states", true),
        ("error of R", true),
        ("error of K", true),
        ("mutants", true),
        ("terms left out", true),
        ("verdict", false),
    ];
    html! {
        table #elements {
            thead { tr {
                @for (head, is_number) in heads {
                    th.number[is_number] scope="col" { button type="button" { (head) } }
                }
            } }
            tbody { @for element in &certificate.elements { (row(element)) } }
        }
    }
}

fn row(element: &ElementCertificate) -> Markup {
    let (residual, tangent, _) = element.worst();
    let mutants = &element.mutants;
    let numbers = [
        (element.unknowns as f64, element.unknowns.to_string()),
        (element.operations as f64, element.operations.to_string()),
        (
            element.source_bytes as f64,
            element.source_bytes.div_ceil(1000).to_string(),
        ),
        (element.states() as f64, element.states().to_string()),
        (residual, format!("{residual:.1e}")),
        (tangent, element.tangent_error()),
        (
            mutants.killed as f64,
            format!("{}/{}", mutants.killed, mutants.made),
        ),
    ];
    html! {
        tr {
            td { a href=(format!("{}/{}.html", ELEMENTS, element.name)) { (element.name) } }
            @for (value, text) in numbers { td.number data-value=(value) { (text) } }
            td.number { (mutants.left_out().count()) }
            td { (frame::verdict(element.failed())) }
        }
    }
}
