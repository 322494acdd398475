//! Moments about two curves: their angles, residual, tangent.

pub mod angle;
pub(crate) mod curves;
pub(crate) mod form;
pub mod residual;
pub mod tangent;
