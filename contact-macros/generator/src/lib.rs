//! The generator behind `contact_elements!`: from the declaration of a contact pair to code for its
//! residual and tangent.
//!
//! | stage | type in → type out | module |
//! |---|---|---|
//! | parse | tokens → [`syntax::File`] | [`syntax`] |
//! | check | `File` → [`model::Model`] | [`model`] |
//! | formulate | `Model` → [`formulate::Formulation`]: programs, offsets, numbers | [`formulate`] |
//! | emit | `Formulation` → Rust tokens | [`emit`] |
//!
//! Formulating asks [`linearise`] for the [`ir::Program`]s of the closed forms and runs the passes of [`ir`] over them.
//!
//! [`expand`] runs them in order.
#![forbid(unsafe_code)]

pub mod diagnostics;
pub mod emit;
pub mod expand;
pub mod formulate;
pub mod header;
pub mod ir;
pub mod linearise;
pub mod model;
pub mod syntax;
