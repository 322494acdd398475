//! Files and items.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, Token, braced, token};

use super::body::{body, entries, skip_item};
use super::item::{ElementItem, File, GeometryItem, GeometryKind, Head, Item, LawItem};
use super::token::{describe, expected, keyword, name};
use crate::diagnostics::{Mistakes, syntax as messages};

impl Parse for File {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut mistakes = Mistakes::new();
        let (mut items, mut broken) = (Vec::new(), Vec::new());
        while !input.is_empty() {
            let mut item_name = None;
            match item(input, &mut item_name, &mut mistakes) {
                Ok(item) => items.push(item),
                Err(error) => {
                    mistakes.push(error);
                    broken.extend(item_name);
                    skip_item(input);
                }
            }
        }
        Ok(File {
            items,
            broken,
            mistakes: mistakes.into_errors(),
        })
    }
}

fn item(
    input: ParseStream<'_>,
    item_name: &mut Option<Ident>,
    mistakes: &mut Mistakes,
) -> syn::Result<Item> {
    let docs = docs(input, mistakes)?;
    let kind = kind(input)?;
    let name = name(input)?;
    *item_name = Some(name.clone());
    match kind {
        Kind::Geometry(kind) => geometry(input, docs, kind, name, mistakes).map(Item::Geometry),
        Kind::Law => law(input, docs, name, mistakes).map(Item::Law),
        Kind::TangentialLaw => law(input, docs, name, mistakes).map(Item::TangentialLaw),
        Kind::Element => element(input, docs, name, mistakes).map(Item::Element),
    }
}

fn docs(input: ParseStream<'_>, mistakes: &mut Mistakes) -> syn::Result<String> {
    let mut lines = Vec::new();
    for attribute in input.call(Attribute::parse_outer)? {
        match doc_line(&attribute) {
            Some(text) => lines.push(text.strip_prefix(' ').unwrap_or(&text).to_string()),
            None => mistakes.report(attribute.pound_token.span, messages::foreign_attribute()),
        }
    }
    Ok(lines.join("\n"))
}

fn doc_line(attribute: &Attribute) -> Option<String> {
    match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(ExprLit {
                lit: Lit::Str(text),
                ..
            }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    }
}

enum Kind {
    Geometry(GeometryKind),
    Law,
    TangentialLaw,
    Element,
}

fn kind(input: ParseStream<'_>) -> syn::Result<Kind> {
    if !input.peek(Ident::peek_any) {
        let hint = "an item starts with `surface`, `curve`, `rigid`, `normal law`, \
                    `tangential law` or `element`";
        return Err(expected(input, "an item", hint));
    }
    let word = input.call(Ident::parse_any)?;
    let kind = match word.to_string().as_str() {
        "surface" => Kind::Geometry(GeometryKind::Surface),
        "curve" => Kind::Geometry(GeometryKind::Curve),
        "rigid" => Kind::Geometry(rigid_kind(input)?),
        "element" => Kind::Element,
        "normal" => followed_by_law(input, "normal", Kind::Law)?,
        "tangential" => followed_by_law(input, "tangential", Kind::TangentialLaw)?,
        other => return Err(messages::unknown_item(other).at(word.span())),
    };
    Ok(kind)
}

/// `kind`, if the word `law` comes next.
fn followed_by_law(input: ParseStream<'_>, word: &str, kind: Kind) -> syn::Result<Kind> {
    match keyword(input, "law") {
        Some(_) => Ok(kind),
        None => Err(messages::word_without_law(word, &describe(input)).at(input.span())),
    }
}

fn rigid_kind(input: ParseStream<'_>) -> syn::Result<GeometryKind> {
    let word = name(input)?;
    match word.to_string().as_str() {
        "surface" => Ok(GeometryKind::RigidSurface),
        "curve" => Ok(GeometryKind::RigidCurve),
        "distance" => Ok(GeometryKind::Distance),
        other => Err(messages::unknown_rigid(other).at(word.span())),
    }
}

fn geometry(
    input: ParseStream<'_>,
    docs: String,
    kind: GeometryKind,
    name: Ident,
    mistakes: &mut Mistakes,
) -> syn::Result<GeometryItem> {
    let head: Head = input.parse()?;
    let mut domain = None;
    if input.peek(Token![in]) {
        input.parse::<Token![in]>()?;
        domain = Some(input.parse()?);
    }
    let rational = keyword(input, "rational");
    let body = block(input, |content| body(content, mistakes))?;
    Ok(GeometryItem {
        docs,
        kind,
        name,
        head,
        domain,
        rational,
        body,
    })
}

fn law(
    input: ParseStream<'_>,
    docs: String,
    name: Ident,
    mistakes: &mut Mistakes,
) -> syn::Result<LawItem> {
    let head = input.parse()?;
    let body = block(input, |content| body(content, mistakes))?;
    Ok(LawItem {
        docs,
        name,
        head,
        body,
    })
}

fn element(
    input: ParseStream<'_>,
    docs: String,
    name: Ident,
    mistakes: &mut Mistakes,
) -> syn::Result<ElementItem> {
    let (entries, complete) = block(input, |content| entries(content, mistakes))?;
    Ok(ElementItem {
        docs,
        name,
        entries,
        complete,
    })
}

/// What `read` makes of the block in braces.
fn block<T>(input: ParseStream<'_>, read: impl FnOnce(ParseStream<'_>) -> T) -> syn::Result<T> {
    if !input.peek(token::Brace) {
        return Err(expected(
            input,
            "`{`",
            "an item ends with a block: `{ name = value; }`",
        ));
    }
    let content;
    braced!(content in input);
    Ok(read(&content))
}
