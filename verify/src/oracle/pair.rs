//! One contact problem as data: slave, master, gap and law.

use super::angle::Angle;
use super::error::OracleError;
use super::geometry::{
    Interpolation, MAX_NODES, Placement, Region, RigidDistance, RigidParametric,
};
use super::law::Law;
use super::multiplier::{Enforced, Multipliers};
use super::tangential::Tangential;

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
    /// Tangential law; none: frictionless.
    pub tangential: Option<Tangential>,
    /// Angles of two curves at which it acts; none: all of them.
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

    /// Checks that the description is consistent.
    pub fn validate(&self) -> Result<(), OracleError> {
        let fail = |reason: String| Err(OracleError::Pair(reason));
        if !(2..=3).contains(&self.dimension) {
            return fail(format!("dimension {} is neither 2 nor 3", self.dimension));
        }
        if self.slave_nodes() > MAX_NODES || self.master_nodes() > MAX_NODES {
            return fail(format!("more than {MAX_NODES} nodes on one side"));
        }
        if self.orientation.abs() != 1.0 || !self.r0.is_finite() {
            return fail("orientation must be +1 or -1 and r0 finite".into());
        }
        let codimension = self.dimension as isize - self.parameters() as isize;
        let by_distance = matches!(self.master, Master::Distance { .. });
        if codimension < 1 || (by_distance && self.slave_parameters() > 0) {
            return fail("more projected parameters than the dimension allows".into());
        }
        match self.gap {
            GapKind::Signed if codimension != 1 && !by_distance => {
                return fail("a signed gap needs codimension one".into());
            }
            GapKind::Distance | GapKind::Oriented if by_distance => {
                return fail("a rigid distance has a sign".into());
            }
            _ => {}
        }
        self.law.defect().map_or(Ok(()), fail)?;
        let tangential = self.tangential.as_ref().and_then(|law| law.defect(self));
        tangential.map_or(Ok(()), |defect| fail(defect.into()))?;
        let angle = self.angle.and_then(|angle| angle.defect(self));
        angle.map_or(Ok(()), |defect| fail(defect.into()))?;
        self.placement()
            .defect()
            .map_or(Ok(()), |d| fail(d.into()))?;
        if let Master::Shape(geometry) = &self.master {
            check(geometry)?;
        }
        self.validate_slave()
    }

    fn validate_slave(&self) -> Result<(), OracleError> {
        let fail = |reason: &str| Err(OracleError::Pair(reason.into()));
        match &self.slave {
            Slave::Point => Ok(()),
            Slave::Curve(geometry) => {
                check(geometry)?;
                if geometry.shape.parameters() != 1 {
                    return fail("a slave whose parameter is projected must be a curve");
                }
                Ok(())
            }
            Slave::Fixed {
                geometry, points, ..
            } => {
                check(geometry)?;
                if geometry.shape.parameters() >= self.dimension {
                    return fail("the slave has more parameters than the dimension allows");
                }
                let finite = |p: &IntegrationPoint| {
                    p.weight.is_finite() && p.eta.iter().all(|v| v.is_finite())
                };
                if !points.iter().all(finite) {
                    return fail("integration point not finite");
                }
                Ok(())
            }
            Slave::Rows { rows, positions } => {
                let finite = |r: &Row| {
                    r.weight.is_finite()
                        && r.shape.len() == positions.len()
                        && r.shape.iter().all(|v| v.is_finite())
                };
                if positions.is_empty() || !rows.iter().all(finite) {
                    return fail("rows must be finite and as long as the list of nodes");
                }
                Ok(())
            }
        }
    }
}

fn check(geometry: &Interpolation) -> Result<(), OracleError> {
    if let Some(reason) = geometry.shape.defect() {
        return Err(OracleError::Pair(reason));
    }
    let Some(weights) = &geometry.weights else {
        return Ok(());
    };
    if weights.len() != geometry.shape.nodes() {
        return Err(OracleError::Length {
            what: "weights",
            expected: geometry.shape.nodes(),
            found: weights.len(),
        });
    }
    if weights.iter().all(|w| w.is_finite() && *w > 0.0) {
        Ok(())
    } else {
        Err(OracleError::Pair("weights must be positive".into()))
    }
}
