//! From programs to Rust: types, trait implementations, descriptors, tables, C symbols.

mod element;
mod export;
mod geometry;
mod law;
mod lists;
mod names;
mod parameters;
mod plain;
mod program;
mod tangential_law;

pub use element::{emit_element, emit_friction};
pub use export::{emit_export, symbol_name};
pub use geometry::emit_geometry;
pub use law::emit_law;
pub use lists::emit_lists;
pub use tangential_law::emit_tangential_law;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::formulate::Formulation;
use crate::model::Domain;
use program::TAG;

/// Everything that was declared, with its lists, and the C symbols under the prefix `export`.
pub fn emit(formulation: &Formulation<'_>, export: Option<&Ident>) -> TokenStream {
    let geometries = formulation.geometries.iter().map(|own| emit_geometry(own));
    let laws = formulation.laws.iter().map(|own| emit_law(own));
    let tangential = formulation.tangential_laws.iter();
    let tangential = tangential.map(|own| emit_tangential_law(own));
    let friction = emit_friction(&formulation.elements);
    let elements = formulation.elements.iter().map(emit_element);
    let lists = emit_lists(formulation.model);
    let export = export.map(|prefix| {
        let elements = formulation.elements.iter();
        let names: Vec<Ident> = elements.map(|own| own.declared.name.clone()).collect();
        emit_export(prefix, &names)
    });
    let all = quote! {
        #(#geometries)* #(#laws)* #(#tangential)* #friction #(#elements)* #lists #export
    };
    plain::plain(all)
}

/// What every emitted item refers to.
fn imports() -> TokenStream {
    quote! {
        #[allow(unused_imports)]
        use ::contact_elements::ElementDescription;
        #[allow(unused_imports)]
        use ::contact_elements::table::{
            AngleDescription, AxisDescription, ElementPrograms, GeometryPrograms, LawPrograms, MasterDescription,
            Operation, RollingDescription, SlaveDescription, Table, TangentialLawPrograms, Term,
        };
        #[allow(unused_imports)]
        use ::contact_elements::runtime;
    }
}

/// Emitted tokens as formatted source. Equations at statements become comments: a comment does not survive among
/// tokens, so the tokens carry it as documentation.
///
/// # Errors
/// Where the tokens are no Rust file.
pub fn readable(tokens: &TokenStream) -> syn::Result<String> {
    let file = syn::parse2(plain::plain(tokens.clone()))?;
    let text = prettyplease::unparse(&file);
    let lines = text.lines().map(|line| match line.trim_start() {
        comment if comment.starts_with(&format!("/// {TAG}")) => line.replacen("///", "//", 1),
        _ => line.to_string(),
    });
    Ok(lines.map(|line| line + "\n").collect())
}

/// A parameter domain as an expression.
fn domain(domain: &Domain) -> TokenStream {
    match domain {
        Domain::Unbounded => quote! { runtime::Domain::Unbounded },
        Domain::Interval(lower, upper) => {
            let (lower, upper) = (number(*lower), number(*upper));
            quote! { runtime::Domain::Interval(#lower, #upper) }
        }
        Domain::Rectangle(lower, upper) => {
            let lower = lower.iter().map(|&v| number(v));
            let upper = upper.iter().map(|&v| number(v));
            quote! { runtime::Domain::Rectangle([#(#lower),*], [#(#upper),*]) }
        }
        Domain::Triangle => quote! { runtime::Domain::Triangle },
    }
}

/// An optional offset as an expression.
fn option(value: Option<usize>) -> TokenStream {
    match value {
        Some(value) => quote! { Some(#value) },
        None => quote! { None },
    }
}

/// A number as an expression, infinities included.
fn number(value: f64) -> TokenStream {
    if value == f64::INFINITY {
        quote! { f64::INFINITY }
    } else if value == f64::NEG_INFINITY {
        quote! { f64::NEG_INFINITY }
    } else {
        quote! { #value }
    }
}
