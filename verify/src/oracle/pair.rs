//! One contact problem as data: slave, master, gap and law.

use super::geometry::{Interpolation, Placement, Region, RigidDistance, RigidParametric};
use super::law::Law;
use super::multiplier::{Enforced, Multipliers};
use super::tangential::TangentialLaw;

/// An integration point of a slave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegrationPoint {
    /// Parameters on the slave.
    pub eta: [f64; 2],
    /// Weight of the rule.
    pub weight: f64,
}

/// What the weight of an integration point is multiplied with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Nothing: J = 1.
    Unit,
    /// Length or area per parameter of the reference configuration (X).
    Reference,
    /// Length or area per parameter of the current configuration (X + u); `R = Σ w J N dg`,
    /// whose tangent is not symmetric.
    Current,
}

/// A slave point that the host interpolates: one shape value per node.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Shape functions at the point.
    pub shape: Vec<f64>,
    /// Weight times measure, fixed by the host.
    pub weight: f64,
}

/// The side whose points are projected.
#[derive(Debug, Clone)]
pub enum Slave {
    /// One node.
    Point,
    /// A curve whose own parameter is projected too.
    Curve(Interpolation),
    /// Fixed points of a curve or surface.
    Fixed {
        /// The curve or surface.
        geometry: Interpolation,
        /// Its points.
        points: Vec<IntegrationPoint>,
        /// Length or area the weights refer to.
        measure: Measure,
    },
    /// Points of any host interpolation.
    Rows {
        /// One row per point, all of the same length.
        rows: Vec<Row>,
        /// For each node whether it is a position, i.e. moves with a translation. The rows'
        /// entries of these nodes sum to one.
        positions: Vec<bool>,
    },
}

/// The side projected onto.
#[derive(Debug, Clone)]
pub enum Master {
    /// One node.
    Point,
    /// A curve or surface with nodes.
    Shape(Interpolation),
    /// A rigid curve or surface given by parameters.
    Parametric {
        /// In its own frame.
        surface: RigidParametric,
        /// Where that frame is.
        placement: Placement,
    },
    /// A rigid body given by its distance: no projection.
    Distance {
        /// In its own frame.
        body: RigidDistance,
        /// Where that frame is.
        placement: Placement,
    },
}

/// How the gap is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GapKind {
    /// `g = |r| - r0`.
    Distance,
    /// `g = ± |r| - r0`, the sign being the orientation.
    Oriented,
    /// `g = r·n - r0`, n the unit vector along `b_1 × b_2` (`b_i = r_,i`), in two dimensions along
    /// `(b_y, -b_x)`, times the orientation. For a rigid distance: that distance times the
    /// orientation.
    Signed,
}

/// Where the first axis of a law with two stiffnesses points; the second is `n × d_1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axis {
    /// Along `w^i b_i`: convected by the master.
    Convected([f64; 2]),
    /// Along the slave curve, projected onto the tangent plane.
    SlaveCurve,
}

/// The tangential part of a pair.
#[derive(Debug, Clone)]
pub struct Tangential {
    /// The law.
    pub law: TangentialLaw,
    /// First axis of a law with two stiffnesses.
    pub axis: Option<Axis>,
    /// False: the residual is `T_i dζ^i` with the exact `dζ`. True: with the one on the tangent
    /// plane, `-a^ij b_j·dr`; such a residual balances moments only at zero distance. The tangent
    /// is the derivative of the exact residual either way.
    pub tangent_plane: bool,
    /// Moments about two curves; without them the curves roll freely.
    pub rolling: Option<Rolling>,
}

/// Moments about two curves.
#[derive(Debug, Clone)]
pub struct Rolling {
    /// Moment against angle: stiffness, and the bound by pressure and path (rad).
    pub law: TangentialLaw,
    /// Directions from which the angles are measured, slave's first; `None` for the principal normals.
    pub directors: Option<[[f64; 3]; 2]>,
}

/// Angles at which the contact of two curves acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    /// Small ones rather than large ones.
    pub small: bool,
    /// Where the factor begins and ends to change (rad).
    pub window: [f64; 2],
}

