//! Normal law of one contact point.

use crate::lanes::Real;

/// Largest N, N' and W [as declared]: ½ ε g² at the largest accepted ε and g. Products of larger values would
/// overflow, even those that no output needs.
pub(crate) const LARGEST_VALUE: f64 = 1e90;

/// N, N' and W of a normal law at one gap.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traction<T = f64> {
    /// N = W', negative in contact.
    pub traction: T,
    /// N'
    pub slope: T,
    /// W; 0 if the law declares no energy.
    pub energy: T,
}

/// Normal law N(g; parameters). [eq:law]
pub trait NormalLaw {
    /// Number of parameters.
    const PARAMETERS: usize;
    /// True where the law declares its energy.
    const ENERGY: bool;
    /// True where the law acts below some gap, false where above.
    const CLOSES_BELOW: bool;
    /// Positive where the law acts.
    fn active<T: Real>(gap: T, parameters: &[T]) -> T;
    /// Positive where the law is defined.
    fn valid<T: Real>(gap: T, parameters: &[T]) -> T;
    /// N, N', W.
    fn evaluate<T: Real>(gap: T, parameters: &[T]) -> Traction<T>;
}
