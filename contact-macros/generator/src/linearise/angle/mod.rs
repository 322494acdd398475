//! Weight by the angle of two curves: window, weight, residual, tangent.

pub(crate) mod pair;
pub mod residual;
pub mod tangent;
pub mod weight;
