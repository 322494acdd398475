//! Expressions that several parts of the output share: paths, calls, lists of components.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::formulate::second_derivatives;
use crate::model::{Geometry, Law, TangentialLaw};

pub(super) fn geometry_path(geometry: &Geometry) -> TokenStream {
    let name = &geometry.name;
    if geometry.built_in {
        quote! { ::contact_elements::geometry::#name }
    } else {
        quote! { #name }
    }
}

pub(super) fn law_path(law: &Law) -> TokenStream {
    let name = &law.name;
    if law.built_in {
        quote! { ::contact_elements::laws::#name }
    } else {
        quote! { #name }
    }
}

pub(super) fn tangential_law_path(law: &TangentialLaw) -> TokenStream {
    let name = &law.name;
    if law.built_in {
        quote! { ::contact_elements::laws::#name }
    } else {
        quote! { #name }
    }
}

/// `<G as runtime::Shape<p, h, n>>::rows`
pub(super) fn shape_call(geometry: &Geometry) -> TokenStream {
    let path = geometry_path(geometry);
    let p = geometry.coordinates.len();
    let (h, n) = (second_derivatives(p), geometry.nodes());
    quote! { <#path as runtime::Shape<#p, #h, #n>>::rows }
}

/// `vectors.field[i][k]` for all components.
pub(super) fn components(field: &str, index: Option<usize>, d: usize) -> Vec<TokenStream> {
    let field = format_ident!("{field}");
    (0..d)
        .map(|k| match index {
            None => quote! { vectors.#field[#k] },
            Some(i) => quote! { vectors.#field[#i][#k] },
        })
        .collect()
}

/// `[[o[start], …]; rows]`
pub(super) fn matrix(start: usize, rows: usize, width: usize) -> TokenStream {
    let rows = (0..rows).map(|row| {
        let entries = (0..width).map(|k| {
            let index = start + row * width + k;
            quote! { o[#index] }
        });
        quote! { [#(#entries),*] }
    });
    quote! { [#(#rows),*] }
}
