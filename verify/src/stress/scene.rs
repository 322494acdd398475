//! A contact of size one at a known point, to be deformed by a sweep and turned into numbers for a call.

use num_dual::DualNum;

use super::exact;
use super::kinematics::Point;
use super::truth::{self, State};
use crate::configurations::{Stream, flat};
use crate::oracle::geometry::{Interpolation, Placement, RigidDistance, RigidParametric};
use crate::oracle::law::Law;
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};
use crate::oracle::rolling::RollingHistory;
use crate::oracle::solve::{Accepted, FrictionHistory};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::vector::{add, cross, dot, scale, sub, unit};

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

/// A state as an element is called with it.
#[derive(Clone, Debug)]
pub struct Case {
    /// The pair.
    pub pair: Pair,
    /// All coordinates, slave nodes first.
    pub positions: Vec<f64>,
    /// Start of the element's projection.
    pub start: [f64; 2],
    /// Where the projection was meant to be.
    pub target: [f64; 2],
    /// What every point remembers; empty without friction.
    pub friction: Vec<FrictionHistory>,
    /// The rounding of ζ to doubles, in which it is handed out and remembered, counts like that of the
    /// coordinates: for geometries whose parameters are singular close by.
    pub is_projection_data: bool,
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

    /// Distance L, with a sign where the gap has one, at which the principal curvature of the master (of the
    /// pair, for two curves) makes the projection singular, on the side of negative or positive L as it is
    /// used; nothing where it is flat.
    pub fn focal_distance(&self) -> Option<f64> {
        let point = Point::new(&self.pair, 0);
        let k = point.at(&self.nodes(), self.target.map(Octuple::from));
        let n = self.direction(&point)?.map(Octuple::from);
        let plain = |v: Octuple| v.to_f64();
        let a = |i: usize, j: usize| plain(dot(k.b[i], k.b[j]));
        let h = k.second.map(|second| plain(dot(n, second)));
        let values = if self.pair.parameters() == 1 {
            [h[0] / a(0, 0); 2]
        } else {
            let det = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
            let half = 0.5 * (a(1, 1) * h[0] - 2.0 * a(0, 1) * h[1] + a(0, 0) * h[2]) / det;
            let product = (h[0] * h[2] - h[1] * h[1]) / det;
            let root = (half * half - product).max(0.0).sqrt();
            [half - root, half + root]
        };
        // F = a + L h
        let sought = if self.pair.gap == GapKind::Signed {
            values[1]
        } else {
            values[0]
        };
        let distance = -1.0 / sought;
        let right = (distance < 0.0) == (self.pair.gap == GapKind::Signed);
        (right && distance.is_finite()).then_some(distance)
    }

    /// Unit vector along which the slave lies off the target.
    fn direction(&self, point: &Point<'_>) -> Option<[f64; 3]> {
        let z = self.target.map(Octuple::from);
        let k = point.at(&self.nodes(), z);
        let b = k.b.map(|b| b.map(Octuple::to_f64));
        let bent = k.second[0].map(Octuple::to_f64);
        if self.pair.gap == GapKind::Signed {
            return Some(point.distance(&k).1.map(Octuple::to_f64));
        }
        let unit_b = |b: [f64; 3]| scale(b, 1.0 / dot(b, b).sqrt());
        Some(match self.pair.dimension - self.pair.parameters() {
            1 => unit(cross(unit_b(b[0]), unit_b(b[1]))),
            // towards the centre of curvature: r,11 of the master has the sign of minus its curvature
            2 if self.pair.parameters() == 1 => {
                let t = unit_b(b[0]);
                unit(sub(scale(t, dot(t, bent)), bent))
            }
            2 => [0.6, 0.8, 0.0],
            _ => unit([0.3, -0.5, 0.7]),
        })
    }

    /// Moves the slave so that its point lies at the gap over the target.
    fn place(&mut self) -> Option<()> {
        if let Master::Distance { .. } = self.pair.master {
            // off the middle, from where no side is the nearest
            self.slave[0] = add(self.slave[0], [0.5, 0.7, 0.6]);
        }
        for _ in 0..3 {
            let point = Point::new(&self.pair, 0);
            let k = point.at(&self.nodes(), self.target.map(Octuple::from));
            let r = k.r.map(Octuple::to_f64);
            let shift = if let Master::Distance { .. } = self.pair.master {
                let (length, n) = point.distance(&k);
                scale(
                    n.map(Octuple::to_f64),
                    self.gap + self.pair.r0 - length.to_f64(),
                )
            } else {
                sub(scale(self.direction(&point)?, self.gap + self.pair.r0), r)
            };
            for (i, node) in self.slave.iter_mut().enumerate() {
                if self.pair.slave_is_position(i) {
                    *node = add(*node, shift);
                }
            }
        }
        Some(())
    }

