//! Finite-element contact elements with exact residual and tangent.
//!
//! Declare a pair with [`contact_elements!`], build, and link a C or Fortran symbol; the built-in elements are the
//! crate `contact-library`. The kernels need neither the standard library nor an allocator.
//!
//! | feature | |
//! |---|---|
//! | `threads`, off | [`abi::element_evaluate_batch_threads`] has threads; needs the standard library |
#![no_std]

extern crate self as contact_elements;
#[cfg(feature = "threads")]
extern crate std;

pub use contact_macros::contact_elements;

pub mod abi;
pub mod arithmetic;
pub mod geometry;
pub mod laws;
pub mod program;
pub mod runtime;
pub mod search;
