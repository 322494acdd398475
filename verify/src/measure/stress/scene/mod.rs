//! A contact of size one at a known point, to be deformed by a sweep and turned into numbers for a call.

mod case;
mod placing;

pub use case::Case;

use super::kinematics::Point;
use crate::configurations::{Stream, flat};
use crate::oracle::geometry::Interpolation;
use crate::oracle::law::Law;
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::vector::{add, scale};

/// How the point is loaded along the tangent plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// No friction.
    Normal,
    /// The trial traction is this multiple of the bound.
    Utilised(f64),
    /// The slip since the anchor has this length, in sizes.
    Slipped(f64),
}

/// What the load is in words.
impl std::fmt::Display for Load {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Normal => Ok(()),
            Self::Utilised(share) if *share < 1.0 => f.write_str(", sticks"),
            Self::Utilised(_) => f.write_str(", slips"),
            Self::Slipped(_) => f.write_str(", slip given"),
        }
    }
}

/// A contact that is still to be deformed and placed.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The pair with all its numbers.
    pub pair: Pair,
    /// Slave nodes, about the origin.
    pub slave: Vec<[f64; 3]>,
    /// Master nodes; rigid masters are in their own frame.
    pub master: Vec<[f64; 3]>,
    /// Projected parameters of the contact point.
    pub target: [f64; 2],
    /// Gap there (length).
    pub gap: f64,
    /// Load along the tangent plane.
    pub load: Load,
    /// Turned and moved by up to a size at random after placing.
    pub turned: bool,
    /// Start of the element's projection, in extents off the target.
    pub start: f64,
    /// Whether ζ counts among the data, see [`Case::is_projection_data`].
    pub is_projection_data: bool,
    /// Everything is multiplied by this, then shifted by that.
    pub scale: f64,
    /// See `scale`; each coordinate.
    pub shift: f64,
}

/// Penalty, its share along the tangent plane, coefficients of friction, gap, offset of distances.
const PENALTY: f64 = 1e3;
const SHARE: [f64; 2] = [0.4, 0.3];
const FRICTION: [f64; 2] = [0.3, 0.2];
const GAP: f64 = -0.08;
const OFFSET: f64 = 0.6;
/// Start of the projection, in extents off the target.
const START: f64 = 0.01;

impl Scene {
    /// A well-conditioned contact of the kind of a template.
    pub fn typical(template: &Pair, load: Load, stream: &mut Stream) -> Self {
        let mut pair = template.clone();
        pair.law = Law::Penalty { eps_n: PENALTY };
        if pair.gap == GapKind::Distance {
            pair.r0 = OFFSET;
        }
        let master = match &mut pair.master {
            Master::Shape(geometry) => nodes(geometry, 1.0, stream),
            Master::Point => vec![stream.cube(0.2)],
            Master::Parametric { .. } | Master::Distance { .. } => vec![],
        };
        let slave = match &mut pair.slave {
            Slave::Point => vec![[0.0; 3]],
            Slave::Curve(geometry) => nodes(geometry, 0.9, stream),
            Slave::Fixed { geometry, .. } => nodes(geometry, 0.4, stream),
            Slave::Rows { positions, .. } => positions.iter().map(|_| stream.cube(0.3)).collect(),
        };
        let mut scene = Self {
            target: target(&pair),
            pair,
            slave,
            master,
            gap: GAP,
            load,
            turned: true,
            start: START,
            is_projection_data: false,
            scale: 1.0,
            shift: 0.0,
        };
        scene.cross(1.2);
        scene.set_penalty(PENALTY);
        scene.set_friction(FRICTION);
        if scene.pair.dimension == 2 {
            for node in scene.slave.iter_mut().chain(&mut scene.master) {
                *node = [node[0], node[2], 0.0];
            }
        }
        scene
    }

