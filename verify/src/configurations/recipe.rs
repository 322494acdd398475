//! The numbers of a pair: weights, radii, placement, law, offsets.

use super::random::Stream;
use super::state::Wanted;
use crate::oracle::geometry::{Interpolation, Placement, RigidDistance, RigidParametric, Shape};
use crate::oracle::law::Law;
use crate::oracle::pair::{GapKind, Master, Pair, Slave};

/// Which numbers of a template are drawn; the others stay as they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Freedom {
    /// Weights of rational geometries, in [0.5, 2].
    pub weights: bool,
    /// Radii, angles and pitches of built-in rigid geometries.
    pub rigid_parameters: bool,
    /// Placement of rigid geometries; if fixed, nothing is moved or turned as a whole.
    pub placement: bool,
    /// Parameters of built-in laws, normal and tangential, with convected axes.
    pub law: bool,
    /// Position of a single integration point; a rule of several points always stays.
    pub eta: bool,
    /// Orientation of a gap that has one.
    pub orientation: bool,
    /// `r0` of a signed gap, if the template's is not zero; that of a distance is always chosen
    /// to suit the requested status.
    pub r0: bool,
}

impl Freedom {
    /// Everything is drawn.
    pub const ALL: Self = Self {
        weights: true,
        rigid_parameters: true,
        placement: true,
        law: true,
        eta: true,
        orientation: true,
        r0: true,
    };
}

/// A pair with its numbers, for a problem of size one.
#[derive(Debug, Clone)]
pub struct Recipe {
    /// The pair; `r0` of a distance is still to be set.
    pub pair: Pair,
    /// Gap (length) aimed at.
    pub gap: f64,
}

/// Draws the numbers of one attempt.
pub fn draw(template: &Pair, freedom: &Freedom, wanted: Wanted, stream: &mut Stream) -> Recipe {
    let mut pair = template.clone();
    if let Master::Shape(geometry) = &mut pair.master {
        draw_weights(geometry, freedom, stream);
    }
    match &mut pair.slave {
        Slave::Curve(geometry) => draw_weights(geometry, freedom, stream),
        Slave::Fixed {
            geometry, points, ..
        } => {
            draw_weights(geometry, freedom, stream);
            if let ([point], true) = (points.as_mut_slice(), freedom.eta) {
                point.eta = draw_parameters(&geometry.shape, stream);
            }
        }
        Slave::Point | Slave::Rows { .. } => {}
    }
    draw_rigid(&mut pair.master, freedom, stream);
    if freedom.law {
        draw_law(&mut pair.law, stream);
    }
    if freedom.orientation && pair.gap != GapKind::Distance {
        pair.orientation = stream.sign();
    }
    if freedom.r0 && pair.gap == GapKind::Signed && pair.r0 != 0.0 {
        pair.r0 = stream.uniform(0.02, 0.1);
    }
    let gap = draw_gap(&pair.law, wanted, stream);
    Recipe { pair, gap }
}

fn draw_weights(geometry: &mut Interpolation, freedom: &Freedom, stream: &mut Stream) {
    if let (Some(weights), true) = (&mut geometry.weights, freedom.weights) {
        for weight in weights {
            *weight = stream.uniform(0.5, 2.0);
        }
    }
}

/// Parameters well inside the region of a shape.
pub fn draw_parameters(shape: &Shape, stream: &mut Stream) -> [f64; 2] {
    let region = shape.region();
    if region.triangle {
        let (a, b) = (stream.uniform(0.08, 0.6), stream.uniform(0.1, 0.9));
        return [a, b * (0.92 - a)];
    }
    let mut z = [0.0; 2];
    for (i, entry) in z.iter_mut().enumerate().take(shape.parameters()) {
        let half = 0.4 * region.extent(i);
        *entry = region.middle()[i] + stream.uniform(-half, half);
    }
    z
}

fn draw_rigid(master: &mut Master, freedom: &Freedom, stream: &mut Stream) {
    let placement = match master {
        Master::Parametric { surface, placement } => {
            if freedom.rigid_parameters {
                draw_parametric(surface, stream);
            }
            placement
        }
        Master::Distance { body, placement } => {
            if freedom.rigid_parameters {
                draw_distance(body, stream);
            }
            placement
        }
        Master::Point | Master::Shape(_) => return,
    };
    if !freedom.placement {
        return;
    }
    match placement {
        Placement::Identity => {}
        Placement::Spatial { origin, quaternion } => {
            *origin = stream.cube(1.0);
            *quaternion = stream.quaternion();
        }
        Placement::Planar { origin, direction } => {
            let [x, y, _] = stream.cube(1.0);
            *origin = [x, y];
            let (angle, length) = (stream.uniform(-3.2, 3.2), stream.uniform(0.5, 2.0));
            *direction = [length * angle.cos(), length * angle.sin()];
        }
    }
}

fn draw_parametric(surface: &mut RigidParametric, stream: &mut Stream) {
    match surface {
        RigidParametric::Cylinder { radius }
        | RigidParametric::Sphere { radius }
        | RigidParametric::Circle { radius } => *radius = stream.uniform(0.7, 1.6),
        RigidParametric::Cone { alpha } => *alpha = stream.uniform(0.3, 1.2),
        RigidParametric::Torus { major, minor } => {
            (*major, *minor) = (stream.uniform(1.2, 2.0), stream.uniform(0.5, 0.8));
        }
        RigidParametric::Helix {
            radius,
            pitch_over_2pi,
        } => {
            *radius = stream.uniform(0.7, 1.6);
            *pitch_over_2pi = stream.sign() * stream.uniform(0.2, 0.6);
        }
        RigidParametric::Line | RigidParametric::Plane | RigidParametric::Declared(_) => {}
    }
}

fn draw_distance(body: &mut RigidDistance, stream: &mut Stream) {
    match body {
        RigidDistance::Circle { radius }
        | RigidDistance::Cylinder { radius }
        | RigidDistance::Sphere { radius } => *radius = stream.uniform(0.7, 1.6),
        RigidDistance::Cone { alpha } => *alpha = stream.uniform(0.3, 1.2),
        RigidDistance::Torus { major, minor } => {
            (*major, *minor) = (stream.uniform(1.2, 2.0), stream.uniform(0.5, 0.8));
        }
        RigidDistance::Line | RigidDistance::Plane | RigidDistance::Declared(_) => {}
    }
}

fn draw_law(law: &mut Law, stream: &mut Stream) {
    match law {
        Law::Penalty { eps_n } => *eps_n = stream.log_uniform(1.0, 1e4),
        Law::Power { eps_n, exponent } => {
            *eps_n = stream.log_uniform(1.0, 1e4);
            *exponent = stream.uniform(1.2, 3.0);
        }
        Law::Barrier { kappa, distance } => {
            *kappa = stream.log_uniform(1.0, 1e4);
            *distance = stream.uniform(0.1, 0.3);
        }
        Law::Declared(_) => {}
    }
}

/// Penetrations between 1e-2 and 0.1 (small ones as likely as large ones), or gaps at which the
/// law does not act.
fn draw_gap(law: &Law, wanted: Wanted, stream: &mut Stream) -> f64 {
    match (law, wanted) {
        (Law::Barrier { distance, .. }, Wanted::Open) => distance * stream.uniform(1.05, 1.5),
        (Law::Barrier { distance, .. }, _) => distance * stream.uniform(0.05, 0.9),
        (_, Wanted::Open) => stream.log_uniform(1e-3, 0.3),
        _ => -stream.log_uniform(1e-2, 0.1),
    }
}
