//! The pipeline, read first: declaration → syntax → model → linearised programs → optimised → Rust.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::budget;
use crate::emit::{
    emit_element, emit_export, emit_friction, emit_geometry, emit_law, emit_tangential_law,
};
use crate::model::Model;
use crate::syntax::File;

/// A declaration file with the `export PREFIX;` line that may stand first.
pub struct Declaration {
    /// Prefix of the C symbols, where the library is exported.
    pub export: Option<Ident>,
    /// The items.
    pub file: File,
}

/// Text of the built-in elements, in the language: two parts, for two crates that are compiled side by side.
pub const LIBRARY_ELEMENTS: [&str; 2] = [
    include_str!("../library/elements.contact"),
    include_str!("../library/elements_extended.contact"),
];

/// Expands the body of `contact_elements! { … }`. Mistakes become `compile_error!` at their tokens.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let library = Model::library();
    let result = parse(tokens).and_then(|declaration| {
        let model = Model::build(&declaration.file, Some(&library))?;
        budget::check(&model)?;
        Ok(emit(&model, declaration.export.as_ref()))
    });
    result.unwrap_or_else(|error| error.into_compile_error())
}

/// Expands one part of the built-in library: `geometries`, `laws`, `elements`, `elements_extended`; or
/// `lists`, those of all elements, whose types must be in scope.
pub fn expand_library(part: &str) -> syn::Result<TokenStream> {
    let library = Model::library();
    let [elements, elements_extended] = LIBRARY_ELEMENTS;
    let model = match part {
        "geometries" => Model {
            geometries: library.geometries.clone(),
            ..Model::default()
        },
        "laws" => Model {
            laws: library.laws.clone(),
            tangential_laws: library.tangential_laws.clone(),
            ..Model::default()
        },
        "elements" => elements_of(elements, &library)?,
        "elements_extended" => elements_of(elements_extended, &library)?,
        "lists" => return Ok(registry(&library_elements()?)),
        _ => {
            let message = format!("the library has no part `{part}`");
            return Err(syn::Error::new(Span::call_site(), message));
        }
    };
    Ok(emit(&model, None))
}

/// Exports the built-in elements under `prefix`; `ELEMENTS` and the types must be in scope.
pub fn expand_library_export(prefix: &Ident) -> syn::Result<TokenStream> {
    let names: Vec<Ident> = library_elements()?
        .elements
        .iter()
        .map(|element| element.name.clone())
        .collect();
    Ok(emit_export(prefix, &names))
}

/// The built-in elements of both parts, in the order of their indices.
pub fn library_elements() -> syn::Result<Model> {
    elements_of(&LIBRARY_ELEMENTS.concat(), &Model::library())
}

fn elements_of(text: &str, library: &Model) -> syn::Result<Model> {
    let tokens: TokenStream = text.parse()?;
    Model::build(&syn::parse2(tokens)?, Some(library))
}

/// Splits off `export PREFIX;` and parses the rest.
pub fn parse(tokens: TokenStream) -> syn::Result<Declaration> {
    let list: Vec<TokenTree> = tokens.into_iter().collect();
    let (export, rest) = match list.as_slice() {
        [
            TokenTree::Ident(keyword),
            TokenTree::Ident(prefix),
            TokenTree::Punct(end),
            rest @ ..,
        ] if keyword == "export" && end.as_char() == ';' => (Some(prefix.clone()), rest),
        rest => (None, rest),
    };
    let file = syn::parse2(rest.iter().cloned().collect())?;
    Ok(Declaration { export, file })
}

fn emit(model: &Model, export: Option<&Ident>) -> TokenStream {
    let geometries = model.geometries.iter().map(|item| emit_geometry(item));
    let laws = model.laws.iter().map(|item| emit_law(item));
    let tangential = model
        .tangential_laws
        .iter()
        .map(|item| emit_tangential_law(item));
    let friction = emit_friction(&model.elements);
    let elements = model.elements.iter().map(emit_element);
    let registry = registry(model);
    let export = export.map(|prefix| {
        let names: Vec<Ident> = model.elements.iter().map(|e| e.name.clone()).collect();
        emit_export(prefix, &names)
    });
    quote! { #(#geometries)* #(#laws)* #(#tangential)* #friction #(#elements)* #registry #export }
}

/// Lists of what was declared, in the order of declaration.
fn registry(model: &Model) -> TokenStream {
    let geometries = list(
        "GEOMETRIES",
        "GeometryPrograms",
        model.geometries.iter().map(|geometry| {
            let name = &geometry.name;
            quote! { #name::PROGRAMS }
        }),
    );
    let laws = list(
        "LAWS",
        "LawPrograms",
        model.laws.iter().map(|law| {
            let name = &law.name;
            quote! { &#name::PROGRAMS }
        }),
    );
    let tangential_laws = list(
        "TANGENTIAL_LAWS",
        "TangentialLawPrograms",
        model.tangential_laws.iter().map(|law| {
            let name = &law.name;
            quote! { &#name::PROGRAMS }
        }),
    );
    let names: Vec<&Ident> = model.elements.iter().map(|element| &element.name).collect();
    let descriptions = list(
        "DESCRIPTIONS",
        "ElementDescription",
        names.iter().map(|name| quote! { &#name::DESCRIPTION }),
    );
    let count = names.len();
    let elements = (count > 0).then(|| {
        quote! {
            /// The elements declared here; an index never changes once released.
            pub static ELEMENTS: [&::contact_elements::abi::Descriptor; #count] =
                [#(#names::DESCRIPTOR),*];
        }
    });
    quote! { #geometries #laws #tangential_laws #descriptions #elements }
}

fn list(name: &str, kind: &str, items: impl Iterator<Item = TokenStream>) -> Option<TokenStream> {
    let items: Vec<TokenStream> = items.collect();
    if items.is_empty() {
        return None;
    }
    let (name, kind) = (format_ident!("{name}"), format_ident!("{kind}"));
    Some(quote! {
        /// What was declared here, for verification.
        pub const #name: &[&::contact_elements::program::#kind] = &[#(#items),*];
    })
}
