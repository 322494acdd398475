//! What several chapters need: kinematics of a pair, declared geometries, orthogonal tangents, the slave's measure.

pub mod basis;
pub mod geometry;
mod kinematics;
pub mod lower;
pub mod measure;

pub use kinematics::{Kinematics, pair_index, second_derivatives, third_derivatives};
