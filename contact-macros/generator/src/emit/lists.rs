//! Lists of what was declared, in the order of declaration.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::model::Model;

/// Lists of what was declared, in the order of declaration.
pub fn emit_lists(model: &Model) -> TokenStream {
    let geometries = list(
        "GEOMETRIES",
        quote! { table::GeometryPrograms },
        model.geometries.iter().map(|geometry| {
            let name = &geometry.name;
            quote! { #name::PROGRAMS }
        }),
    );
    let laws = list(
        "LAWS",
        quote! { table::LawPrograms },
        model.laws.iter().map(|law| {
            let name = &law.name;
            quote! { &#name::PROGRAMS }
        }),
    );
    let tangential_laws = list(
        "TANGENTIAL_LAWS",
        quote! { table::TangentialLawPrograms },
        model.tangential_laws.iter().map(|law| {
            let name = &law.name;
            quote! { &#name::PROGRAMS }
        }),
    );
    let names: Vec<&Ident> = model.elements.iter().map(|element| &element.name).collect();
    let descriptions = list(
        "DESCRIPTIONS",
        quote! { ElementDescription },
        names.iter().map(|name| quote! { &#name::DESCRIPTION }),
    );
    let count = names.len();
    let elements = (count > 0).then(|| {
        quote! {
            /// The elements declared here; an index never changes once released.
            pub static ELEMENTS: [&::contact_elements::Registered; #count] =
                [#(#names::DESCRIPTOR),*];
        }
    });
    quote! { #geometries #laws #tangential_laws #descriptions #elements }
}

fn list(
    name: &str,
    kind: TokenStream,
    items: impl Iterator<Item = TokenStream>,
) -> Option<TokenStream> {
    let items: Vec<TokenStream> = items.collect();
    if items.is_empty() {
        return None;
    }
    let name = format_ident!("{name}");
    Some(quote! {
        /// What was declared here, for verification.
        pub const #name: &[&::contact_elements::#kind] = &[#(#items),*];
    })
}
