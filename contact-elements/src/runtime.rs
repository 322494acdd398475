//! What emitted code calls: the one public door to kinematics, projection, contraction and the driver of an element.
//! Nothing inside the crate imports through it.
//!
//! | level | start here |
//! |---|---|
//! | 1 contact point: kinematics in, coefficients out, no nodes | [`Element::gap`], [`Element::tangent`] |
//! | 2 contraction with shape rows given at run time | [`contract`] |
//! | 3 element | [`evaluate`] |

pub use crate::batch::block::ROOM;
pub use crate::batch::contacts::{AllPlaces, Contacts, Places};
pub use crate::batch::dispatch::{evaluate_batch, one_by_one};
pub use crate::batch::screen::{SCREENED, is_screened, screen};
pub use crate::element::contraction::{NormalContraction, contract};
pub use crate::element::driver::evaluate;
pub use crate::element::gather::{Coordinates, Nodes};
pub use crate::element::kernel::{fixed, interpolated, workspace};
pub use crate::element::receiver::{
    Call, Failure, InputError, OUTPUT_SIZE, Receiver, Report, Summary, Wanted, Write,
};
pub use crate::element::stage::{Stage, TangentialRows, Temporaries};
pub use crate::element::tangential_contraction::{Shares, contract_sliding};
pub use crate::element::traits::{Element, Layout, Search, can_divide};
pub use crate::lanes::{Real, Width};
pub use crate::point::blend::{AngleCoefficients, AngleForm, Blend};
pub use crate::point::domain::Domain;
pub use crate::point::friction::{Friction, Frictionless, Tangential, TangentialLaw, return_map};
pub use crate::point::history::{History, HistoryLayout, Reach};
pub use crate::point::kinematics::{
    curve_to_curve, curve_to_curve_higher, curve_to_curve_third, curve_to_rigid,
    curve_to_rigid_higher, onto_point, onto_rigid, onto_rigid_higher, onto_shape,
    onto_shape_higher, slave_point, slave_tangents, spread_variation,
};
pub use crate::point::law::{NormalLaw, Traction};
pub use crate::point::motion::{
    Motion, Rolling, RollingAngles, RollingCoefficients, RollingForce, RollingLayout,
};
pub use crate::point::placement::Placement;
pub use crate::point::projection::foot::Projected;
pub use crate::point::projection::newton::project;
pub use crate::point::shape::{Distance, Rigid, Shape};
pub use crate::point::tangent_plane::TangentPlane;
pub use crate::point::tangential::{
    ForceChange, SecondVariation, TangentialCoefficients, TangentialForce, Variation,
};
pub use crate::point::values::{
    Coefficients, Enforcement, Frame, Gap, Measure, Rows, ShapeRows, Status, Vectors, dot,
};
