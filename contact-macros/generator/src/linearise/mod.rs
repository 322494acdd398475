//! The hand-derived covariant forms: one function per term, each tagged with its equation.
//!
//! Input: the checked model. Output: programs of one contact point. Nothing here differentiates an
//! energy; only declared shape functions, rigid geometries, distance functions and laws are
//! differentiated, because their derivatives are what the closed forms are written in.
//!
//! | file | program | equations |
//! |---|---|---|
//! | `shared/geometry` | shape rows, rigid positions and their derivatives, closed projections | declared |
//! | `shared/lower` | declared expressions | – |
//! | `shared/basis` | orthogonal tangents | [eq:orthogonal-basis] |
//! | `shared/measure` | Jacobian of the slave and its variation | [eq:measure] |
//! | `normal/gap` | normal, distance, gap | [eq:2-normal] [eq:gap] |
//! | `normal/law` | N, N', W of a normal law | [eq:law] |
//! | `normal/tangent` | coefficients of the tangent | [eq:12-main] [eq:13-curvature] … |
//! | `normal/distance` | gap and tangent of a rigid distance function | [eq:distance] |
//! | `tangential/frame` | orthonormal frame and slip | [eq:frame] [eq:slip] |
//! | `tangential/law` | stiffness, bound, return to the bound | [eq:trial] [eq:return-map] [eq:ellipse] |
//! | `tangential/point`, `tangential/form` | the contact point in that frame, and linear forms over its motion | [eq:F] [eq:variation] |
//! | `tangential/residual` | residual of tangential contact | [eq:tangential-residual] |
//! | `tangential/tangent` | its tangent | [eq:tangential-tangent] [eq:via-surface] [eq:via-curve] |
//! | `rolling/angle` | angles about two curves | [eq:rolling-angle] |
//! | `rolling/curves`, `rolling/form` | the two curves, and linear forms over their motion | [eq:rolling-angle] |
//! | `rolling/residual` | residual of the moments | [eq:rolling-residual] |
//! | `rolling/tangent` | their tangent | [eq:rolling-tangent] |
//! | `angle/weight` | weight by the angle of two curves | [eq:angle-window] [eq:angle-weight] |
//! | `angle/pair` | the two curves and the variation of their projection | [eq:F] [eq:variation] |
//! | `angle/residual` | share of the weight in the residual | [eq:angle-residual] |
//! | `angle/tangent` | share of the weight in the tangent | [eq:angle-tangent] |

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

pub mod angle;
pub mod normal;
pub mod rolling;
pub mod shared;
pub mod tangential;
