//! Tangential contact: frame and slip, law, residual, tangent.

pub(crate) mod form;
pub mod frame;
pub mod law;
pub(crate) mod point;
pub mod residual;
pub mod tangent;
