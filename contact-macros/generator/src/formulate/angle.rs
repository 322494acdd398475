//! The programs of the weight by the angle of two curves.

use super::geometry::FormulatedGeometry;
use super::routine::Routine;
use crate::linearise::angle::pair::Bends;
use crate::linearise::angle::{residual, tangent, weight};
use crate::linearise::shared::Kinematics;
use crate::model::{Angle, Element};

/// Largest number of pairs of forms that the tangent gives.
pub const MOST_PAIRS: usize = tangent::pairs(2);

/// Position in the window, weight, and the weight's share of residual and tangent.
pub struct AnglePrograms {
    /// Where the angle lies in the window.
    pub position: Routine,
    /// The weight and its slopes.
    pub weight: Routine,
    /// Share of the residual.
    pub residual: Routine,
    /// Share of the tangent, unless the element has a residual only.
    pub tangent: Option<Routine>,
    /// At which angles the contact acts.
    pub acts_at: Angle,
    /// Number of pairs of forms that the tangent gives.
    pub pairs: usize,
}

impl AnglePrograms {
    /// The programs of `element`; `None` where it acts at any angle.
    pub fn new(
        element: &Element,
        kinematics: &Kinematics,
        slave: Option<&FormulatedGeometry>,
        master: Option<&FormulatedGeometry>,
    ) -> Option<Self> {
        let acts_at = element.angle?;
        let bends = Bends {
            kinematics: kinematics.clone(),
            third: [slave?, master?].map(FormulatedGeometry::has_third),
        };
        let tangent =
            (!element.residual_only).then(|| Routine::new(&tangent::tangent_program(&bends)));
        Some(Self {
            position: Routine::new(&weight::position_program(acts_at)),
            weight: Routine::new(&weight::weight_program()),
            residual: Routine::new(&residual::residual_program(&bends)),
            tangent,
            acts_at,
            pairs: tangent::pairs(kinematics.projected()),
        })
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        [&self.position, &self.weight, &self.residual]
            .into_iter()
            .chain(&self.tangent)
    }
}
