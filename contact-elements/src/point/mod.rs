//! The numbers of one contact point: kinematics, projection, laws, history. No nodes of a mesh, no outputs.

pub(crate) mod blend;
pub(crate) mod domain;
pub(crate) mod enforcement;
pub(crate) mod friction;
pub(crate) mod history;
pub(crate) mod kinematics;
pub(crate) mod law;
pub(crate) mod motion;
pub(crate) mod placement;
pub(crate) mod projection;
pub(crate) mod shape;
pub(crate) mod state;
pub(crate) mod tangent_plane;
pub(crate) mod tangential;
pub(crate) mod values;
