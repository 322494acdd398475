//! Text of the documentation with its formulas as MathML, which browsers typeset without a script.

use maud::{Markup, PreEscaped, html};
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// Text in which `` $`…`$ `` is a formula and `` `…` `` is code.
pub(super) fn markup(text: &str) -> Markup {
    html! { @for piece in pieces(text) { (piece.markup()) } }
}

#[derive(Debug, PartialEq, Eq)]
enum Piece<'a> {
    Text(&'a str),
    Code(&'a str),
    Formula(&'a str),
}

impl Piece<'_> {
    fn markup(&self) -> Markup {
        match self {
            Self::Text(text) => html! { (text) },
            Self::Code(text) => html! { code { (text) } },
            Self::Formula(text) => match mathml(text) {
                Some(mathml) => PreEscaped(mathml),
                None => html! { code { (text) } },
            },
        }
    }
}

/// Formulas, code and the text between them.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find('`') {
        let is_formula = rest[..start].ends_with('$');
        let end = if is_formula { "`$" } else { "`" };
        let Some(length) = rest[start + 1..].find(end) else {
            break;
        };
        let inner = &rest[start + 1..start + 1 + length];
        let before = &rest[..start];
        pieces.push(Piece::Text(
            before
                .strip_suffix('$')
                .filter(|_| is_formula)
                .unwrap_or(before),
        ));
        pieces.push(if is_formula {
            Piece::Formula(inner)
        } else {
            Piece::Code(inner)
        });
        rest = &rest[start + 1 + length + end.len()..];
    }
    pieces.push(Piece::Text(rest));
    pieces.retain(|piece| *piece != Piece::Text(""));
    pieces
}

/// A formula as MathML; `None` where it cannot be read.
fn mathml(latex: &str) -> Option<String> {
    let storage = Storage::new();
    let events: Vec<_> = Parser::new(latex, &storage).collect();
    if events.iter().any(Result::is_err) {
        return None;
    }
    let mut text = String::new();
    push_mathml(&mut text, events.into_iter(), RenderConfig::default()).ok()?;
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_and_code_are_told_apart() {
        let expected = [
            Piece::Text("a "),
            Piece::Formula("x_{i}"),
            Piece::Text(", b "),
            Piece::Code("f(x)"),
            Piece::Text("."),
        ];
        assert_eq!(pieces("a $`x_{i}`$, b `f(x)`."), expected);
        assert_eq!(pieces("open ` end"), [Piece::Text("open ` end")]);
    }

    #[test]
    fn formulas_become_mathml() {
        let markup = markup(r"$`-N \alpha_{i} (a^{-1}\kappa m)^{ij} \alpha_{j}`$").into_string();
        assert!(
            markup.starts_with("<math") && markup.contains('κ'),
            "{markup}"
        );
        assert!(mathml(r"\notacommand{x").is_none());
    }
}
