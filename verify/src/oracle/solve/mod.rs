//! Energy, residual and tangent of a pair, from dual and hyper-dual sweeps.
//!
//! - [`evaluate`]: residual and full tangent; [`tangent_times`]: residual and tangent times given
//!   directions (for big elements); [`residual`], [`energy`], [`reports`]: less;
//! - [`solve_point`]: one contact point, with gradient and Hessian of its gap and of its
//!   projected parameters.
//!
//! Where the law has an energy and the measure does not move, residual and tangent are gradient
//! and Hessian of `Σ_q w_q J_q W(g_q)`. Otherwise the residual is `Σ_q w_q J_q N(g_q) dg_q`, `dg`
//! from the hyper-dual gap, and the tangent its derivative. A contact that acts at some angles only has the energy
//! `Σ_q w_q J_q f_q W(g_q)` with the factor f of [`super::angle`]. Friction adds `Σ_q w_q J_q T_i dζ^i`, rolling
//! `Σ_q w_q J_q M_c dφ_c`.

mod assemble;
mod couplings;
mod friction;
mod locate;
mod point;
mod report;
mod rolling;
mod state;

pub use assemble::{energy, evaluate, reports, residual, tangent_times};
pub use locate::search_window;
pub use point::{HyperPoint, PointSolution, Seed, Sweep};
pub use report::{Couplings, Evaluation, FrictionReport, PointReport, PointStatus, RollingReport};
pub use state::{Start, State, validate};

use super::error::OracleError;
use super::pair::Pair;
use locate::locate;

/// One contact point with the derivatives of its gap and parameters; the law plays no part
/// except in the report's status.
pub fn solve_point<'a>(
    pair: &'a Pair,
    state: &State<'_>,
    q: usize,
) -> Result<PointSolution<'a>, OracleError> {
    validate(pair, state)?;
    if q >= pair.points() {
        return Err(OracleError::Length {
            what: "points",
            expected: pair.points(),
            found: q + 1,
        });
    }
    match locate(pair, state, q)? {
        (frame, Some(root), report) => Ok(PointSolution::new(frame, root, report)),
        _ => Err(OracleError::NoProjection),
    }
}
