//! Blocks: statements of geometries and laws, entries of elements.

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::ParseStream;
use syn::{Ident, LitInt, Token, bracketed, parenthesized, token};

use super::expression::{after_operand, list};
use super::head::names;
use super::item::{Body, Comparison, Entry, Expr, Field, Relation, Rule, Statement, Value, Word};
use super::token::{expected, inside, keyword, name};
use crate::diagnostics::Mistakes;

/// Reads the statements of a block; after a mistake it goes on with the next one.
pub(super) fn body(input: ParseStream<'_>, mistakes: &mut Mistakes) -> Body {
    let (statements, complete) = each(input, mistakes, statement);
    Body {
        statements,
        complete,
    }
}

/// Reads the entries of an element; after a mistake it goes on with the next one.
pub(super) fn entries(input: ParseStream<'_>, mistakes: &mut Mistakes) -> (Vec<Entry>, bool) {
    each(input, mistakes, entry)
}

fn each<T>(
    input: ParseStream<'_>,
    mistakes: &mut Mistakes,
    parse: fn(ParseStream<'_>) -> syn::Result<T>,
) -> (Vec<T>, bool) {
    let (mut found, mut complete) = (Vec::new(), true);
    while !input.is_empty() {
        match parse(input).and_then(|item| end(input).map(|()| item)) {
            Ok(item) => found.push(item),
            Err(error) => {
                mistakes.push(error);
                complete = false;
                skip_statement(input);
            }
        }
    }
    (found, complete)
}

/// The semicolon after a statement or entry.
fn end(input: ParseStream<'_>) -> syn::Result<()> {
    match input.peek(Token![;]) {
        true => input.parse::<Token![;]>().map(drop),
        false => Err(expected(
            input,
            "`;`",
            "every statement and every entry ends with `;`",
        )),
    }
}

/// Goes past the next semicolon.
fn skip_statement(input: ParseStream<'_>) {
    while let Ok(token) = input.parse::<TokenTree>() {
        if matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';') {
            return;
        }
    }
}

/// Goes past the end of an item: its block, or a semicolon.
pub(super) fn skip_item(input: ParseStream<'_>) {
    while let Ok(token) = input.parse::<TokenTree>() {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => return,
            TokenTree::Punct(punct) if punct.as_char() == ';' => return,
            _ => {}
        }
    }
}

fn statement(input: ParseStream<'_>) -> syn::Result<Statement> {
    if input.peek(Token![let]) {
        input.parse::<Token![let]>()?;
        let name = name(input)?;
        equals(input)?;
        return Ok(Statement::Let(name, Expr::parse(input)?));
    }
    let name = name(input)?;
    let mut arguments = None;
    if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        arguments = Some(inside(&content, arguments_of)?);
    }
    equals(input)?;
    Ok(Statement::Field(Field {
        name,
        arguments,
        value: value(input)?,
    }))
}

/// The names in the brackets of a field.
fn arguments_of(input: ParseStream<'_>) -> syn::Result<Vec<Ident>> {
    let names = names(input)?;
    match input.is_empty() {
        true => Ok(names),
        false => Err(expected(input, "`,` or `)`", "the arguments are names")),
    }
}

fn equals(input: ParseStream<'_>) -> syn::Result<()> {
    match input.peek(Token![=]) && !input.peek(Token![==]) {
        true => input.parse::<Token![=]>().map(drop),
        false => Err(expected(
            input,
            "`=`",
            "a statement is `let name = value;` or `name = value;`",
        )),
    }
}

fn value(input: ParseStream<'_>) -> syn::Result<Value> {
    if input.peek(token::Bracket) {
        let content;
        bracketed!(content in input);
        return Ok(Value::List(inside(&content, list)?));
    }
    let left = Expr::parse(input)?;
    let relation = if input.peek(Token![<]) {
        input.parse::<Token![<]>()?;
        Relation::Less
    } else if input.peek(Token![>]) {
        input.parse::<Token![>]>()?;
        Relation::Greater
    } else {
        return Ok(Value::Expr(left));
    };
    let right = Expr::parse(input)?;
    if input.peek(Token![<]) || input.peek(Token![>]) {
        return Err(after_operand(input));
    }
    Ok(Value::Comparison(Comparison {
        left,
        relation,
        right,
    }))
}

fn entry(input: ParseStream<'_>) -> syn::Result<Entry> {
    let key = name(input)?;
    if !input.peek(Token![:]) {
        return Err(expected(
            input,
            "`:`",
            "an entry of an element is `key: value;`",
        ));
    }
    input.parse::<Token![:]>()?;
    let word = match input.peek(LitInt) && !input.peek(Token![-]) {
        true => {
            let (value, span) = count(input)?;
            Word::Number(value, span)
        }
        false => Word::Name(name(input)?),
    };
    let rule = match keyword(input, "at") {
        Some(_) => Some(rule(input)?),
        None => None,
    };
    Ok(Entry {
        key,
        word,
        rule,
        placed: keyword(input, "placed"),
    })
}

fn rule(input: ParseStream<'_>) -> syn::Result<Rule> {
    let name = name(input)?;
    let mut points = None;
    if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        points = Some(inside(&content, counts)?);
    }
    Ok(Rule { name, points })
}

/// Whole numbers with commas between them.
fn counts(input: ParseStream<'_>) -> syn::Result<Vec<(usize, Span)>> {
    let mut counts = Vec::new();
    while !input.is_empty() {
        counts.push(count(input)?);
        if input.is_empty() {
            break;
        }
        if !input.peek(Token![,]) {
            return Err(expected(input, "`,`", "write `gauss(n)` or `gauss(n, m)`"));
        }
        input.parse::<Token![,]>()?;
    }
    Ok(counts)
}

/// A whole number.
fn count(input: ParseStream<'_>) -> syn::Result<(usize, Span)> {
    let hint = "write a whole number, such as `2`";
    if !input.peek(LitInt) || input.peek(Token![-]) {
        return Err(expected(input, "a whole number", hint));
    }
    let ahead = input.fork();
    let literal: LitInt = ahead.parse()?;
    if !literal.suffix().is_empty() {
        return Err(expected(input, "a whole number", hint));
    }
    let value = literal
        .base10_parse()
        .map_err(|_| expected(input, "a whole number", hint))?;
    input.parse::<LitInt>()?;
    Ok((value, literal.span()))
}
