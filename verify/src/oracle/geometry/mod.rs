//! Geometries: interpolated from nodes ([`interpolation`]), rigid and given by parameters or by a
//! distance ([`rigid`]), or declared by a user ([`declared`]).

pub mod declared;
pub mod interpolation;
mod polynomials;
pub mod region;
pub mod rigid;

pub use declared::{DeclaredDistance, DeclaredShape, DeclaredSurface};
pub use interpolation::{Interpolation, MAX_NODES, Shape};
pub use region::{Feature, Region};
pub use rigid::{Placement, RigidDistance, RigidParametric};

#[cfg(test)]
mod tests;
