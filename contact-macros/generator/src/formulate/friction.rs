//! The programs of tangential contact.

use super::rolling::RollingPrograms;
use super::routine::Routine;
use crate::linearise::shared::Kinematics;
use crate::linearise::tangential::{frame, residual, tangent};
use crate::model::{Axis, Element, Measure};

/// Frame, residual and tangent of tangential contact, and what comes with rolling.
pub struct FrictionPrograms {
    /// Frame and slip.
    pub frame: Routine,
    /// The residual.
    pub residual: Routine,
    /// The tangent, unless the element has a residual only.
    pub tangent: Option<Routine>,
    /// The programs of the moments.
    pub rolling: Option<RollingPrograms>,
    /// The first axis of an orthotropic law.
    pub axis: Option<Axis>,
    /// Whether the tangent joins the matrix p of the normal one: where no unknown turns the tangents, no
    /// axis moves with the slave and no measure with the point.
    pub merges_with_normal: bool,
}

impl FrictionPrograms {
    /// The programs of `element`; `None` for a frictionless one.
    pub fn new(
        element: &Element,
        kinematics: &Kinematics,
        rolling: Option<RollingPrograms>,
    ) -> Option<Self> {
        let axis = element.tangential.as_ref()?.axis;
        let rolls = element.rolling.is_some();
        let tangent = (!element.residual_only)
            .then(|| Routine::shared(&tangent::tangent_program(kinematics, axis, rolls)));
        let moving = kinematics.moving.contains(&true);
        Some(Self {
            frame: Routine::shared(&frame::frame_program(kinematics, axis)),
            residual: Routine::shared(&residual::residual_program(kinematics)),
            tangent,
            rolling,
            axis,
            merges_with_normal: !moving
                && axis != Some(Axis::Slave)
                && element.measure != Measure::Current,
        })
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        [&self.frame, &self.residual]
            .into_iter()
            .chain(&self.tangent)
            .chain(self.rolling.iter().flat_map(RollingPrograms::routines))
    }
}
