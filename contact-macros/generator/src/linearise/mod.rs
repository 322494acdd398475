//! The hand-derived covariant forms: one function per term, each tagged with its equation.
//!
//! Input: the checked model. Output: programs of one contact point. Nothing here differentiates an
//! energy; only declared shape functions, rigid geometries, distance functions and laws are
//! differentiated, because their derivatives are what the closed forms are written in.
//!
//! | file | program | equations |
//! |---|---|---|
//! | `geometry` | shape rows, rigid positions and their derivatives, closed projections | declared |
//! | `gap` | normal, distance, gap | [eq:2-normal] [eq:gap] |
//! | `normal` | coefficients of the tangent | [eq:12-main] [eq:13-curvature] … |
//! | `basis` | orthogonal tangents | [eq:orthogonal-basis] |
//! | `distance` | gap and tangent of a rigid distance function | [eq:distance] |
//! | `law` | N, N', W of a normal law | [eq:law] |
//! | `frame` | orthonormal frame and slip | [eq:frame] [eq:slip] |
//! | `sliding` | stiffness, bound, return to the bound | [eq:trial] [eq:return-map] [eq:ellipse] |
//! | `tangential` | residual and tangent of tangential contact | [eq:tangential-residual] [eq:tangential-tangent] [eq:via-surface] [eq:via-curve] |
//! | `contact` | the contact point and its slip in that frame, for `tangential` | [eq:F] |
//! | `rolling` | angles about two curves, residual of their moments | [eq:rolling-angle] [eq:rolling-residual] |
//! | `turning` | tangent of those moments | [eq:rolling-tangent] |
//! | `curves` | the two curves, for `rolling` and `turning` | [eq:rolling-angle] |
//! | `motion` | linear forms in which `turning` and `angle_tangent` are written | – |
//! | `angle` | weight by the angle of two curves, its share of the residual | [eq:angle-window] [eq:angle-weight] [eq:angle-residual] |
//! | `angle_tangent` | its share of the tangent | [eq:angle-tangent] |
//! | `row` | linear forms in which `tangential` is written | – |
//! | `measure` | Jacobian of the slave and its variation | [eq:measure] |

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

pub mod angle;
pub mod angle_tangent;
mod basis;
mod contact;
mod curves;
pub mod distance;
pub mod frame;
pub mod gap;
pub mod geometry;
pub mod law;
pub mod measure;
mod motion;
pub mod normal;
pub mod rolling;
mod row;
pub mod sliding;
pub mod tangential;
pub mod turning;

use crate::model::{Gap, Linearisation};

/// What the closed forms need to know about a pair.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// Space dimension, 2 or 3.
    pub dimension: usize,
    /// Which relative positions move with the projected parameter i: r_,i has a shape row (false for
    /// the parameters of a rigid master). Its length is the number of projected parameters.
    pub moving: Vec<bool>,
    /// Which second derivatives r_,11 r_,12 r_,22 can be non-zero.
    pub curved: Vec<bool>,
    /// Which third derivatives r_,111 r_,112 r_,122 r_,222 can be non-zero.
    pub third: Vec<bool>,
    /// How the gap is measured.
    pub gap: Gap,
    /// Which form of the tangent.
    pub linearisation: Linearisation,
}

impl Kinematics {
    /// Number of projected parameters.
    pub fn projected(&self) -> usize {
        self.moving.len()
    }

    /// Directions that are neither normal nor tangential.
    pub fn complement(&self) -> usize {
        self.dimension - 1 - self.projected()
    }
}

/// Number of second derivatives of `p` parameters.
pub fn second_derivatives(p: usize) -> usize {
    p * (p + 1) / 2
}

/// Number of third derivatives of `p` parameters; i + j + k is the position of one.
pub fn third_derivatives(p: usize) -> usize {
    if p == 0 { 0 } else { 3 * p - 2 }
}

/// Position of the pair i, j in the order 11, 12, 22.
pub fn pair_index(i: usize, j: usize) -> usize {
    i + j
}
