//! What the emitted code calls: kinematics, projection, contraction and the driver of an element.
//!
//! | level | start here |
//! |---|---|
//! | 1 contact point: kinematics in, coefficients out, no nodes | [`Element::gap`], [`Element::tangent`] |
//! | 2 contraction with shape rows given at run time | [`contract`] |
//! | 3 element | [`evaluate`] |

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

mod angle;
mod batch;
mod classify;
mod constrained;
mod contraction;
mod driver;
mod element;
mod enforcement;
mod extent;
mod friction;
mod gather;
mod history;
mod kernel;
mod kinematics;
mod lanes;
mod motion;
mod newton_step;
mod placement;
mod projection;
mod real;
mod receiver;
mod rolling;
mod rows;
mod shape;
mod side;
mod sliding;
mod tangential;
mod tangential_contraction;
mod transfer;
mod values;

pub use angle::{AngleCoefficients, AngleForm, Blend};
pub use batch::{
    AllPlaces, Contacts, Places, ROOM, SCREENED, Width, evaluate_batch, is_screened, one_by_one,
    screen,
};
pub use contraction::{Temporaries, contract};
pub use driver::{Stage, evaluate};
pub use element::{Element, Layout, Search, can_divide};
pub use enforcement::Enforcement;
pub use friction::{Friction, Frictionless, Tangential, TangentialLaw, return_map};
pub(crate) use gather::is_usable;
pub use gather::{Coordinates, Nodes};
pub use history::{History, HistoryLayout};
pub use kernel::{InputError, fixed, interpolated, workspace};
pub(crate) use kernel::{can_be_anchor, can_be_projection, is_status};
pub use kinematics::{
    curve_to_curve, curve_to_curve_higher, curve_to_curve_third, curve_to_rigid,
    curve_to_rigid_higher, onto_point, onto_rigid, onto_rigid_higher, onto_shape,
    onto_shape_higher, slave_point, slave_tangents, spread_variation,
};
pub use motion::{Motion, RollingCoefficients, RollingForce};
pub use placement::Placement;
pub use projection::{Projected, project};
pub use real::Real;
pub use receiver::{Call, Failure, Receiver, Report, Summary, Wanted};
pub(crate) use rolling::is_remembered;
pub use rolling::{Rolling, RollingAngles, RollingLayout};
pub use shape::{Distance, Domain, NormalLaw, Rigid, Shape, Traction};
pub(crate) use side::is_side;
pub use tangential::{
    ForceChange, SecondVariation, TangentialCoefficients, TangentialForce, TangentialRows,
    Variation,
};
pub use tangential_contraction::{Shares, contract_sliding};
pub use transfer::TangentPlane;
pub use values::{Coefficients, Frame, Gap, Measure, Rows, ShapeRows, Status, Vectors, dot};
