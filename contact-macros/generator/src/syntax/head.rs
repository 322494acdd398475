//! What stands between the kind of an item and its block: name, coordinates, parameters, domain.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Ident, LitStr, Token, bracketed, parenthesized, token};

use super::item::{Bound, Domain, Head, Parameter};
use super::token::{expected, inside, keyword, name, number};

/// Names with commas between them.
pub(super) fn names(input: ParseStream<'_>) -> syn::Result<Vec<Ident>> {
    let mut names = Vec::new();
    while !input.is_empty() && !input.peek(Token![;]) {
        names.push(name(input)?);
        if !input.peek(Token![,]) {
            break;
        }
        input.parse::<Token![,]>()?;
    }
    Ok(names)
}

impl Parse for Head {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        if !input.peek(token::Paren) {
            return Err(expected(
                input,
                "`(`",
                "write `Name(coordinates; parameters)`",
            ));
        }
        let content;
        parenthesized!(content in input);
        inside(&content, head)
    }
}

/// The inside of the brackets.
fn head(input: ParseStream<'_>) -> syn::Result<Head> {
    let coordinates = names(input)?;
    let mut parameters = Vec::new();
    if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
        let list = Punctuated::<Parameter, Token![,]>::parse_separated_nonempty(input)?;
        parameters = list.into_iter().collect();
    }
    if !input.is_empty() {
        let hint = "write `(coordinates; name: \"unit\" in (lower, upper), ..)`";
        return Err(expected(input, "`,`, `;` or `)`", hint));
    }
    Ok(Head {
        coordinates,
        parameters,
    })
}

impl Parse for Parameter {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = name(input)?;
        let mut unit = None;
        if input.peek(Token![:]) {
            input.parse::<Token![:]>()?;
            if !input.peek(LitStr) {
                let hint = "write the unit as text, such as `\"force/length\"`, or `\"1\"`";
                return Err(expected(input, "a unit", hint));
            }
            unit = Some(input.parse::<LitStr>()?);
        }
        let mut range = None;
        if input.peek(Token![in]) {
            input.parse::<Token![in]>()?;
            range = Some(parse_range(input)?);
        }
        Ok(Parameter { name, unit, range })
    }
}

fn parse_range(input: ParseStream<'_>) -> syn::Result<([Bound; 2], bool)> {
    let hint = "write `in (lower, upper)`, or `in [lower, upper]` if the bounds are allowed";
    let content;
    let closed = input.peek(token::Bracket);
    if closed {
        bracketed!(content in input);
    } else if input.peek(token::Paren) {
        parenthesized!(content in input);
    } else {
        return Err(expected(input, "a range", hint));
    }
    let bounds = inside(&content, |content| {
        let lower: Bound = content.parse()?;
        if !content.peek(Token![,]) {
            return Err(expected(content, "`,`", hint));
        }
        content.parse::<Token![,]>()?;
        let upper: Bound = content.parse()?;
        match content.is_empty() {
            true => Ok([lower, upper]),
            false => Err(expected(content, "the end of the range", hint)),
        }
    })?;
    Ok((bounds, closed))
}

impl Parse for Bound {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let span = input.span();
        let negative = input.peek(Token![-]);
        if negative {
            input.parse::<Token![-]>()?;
        }
        let value = if keyword(input, "inf").is_some() {
            f64::INFINITY
        } else if input.peek(syn::Lit) {
            number(input)?.0
        } else {
            return Err(expected(
                input,
                "a bound",
                "a bound is a number or `inf`, with or without `-`",
            ));
        };
        Ok(Bound {
            value: if negative { -value } else { value },
            span,
        })
    }
}

impl Parse for Domain {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = name(input)?;
        let mut bounds = Vec::new();
        if input.peek(token::Paren) {
            let content;
            parenthesized!(content in input);
            bounds = inside(&content, domain_bounds)?;
        }
        Ok(Domain { name, bounds })
    }
}

/// Bounds with commas between them.
fn domain_bounds(input: ParseStream<'_>) -> syn::Result<Vec<Bound>> {
    let mut bounds = Vec::new();
    while !input.is_empty() {
        bounds.push(input.parse()?);
        if input.is_empty() {
            break;
        }
        if !input.peek(Token![,]) {
            return Err(expected(input, "`,`", "bounds are separated by commas"));
        }
        input.parse::<Token![,]>()?;
    }
    Ok(bounds)
}