    /// Turns the slave about z to an angle with the x axis.
    pub fn cross(&mut self, angle: f64) {
        let (sin, cos) = angle.sin_cos();
        for v in &mut self.slave {
            *v = [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1], v[2]];
        }
    }

    /// Turns a slave curve so that it crosses the master curve at an angle, both as they run through the target.
    pub fn cross_at(&mut self, angle: f64) {
        let k = Point::new(&self.pair, 0).at(&self.nodes(), self.target.map(Octuple::from));
        let [slave, master] = k.b.map(|b| b.map(Octuple::to_f64));
        // r,2 is minus the master's tangent
        self.cross(angle + (-master[1]).atan2(-master[0]) - slave[1].atan2(slave[0]));
    }

    /// Sets the normal penalty, and the tangential ones in proportion.
    pub fn set_penalty(&mut self, eps: f64) {
        self.pair.law = Law::Penalty { eps_n: eps };
        match self.pair.tangential.as_mut().map(|own| &mut own.law) {
            Some(TangentialLaw::Coulomb { eps_t, .. } | TangentialLaw::Stick { eps_t }) => {
                *eps_t = SHARE[0] * eps;
            }
            Some(TangentialLaw::Orthotropic { eps_t, .. }) => *eps_t = SHARE.map(|s| s * eps),
            _ => {}
        }
    }

    /// Sets the coefficients of friction; without axes the first counts.
    pub fn set_friction(&mut self, coefficients: [f64; 2]) {
        match self.pair.tangential.as_mut().map(|own| &mut own.law) {
            Some(TangentialLaw::Coulomb { mu, .. }) => *mu = coefficients[0],
            Some(TangentialLaw::Orthotropic { mu, .. }) => *mu = coefficients,
            _ => {}
        }
    }

    /// Weights of a rational geometry on either side.
    pub fn weights(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        let slave = match &mut self.pair.slave {
            Slave::Curve(geometry) | Slave::Fixed { geometry, .. } => geometry.weights.as_mut(),
            _ => None,
        };
        let master = match &mut self.pair.master {
            Master::Shape(geometry) => geometry.weights.as_mut(),
            _ => None,
        };
        slave.into_iter().chain(master)
    }

    /// Bends the master: what lies across a curve or a surface is multiplied by a factor.
    pub fn bend(&mut self, factor: f64) {
        let is_curve = self.pair.master_parameters() == 1;
        for node in &mut self.master {
            node[2] *= factor;
            if is_curve {
                node[1] *= factor;
            }
        }
    }

    /// Brings the start of the projection nearer to the target: where F is nearly singular, the region from which
    /// Newton's method finds the foot is small, and how large it is is not the question here.
    pub fn start_nearer(&mut self, factor: f64) {
        self.start *= factor.min(1.0);
    }

    /// Whether the law of friction has axes.
    pub fn is_orthotropic(&self) -> bool {
        let own = self.pair.tangential.as_ref();
        own.is_some_and(|own| own.law.orthotropic())
    }

    fn nodes(&self) -> Vec<[Octuple; 3]> {
        let all = self.slave.iter().chain(&self.master);
        all.map(|node| node.map(Octuple::from)).collect()
    }
}

/// Nodes of a typical geometry, disturbed; weights of a rational one.
fn nodes(geometry: &mut Interpolation, size: f64, stream: &mut Stream) -> Vec<[f64; 3]> {
    if let Some(weights) = &mut geometry.weights {
        for weight in weights {
            *weight = stream.uniform(0.7, 1.4);
        }
    }
    let disturbed = |node: [f64; 3], stream: &mut Stream| scale(add(node, stream.cube(0.04)), size);
    let nodes = flat::nodes(&geometry.shape).into_iter();
    nodes.map(|node| disturbed(node, stream)).collect()
}

/// A point inside the region, off its middle.
fn target(pair: &Pair) -> [f64; 2] {
    let region = pair.region();
    if region.triangle {
        return [0.31, 0.27];
    }
    let at = |i: usize, share: f64| match (region.bounds[i], i < pair.parameters()) {
        (_, false) => 0.0,
        (Some(_), true) => region.middle()[i] + share * region.extent(i),
        (None, true) => 0.7,
    };
    [at(0, 0.07), at(1, -0.11)]
}
