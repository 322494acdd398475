//! Single tokens: names, numbers, keywords, brackets, and the mistake that something else stands there.

use proc_macro2::{Delimiter, Literal, Span, TokenTree};
use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use crate::diagnostics::syntax as messages;

/// The mistake that something else stands at the next token.
pub(super) fn expected(input: ParseStream<'_>, what: &str, hint: &str) -> syn::Error {
    messages::expected(what, &describe(input), hint).at(input.span())
}

/// What `read` makes of the inside of brackets.
///
/// After a mistake the rest is taken out, because `syn` reports what nobody took.
pub(super) fn inside<T>(
    content: ParseStream<'_>,
    read: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    let result = read(content);
    while content.parse::<TokenTree>().is_ok() {}
    result
}

/// The next token, for messages.
pub(super) fn describe(input: ParseStream<'_>) -> String {
    match input.fork().parse::<TokenTree>() {
        Ok(TokenTree::Group(group)) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_string(),
            Delimiter::Bracket => "`[`".to_string(),
            Delimiter::Brace => "`{`".to_string(),
            Delimiter::None => format!("`{group}`"),
        },
        Ok(token) => format!("`{token}`"),
        Err(_) => "the end".to_string(),
    }
}

/// Takes the word if it comes next.
pub(super) fn keyword(input: ParseStream<'_>, word: &str) -> Option<Ident> {
    let next = input.fork().call(Ident::parse_any).ok()?;
    if next == word {
        input.call(Ident::parse_any).ok()
    } else {
        None
    }
}

/// One name.
pub(super) fn name(input: ParseStream<'_>) -> syn::Result<Ident> {
    match input.peek(Ident) {
        true => input.parse(),
        false => Err(expected(
            input,
            "a name",
            "names are made of letters, digits and `_`; words of Rust are taken",
        )),
    }
}

/// A decimal number without sign.
pub(super) fn number(input: ParseStream<'_>) -> syn::Result<(f64, Span)> {
    let literal: Literal = input.parse()?;
    let text = literal.to_string();
    match text.replace('_', "").parse::<f64>() {
        Ok(value) if value.is_finite() => Ok((value, literal.span())),
        _ => Err(messages::bad_number(&text).at(literal.span())),
    }
}
