//! What is swept, over which range, with which elements.

mod law;
mod placement;
mod shape;
mod sweep;

pub use sweep::{Series, Sweep};

/// All of them.
pub const SWEEPS: &[Sweep] = &[
    placement::ORIGIN,
    placement::SCALE,
    placement::GAP,
    placement::TINY_GAP,
    placement::ANGLE,
    placement::FOCAL,
    shape::ASPECT,
    shape::SKEW,
    shape::FOLD,
    shape::COLLAPSE,
    shape::TANGENT,
    shape::WEIGHT,
    law::PENALTY,
    law::TRACTION,
    law::FRICTION,
];
