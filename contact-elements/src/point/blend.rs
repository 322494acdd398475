//! Contributions of the weight by the angle of two curves to a contact point.

use crate::arithmetic::abs;

/// Pairs of forms of the tangent, see [`AngleCoefficients`].
const PAIRS: usize = 12;

/// Values of the law before the weight, and how the weight changes with q = sin²θ.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blend {
    /// w' = dw/dq
    pub slope: f64,
    /// w''
    pub curvature: f64,
    /// N
    pub traction: f64,
    /// W
    pub energy: f64,
}

impl Blend {
    /// The weight changes with the angle here.
    #[inline(always)]
    pub(crate) fn changes(&self) -> bool {
        abs(self.slope) > 0.0 || abs(self.curvature) > 0.0
    }
}

/// A linear form over the unknowns of two curves.
#[derive(Clone, Copy, Debug)]
pub struct AngleForm<const D: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies N_A,1 of slave and master.
    pub turning: [[f64; D]; 2],
    /// Multiplies N_A,11 of slave and master.
    pub bending: [[f64; D]; 2],
}

impl<const D: usize> Default for AngleForm<D> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            position: [0.0; D],
            turning: [[0.0; D]; 2],
            bending: [[0.0; D]; 2],
        }
    }
}

/// Pairs A, B of A⊗B + B⊗A.
#[derive(Clone, Copy, Debug)]
pub struct AngleCoefficients<const D: usize>(pub [[AngleForm<D>; 2]; PAIRS]);

impl<const D: usize> Default for AngleCoefficients<D> {
    #[inline(always)]
    fn default() -> Self {
        Self([[AngleForm::default(); 2]; PAIRS])
    }
}

/// s_A and the rows of both curves, in the order of a form; empty where a curve is not projected.
pub(crate) struct FormRows<'a>(pub(crate) [&'a [f64]; 5]);

impl<const D: usize> AngleForm<D> {
    /// The vectors in the order of [`FormRows`].
    #[inline(always)]
    fn vectors(&self) -> [&[f64; D]; 5] {
        let [slave, master] = &self.turning;
        let [bend, other] = &self.bending;
        [&self.position, slave, master, bend, other]
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        let [slave, master] = &mut self.turning;
        let [bend, last] = &mut self.bending;
        let own = [&mut self.position, slave, master, bend, last];
        for (to, from) in own.into_iter().zip(other.vectors()) {
            for k in 0..D {
                to[k] += factor * from[k];
            }
        }
    }
}

impl FormRows<'_> {
    /// Entry (node, component) of a form.
    #[inline(always)]
    pub(crate) fn entry<const D: usize>(&self, form: &AngleForm<D>, (a, k): (usize, usize)) -> f64 {
        let mut sum = 0.0;
        for (row, vector) in self.0.iter().zip(form.vectors()) {
            sum += row.get(a).copied().unwrap_or(0.0) * vector[k];
        }
        sum
    }
}
