//! Random numbers that depend on seed, index and purpose only.

use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64;

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct Stream(Pcg64);

impl Stream {
    /// The stream of state `index` for a purpose; streams are independent of each other.
    pub fn new(seed: u64, index: u64, purpose: u64) -> Self {
        let mixed = [index, purpose].into_iter().fold(seed, |state, next| {
            Pcg64::seed_from_u64(state).random::<u64>() ^ next
        });
        Self(Pcg64::seed_from_u64(mixed))
    }

    /// Uniform in `[low, high)`; `low` if the interval is empty.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }

    /// The logarithm uniform between those of `low > 0` and `high`.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        self.uniform(low.ln(), high.ln()).exp()
    }

    /// +1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.0.random::<bool>() { 1.0 } else { -1.0 }
    }

    /// One of `0..count` (`count > 0`).
    pub fn index(&mut self, count: usize) -> usize {
        self.0.random_range(0..count.max(1))
    }

    /// A vector in the cube `[-half, half]³`.
    pub fn cube(&mut self, half: f64) -> [f64; 3] {
        [0; 3].map(|_| self.uniform(-half, half))
    }

    /// A unit vector, uniform on the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = self.cube(1.0);
            let square: f64 = v.iter().map(|c| c * c).sum();
            if (0.01..=1.0).contains(&square) {
                return v.map(|c| c / square.sqrt());
            }
        }
    }

    /// A quaternion uniform over the rotations, of length between 0.5 and 2.
    pub fn quaternion(&mut self) -> [f64; 4] {
        loop {
            let q = [0; 4].map(|_| self.uniform(-1.0, 1.0));
            let square: f64 = q.iter().map(|c| c * c).sum();
            if (0.01..=1.0).contains(&square) {
                let length = self.uniform(0.5, 2.0);
                return q.map(|c| c * length / square.sqrt());
            }
        }
    }
}
