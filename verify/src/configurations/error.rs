//! Why no state could be generated.

use std::fmt;

use crate::oracle::OracleError;

/// Why no state could be generated.
#[derive(Debug, Clone, PartialEq)]
pub enum GenerateError {
    /// The template is inconsistent.
    Template(OracleError),
    /// The pair has no boundary, or no parameter, so nothing is ever outside.
    NeverOutside,
    /// The pair has no friction, or a law without bound.
    NeverSlips,
    /// No attempt gave the requested status in a well-conditioned state.
    Exhausted {
        /// Attempts made.
        attempts: usize,
    },
}

impl fmt::Display for GenerateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Template(error) => write!(f, "{error}"),
            Self::NeverOutside => write!(f, "the pair has no boundary"),
            Self::NeverSlips => write!(f, "the pair has no friction, or it never slips"),
            Self::Exhausted { attempts } => write!(f, "no suitable state in {attempts} attempts"),
        }
    }
}

impl std::error::Error for GenerateError {}
