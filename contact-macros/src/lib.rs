//! `contact_elements!`: declares contact pairs, generates their residual and tangent.
//!
//! The language and the generator live in `contact-generator`; this crate is only the door.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Declares geometries, laws and elements; `docs/declare.md` describes the language.
///
/// With `export PREFIX;` as the first line the C interface of the declared elements is exported under
/// that prefix.
#[proc_macro]
pub fn contact_elements(tokens: TokenStream) -> TokenStream {
    contact_generator::expand::expand(tokens.into()).into()
}

/// One part of the built-in library: `geometries`, `laws`, `elements`, `elements_extended`; or `lists`, those of all
/// elements, whose types must be in scope.
#[proc_macro]
pub fn library(part: TokenStream) -> TokenStream {
    contact_generator::expand::expand_library(&part.to_string())
        .unwrap_or_else(|error| error.into_compile_error())
        .into()
}

/// Exports the built-in elements in scope under a prefix: `library_export!(cte)`.
#[proc_macro]
pub fn library_export(prefix: TokenStream) -> TokenStream {
    syn::parse(prefix)
        .and_then(|prefix| contact_generator::expand::expand_library_export(&prefix))
        .unwrap_or_else(|error| error.into_compile_error())
        .into()
}
