//! What can be wrong with a question put to the oracle.

use std::fmt;

/// Why the oracle gives no answer at all. (Contact states such as *outside* or *degenerate* are
/// answers: see [`crate::oracle::solve::PointStatus`].)
#[derive(Debug, Clone, PartialEq)]
pub enum OracleError {
    /// The pair contradicts itself, e.g. a signed gap without a unique normal.
    Pair(String),
    /// An array has the wrong length.
    Length {
        /// Which array.
        what: &'static str,
        /// Length needed.
        expected: usize,
        /// Length given.
        found: usize,
    },
    /// NaN or infinity in the input.
    NotFinite(&'static str),
    /// The normal law has no value at this gap (e.g. a barrier at `g <= 0`).
    Infeasible {
        /// The gap met.
        gap: f64,
    },
    /// The point asked for has no converged projection inside its master.
    NoProjection,
}

impl fmt::Display for OracleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pair(reason) => write!(f, "inconsistent pair: {reason}"),
            Self::Length {
                what,
                expected,
                found,
            } => {
                write!(f, "{what}: {expected} values needed, {found} given")
            }
            Self::NotFinite(what) => write!(f, "{what}: not finite"),
            Self::Infeasible { gap } => write!(f, "the normal law has no value at gap {gap:e}"),
            Self::NoProjection => write!(f, "no projection inside the master"),
        }
    }
}

impl std::error::Error for OracleError {}
