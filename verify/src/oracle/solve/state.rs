//! The state of a pair.

use crate::oracle::error::OracleError;
use crate::oracle::history::FrictionHistory;
use crate::oracle::pair::Pair;

/// Where the projections start.
#[derive(Debug, Clone, Copy)]
pub enum Start<'s> {
    /// Parameters (slave's first) for each contact point, or once for all.
    Given(&'s [[f64; 2]]),
    /// The best of a regular grid of samples.
    Search,
}

/// State of a pair. Positions are `reference + displacement`; both hold all unknowns: slave
/// nodes, then master nodes, components fastest.
#[derive(Debug, Clone, Copy)]
pub struct State<'s> {
    /// X (length).
    pub reference: &'s [f64],
    /// u (length).
    pub displacement: &'s [f64],
    /// Where the projections start.
    pub start: Start<'s>,
    /// Accepted state of each contact point; if empty, contact begins at all of them. Ignored
    /// for a pair without friction.
    pub friction: &'s [FrictionHistory],
}

/// Checks lengths and finiteness of a state, and the pair itself.
pub fn validate(pair: &Pair, state: &State<'_>) -> Result<(), OracleError> {
    pair.validate()?;
    for (what, array) in [
        ("reference", state.reference),
        ("displacement", state.displacement),
    ] {
        if array.len() != pair.unknowns() {
            return Err(OracleError::Length {
                what,
                expected: pair.unknowns(),
                found: array.len(),
            });
        }
        if !array.iter().all(|v| v.is_finite()) {
            return Err(OracleError::NotFinite(what));
        }
    }
    if let Start::Given(start) = state.start {
        if start.len() != 1 && start.len() != pair.points() {
            let (expected, found) = (pair.points(), start.len());
            return Err(OracleError::Length {
                what: "start",
                expected,
                found,
            });
        }
        if !start.iter().flatten().all(|v| v.is_finite()) {
            return Err(OracleError::NotFinite("start"));
        }
    }
    validate_friction(pair, state)
}

fn validate_friction(pair: &Pair, state: &State<'_>) -> Result<(), OracleError> {
    let (expected, found) = (pair.points(), state.friction.len());
    if found != 0 && found != expected {
        return Err(OracleError::Length {
            what: "friction",
            expected,
            found,
        });
    }
    let finite = |h: &FrictionHistory| h.slip.is_finite() && h.anchor.iter().all(|v| v.is_finite());
    if state.friction.iter().all(finite) {
        Ok(())
    } else {
        Err(OracleError::NotFinite("friction"))
    }
}
