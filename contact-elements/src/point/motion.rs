//! Linear forms over the motion of two curves, in which the coefficients of their moments are written.
//!
//! ```text
//! form(A,k) = s_A v_k + s_A,i v^i_k + s_A,ii w^i_k + s_A,iii z^i_k
//! ```

use crate::arithmetic::abs;
use crate::point::values::Rows;

/// A linear form over the unknowns of two curves.
#[derive(Clone, Copy, Debug)]
pub struct Motion<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i.
    pub turning: [[f64; D]; P],
    /// Multiplies s_A,ii.
    pub bending: [[f64; D]; P],
    /// Multiplies s_A,iii.
    pub third: [[f64; D]; P],
}

/// Coefficients of the residual of the moments.
#[derive(Clone, Copy, Debug)]
pub struct RollingForce<const D: usize, const P: usize> {
    /// Added to t_q in the factor of δζ̂^q.
    pub share: [f64; 2],
    /// The rest.
    pub explicit: Motion<D, P>,
}

/// Coefficients of the tangent of the moments.
#[derive(Clone, Copy, Debug)]
pub struct RollingCoefficients<const D: usize, const P: usize> {
    /// A, B of A⊗B + B⊗A.
    pub symmetric: [[Motion<D, P>; 2]; 9],
    /// A, B of A⊗B.
    pub moment: [[Motion<D, P>; 2]; 2],
}

impl<const D: usize, const P: usize> Default for Motion<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            position: [0.0; D],
            turning: [[0.0; D]; P],
            bending: [[0.0; D]; P],
            third: [[0.0; D]; P],
        }
    }
}

impl<const D: usize, const P: usize> Default for RollingForce<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            share: [0.0; 2],
            explicit: Motion::default(),
        }
    }
}

impl<const D: usize, const P: usize> Default for RollingCoefficients<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            symmetric: [[Motion::default(); 2]; 9],
            moment: [[Motion::default(); 2]; 2],
        }
    }
}

/// The rows that a [`Motion`] multiplies.
pub(crate) struct MotionRows<'a, const P: usize, const H: usize> {
    pub(crate) rows: &'a Rows<'a, P>,
    pub(crate) second: &'a [&'a mut [f64]; H],
    pub(crate) third: &'a [&'a mut [f64]; P],
}

impl<const P: usize, const H: usize> MotionRows<'_, P, H> {
    /// Entry (node, component) of a form.
    #[inline(always)]
    pub(crate) fn entry<const D: usize>(&self, form: &Motion<D, P>, (a, k): (usize, usize)) -> f64 {
        let at = |row: &[f64]| row.get(a).copied().unwrap_or(0.0);
        let mut sum = at(self.rows.s) * form.position[k];
        for i in 0..P {
            sum += at(self.rows.ds[i]) * form.turning[i][k] + at(self.third[i]) * form.third[i][k];
            // 11 and 22 in the order 11, 12, 22
            if let Some(second) = self.second.get(2 * i) {
                sum += at(second) * form.bending[i][k];
            }
        }
        sum
    }
}

impl<const D: usize, const P: usize> Motion<D, P> {
    /// self + factor·other
    #[inline(always)]
    fn add(&mut self, factor: f64, other: &Self) {
        for k in 0..D {
            self.position[k] += factor * other.position[k];
            for i in 0..P {
                self.turning[i][k] += factor * other.turning[i][k];
                self.bending[i][k] += factor * other.bending[i][k];
                self.third[i][k] += factor * other.third[i][k];
            }
        }
    }

    #[inline(always)]
    pub(crate) fn is_finite(&self) -> bool {
        let rows = self.turning.iter().chain(&self.bending).chain(&self.third);
        let mut entries = rows.chain([&self.position]).flatten();
        entries.all(|&entry| abs(entry) <= f64::MAX)
    }
}

impl<const D: usize, const P: usize> RollingCoefficients<D, P> {
    /// A row of K is itself a form: Σ A(unknown) B + B(unknown) A.
    #[inline(always)]
    pub(crate) fn row(&self, at: impl Fn(&Motion<D, P>) -> f64) -> Motion<D, P> {
        let mut whole = Motion::default();
        for [left, right] in &self.symmetric {
            whole.add(at(left), right);
            whole.add(at(right), left);
        }
        for [left, right] in &self.moment {
            whole.add(at(left), right);
        }
        whole
    }
}

/// Where the parameters of rolling begin in an element's list.
#[derive(Clone, Copy, Debug)]
pub struct RollingLayout {
    /// Law.
    pub law: usize,
    /// Directors, slave first; `None` with principal normals.
    pub directors: Option<usize>,
}

/// Angles about both curves.
#[derive(Clone, Copy, Debug, Default)]
pub struct RollingAngles {
    /// φ_c in (−π, π] [rad].
    pub angle: [f64; 2],
    /// Square of the part of the reference direction across the curve, relative to the whole.
    pub share: [f64; 2],
    /// Length of that part over that of the tangent: how fast the curve turns with its parameter.
    pub bend: [f64; 2],
}

/// Angles and moments of a closed point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rolling {
    /// φ_c [rad]
    pub angle: [f64; 2],
    /// M_c
    pub moment: [f64; 2],
    /// ∂M_c/∂φ_c
    pub stiffness: [f64; 2],
    /// ∂M_c/∂p
    pub by_pressure: [f64; 2],
    /// φ0_c for the next step [rad].
    pub anchor: [f64; 2],
    /// Path of each angle for the next step [rad].
    pub path: [f64; 2],
    /// Which curves roll: 1 for the first, 2 for the second, 3 for both.
    pub regime: f64,
}
