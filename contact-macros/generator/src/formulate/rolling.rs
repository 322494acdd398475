//! The programs of moments about two curves.

use super::geometry::FormulatedGeometry;
use super::routine::Routine;
use crate::linearise::rolling::curves::Curves;
use crate::linearise::rolling::{angle, residual, tangent};
use crate::linearise::shared::Kinematics;
use crate::model::{Element, Reference};

/// Angles, residual and tangent of the moments.
pub struct RollingPrograms {
    /// The angles about both curves.
    pub angle: Routine,
    /// The residual.
    pub residual: Routine,
    /// The tangent, unless the element has a residual only.
    pub tangent: Option<Routine>,
    /// What the angles are measured from.
    pub reference: Reference,
}

impl RollingPrograms {
    /// The programs of `element`; `None` where its curves roll freely.
    pub fn new(
        element: &Element,
        kinematics: &Kinematics,
        slave: Option<&FormulatedGeometry>,
        master: Option<&FormulatedGeometry>,
    ) -> Option<Self> {
        let reference = element.rolling.as_ref()?.reference;
        let curves = Curves {
            reference,
            third: [slave?, master?].map(FormulatedGeometry::has_third),
        };
        let tangent = (!element.residual_only)
            .then(|| Routine::shared(&tangent::tangent_program(kinematics, curves)));
        Some(Self {
            angle: Routine::shared(&angle::angle_program(reference)),
            residual: Routine::shared(&residual::residual_program(kinematics, curves)),
            tangent,
            reference,
        })
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        [&self.angle, &self.residual]
            .into_iter()
            .chain(&self.tangent)
    }
}
