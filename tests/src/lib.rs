//! Tests across the workspace; see README.md beside this crate for which test lives where.
//!
//! This library is what the tests share: building the C library, running compilers, and files that
//! are committed and compared.
#![forbid(unsafe_code)]

pub mod abi;
pub mod circles;
pub mod committed;
pub mod compiler;
pub mod documents;
pub mod header;
pub mod library;
mod paths;
pub mod process;
pub mod random;
pub mod words;

use std::path::PathBuf;

/// A path in the workspace.
pub fn workspace(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(path)
}
