//! Crates outside the workspace, built as their users would build them.

mod threads;
mod user_crate;
