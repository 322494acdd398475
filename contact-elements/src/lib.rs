//! Finite-element contact elements with exact residual and tangent.
//!
//! Declare a pair with [`contact_elements!`], build, and link a C or Fortran symbol; the built-in elements are the
//! crate `contact-library`. The kernels need neither the standard library nor an allocator.
//!
//! | feature | |
//! |---|---|
//! | `threads`, off | [`abi::element_evaluate_batch_threads`] has threads; needs the standard library |
#![cfg_attr(not(test), no_std)]
// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

extern crate self as contact_elements;
#[cfg(feature = "threads")]
extern crate std;

pub use contact_macros::contact_elements;

pub mod abi;
pub mod arithmetic;
mod augment;
mod batch;
pub mod codes;
mod describe;
mod description;
mod descriptor;
mod element;
mod error;
mod evaluation;
pub mod geometry;
mod lanes;
pub mod laws;
mod messages;
mod patch;
mod point;
mod project;
mod registered;
pub mod runtime;
pub mod search;
pub mod table;
mod transfer;

pub use augment::augment;
pub use codes::{argument, code, kind, request};
pub use describe::{check_parameters, find, initial_history};
pub use description::ElementDescription;
pub use descriptor::{Descriptor, Parameter};
pub use error::Error;
pub use evaluation::{
    Assembly, Batch, BatchKernel, Evaluation, Kernel, Run, ScreenKernel, Sparsity, Target,
    evaluate, evaluate_batch, scatter_blocks, scatter_map,
};
pub use patch::{Patch, PatchSizes, evaluate_patch};
pub use project::{Query, project};
pub use registered::Registered;
pub use runtime::{OUTPUT_SIZE, Status, Summary};
pub use search::{Closest, Verdict};
pub use transfer::{Entered, Left, transfer};
