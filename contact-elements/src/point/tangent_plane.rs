//! Carries an elastic slip along when the projection passes from one element to its neighbour. [eq:transfer]
//!
//! The anchor is a pair of parameters of one element; what two elements have in common is the slip in space.

use crate::arithmetic::{abs, sqrt};
use crate::point::values::dot;

/// Below this length, or this projected part of a unit vector, a tangent plane has no direction.
const SMALLEST: f64 = 1e-30;
/// Least squared sine between two tangents.
const PARALLEL: f64 = 1e-13;
/// Most that |n|² may differ from 1.
const NOT_UNIT: f64 = 1e-6;
/// Least |n_A + n_B|²: the smallest rotation between opposite normals is not unique.
const OPPOSITE: f64 = 1e-12;
/// Least cosine between the turned slip and the one tangent of a curve.
const ACROSS: f64 = 1e-6;

/// Normal and tangents of a contact point in the global frame; third entries 0 in the plane.
#[derive(Clone, Copy, Debug)]
pub struct TangentPlane {
    /// b_1 and b_2 of a contact point with one or two projected parameters.
    b: [[f64; 3]; 2],
    /// b_2 − t b_1, orthogonal to b_1, and t = a_12/a_11; zero for one parameter.
    orthogonal: ([f64; 3], f64),
    /// Unit normal.
    n: [f64; 3],
    /// One or two.
    projected: usize,
}

impl TangentPlane {
    /// The plane of `projected` tangents; `None` where they span no plane or n is no unit vector.
    pub fn new(b: [[f64; 3]; 2], n: [f64; 3], projected: usize) -> Option<Self> {
        let unit = abs(dot(&n, &n) - 1.0) <= NOT_UNIT;
        let lengths = b.iter().take(projected);
        let long = lengths.fold(true, |all, b| all & (dot(b, b) >= SMALLEST * SMALLEST));
        if !unit || !long || !(1..=2).contains(&projected) {
            return None;
        }
        let mut plane = Self {
            b,
            orthogonal: ([0.0; 3], 0.0),
            n,
            projected,
        };
        if projected == 2 {
            let shear = dot(&b[0], &b[1]) / dot(&b[0], &b[0]);
            let second = core::array::from_fn(|k| b[1][k] - shear * b[0][k]);
            if dot(&second, &second) <= PARALLEL * dot(&b[1], &b[1]) {
                return None;
            }
            plane.orthogonal = (second, shear);
        }
        Some(plane)
    }

    /// s = b_i Δζ^i
    pub fn slip(&self, moved: [f64; 2]) -> [f64; 3] {
        let mut s = [0.0; 3];
        for (b, moved) in self.b.iter().zip(moved).take(self.projected) {
            for k in 0..3 {
                s[k] += moved * b[k];
            }
        }
        s
    }

    /// s of this plane rotated into the plane `to` by the smallest rotation between their normals: the
    /// reflection that takes n_A into −n_B, m = n_A + n_B. `None` for opposite normals.
    pub fn turned(&self, s: &[f64; 3], to: &Self) -> Option<[f64; 3]> {
        let m: [f64; 3] = core::array::from_fn(|k| self.n[k] + to.n[k]);
        let square = dot(&m, &m);
        if square <= OPPOSITE {
            return None;
        }
        let part = 2.0 * dot(&m, s) / square;
        Some(core::array::from_fn(|k| s[k] - part * m[k]))
    }

    /// Δζ^i = a^ij b_j·s. Along a curve s keeps its length; `None` where it stands across the curve.
    pub fn parameters(&self, s: &[f64; 3]) -> Option<[f64; 2]> {
        let [b, _] = &self.b;
        let (along, square) = (dot(b, s), dot(b, b));
        if self.projected == 2 {
            let (second, shear) = &self.orthogonal;
            let moved = dot(second, s) / dot(second, second);
            return Some([along / square - shear * moved, moved]);
        }
        let length = sqrt(dot(s, s));
        let whole = length * sqrt(square);
        if whole == 0.0 {
            return Some([0.0; 2]);
        }
        if abs(along) < ACROSS * whole {
            return None;
        }
        let moved = length / sqrt(square);
        Some([if along < 0.0 { -moved } else { moved }, 0.0])
    }
}
