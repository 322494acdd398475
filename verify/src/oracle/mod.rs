//! The oracle: truth by dual numbers, slowly but without any typed derivative.
//!
//! Read in this order: [`geometry`] (positions as functions of parameters), [`law`] (energy as a
//! function of the gap), [`multiplier`] (what a multiplier adds to it), [`tangential`] (traction as a function of slip,
//! pressure and path), [`rolling`] (angles about two curves), [`angle`] (angles at which a contact acts), [`pair`]
//! (one contact problem as data), [`kinematics`] (relative
//! position, tangents, normal, gap), [`projection`] (closest point in doubles), [`solve`]
//! (energy, residual and tangent from dual sweeps).
//!
//! Conventions. Gap `g > 0` open, `g < 0` penetration; `N = dW/dg`, negative in contact for a
//! repulsive law; residual `R = dW/dx`, tangent `K = dR/dx`. Unknowns: slave nodes, then master
//! nodes, components fastest. Any consistent set of units.
//!
//! ```
//! use contact_verify::oracle::geometry::{Interpolation, Shape};
//! use contact_verify::oracle::law::Law;
//! use contact_verify::oracle::multiplier::Multipliers;
//! use contact_verify::oracle::pair::{GapKind, Master, Pair, Slave};
//! use contact_verify::oracle::solve::{self, Start, State};
//!
//! let pair = Pair {
//!     dimension: 3,
//!     slave: Slave::Point,
//!     master: Master::Shape(Interpolation::new(Shape::Quad4)),
//!     gap: GapKind::Signed,
//!     orientation: 1.0,
//!     r0: 0.0,
//!     law: Law::Penalty { eps_n: 1000.0 },
//!     tangential: None,
//!     angle: None,
//!     multipliers: Multipliers::None,
//! };
//! let x = [
//!     0.2, -0.1, -0.05, // slave point, 0.05 below the facet
//!     -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
//! ];
//! let state = State {
//!     reference: &x,
//!     displacement: &[0.0; 15],
//!     start: Start::Search,
//!     friction: &[],
//! };
//! let evaluation = solve::evaluate(&pair, &state).unwrap();
//! assert!((evaluation.points[0].gap + 0.05).abs() < 1e-15);
//! assert!((evaluation.residual[2] + 50.0).abs() < 1e-12);
//! ```

pub mod angle;
pub mod error;
pub mod geometry;
pub mod history;
pub mod kinematics;
pub mod law;
pub mod multiplier;
pub mod number;
pub mod octuple;
pub mod pair;
pub mod projection;
pub mod rolling;
pub mod solve;
pub mod tangential;
mod validate;
pub mod vector;

#[cfg(test)]
mod reference_tests;
#[cfg(test)]
mod rolling_tests;
#[cfg(test)]
mod solve_tests;

pub use error::OracleError;
