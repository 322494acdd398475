//! Finite-element contact elements with exact residual and tangent.
//!
//! Declare a pair with [`contact_elements!`], build, and link a C or Fortran symbol; the built-in elements are the
//! crate `contact-library`. The kernels need neither the standard library nor an allocator.
//!
//! | feature | |
//! |---|---|
//! | `threads`, off | [`abi::element_evaluate_batch_threads`] has threads; needs the standard library |
#![no_std]
// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

extern crate self as contact_elements;
#[cfg(feature = "threads")]
extern crate std;

pub use contact_macros::contact_elements;

pub mod abi;
pub mod arithmetic;
mod batch;
mod element;
pub mod geometry;
mod lanes;
pub mod laws;
mod point;
pub mod program;
pub mod runtime;
pub mod search;
