//! Values that travel between the stages. D: space dimension, P: projected parameters, H = P(P+1)/2,
//! T: one number or several side by side.

use crate::arithmetic::abs;
use crate::lanes::Real;

/// Outcome of one contact point. The numbers are those of `CTE_STATUS_*`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(i32)]
pub enum Status {
    /// No contact.
    Open = 0,
    /// In contact, without friction.
    Closed = 1,
    /// In contact, sticking.
    Stick = 2,
    /// In contact, sliding.
    Slip = 3,
    /// The projection lies beyond the master's edge or vertex.
    Outside = 4,
    /// The projection did not converge.
    NotConverged = 5,
    /// The projection is not unique: F singular or indefinite, tangents parallel.
    NotUnique = 6,
    /// Zero area or length, or L = 0 in codimension 2 or 3.
    Degenerate = 7,
    /// The gap is outside the law's domain.
    Law = 8,
}

impl Status {
    /// The status with this number, as a history holds it.
    pub fn of_number(number: f64) -> Option<Self> {
        let all = [
            Self::Open,
            Self::Closed,
            Self::Stick,
            Self::Slip,
            Self::Outside,
            Self::NotConverged,
            Self::NotUnique,
            Self::Degenerate,
            Self::Law,
        ];
        all.into_iter()
            .find(|&status| f64::from(status as i32) == number)
    }

    /// True for a point that carries load.
    #[inline(always)]
    pub fn is_closed(self) -> bool {
        matches!(self, Status::Closed | Status::Stick | Status::Slip)
    }

    /// Order in which the status of an element is chosen: open, outside, closed or sticking, sliding, then
    /// the failures.
    #[inline]
    pub fn rank(self) -> i32 {
        match self {
            Status::Open => 0,
            Status::Outside => 1,
            Status::Closed | Status::Stick => 2,
            Status::Slip => 3,
            failure => failure as i32,
        }
    }
}

/// Shape functions and their derivatives at one point, orders 0, 1 and 2 (11, 12, 22).
#[derive(Clone, Copy, Debug)]
pub struct ShapeRows<const P: usize, const H: usize, const N: usize, T = f64> {
    /// N_A
    pub n: [T; N],
    /// N_A,i
    pub d1: [[T; N]; P],
    /// N_A,ij
    pub d2: [[T; N]; H],
}

/// Rows s_A and s_A,i of the relative position r = Σ s_A x_A over all nodes of the element.
#[derive(Debug)]
pub struct Rows<'a, const P: usize, T = f64> {
    /// s_A: + on the slave, − on the master.
    pub s: &'a mut [T],
    /// s_A,i
    pub ds: [&'a mut [T]; P],
}

impl<const P: usize, T> Rows<'_, P, T> {
    /// The same rows. Made where a call needs them: it then knows that nothing else writes to what they refer to.
    #[inline(always)]
    pub(crate) fn reborrow(&mut self) -> Rows<'_, P, T> {
        Rows {
            s: &mut *self.s,
            ds: self.ds.each_mut().map(|row| &mut **row),
        }
    }
}

/// r, b_i = r_,i and r_,ij at one contact point.
#[derive(Clone, Copy, Debug)]
pub struct Vectors<const D: usize, const P: usize, const H: usize, T = f64> {
    /// Relative position: slave minus master [length].
    pub r: [T; D],
    /// b_i
    pub b: [[T; D]; P],
    /// r_,11 r_,12 r_,22
    pub second: [[T; D]; H],
}

impl<const D: usize, const P: usize, const H: usize, T: Real> Default for Vectors<D, P, H, T> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            r: [T::constant(0.0); D],
            b: [[T::constant(0.0); D]; P],
            second: [[T::constant(0.0); D]; H],
        }
    }
}

/// Normal, distance and gap. [eq:gap]
#[derive(Clone, Copy, Debug)]
pub struct Gap<const D: usize, T = f64> {
    /// Unit normal.
    pub n: [T; D],
    /// L, with a sign in codimension one [length].
    pub distance: T,
    /// g = L − r0, negative when penetrating [length].
    pub gap: T,
}

impl<const D: usize, T: Real> Default for Gap<D, T> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            n: [T::constant(0.0); D],
            distance: T::constant(0.0),
            gap: T::constant(0.0),
        }
    }
}

/// Slip since the anchor in the orthonormal frame of the contact point. [eq:frame] [eq:slip]
#[derive(Clone, Copy, Debug)]
pub struct Frame<const P: usize> {
    /// s_q [length]
    pub s: [f64; P],
    /// E^i_q: e_q = E^i_q b_i.
    pub e: [[f64; P]; P],
    /// Square of the axis' part in the tangent plane, relative to the whole; 1 without axis.
    pub share: f64,
}

impl<const P: usize> Default for Frame<P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            s: [0.0; P],
            e: [[0.0; P]; P],
            share: 1.0,
        }
    }
}

/// The small matrices of the tangent of one contact point, see [`contract`](crate::element::contraction::contract).
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<const D: usize, const P: usize, T = f64> {
    /// Multiplies s_A s_B.
    pub p: [[T; D]; D],
    /// Multiplies s_A s_B,j with n on the right.
    pub right: [[T; D]; P],
    /// Multiplies s_A,j s_B with n on the left.
    pub left: [[T; D]; P],
    /// Multiplies s_A,i s_B,j n⊗n.
    pub s: [[T; P]; P],
}

impl<const D: usize, const P: usize, T: Real> Default for Coefficients<D, P, T> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            p: [[T::constant(0.0); D]; D],
            right: [[T::constant(0.0); D]; P],
            left: [[T::constant(0.0); D]; P],
            s: [[T::constant(0.0); P]; P],
        }
    }
}

/// Integration weight times Jacobian of one point, and the rows of its variation where the measure
/// moves: ∂J/∂t_i (zero for the reference measure).
#[derive(Clone, Copy, Debug)]
pub struct Measure<const D: usize> {
    /// w J
    pub weight: f64,
    /// w ∂J/∂t_i
    pub variation: [[f64; D]; 2],
}

impl<const D: usize> Default for Measure<D> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            weight: 1.0,
            variation: [[0.0; D]; 2],
        }
    }
}

/// a·b
#[inline(always)]
pub fn dot<const D: usize, T: Real>(a: &[T; D], b: &[T; D]) -> T {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum = sum + a[k] * b[k];
    }
    sum
}

/// |r| is zero to rounding.
#[inline(always)]
pub(crate) fn is_zero<const D: usize>(r: &[f64; D], scale: f64) -> bool {
    r.iter()
        .all(|&component| abs(component) <= (8.0 * f64::EPSILON * scale).max(1e-30))
}

/// How the normal law holds the bodies apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enforcement {
    /// The law alone.
    Penalty,
    /// The law and a multiplier that the history carries.
    Augmented,
    /// The law and a multiplier that is an unknown.
    Multiplier,
}
