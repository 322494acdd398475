//! Errors over many states: the worst one, their distribution, and how the worst one grows with the number of states.

use serde::Serialize;

/// The worst error of a comparison and where it was found.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Worst {
    /// Relative error.
    pub error: f64,
    /// Number of the state.
    pub state: u64,
}

impl Worst {
    /// Keeps the larger of two.
    pub fn absorb(&mut self, error: f64, state: u64) {
        if error > self.error || error.is_nan() {
            *self = Self { error, state };
        }
    }

    /// Keeps the larger of two.
    pub fn merge(&mut self, other: &Self) {
        self.absorb(other.error, other.state);
    }
}

/// Classes per decade, decades and the lower end of a [`Histogram`].
const PER_DECADE: usize = 4;
const DECADES: usize = 6;
const LOWEST: f64 = -17.0;
/// Classes of a [`Histogram`].
pub const CLASSES: usize = PER_DECADE * DECADES;

/// Counts of relative errors by their magnitude. Errors below the lowest class count in it, errors above the highest
/// in that.
#[derive(Clone, Debug, Serialize)]
pub struct Histogram {
    /// States of each class.
    pub counts: [u64; CLASSES],
}

impl Default for Histogram {
    fn default() -> Self {
        Self {
            counts: [0; CLASSES],
        }
    }
}

impl Histogram {
    /// Counts one error.
    pub fn add(&mut self, error: f64) {
        let position = (error.log10() - LOWEST) * PER_DECADE as f64;
        // zero has the logarithm -inf, NaN counts as the largest error
        let class = if position.is_nan() {
            CLASSES - 1
        } else {
            position.clamp(0.0, (CLASSES - 1) as f64) as usize
        };
        self.counts[class] += 1;
    }

    /// Adds the counts of another one.
    pub fn merge(&mut self, other: &Self) {
        for (count, more) in self.counts.iter_mut().zip(&other.counts) {
            *count += more;
        }
    }

    /// Decimal logarithm of the lower end of a class.
    pub fn lower_end(class: usize) -> f64 {
        LOWEST + class as f64 / PER_DECADE as f64
    }

    /// Whether nothing was counted.
    pub fn is_empty(&self) -> bool {
        self.counts.iter().all(|&count| count == 0)
    }
}

/// The worst errors after some number of states.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Reached {
    /// Number of states.
    pub states: u64,
    /// Largest relative error of the residual.
    pub residual: f64,
    /// Largest relative error of the tangent.
    pub tangent: f64,
}

/// Numbers of states at which [`Reached`] is noted: 10, 30, 100, 300, … and `states` itself.
pub fn milestones(states: u64) -> Vec<u64> {
    let decades = std::iter::successors(Some(10_u64), |decade| decade.checked_mul(10));
    let all = decades.flat_map(|decade| [decade, decade.saturating_mul(3)]);
    let before = all.take_while(|&milestone| milestone < states);
    before.chain([states]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_fall_into_their_classes() {
        let mut histogram = Histogram::default();
        for error in [0.0, 1e-30, 1.5e-17, 1.1e-14, 3e-12, 1.0, f64::NAN] {
            histogram.add(error);
        }
        assert_eq!(histogram.counts[0], 3);
        assert_eq!(histogram.counts[12], 1);
        assert_eq!(Histogram::lower_end(12), -14.0);
        assert_eq!(histogram.counts[CLASSES - 3], 1);
        assert_eq!(histogram.counts[CLASSES - 1], 2);
    }

    #[test]
    fn milestones_end_with_the_last_state() {
        assert_eq!(milestones(7), [7]);
        assert_eq!(milestones(100), [10, 30, 100]);
        assert_eq!(milestones(400), [10, 30, 100, 300, 400]);
    }
}
