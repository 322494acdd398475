//! The generator behind `contact_elements!`: from the declaration of a contact pair to code for its
//! residual and tangent.
//!
//! | stage | type in → type out | module |
//! |---|---|---|
//! | parse | tokens → [`syntax::File`] | [`syntax`] |
//! | check | `File` → [`model::Model`] | [`model`] |
//! | linearise | `Model` → [`ir::Program`] | [`linearise`] |
//! | optimise | `Program` → `Program` | [`optimise`] |
//! | emit | `Program` → Rust tokens | [`emit`] |
//!
//! [`expand`] runs them in order.
#![forbid(unsafe_code)]

pub mod budget;
pub mod diagnostics;
pub mod emit;
pub mod expand;
pub mod header;
pub mod ir;
pub mod linearise;
pub mod model;
pub mod optimise;
pub mod syntax;
