//! The elements under test: which oracle pair each is, and how to call it.

use contact_elements::abi::{self, Evaluation, OUTPUT_SIZE, Outcome};
use contact_elements::program::{ElementDescription, SlaveDescription};
use contact_elements::runtime::Enforcement;

use crate::catalogue::{CIRCLE_RADIUS, law, master, slave, tangential};
use crate::configurations::Configuration;
use crate::oracle::angle::Angle;
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::rolling::RollingHistory;
use crate::oracle::solve::{Accepted, Couplings, FrictionHistory};
use crate::oracle::tangential::{Axis, TangentialLaw};

/// An element under test.
#[derive(Clone, Debug)]
pub struct Subject {
    /// What was declared.
    pub description: &'static ElementDescription,
    /// The same pair for the oracle; random states replace its numbers.
    pub template: Pair,
    /// Parameters of a law that the oracle was given as [`Law::Declared`].
    pub law_parameters: Vec<f64>,
    /// Parameters of a tangential law that the oracle was given as [`TangentialLaw::Declared`].
    pub tangential_parameters: Vec<f64>,
    /// Parameters of a law of rolling that the oracle was given as [`TangentialLaw::Declared`].
    pub rolling_parameters: Vec<f64>,
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
    contact_library::DESCRIPTIONS
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
            gap: match description.descriptor.layout.orientation {
                _ if description.signed => GapKind::Signed,
                Some(_) => GapKind::Oriented,
                None => GapKind::Distance,
            },
            orientation: 1.0,
            r0: 0.0,
            law: law(description.law.name)?,
            tangential: tangential(description)?,
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

