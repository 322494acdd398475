//! The elements under test: which oracle pair each is, and how to call it.

use contact_elements::abi::{self, Evaluation, OUTPUT_SIZE, Outcome};
use contact_elements::program::{ElementDescription, SlaveDescription};

use crate::catalogue::{CIRCLE_RADIUS, law, master, slave};
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::law::Law;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};

/// An element under test.
#[derive(Clone, Debug)]
pub struct Subject {
    /// What was declared.
    pub description: &'static ElementDescription,
    /// The same pair for the oracle; random states replace its numbers.
    pub template: Pair,
    /// Parameters of a law that the oracle was given as [`Law::Declared`].
    pub law_parameters: Vec<f64>,
    /// Parameters of a rigid geometry that the oracle was given as `Declared`.
    pub geometry_parameters: Vec<f64>,
}

/// A name in a declaration that the oracle does not know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName(pub String);

impl std::fmt::Display for UnknownName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "the oracle does not know `{}`: add it to the catalogue or give a template",
            self.0
        )
    }
}

/// Every built-in element.
pub fn built_in() -> Result<Vec<Subject>, UnknownName> {
    contact_elements::elements::DESCRIPTIONS
        .iter()
        .map(|description| Subject::new(description))
        .collect()
}

impl Subject {
    /// The subject of a built-in element.
    ///
    /// # Errors
    /// [`UnknownName`] where the oracle knows a geometry or law of the declaration by no name.
    pub fn new(description: &'static ElementDescription) -> Result<Self, UnknownName> {
        let dimension = description.descriptor.dimension;
        let template = Pair {
            dimension,
            slave: slave(description)?,
            master: master(description)?,
            gap: if description.signed {
                GapKind::Signed
            } else {
                GapKind::Distance
            },
            orientation: 1.0,
            r0: 0.0,
            law: law(description.law.name)?,
        };
        Ok(Self {
            description,
            template,
            law_parameters: vec![],
            geometry_parameters: vec![CIRCLE_RADIUS],
        })
    }

    /// Name of the element.
    pub fn name(&self) -> &'static str {
        self.description.name
    }

    /// The element's parameter list for a pair's numbers.
    pub fn parameters(&self, pair: &Pair) -> Vec<f64> {
        let mut list = self.parameters_of_law(&pair.law);
        list.push(pair.r0);
        if self.description.signed {
            list.push(pair.orientation);
        }
        list.extend(self.parameters_of_rigid(&pair.master));
        if let Master::Shape(geometry) = &pair.master {
            list.extend(geometry.weights.iter().flatten());
        }
        if let Slave::Curve(geometry) | Slave::Fixed { geometry, .. } = &pair.slave {
            list.extend(geometry.weights.iter().flatten());
        }
        if let (
            SlaveDescription::Given(_),
            Slave::Fixed {
                geometry, points, ..
            },
        ) = (&self.description.slave, &pair.slave)
        {
            for point in points {
                list.extend(point.eta.iter().take(geometry.shape.parameters()));
                list.push(point.weight);
            }
        }
        if self.description.placed {
            list.extend(placement_parameters(&pair.placement(), pair.dimension));
        }
        list
    }

    fn parameters_of_law(&self, law: &Law) -> Vec<f64> {
        match *law {
            Law::Penalty { eps_n } => vec![eps_n],
            Law::Power { eps_n, exponent } => vec![eps_n, exponent],
            Law::Barrier { kappa, distance } => vec![kappa, distance],
            Law::Declared(_) => self.law_parameters.clone(),
        }
    }

    fn parameters_of_rigid(&self, master: &Master) -> Vec<f64> {
        match master {
            Master::Parametric { surface, .. } => match *surface {
                RigidParametric::Cylinder { radius }
                | RigidParametric::Sphere { radius }
                | RigidParametric::Circle { radius } => vec![radius],
                RigidParametric::Cone { alpha } => vec![alpha],
                RigidParametric::Torus { major, minor } => vec![major, minor],
                RigidParametric::Helix {
                    radius,
                    pitch_over_2pi,
                } => vec![radius, pitch_over_2pi],
                RigidParametric::Declared(_) => self.geometry_parameters.clone(),
                RigidParametric::Line | RigidParametric::Plane => vec![],
            },
            Master::Distance { body, .. } => match *body {
                RigidDistance::Circle { radius }
                | RigidDistance::Cylinder { radius }
                | RigidDistance::Sphere { radius } => vec![radius],
                RigidDistance::Cone { alpha } => vec![alpha],
                RigidDistance::Torus { major, minor } => vec![major, minor],
                RigidDistance::Declared(_) => self.geometry_parameters.clone(),
                RigidDistance::Line | RigidDistance::Plane => vec![],
            },
            _ => vec![],
        }
    }

    /// Row and weight of an interpolated slave; empty otherwise.
    pub fn slave_row(&self, pair: &Pair) -> Vec<f64> {
        match (&self.description.slave, &pair.slave) {
            (SlaveDescription::Interpolated, Slave::Rows { rows, .. }) => rows
                .iter()
                .flat_map(|row| row.shape.iter().copied().chain([row.weight]))
                .collect(),
            _ => vec![],
        }
    }

    /// Projected parameters of the oracle's start as the element's history.
    pub fn history(&self, start: &[[f64; 2]]) -> Vec<f64> {
        let descriptor = self.description.descriptor;
        (0..descriptor.points)
            .flat_map(|q| {
                let start = start.get(q).or(start.first()).copied().unwrap_or([0.0; 2]);
                let zeta = start.into_iter().take(descriptor.projected);
                std::iter::once(0.0).chain(zeta).collect::<Vec<f64>>()
            })
            .collect()
    }

    /// Calls the element through the C interface.
    pub fn call(&self, input: &Input<'_>, wanted: Wanted) -> Answer {
        let descriptor = self.description.descriptor;
        let unknowns = input.reference.len();
        let tangent = if wanted.tangent && descriptor.tangent {
            unknowns * unknowns
        } else {
            0
        };
        let nodes = unknowns / descriptor.dimension;
        let mut answer = Answer {
            residual: vec![UNTOUCHED; unknowns],
            tangent: vec![UNTOUCHED; tangent],
            output: vec![UNTOUCHED; descriptor.points * OUTPUT_SIZE],
            energy: vec![UNTOUCHED; usize::from(descriptor.energy)],
            outcome: None,
        };
        let mut workspace = vec![0.0; descriptor.workspace(nodes)];
        let outcome = abi::evaluate(
            descriptor,
            &mut Evaluation {
                x: input.reference,
                u: input.displacement,
                parameters: input.parameters,
                history: input.history,
                slave_row: input.slave_row,
                residual: if wanted.residual {
                    &mut answer.residual
                } else {
                    &mut []
                },
                tangent: &mut answer.tangent,
                output: &mut answer.output,
                new_history: &mut [],
                energy: &mut answer.energy,
                workspace: &mut workspace,
                bits: wanted.bits,
            },
        );
        answer.outcome = Some(outcome);
        answer
    }
}

