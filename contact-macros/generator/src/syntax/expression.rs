//! Expressions as written.

use proc_macro2::{Delimiter, TokenStream};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Ident, Token, parenthesized, token};

use super::item::{BinaryOperator, Expr};
use super::token::{expected, inside, name, number};
use crate::diagnostics::syntax as messages;

impl Expr {
    /// Reads an expression and makes sure that it ends where an expression may end.
    pub(super) fn parse(input: ParseStream<'_>) -> syn::Result<Expr> {
        let value = sum(input)?;
        let ends = input.is_empty()
            || input.peek(Token![;])
            || input.peek(Token![,])
            || (input.peek(Token![<]) && !input.peek(Token![<=]))
            || (input.peek(Token![>]) && !input.peek(Token![>=]));
        if ends {
            Ok(value)
        } else {
            Err(after_operand(input))
        }
    }
}

/// The mistake of something that follows an operand.
pub(super) fn after_operand(input: ParseStream<'_>) -> syn::Error {
    let operators = [
        "<=", ">=", "==", "^", ".", "<", ">", "=", "&", "|", "?", "%", "!",
    ];
    let text = input.fork().to_string().replace(' ', "");
    match operators
        .into_iter()
        .find(|operator| text.starts_with(operator))
    {
        Some(operator) => messages::unknown_operator(operator).at(input.span()),
        None => expected(
            input,
            "an operator or `;`",
            "a product is written `a*b`; a statement ends with `;`",
        ),
    }
}

fn sum(input: ParseStream<'_>) -> syn::Result<Expr> {
    let mut left = product(input)?;
    loop {
        let operator = if input.peek(Token![+]) {
            input.parse::<Token![+]>()?;
            BinaryOperator::Add
        } else if input.peek(Token![-]) {
            input.parse::<Token![-]>()?;
            BinaryOperator::Subtract
        } else {
            return Ok(left);
        };
        left = Expr::Binary(operator, Box::new(left), Box::new(product(input)?));
    }
}

fn product(input: ParseStream<'_>) -> syn::Result<Expr> {
    let mut left = signed(input)?;
    loop {
        let operator = if input.peek(Token![*]) {
            let star = input.parse::<Token![*]>()?;
            if input.peek(Token![*]) {
                return Err(messages::unknown_operator("**").at(star.span));
            }
            BinaryOperator::Multiply
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            BinaryOperator::Divide
        } else {
            return Ok(left);
        };
        left = Expr::Binary(operator, Box::new(left), Box::new(signed(input)?));
    }
}

fn signed(input: ParseStream<'_>) -> syn::Result<Expr> {
    if input.peek(Token![-]) {
        let minus = input.parse::<Token![-]>()?;
        return Ok(Expr::Negate(Box::new(signed(input)?), minus.span));
    }
    operand(input)
}

fn operand(input: ParseStream<'_>) -> syn::Result<Expr> {
    if let Some(tokens) = substituted(input) {
        return Expr::parse.parse2(tokens);
    }
    if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        return inside(&content, |content| {
            let value = Expr::parse(content)?;
            match content.is_empty() {
                true => Ok(value),
                false => Err(after_operand(content)),
            }
        });
    }
    if input.peek(token::Bracket) {
        return Err(messages::list_inside_expression().at(input.span()));
    }
    if input.peek(Ident::peek_any) {
        return name_or_call(input);
    }
    if input.peek(syn::Lit) {
        let (value, span) = number(input)?;
        return Ok(Expr::Number(value, span));
    }
    Err(expected(
        input,
        "an expression",
        "an expression is made of numbers, names, `+ - * /`, brackets and functions",
    ))
}

/// An expression that a `macro_rules` macro put here: one operand, whatever its operators.
fn substituted(input: ParseStream<'_>) -> Option<TokenStream> {
    input
        .step(|cursor| match cursor.group(Delimiter::None) {
            Some((inside, _, rest)) => Ok((inside.token_stream(), rest)),
            None => Err(cursor.error("no substituted expression")),
        })
        .ok()
}

fn name_or_call(input: ParseStream<'_>) -> syn::Result<Expr> {
    let name = name(input)?;
    if !input.peek(token::Paren) {
        return Ok(Expr::Name(name));
    }
    let content;
    parenthesized!(content in input);
    Ok(Expr::Call(name, inside(&content, list)?))
}

/// Expressions with commas between them; a comma at the end is allowed.
pub(super) fn list(input: ParseStream<'_>) -> syn::Result<Vec<Expr>> {
    let list = Punctuated::<Expr, Token![,]>::parse_terminated_with(input, |input| {
        let value = Expr::parse(input)?;
        match input.is_empty() || input.peek(Token![,]) {
            true => Ok(value),
            false => Err(after_operand(input)),
        }
    })?;
    Ok(list.into_iter().collect())
}
