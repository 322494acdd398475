//! The C interface: pointers of a host into slices, and results back.
//!
//! Everything that touches a caller's pointer is here; safe modules outside do the computing. An exported symbol is
//! one line that calls a function of this module with the registry of its library; see `contact_elements.h` for the
//! manual.

mod api_table;
mod batch;
mod csr;
mod describe;
mod evaluate;
pub mod fortran;
mod histories;
#[cfg(feature = "threads")]
mod journal;
mod messages;
mod outputs;
mod ownership;
mod patch;
mod pointers;
mod project;
mod threads;
mod types;
mod versioned;

pub use crate::registered::Registered;
pub use api_table::{ApiTable, api};
pub use batch::{element_batch_workspace, element_evaluate_batch, element_evaluate_batch_in};
pub use csr::{Sparse, csr_blocks, csr_map};
pub use describe::{
    element_check_parameters, element_count, element_find, element_get, element_history_init,
    element_info, element_parameter, element_unknown,
};
pub use evaluate::element_evaluate;
pub use histories::{history_augment, history_transfer};
pub use messages::{argument_name, code_message, element_message, status_message};
pub use patch::{Patch, patch_evaluate, patch_info};
pub use project::{Projection, element_project};
pub use threads::element_evaluate_batch_threads;
pub use types::{Arguments, Batch, Info};

/// Version of the interface: major << 16 | minor.
pub const VERSION: u32 = 1 << 16;
