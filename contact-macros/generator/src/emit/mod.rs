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
mod source;
mod tangential_law;
mod values;

pub use element::{emit_element, emit_friction};
pub use export::{emit_export, symbol_name};
pub use geometry::emit_geometry;
pub use law::emit_law;
pub use lists::emit_lists;
pub use source::readable;
pub use tangential_law::emit_tangential_law;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::formulate::Formulation;

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
