//! The pipeline, read first: parse → check → formulate → emit.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

use crate::emit::{emit, emit_element, emit_export, emit_lists, readable};
use crate::formulate::formulate;
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
    stages(tokens).unwrap_or_else(|error| error.into_compile_error())
}

/// Every stage in order.
fn stages(tokens: TokenStream) -> syn::Result<TokenStream> {
    let declaration = parse(tokens)?;
    let model = Model::build(&declaration.file, Some(&Model::library()))?;
    let formulation = formulate(&model)?;
    Ok(emit(&formulation, declaration.export.as_ref()))
}

/// Expands one part of the built-in library: `geometries`, `laws`, `elements`, `elements_extended`; or
/// `lists`, those of all elements, whose types must be in scope.
pub fn expand_library(part: &str) -> syn::Result<TokenStream> {
    let library = Model::library();
    let [elements, elements_extended] = LIBRARY_ELEMENTS;
    let model = match part {
        "geometries" => Model {
            geometries: library.geometries,
            ..Model::default()
        },
        "laws" => Model {
            laws: library.laws,
            tangential_laws: library.tangential_laws,
            ..Model::default()
        },
        "elements" => elements_of(elements)?,
        "elements_extended" => elements_of(elements_extended)?,
        "lists" => return Ok(emit_lists(&library_elements()?)),
        _ => {
            let message = format!("the library has no part `{part}`");
            return Err(syn::Error::new(Span::call_site(), message));
        }
    };
    Ok(emit(&formulate(&model)?, None))
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
    elements_of(&LIBRARY_ELEMENTS.concat())
}

/// Name and emitted source of every built-in element.
pub fn library_sources() -> syn::Result<Vec<(String, String)>> {
    let model = library_elements()?;
    let formulation = formulate(&model)?;
    let elements = formulation.elements.iter().map(|element| {
        let text = readable(&emit_element(element))?;
        Ok((element.declared.name.to_string(), text))
    });
    elements.collect()
}

fn elements_of(text: &str) -> syn::Result<Model> {
    let tokens: TokenStream = text.parse()?;
    Model::build(&syn::parse2(tokens)?, Some(&Model::library()))
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