    /// Turns, scales and shifts everything.
    fn motion(&mut self, stream: &mut Stream) {
        let angle = stream.uniform(0.3, 1.2);
        let quaternion = match (self.turned, self.pair.dimension) {
            (false, _) => [1.0, 0.0, 0.0, 0.0],
            (_, 2) => [angle.cos(), 0.0, 0.0, angle.sin()],
            _ => stream.quaternion(),
        };
        let frame = Placement::Spatial {
            origin: [0.0; 3],
            quaternion,
        };
        let rows = frame.rotation();
        let turned = |v: [f64; 3]| rows.map(|row| self.scale * dot(row, v));
        // anywhere: coordinates that happen to be small carry more digits than others
        let place = stream.cube(if self.turned { 1.0 } else { 0.0 });
        let shift = [0, 1, 2].map(|c| {
            if c < self.pair.dimension {
                self.scale * place[c] + self.shift
            } else {
                0.0
            }
        });
        let moved = |v: [f64; 3], position| {
            if position {
                add(turned(v), shift)
            } else {
                turned(v)
            }
        };
        for (i, node) in self.slave.iter_mut().enumerate() {
            *node = moved(*node, self.pair.slave_is_position(i));
        }
        for (i, node) in self.master.iter_mut().enumerate() {
            *node = moved(*node, self.pair.master_is_position(i));
        }
        self.pair.r0 *= self.scale;
        self.gap *= self.scale;
        if let Master::Parametric { placement, .. } | Master::Distance { placement, .. } =
            &mut self.pair.master
        {
            match placement {
                Placement::Identity => {}
                Placement::Spatial {
                    origin,
                    quaternion: q,
                } => (*origin, *q) = (shift, quaternion),
                Placement::Planar { origin, direction } => {
                    *origin = [shift[0], shift[1]];
                    *direction = [rows[0][0], rows[1][0]];
                }
            }
        }
        scale_radii(&mut self.pair.master, self.scale);
        if let Master::Parametric { surface, .. } = &self.pair.master {
            // parameters that are lengths
            match surface {
                RigidParametric::Plane => self.target = self.target.map(|z| z * self.scale),
                RigidParametric::Cylinder { .. } => self.target[1] *= self.scale,
                _ => {}
            }
        }
    }

    /// Places the slave, moves everything and adds what the points remember.
    pub fn case(mut self, stream: &mut Stream) -> Option<Case> {
        self.place()?;
        self.motion(stream);
        let d = self.pair.dimension;
        let all = self.slave.iter().chain(&self.master);
        let positions: Vec<f64> = all.flat_map(|node| node[..d].to_vec()).collect();
        let region = self.pair.region();
        let off = |i: usize| self.start * region.extent(i) * if i == 0 { 1.0 } else { -1.0 };
        let p = self.pair.parameters();
        let start = |i: usize| if i < p { self.target[i] + off(i) } else { 0.0 };
        let mut case = Case {
            start: [start(0), start(1)],
            target: self.target,
            friction: vec![],
            is_projection_data: self.is_projection_data,
            pair: self.pair,
            positions,
        };
        if case.pair.tangential.is_some() {
            case.friction = case.remembered(self.load, self.gap, self.scale)?;
        }
        case.positions.iter().all(|v| v.is_finite()).then_some(case)
    }
}

impl Case {
    /// The state in octuple precision.
    pub fn state<'a>(&'a self, start: &'a [[f64; 2]]) -> State<'a> {
        State {
            pair: &self.pair,
            nodes: exact(&self.positions, self.pair.dimension),
            start,
            friction: &self.friction,
            nudge: [0.0; 2],
        }
    }

    /// Anchors that lie off the feet by the slip that the load asks for.
    fn remembered(&self, load: Load, gap: f64, size: f64) -> Option<Vec<FrictionHistory>> {
        let law = &self.pair.tangential.as_ref()?.law;
        let (eps_t, mu) = match *law {
            TangentialLaw::Coulomb { eps_t, mu } => (eps_t, mu),
            TangentialLaw::Orthotropic { eps_t, mu } => (eps_t[0], mu[0]),
            _ => return None,
        };
        let Law::Penalty { eps_n } = self.pair.law else {
            return None;
        };
        let length = match load {
            Load::Normal => return None,
            Load::Slipped(length) => length * size,
            Load::Utilised(share) => share * mu * gap.abs() * (eps_n / eps_t),
        };
        let start = [self.target];
        let state = self.state(&start);
        let anchor = |q: usize| {
            let found = truth::foot(&state, q);
            let z = found.unwrap_or(self.target.map(Octuple::from));
            let k = Point::new(&self.pair, q).at(&state.nodes, z);
            let norm = |b: [Octuple; 3]| dot(b, b).sqrt().max(Octuple::from(1e-30));
            let share = [1.0, 0.6].map(Octuple::from);
            let mut step = [0, 1].map(|i| share[i] / norm(k.b[i]));
            if self.pair.parameters() == 1 {
                step[1] = Octuple::from(0.0);
            }
            let moved = add(scale(k.b[0], step[0]), scale(k.b[1], step[1]));
            let factor = Octuple::from(length) / norm(moved);
            [0, 1].map(|i| (z[i] - step[i] * factor).to_f64())
        };
        let history = |q: usize| FrictionHistory {
            status: Accepted::Stick,
            anchor: anchor(q),
            slip: 0.0,
            rolling: RollingHistory::default(),
        };
        Some((0..self.pair.points()).map(history).collect())
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

fn scale_radii(master: &mut Master, s: f64) {
    match master {
        Master::Parametric { surface, .. } => match surface {
            RigidParametric::Cylinder { radius }
            | RigidParametric::Sphere { radius }
            | RigidParametric::Circle { radius } => *radius *= s,
            RigidParametric::Torus { major: a, minor: b }
            | RigidParametric::Helix {
                radius: a,
                pitch_over_2pi: b,
            } => (*a, *b) = (*a * s, *b * s),
            _ => {}
        },
        Master::Distance { body, .. } => match body {
            RigidDistance::Circle { radius }
            | RigidDistance::Cylinder { radius }
            | RigidDistance::Sphere { radius } => *radius *= s,
            RigidDistance::Torus { major, minor } => (*major, *minor) = (*major * s, *minor * s),
            _ => {}
        },
        _ => {}
    }
}