/// One contact problem.
#[derive(Debug, Clone)]
pub struct Pair {
    /// 2 or 3.
    pub dimension: usize,
    /// The side whose points are projected.
    pub slave: Slave,
    /// The side projected onto.
    pub master: Master,
    /// How the gap is measured.
    pub gap: GapKind,
    /// +1 or -1: factor of the normal of a signed gap, of the length of an oriented one.
    pub orientation: f64,
    /// Radii, offsets, thickness (length).
    pub r0: f64,
    /// Normal law.
    pub law: Law,
    /// Tangential law; `None` if frictionless.
    pub tangential: Option<Tangential>,
    /// Angles of two curves at which it acts; `None` for all angles.
    pub angle: Option<Angle>,
    /// Multipliers beside the normal law.
    pub multipliers: Multipliers,
}

impl Pair {
    /// Number of slave nodes.
    pub fn slave_nodes(&self) -> usize {
        match &self.slave {
            Slave::Point => 1,
            Slave::Curve(geometry) | Slave::Fixed { geometry, .. } => geometry.shape.nodes(),
            Slave::Rows { positions, .. } => positions.len(),
        }
    }

    /// Number of master nodes, zero for a rigid master.
    pub fn master_nodes(&self) -> usize {
        match &self.master {
            Master::Point => 1,
            Master::Shape(geometry) => geometry.shape.nodes(),
            Master::Parametric { .. } | Master::Distance { .. } => 0,
        }
    }

    /// The normal law of point `q` with its multiplier.
    pub fn enforced(&self, q: usize) -> Enforced<'_> {
        Enforced {
            law: &self.law,
            multiplier: self.multipliers.at(q),
        }
    }

    /// Number of unknowns; multipliers are not counted.
    pub fn unknowns(&self) -> usize {
        self.dimension * (self.slave_nodes() + self.master_nodes())
    }

    /// Number of contact points.
    pub fn points(&self) -> usize {
        match &self.slave {
            Slave::Point | Slave::Curve(_) => 1,
            Slave::Fixed { points, .. } => points.len(),
            Slave::Rows { rows, .. } => rows.len(),
        }
    }

    /// Number of the slave's projected parameters.
    pub fn slave_parameters(&self) -> usize {
        usize::from(matches!(self.slave, Slave::Curve(_)))
    }

    /// Number of the master's projected parameters.
    pub fn master_parameters(&self) -> usize {
        match &self.master {
            Master::Point | Master::Distance { .. } => 0,
            Master::Shape(geometry) => geometry.shape.parameters(),
            Master::Parametric { surface, .. } => surface.parameters(),
        }
    }

    /// Number of all projected parameters, slave first.
    pub fn parameters(&self) -> usize {
        self.slave_parameters() + self.master_parameters()
    }

    /// Range of the projected parameters.
    pub fn region(&self) -> Region {
        let master = match &self.master {
            Master::Point | Master::Distance { .. } => Region::FREE,
            Master::Shape(geometry) => geometry.shape.region(),
            Master::Parametric { surface, .. } => surface.region(),
        };
        match &self.slave {
            Slave::Curve(geometry) => Region::product(geometry.shape.region(), master),
            _ => master,
        }
    }

    /// Where the master's frame is; the global frame for a master with nodes.
    pub fn placement(&self) -> Placement {
        match self.master {
            Master::Parametric { placement, .. } | Master::Distance { placement, .. } => placement,
            _ => Placement::Identity,
        }
    }

    /// Whether slave node `node` is a position.
    pub fn slave_is_position(&self, node: usize) -> bool {
        match &self.slave {
            Slave::Point => true,
            Slave::Curve(geometry) | Slave::Fixed { geometry, .. } => {
                geometry.shape.is_position(node)
            }
            Slave::Rows { positions, .. } => positions.get(node).copied().unwrap_or(false),
        }
    }

    /// Whether master node `node` is a position.
    pub fn master_is_position(&self, node: usize) -> bool {
        match &self.master {
            Master::Shape(geometry) => geometry.shape.is_position(node),
            _ => true,
        }
    }
}

impl Tangential {
    /// A law without axes, with the exact residual.
    pub fn isotropic(law: TangentialLaw) -> Self {
        Self {
            law,
            axis: None,
            tangent_plane: false,
            rolling: None,
        }
    }

    /// A law with axes, with the exact residual.
    pub fn orthotropic(law: TangentialLaw, axis: Axis) -> Self {
        Self {
            law,
            axis: Some(axis),
            tangent_plane: false,
            rolling: None,
        }
    }
}
