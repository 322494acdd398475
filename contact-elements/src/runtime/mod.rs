//! What the emitted code calls: kinematics, projection, contraction and the driver of an element.
//!
//! | level | start here |
//! |---|---|
//! | 1 contact point: kinematics in, coefficients out, no nodes | [`Element::gap`], [`Element::tangent`] |
//! | 2 contraction with shape rows given at run time | [`contract`] |
//! | 3 element | [`evaluate`] |

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

mod classify;
mod constrained;
mod contraction;
mod driver;
mod element;
mod kernel;
mod kinematics;
mod placement;
mod projection;
mod receiver;
mod shape;
mod values;

pub use contraction::{Temporaries, contract};
pub use driver::{Stage, evaluate};
pub use element::{Element, Layout, Search, can_divide};
pub(crate) use kernel::is_usable;
pub use kernel::{Coordinates, InputError, Nodes, fixed, interpolated, workspace};
pub use kinematics::{
    curve_to_curve, curve_to_rigid, onto_point, onto_rigid, onto_shape, slave_point,
    slave_tangents, spread_variation,
};
pub use placement::Placement;
pub use projection::{Projected, project};
pub use receiver::{Call, Failure, Receiver, Report, Summary, Wanted};
pub use shape::{Distance, Domain, NormalLaw, Rigid, Shape, Traction};
pub use values::{Coefficients, Gap, Measure, Rows, ShapeRows, Status, Vectors, dot};