/// What an entry holds that the element did not write.
pub const UNTOUCHED: f64 = -7.25e77;

/// Inputs of a call.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// X.
    pub reference: &'a [f64],
    /// u.
    pub displacement: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// History: start of the projection.
    pub history: &'a [f64],
    /// Row of an interpolated slave.
    pub slave_row: &'a [f64],
}

/// Which outputs a call wants.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Residual.
    pub residual: bool,
    /// Tangent.
    pub tangent: bool,
    /// Further request bits.
    pub bits: u32,
}

impl Wanted {
    /// Residual and tangent.
    pub const BOTH: Self = Self {
        residual: true,
        tangent: true,
        bits: 0,
    };
}

/// Outputs of a call.
#[derive(Clone, Debug)]
pub struct Answer {
    /// R.
    pub residual: Vec<f64>,
    /// K, row-major; empty where not offered or not wanted.
    pub tangent: Vec<f64>,
    /// Output per contact point.
    pub output: Vec<f64>,
    /// Energy.
    pub energy: Vec<f64>,
    /// Codes.
    pub outcome: Option<Outcome>,
}

impl Answer {
    /// Status of the element.
    pub fn status(&self) -> Option<contact_elements::runtime::Status> {
        self.outcome.and_then(|outcome| outcome.status())
    }

    /// True where no output was written.
    pub fn is_untouched(&self) -> bool {
        let mut entries = self
            .residual
            .iter()
            .chain(&self.tangent)
            .chain(&self.energy);
        entries.all(|&value| value == UNTOUCHED)
    }

    /// True where residual and tangent are exactly zero.
    pub fn is_zero(&self) -> bool {
        self.residual
            .iter()
            .chain(&self.tangent)
            .all(|&value| value == 0.0)
    }
}

fn placement_parameters(placement: &Placement, dimension: usize) -> Vec<f64> {
    match placement {
        Placement::Identity => vec![0.0; if dimension == 3 { 7 } else { 4 }],
        Placement::Spatial { origin, quaternion } => {
            origin.iter().chain(quaternion).copied().collect()
        }
        Placement::Planar { origin, direction } => {
            origin.iter().chain(direction).copied().collect()
        }
    }
}
