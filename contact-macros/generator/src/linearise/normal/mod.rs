//! Normal contact: gap, law, tangent.

pub mod distance;
pub mod gap;
pub mod law;
pub mod tangent;
