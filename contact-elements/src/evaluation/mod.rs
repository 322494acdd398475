//! Evaluation of elements: slices in, slices out.
//!
//! | file | question |
//! |---|---|
//! | `single` | one contact of an element |
//! | `inputs`, `sizes` | can the inputs be used, and how long are they |
//! | `target` | where do the outputs of a contact go |
//! | `places`, `pattern` | where do the entries of a contact stand in a sparse matrix |
//! | `batch` | many contacts of one element |

pub(crate) mod batch;
pub(crate) mod inputs;
pub(crate) mod pattern;
pub(crate) mod places;
pub(crate) mod single;
pub(crate) mod sizes;
pub(crate) mod target;

pub use batch::run::{BatchKernel, Run, ScreenKernel};
pub use batch::{Assembly, Batch, evaluate_batch};
pub use pattern::{Sparsity, scatter_blocks, scatter_map};
pub use single::{Evaluation, evaluate};
pub use target::{Kernel, Target};
