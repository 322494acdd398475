//! Many contacts of one element: slices in, slices out.
//!
//! | file | question |
//! |---|---|
//! | `shape`, `arrays` | what do the arrays look like, what do they hold for a contact |
//! | `run`, `screening` | which contacts are evaluated, in lanes or alone |
//! | `sums` | what do they add to the forces and the sparse matrix of a model |

pub(crate) mod arrays;
pub(crate) mod run;
mod screening;
pub(crate) mod shape;
mod slices;
mod sums;

pub use slices::{Batch, evaluate_batch};
pub use sums::Assembly;
