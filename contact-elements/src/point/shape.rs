//! The traits that the macro implements for the items of a declaration.

use crate::lanes::Real;
use crate::point::domain::Domain;
use crate::point::values::{ShapeRows, Vectors};

/// Curve (P = 1) or surface (P = 2) by N shape functions.
pub trait Shape<const P: usize, const H: usize, const N: usize> {
    /// Parameter domain.
    const DOMAIN: Domain;
    /// True where all second derivatives vanish: the projection is one linear solve.
    const AFFINE: bool;
    /// Number of weights of a rational geometry, else 0.
    const WEIGHTS: usize;
    /// Controls that are tangent vectors, not positions.
    const VECTORS: [bool; N];
    /// False where the N_A,ij vanish identically.
    const CURVED: [bool; H];
    /// N_A, N_A,i, N_A,ij.
    fn rows<T: Real>(zeta: &[T; P], weights: &[T]) -> ShapeRows<P, H, N, T>;
    /// N_A,111, N_A,112, N_A,122, N_A,222; a curve has the first only.
    fn third(zeta: &[f64; P], weights: &[f64]) -> [[f64; N]; 4];
}

/// Rigid curve or surface ρ(ζ; parameters).
pub trait Rigid<const D: usize, const P: usize, const H: usize> {
    /// Parameter domain.
    const DOMAIN: Domain;
    /// True where all second derivatives vanish.
    const AFFINE: bool;
    /// ρ, ρ_i, ρ_ij as the `r`, `b`, `second` of a position.
    fn position<T: Real>(zeta: &[T; P], parameters: &[T]) -> Vectors<D, P, H, T>;
    /// ρ_,111, ρ_,112, ρ_,122, ρ_,222; a curve has the first only.
    fn third(zeta: &[f64; P], parameters: &[f64]) -> [[f64; D]; 4];
    /// Closed projection of the point x, where declared.
    fn projection(x: &[f64; D], parameters: &[f64]) -> Option<[f64; P]>;
}

/// Rigid distance function d(x; parameters) of D coordinates. Its programs belong to the element.
pub trait Distance<const D: usize> {}
