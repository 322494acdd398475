//! The elements under test: which oracle pair each is, and how to call it.

mod call;
mod history;
mod parameters;
mod programs;

pub use call::{Answer, Input, UNTOUCHED, Wanted};

use contact_elements::ElementDescription;
use contact_elements::runtime::Enforcement;

use crate::catalogue::{self, CIRCLE_RADIUS, UnknownName};
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::Angle;
use crate::oracle::pair::{GapKind, Pair};

/// An element under test.
#[derive(Clone, Debug)]
pub struct Subject {
    /// What was declared.
    pub description: &'static ElementDescription,
    /// The same pair for the oracle; random states replace its numbers.
    pub template: Pair,
    /// Parameters of a law that the oracle was given as `Law::Declared`.
    pub law_parameters: Vec<f64>,
    /// Parameters of a tangential law that the oracle was given as `TangentialLaw::Declared`.
    pub tangential_parameters: Vec<f64>,
    /// Parameters of a law of rolling that the oracle was given as `TangentialLaw::Declared`.
    pub rolling_parameters: Vec<f64>,
    /// Parameters of a rigid geometry that the oracle was given as `Declared`.
    pub geometry_parameters: Vec<f64>,
}

/// Every built-in element.
#[cfg(feature = "library")]
pub fn built_in() -> Result<Vec<Subject>, UnknownName> {
    contact_library::DESCRIPTIONS
        .iter()
        .map(|description| Subject::new(description))
        .collect()
}

impl Subject {
    /// The subject of a built-in element.
    ///
    /// # Errors
    /// `UnknownName` if the oracle does not know a geometry or law of the declaration.
    pub fn new(description: &'static ElementDescription) -> Result<Self, UnknownName> {
        let dimension = description.descriptor.dimension;
        let template = Pair {
            dimension,
            slave: catalogue::slave(description)?,
            master: catalogue::master(description)?,
            gap: match description.descriptor.layout.orientation {
                _ if description.signed => GapKind::Signed,
                Some(_) => GapKind::Oriented,
                None => GapKind::Distance,
            },
            orientation: 1.0,
            r0: 0.0,
            law: catalogue::law(description.law.name)?,
            tangential: catalogue::tangential(description)?,
            angle: description.angle.map(|angle| Angle {
                small: angle.small,
                window: [0.2, 0.6],
            }),
            multipliers: match description.descriptor.enforcement {
                Enforcement::Penalty => Multipliers::None,
                Enforcement::Augmented => Multipliers::Held(vec![]),
                Enforcement::Multiplier => Multipliers::Unknown(vec![]),
            },
        };
        Ok(Self {
            description,
            template,
            law_parameters: vec![],
            tangential_parameters: vec![],
            rolling_parameters: vec![],
            geometry_parameters: vec![CIRCLE_RADIUS],
        })
    }

    /// Name of the element.
    pub fn name(&self) -> &'static str {
        self.description.name
    }
}
