//! Fortran 77: everything by address, no CHARACTER arguments, elements by index. An exported symbol fills a struct of
//! addresses and calls a function of this module, which fills the struct of the C interface and calls that.

mod addresses;
mod batch;
mod describe;
mod evaluate;
mod history;
mod patch;
mod project;

pub use batch::{BatchAddresses, SparseAddresses, batch, scatter_map};
pub use describe::{find, info, message};
pub use evaluate::{Addresses, evaluate};
pub use history::{Side, augment, history_init, transfer};
pub use patch::{PatchAddresses, patch_evaluate, patch_info};
pub use project::{ProjectAddresses, project};
