//! Finite-element contact elements with exact residual and tangent.
//!
//! Declare a pair with [`contact_elements!`], build, and link a C or Fortran symbol; or use the built-in
//! [`elements`]. The kernels need neither the standard library nor an allocator.
#![no_std]

extern crate self as contact_elements;

pub use contact_macros::contact_elements;

pub mod abi;
pub mod arithmetic;
pub mod elements;
pub mod geometry;
pub mod laws;
pub mod program;
pub mod runtime;
pub mod search;
