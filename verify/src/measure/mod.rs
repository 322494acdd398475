//! What is measured, not proven: how many digits are left at the extremes, and what projections cost.

pub mod projections;
pub mod stress;
