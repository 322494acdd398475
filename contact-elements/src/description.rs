//! An element as declared: what a verifier knows of it.

use crate::element::traits::Layout;
use crate::registered::Registered;
use crate::table::{
    AngleDescription, AxisDescription, ElementPrograms, LawPrograms, MasterDescription,
    RollingDescription, SlaveDescription, TangentialLawPrograms,
};

/// An element as declared, with its programs.
#[derive(Clone, Copy, Debug)]
pub struct ElementDescription {
    /// Name.
    pub name: &'static str,
    /// The element itself with its kernels.
    pub descriptor: &'static Registered,
    /// Its own programs.
    pub programs: &'static ElementPrograms,
    /// Slave.
    pub slave: SlaveDescription,
    /// Master.
    pub master: MasterDescription,
    /// Normal law.
    pub law: &'static LawPrograms,
    /// Tangential law; `None` if frictionless.
    pub tangential: Option<&'static TangentialLawPrograms>,
    /// First axis of an orthotropic tangential law.
    pub axis: AxisDescription,
    /// Moments about two curves; `None` if they roll freely.
    pub rolling: Option<&'static RollingDescription>,
    /// Weight by the angle of two curves; `None` for any angle.
    pub angle: Option<&'static AngleDescription>,
    /// True where a rigid geometry is placed by parameters.
    pub placed: bool,
    /// True for a gap with a sign.
    pub signed: bool,
    /// True for the linearisation on the tangent plane.
    pub tangent_plane: bool,
    /// True for the current measure.
    pub current: bool,
    /// False where no unknown turns the tangents.
    pub moving: bool,
    /// Parameter list.
    pub layout: Layout,
}
