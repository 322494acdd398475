//! Values that travel between the stages. D: space dimension, P: projected parameters, H = P(P+1)/2.

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
pub struct ShapeRows<const P: usize, const H: usize, const N: usize> {
    /// N_A
    pub n: [f64; N],
    /// N_A,i
    pub d1: [[f64; N]; P],
    /// N_A,ij
    pub d2: [[f64; N]; H],
}

/// Rows s_A and s_A,i of the relative position r = Σ s_A x_A over all nodes of the element.
#[derive(Debug)]
pub struct Rows<'a, const P: usize> {
    /// s_A: + on the slave, − on the master.
    pub s: &'a mut [f64],
    /// s_A,i
    pub ds: [&'a mut [f64]; P],
}

/// r, b_i = r_,i and r_,ij at one contact point.
#[derive(Clone, Copy, Debug)]
pub struct Vectors<const D: usize, const P: usize, const H: usize> {
    /// Relative position: slave minus master [length].
    pub r: [f64; D],
    /// b_i
    pub b: [[f64; D]; P],
    /// r_,11 r_,12 r_,22
    pub second: [[f64; D]; H],
}

impl<const D: usize, const P: usize, const H: usize> Default for Vectors<D, P, H> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            r: [0.0; D],
            b: [[0.0; D]; P],
            second: [[0.0; D]; H],
        }
    }
}

/// Normal, distance and gap. [eq:gap]
#[derive(Clone, Copy, Debug)]
pub struct Gap<const D: usize> {
    /// Unit normal.
    pub n: [f64; D],
    /// L, with a sign in codimension one [length].
    pub distance: f64,
    /// g = L − r0, negative when penetrating [length].
    pub gap: f64,
}

impl<const D: usize> Default for Gap<D> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            n: [0.0; D],
            distance: 0.0,
            gap: 0.0,
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

/// The small matrices of the tangent of one contact point, see [`contract`](super::contract).
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<const D: usize, const P: usize> {
    /// Multiplies s_A s_B.
    pub p: [[f64; D]; D],
    /// Multiplies s_A s_B,j with n on the right.
    pub right: [[f64; D]; P],
    /// Multiplies s_A,j s_B with n on the left.
    pub left: [[f64; D]; P],
    /// Multiplies s_A,i s_B,j n⊗n.
    pub s: [[f64; P]; P],
}

impl<const D: usize, const P: usize> Default for Coefficients<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            p: [[0.0; D]; D],
            right: [[0.0; D]; P],
            left: [[0.0; D]; P],
            s: [[0.0; P]; P],
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
pub fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum += a[k] * b[k];
    }
    sum
}
