//! What is proven, one file per kind of evidence.
//!
//! | file | evidence |
//! |---|---|
//! | `tables` | tables agree with the emitted code bit for bit; derivatives in them with duals |
//! | `random`, `points` | residual, tangent, energy, output and trial history of every contact point over random states against the oracle |
//! | `statistics`, `hardest` | how errors are distributed; the states of a long run that had the largest ones |
//! | `sequences` | steps of frictional contact, element and oracle each with its own history |
//! | `edges` | states where elements tend to fail |
//! | `reference` | cases of 25 digits from a third program |
//! | `invariance`, `units` | symmetry, balance of force and moment, rigid motion, change of units |
//! | `global` | the closest point over the whole domain, found without a start |
//! | `sides` | which side two edges are on: of the parameter, of the remembered normal |
//! | `slopes` | error orders of the linearisation on the tangent plane |
//! | `mutation` | every term dropped, doubled, flipped: each must be noticed |
//! | `coverage` | every status and feature, every return code and argument that a safe caller can provoke, was seen |

pub mod cases;
pub mod coverage;
pub mod edges;
mod errors;
pub mod global;
pub mod hardest;
pub mod interpreted;
pub mod invariance;
pub mod mutation;
mod points;
pub mod random;
pub mod reference;
pub mod sequences;
pub mod sides;
pub mod slopes;
pub mod statistics;
pub mod tables;
mod units;

pub use statistics::Worst;

use serde::Serialize;

/// Failures are listed up to this number; all are counted.
const LISTED: usize = 5;

/// Outcome of one kind of evidence for one subject.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Finding {
    /// States or cases tried.
    pub tried: u64,
    /// How many failed.
    pub failed: u64,
    /// The first failures in words.
    pub failures: Vec<String>,
}

impl Finding {
    /// Counts a success.
    pub fn pass(&mut self) {
        self.tried += 1;
    }

    /// Counts a failure.
    pub fn fail(&mut self, what: String) {
        self.tried += 1;
        self.failed += 1;
        if self.failures.len() < LISTED {
            self.failures.push(what);
        }
    }

    /// Counts a comparison: within the tolerance or not.
    pub fn compare(&mut self, what: &str, error: f64, tolerance: f64) {
        if error <= tolerance {
            self.pass();
        } else {
            self.fail(format!(
                "{what}: error {error:.2e}, allowed {tolerance:.0e}"
            ));
        }
    }

    /// Adds another finding.
    pub fn merge(&mut self, other: Self) {
        self.tried += other.tried;
        self.failed += other.failed;
        let room = LISTED.saturating_sub(self.failures.len());
        self.failures.extend(other.failures.into_iter().take(room));
    }
}
