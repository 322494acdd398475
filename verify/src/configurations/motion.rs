//! Moves, turns and scales a problem of size one as a whole, and splits positions into X + u.

use super::build::{Built, flat_positions};
use super::random::Stream;
use super::recipe::{Freedom, Recipe};
use super::state::Configuration;
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::law::Law;
use crate::oracle::pair::{Master, Pair};

/// A rotation with scale, and a shift.
struct Motion {
    quaternion: [f64; 4],
    scale: f64,
    shift: [f64; 3],
}

impl Motion {
    fn draw(pair: &Pair, freedom: &Freedom, stream: &mut Stream) -> Self {
        let scale = if scalable(pair, freedom) {
            stream.log_uniform(0.3, 3.0)
        } else {
            1.0
        };
        let fixed = match pair.placement() {
            _ if !is_rigid(pair) => false,
            Placement::Identity => true,
            _ => !freedom.placement,
        };
        let mut motion = Self {
            quaternion: [1.0, 0.0, 0.0, 0.0],
            scale,
            shift: [0.0; 3],
        };
        if fixed {
            return motion;
        }
        motion.shift = stream.cube(2.0);
        motion.quaternion = if pair.dimension == 2 {
            motion.shift[2] = 0.0;
            let half = stream.uniform(-1.6, 1.6);
            [half.cos(), 0.0, 0.0, half.sin()]
        } else {
            stream.quaternion()
        };
        motion
    }

    /// Image of a direction.
    fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        let frame = Placement::Spatial {
            origin: [0.0; 3],
            quaternion: self.quaternion,
        };
        frame
            .rotation()
            .map(|r| self.scale * (r[0] * v[0] + r[1] * v[1] + r[2] * v[2]))
    }

    /// Image of a position.
    fn moved(&self, v: [f64; 3]) -> [f64; 3] {
        let turned = self.turned(v);
        [0, 1, 2].map(|c| turned[c] + self.shift[c])
    }
}

fn is_rigid(pair: &Pair) -> bool {
    matches!(
        pair.master,
        Master::Parametric { .. } | Master::Distance { .. }
    )
}

/// Whether every length of the pair may be scaled.
fn scalable(pair: &Pair, freedom: &Freedom) -> bool {
    let declared = matches!(
        &pair.master,
        Master::Parametric {
            surface: RigidParametric::Declared(_),
            ..
        } | Master::Distance {
            body: RigidDistance::Declared(_),
            ..
        }
    );
    let has_length = matches!(pair.law, Law::Barrier { .. } | Law::Declared(_));
    let rigid_ok = !is_rigid(pair) || (freedom.rigid_parameters && !declared);
    let law_ok = !has_length || (freedom.law && !matches!(pair.law, Law::Declared(_)));
    rigid_ok && law_ok && (freedom.r0 || pair.r0 == 0.0)
}

/// Applies a random motion; starts and reports are still to be filled in.
pub fn apply(
    recipe: &Recipe,
    built: Built,
    freedom: &Freedom,
    stream: &mut Stream,
) -> Configuration {
    let motion = Motion::draw(&recipe.pair, freedom, stream);
    let Built {
        mut pair,
        mut slave,
        mut master,
    } = built;
    for (i, node) in slave.iter_mut().enumerate() {
        let position = pair.slave_is_position(i);
        *node = if position {
            motion.moved(*node)
        } else {
            motion.turned(*node)
        };
    }
    for (i, node) in master.iter_mut().enumerate() {
        let position = pair.master_is_position(i);
        *node = if position {
            motion.moved(*node)
        } else {
            motion.turned(*node)
        };
    }
    scale_lengths(&mut pair, motion.scale);
    move_placement(&mut pair.master, &motion);
    let positions = flat_positions(&pair, &slave, &master);
    let displacement: Vec<f64> = positions
        .iter()
        .map(|_| motion.scale * stream.uniform(-0.1, 0.1))
        .collect();
    let reference = positions
        .iter()
        .zip(&displacement)
        .map(|(x, u)| x - u)
        .collect();
    let start = vec![[0.0; 2]; pair.points()];
    Configuration {
        pair,
        reference,
        displacement,
        start,
        size: motion.scale,
        friction: vec![],
        points: vec![],
    }
}

fn scale_lengths(pair: &mut Pair, s: f64) {
    pair.r0 *= s;
    if let Law::Barrier { distance, .. } = &mut pair.law {
        *distance *= s;
    }
    match &mut pair.master {
        Master::Parametric { surface, .. } => match surface {
            RigidParametric::Cylinder { radius }
            | RigidParametric::Sphere { radius }
            | RigidParametric::Circle { radius } => *radius *= s,
            RigidParametric::Torus { major: a, minor: b }
            | RigidParametric::Helix {
                radius: a,
                pitch_over_2pi: b,
            } => {
                *a *= s;
                *b *= s;
            }
            RigidParametric::Line
            | RigidParametric::Plane
            | RigidParametric::Cone { .. }
            | RigidParametric::Declared(_) => {}
        },
        Master::Distance { body, .. } => match body {
            RigidDistance::Circle { radius }
            | RigidDistance::Cylinder { radius }
            | RigidDistance::Sphere { radius } => *radius *= s,
            RigidDistance::Torus { major, minor } => {
                *major *= s;
                *minor *= s;
            }
            RigidDistance::Line
            | RigidDistance::Plane
            | RigidDistance::Cone { .. }
            | RigidDistance::Declared(_) => {}
        },
        Master::Point | Master::Shape(_) => {}
    }
}

fn move_placement(master: &mut Master, motion: &Motion) {
    let (Master::Parametric { placement, .. } | Master::Distance { placement, .. }) = master else {
        return;
    };
    match placement {
        Placement::Identity => {}
        Placement::Spatial { origin, quaternion } => {
            *origin = motion.moved(*origin);
            *quaternion = product(motion.quaternion, *quaternion);
        }
        Placement::Planar { origin, direction } => {
            let [x, y, _] = motion.moved([origin[0], origin[1], 0.0]);
            *origin = [x, y];
            let [c, s, _] = motion.turned([direction[0], direction[1], 0.0]);
            *direction = [c, s];
        }
    }
}

/// Product of two quaternions (w, v): `(w₁w₂ - v₁·v₂, w₁v₂ + w₂v₁ + v₁×v₂)`.
fn product(p: [f64; 4], q: [f64; 4]) -> [f64; 4] {
    use crate::oracle::vector::{cross, dot};
    let (v, w) = ([p[1], p[2], p[3]], [q[1], q[2], q[3]]);
    let c = cross(v, w);
    let vector = [0, 1, 2].map(|i| p[0] * w[i] + q[0] * v[i] + c[i]);
    [p[0] * q[0] - dot(v, w), vector[0], vector[1], vector[2]]
}
