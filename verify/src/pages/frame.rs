//! What all pages share: head, style, verdicts.

use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = "
:root { color-scheme: light dark; --line: #8886; --soft: #8881; --bad: #c22; --good: #173; }
@media (prefers-color-scheme: dark) { :root { --good: #6c8; --bad: #f77; } svg.plot { filter: invert(0.88) hue-rotate(180deg); } }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; padding: 0 1.5rem; max-width: 80rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
table { border-collapse: collapse; } th, td { padding: .2rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
thead th { position: sticky; top: 0; background: Canvas; } tbody tr:hover { background: var(--soft); }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
th button { all: unset; cursor: pointer; font-weight: 600; } th button:focus-visible { outline: 2px solid; }
th[aria-sort=ascending] button::after { content: ' \u{25b4}'; } th[aria-sort=descending] button::after { content: ' \u{25be}'; }
pre { background: var(--soft); padding: .8rem 1rem; overflow-x: auto; } code { font-family: ui-monospace, monospace; font-size: .92em; } td code { white-space: nowrap; }
.bad { color: var(--bad); font-weight: 600; } .good { color: var(--good); } .muted { opacity: .65; }
.plots { display: flex; flex-wrap: wrap; gap: 1.5rem; } figure { margin: 0; } figcaption { font-size: .9em; }
input { font: inherit; padding: .2rem .5rem; margin: .6rem 0; min-width: 18rem; }
";

/// A page.
pub(super) fn page(title: &str, body: Markup) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body { (body) }
        }
    }
}

/// `0` in green, other numbers of failures in red.
pub(super) fn verdict(failed: u64) -> Markup {
    html! {
        @if failed == 0 { span.good { "proven" } } @else { span.bad { (failed) " failed" } }
    }
}
