//! The page of one element: declaration, terms with their mutants, errors, operations.

use maud::{Markup, html};

use super::plot::{self, PlotError};
use super::quotes::Quotes;
use super::{formula, frame};
use crate::certificate::ElementCertificate;
use crate::proof::Finding;
use crate::proof::mutation::TermResult;

/// The page.
pub(super) fn page(element: &ElementCertificate, quotes: &Quotes) -> Result<Markup, PlotError> {
    let plots = plots(element)?;
    let body = html! {
        p { a href="../certificate.html" { "All elements" } }
        h1 { (element.name) " " (frame::verdict(element.failed())) }
        @if let Some(text) = quotes.declarations.get(&element.name) {
            h2 { "Declaration" }
            pre { code { (text) } }
        }
        p {
            (element.unknowns) " unknowns, " (element.operations) " operations per contact point"
            @if element.source_bytes > 0 {
                ", " a href=(format!("../generated/{}.rs", element.name)) { "emitted source" }
                " of " (element.source_bytes.div_ceil(1000)) " kB"
            }
        }
        @for failure in element.failures() { p.bad { (failure) } }
        h2 { "Terms of the linearisation" }
        (terms(element, quotes))
        h2 { "Random states" }
        (states(element))
        h2 { "Errors" }
        div.plots { (plots) }
        h2 { "Other evidence" }
        (evidence(element))
        h2 { "Operations" }
        (operations(element))
    };
    Ok(frame::page(&element.name, body))
}

fn terms(element: &ElementCertificate, quotes: &Quotes) -> Markup {
    html! {
        table {
            thead { tr {
                th { "term" } th { "equation" } th { "page of the theory" } th { "program" } th.number { "mutants" }
                th { "left out because" }
            } }
            tbody { @for term in &element.mutants.terms { (row_of_term(term, quotes)) } }
        }
        p { "A mutant drops, doubles or flips the term. Killed: the comparison noticed it." }
    }
}

fn row_of_term(term: &TermResult, quotes: &Quotes) -> Markup {
    let equation = quotes.equations.get(term.tag);
    html! {
        tr.muted[term.left_out.is_some()] {
            td { code { (term.tag) } }
            td { @if let Some(equation) = equation { (formula::markup(&equation.text)) } }
            td { @if let Some(equation) = equation { (equation.page) } }
            td { code { (term.program) } }
            td.number { @if term.made > 0 { (term.killed) " of " (term.made) " killed" } }
            td { @if let Some(reason) = term.left_out { (reason) } }
        }
    }
}

fn states(element: &ElementCertificate) -> Markup {
    html! {
        table {
            thead { tr {
                th { "built to be" } th.number { "states" } th.number { "failed" } th.number { "error of R" }
                th.number { "error of K" } th.number { "error of the energy" } th.number { "error of points" }
                th { "worst state of R, K" }
            } }
            tbody { @for (status, random) in element.random.iter() {
                tr {
                    td { (status) }
                    td.number { (random.finding.tried) }
                    td.number { (random.finding.failed) }
                    @for worst in [&random.residual, &random.tangent, &random.energy, &random.points] {
                        td.number { (format!("{:.1e}", worst.error)) }
                    }
                    td { (random.residual.state) ", " (random.tangent.state) }
                }
            } }
        }
    }
}

/// Distribution of the errors, and the largest error against the number of states, of every status with load.
fn plots(element: &ElementCertificate) -> Result<Markup, PlotError> {
    let mut plots = Vec::new();
    for (status, random) in element.random.iter() {
        if random.residuals.is_empty() {
            continue;
        }
        plots.push(plot::distribution(
            status,
            &random.residuals,
            &random.tangents,
        )?);
    }
    Ok(html! { @for plot in plots { (plot) } })
}

fn evidence(element: &ElementCertificate) -> Markup {
    let optional = [
        (
            "sequences of steps",
            element.sequences.as_ref().map(|found| &found.finding),
        ),
        (
            "global projections",
            element.global.as_ref().map(|found| &found.finding),
        ),
        ("side of edges", element.sides.as_ref()),
        (
            "error orders of tangent_plane",
            element.slopes.as_ref().map(|found| &found.finding),
        ),
    ];
    let always = [
        (
            "symmetry, balance, rigid motion, units",
            Some(&element.invariance.finding),
        ),
        (
            "tables against the compiled element",
            Some(&element.mutants.unchanged),
        ),
    ];
    let row = |(name, finding): (&'static str, Option<&Finding>)| {
        let finding = finding?;
        let passed = finding.tried - finding.failed;
        Some(html! { tr { td { (name) } td { (passed) " of " (finding.tried) } } })
    };
    html! {
        table { @for row in always.into_iter().chain(optional).filter_map(row) { (row) } }
    }
}

fn operations(element: &ElementCertificate) -> Markup {
    html! {
        table {
            thead { tr { th { "of" } th { "program" } th.number { "operations of one call" } } }
            tbody { @for cost in &element.programs {
                tr {
                    td { (cost.owner) }
                    td { code { (cost.program) } }
                    td.number { (cost.operations) }
                }
            } }
        }
    }
}