    /// The element's parameter list for a pair's numbers.
    pub fn parameters(&self, pair: &Pair) -> Vec<f64> {
        let mut list = self.parameters_of_law(&pair.law);
        if let Some(tangential) = &pair.tangential {
            let own = &self.tangential_parameters;
            list.extend(parameters_of_tangential(&tangential.law, own));
        }
        let rolling = pair
            .tangential
            .as_ref()
            .and_then(|own| own.rolling.as_ref());
        if let Some(rolling) = rolling {
            let own = &self.rolling_parameters;
            list.extend(parameters_of_tangential(&rolling.law, own));
        }
        list.push(pair.r0);
        if self.description.layout.orientation.is_some() {
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
        if let Some(Axis::Convected(w)) = pair.tangential.as_ref().and_then(|law| law.axis) {
            list.extend(w);
        }
        let directors = rolling.and_then(|rolling| rolling.directors);
        list.extend(directors.iter().flatten().flatten());
        list.extend(pair.angle.iter().flat_map(|angle| angle.window));
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

    /// The oracle's start and what it remembers as the element's history: per point status and projected
    /// parameters, with friction the anchor and the path too, of edges no side, multipliers that are held. Nothing remembered: open.
    pub fn history(
        &self,
        start: &[[f64; 2]],
        friction: &[FrictionHistory],
        multipliers: &Multipliers,
    ) -> Vec<f64> {
        let descriptor = self.description.descriptor;
        let mut history = Vec::with_capacity(descriptor.history());
        for q in 0..descriptor.points {
            let start = start.get(q).or(start.first()).copied().unwrap_or([0.0; 2]);
            let remembered = friction.get(q).copied().unwrap_or(FORGOTTEN);
            history.push(match remembered.status {
                Accepted::Open => 0.0,
                Accepted::Stick => 2.0,
                Accepted::Slip => 3.0,
            });
            history.extend(&start[..descriptor.projected]);
            if descriptor.friction {
                history.extend(&remembered.anchor[..descriptor.projected]);
                history.push(remembered.slip);
            }
            if descriptor.rolling {
                history.extend(remembered.rolling.anchor);
                history.extend(remembered.rolling.path);
                history.push(0.0);
            }
            if descriptor.keeps_side {
                history.extend([0.0; 3]);
            }
            if let Multipliers::Held(_) = multipliers {
                history.extend(multipliers.at(q));
            }
        }
        history
    }

    /// The history of a configuration.
    pub fn history_of(&self, configuration: &Configuration) -> Vec<f64> {
        self.history(
            &configuration.start,
            &configuration.friction,
            &configuration.pair.multipliers,
        )
    }

    /// Calls the element through the C interface.
    pub fn call(&self, input: &Input<'_>, wanted: Wanted) -> Answer {
        let descriptor = self.description.descriptor;
        let d = descriptor.dimension;
        let positions = input.reference.len();
        let nodes = positions / d + descriptor.multipliers();
        let unknowns = descriptor.unknowns(nodes);
        let tangent = if wanted.tangent && descriptor.tangent {
            unknowns * unknowns
        } else {
            0
        };
        let (mut x, mut u) = (input.reference.to_vec(), input.displacement.to_vec());
        for q in 0..descriptor.multipliers() {
            // what stands beside the multiplier is not looked at
            let value = input.multipliers.get(q).copied().unwrap_or(0.0);
            x.extend(vec![UNTOUCHED; d]);
            u.push(value);
            u.extend(vec![UNTOUCHED; d - 1]);
        }
        let mut answer = Answer {
            residual: vec![UNTOUCHED; unknowns],
            tangent: vec![UNTOUCHED; tangent],
            output: vec![UNTOUCHED; descriptor.points * OUTPUT_SIZE],
            energy: vec![UNTOUCHED; usize::from(descriptor.energy)],
            history: vec![UNTOUCHED; descriptor.history()],
            couplings: Couplings::default(),
            outcome: None,
        };
        let mut workspace = vec![0.0; descriptor.workspace(nodes)];
        let outcome = abi::evaluate(
            descriptor,
            &mut Evaluation {
                x: &x,
                u: &u,
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
                trial: &mut answer.history,
                energy: &mut answer.energy,
                workspace: &mut workspace,
                bits: wanted.bits,
            },
        );
        answer.outcome = Some(outcome);
        answer.split(positions);
        answer
    }
}

/// Of a point that remembers nothing.
const FORGOTTEN: FrictionHistory = FrictionHistory {
    status: Accepted::Open,
    anchor: [0.0; 2],
    slip: 0.0,
    rolling: RollingHistory {
        anchor: [0.0; 2],
        path: [0.0; 2],
    },
};

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
    /// History: start of the projection; with friction anchors and paths.
    pub history: &'a [f64],
    /// Row of an interpolated slave.
    pub slave_row: &'a [f64],
    /// Multipliers that are unknowns.
    pub multipliers: &'a [f64],
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
    /// Trial history per contact point.
    pub history: Vec<f64>,
    /// What belongs to multipliers that are unknowns.
    pub couplings: Couplings,
    /// Codes.
    pub outcome: Option<Outcome>,
}

impl Answer {
    /// Takes what belongs to multipliers out of residual and tangent.
    fn split(&mut self, positions: usize) {
        let all = self.residual.len();
        if all == positions {
            return;
        }
        self.couplings.residual = self.residual.split_off(positions);
        let whole = std::mem::take(&mut self.tangent);
        let at = |i: usize, j: usize| whole[all * i + j];
        let (inner, outer) = (0..positions, positions..all);
        if whole.is_empty() {
            return;
        }
        for i in inner.clone() {
            self.tangent.extend(inner.clone().map(|j| at(i, j)));
        }
        for q in outer.clone() {
            self.couplings
                .columns
                .extend(inner.clone().map(|i| at(i, q)));
            self.couplings.rows.extend(inner.clone().map(|j| at(q, j)));
            self.couplings.block.extend(outer.clone().map(|p| at(q, p)));
        }
    }

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
            .chain(&self.energy)
            .chain(&self.history)
            .chain(&self.couplings.residual)
            .chain(&self.couplings.block);
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

/// Parameters of a tangential law; `own`: those of a declared one.
fn parameters_of_tangential(law: &TangentialLaw, own: &[f64]) -> Vec<f64> {
    match *law {
        TangentialLaw::Stick { eps_t } => vec![eps_t],
        TangentialLaw::Coulomb { eps_t, mu } => vec![eps_t, mu],
        TangentialLaw::Adhesive {
            eps_t,
            mu,
            cohesion,
        } => vec![eps_t, mu, cohesion],
        TangentialLaw::StaticKinetic {
            eps_t,
            mu_s,
            mu_k,
            decay,
        } => vec![eps_t, mu_s, mu_k, decay],
        TangentialLaw::Orthotropic { eps_t, mu } => [eps_t, mu].concat(),
        TangentialLaw::Declared(_) => own.to_vec(),
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
