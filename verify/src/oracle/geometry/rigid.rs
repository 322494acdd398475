//! Rigid geometries in their own frame, and where that frame is placed.

use std::sync::Arc;

use super::region::Region;
use crate::oracle::number::{Base, DistanceEvaluator, Number, SurfaceEvaluator};

/// A rigid curve or surface given by parameters, in its own frame. Lengths in the unit of the
/// problem, angles in radians.
#[derive(Debug, Clone)]
pub enum RigidParametric {
    /// `(u, 0)`: the x axis, two-dimensional problems.
    Line,
    /// `(u, v, 0)`, normal +z.
    Plane,
    /// `(R cos u, R sin u, v)`, normal outward.
    Cylinder {
        /// Radius R.
        radius: f64,
    },
    /// `(R cos v cos u, R cos v sin u, R sin v)`: longitude u, latitude v, normal outward.
    Sphere {
        /// Radius R.
        radius: f64,
    },
    /// `v (sin α cos u, sin α sin u, cos α)`: apex at the origin, v > 0, normal away from the axis.
    Cone {
        /// Half opening angle.
        alpha: f64,
    },
    /// `((R + r cos v) cos u, (R + r cos v) sin u, r sin v)`, normal outward.
    Torus {
        /// Radius R of the centre circle.
        major: f64,
        /// Radius r of the tube.
        minor: f64,
    },
    /// `(R cos u, R sin u, 0)`, in two dimensions (left normal towards the centre) or three.
    Circle {
        /// Radius R.
        radius: f64,
    },
    /// `(R cos u, R sin u, c u)`.
    Helix {
        /// Radius R.
        radius: f64,
        /// c: rise per radian.
        pitch_over_2pi: f64,
    },
    /// Anything else.
    Declared(Arc<dyn SurfaceEvaluator>),
}

impl RigidParametric {
    /// Number of parameters.
    pub fn parameters(&self) -> usize {
        match self {
            Self::Line | Self::Circle { .. } | Self::Helix { .. } => 1,
            Self::Declared(surface) => surface.parameter_count(),
            _ => 2,
        }
    }

    /// Range of the parameters; the built-in geometries have no bounds.
    pub fn region(&self) -> Region {
        match self {
            Self::Declared(surface) => surface.parameter_region(),
            _ => Region::FREE,
        }
    }

    /// Parameters among which to search for a start, and to draw random states from: one turn
    /// for angles, away from poles and apex, about the radius along straight directions.
    pub fn window(&self) -> [[f64; 2]; 2] {
        let turn = [0.0, std::f64::consts::TAU];
        match self {
            Self::Line | Self::Plane => [[-1.0, 1.0]; 2],
            Self::Cylinder { radius } => [turn, [-radius, *radius]],
            Self::Sphere { .. } => [turn, [-1.2, 1.2]],
            Self::Cone { .. } => [turn, [0.7, 2.0]],
            Self::Torus { .. } => [turn; 2],
            Self::Circle { .. } => [turn, [0.0; 2]],
            Self::Helix { .. } => [[-turn[1], turn[1]], [0.0; 2]],
            Self::Declared(surface) => surface.parameter_window(),
        }
    }

    /// Position in the own frame.
    #[inline]
    pub fn point<D: Number>(&self, z: [D; 2]) -> [D; 3] {
        let [u, v] = z;
        let ring = |radius: D, height: D| {
            let (sin, cos) = u.sin_cos();
            [radius * cos, radius * sin, height]
        };
        match self {
            Self::Line => [u, D::zero(), D::zero()],
            Self::Plane => [u, v, D::zero()],
            Self::Cylinder { radius } => ring(D::from(*radius), v),
            Self::Sphere { radius } => {
                let (sin, cos) = v.sin_cos();
                ring(cos * *radius, sin * *radius)
            }
            Self::Cone { alpha } => ring(v * alpha.sin(), v * alpha.cos()),
            Self::Torus { major, minor } => {
                let (sin, cos) = v.sin_cos();
                ring(cos * *minor + *major, sin * *minor)
            }
            Self::Circle { radius } => ring(D::from(*radius), D::zero()),
            Self::Helix {
                radius,
                pitch_over_2pi,
            } => ring(D::from(*radius), u * *pitch_over_2pi),
            Self::Declared(surface) => D::surface_point(&**surface, z),
        }
    }

    /// Position and derivatives with respect to the parameters, from nested duals.
    #[inline]
    pub fn evaluate<D: Base>(&self, z: [D; 2]) -> ([D; 3], [[D; 3]; 2]) {
        let (mut value, mut slopes) = ([D::zero(); 3], [[D::zero(); 3]; 2]);
        for k in 0..self.parameters() {
            let seed = |i: usize| D::nest(z[i], if i == k { D::one() } else { D::zero() });
            let parts = self.point([seed(0), seed(1)]).map(D::parts);
            value = parts.map(|p| p.0);
            slopes[k] = parts.map(|p| p.1);
        }
        (value, slopes)
    }
}

/// A rigid body given by its signed distance in its own frame, positive outside.
#[derive(Debug, Clone)]
pub enum RigidDistance {
    /// `y`: two-dimensional half plane.
    Line,
    /// `z`.
    Plane,
    /// `sqrt(x² + y²) - R` in two dimensions.
    Circle {
        /// Radius R.
        radius: f64,
    },
    /// `sqrt(x² + y²) - R`.
    Cylinder {
        /// Radius R.
        radius: f64,
    },
    /// `sqrt(x² + y² + z²) - R`.
    Sphere {
        /// Radius R.
        radius: f64,
    },
    /// `cos α sqrt(x² + y²) - sin α z`.
    Cone {
        /// Half opening angle.
        alpha: f64,
    },
    /// `sqrt((sqrt(x² + y²) - R)² + z²) - r`.
    Torus {
        /// Radius R of the centre circle.
        major: f64,
        /// Radius r of the tube.
        minor: f64,
    },
    /// Anything else.
    Declared(Arc<dyn DistanceEvaluator>),
}

impl RigidDistance {
    /// Distance of a point given in the own frame.
    #[inline]
    pub fn distance<D: Number>(&self, x: [D; 3]) -> D {
        let axial = || (x[0] * x[0] + x[1] * x[1]).sqrt();
        match self {
            Self::Line => x[1],
            Self::Plane => x[2],
            Self::Circle { radius } | Self::Cylinder { radius } => axial() - *radius,
            Self::Sphere { radius } => (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt() - *radius,
            Self::Cone { alpha } => axial() * alpha.cos() - x[2] * alpha.sin(),
            Self::Torus { major, minor } => {
                let tube = axial() - *major;
                (tube * tube + x[2] * x[2]).sqrt() - *minor
            }
            Self::Declared(body) => D::distance(&**body, x),
        }
    }
}

/// Where a rigid frame is: `global = origin + rotation local`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Placement {
    /// The global frame itself.
    Identity,
    /// Anywhere in space.
    Spatial {
        /// Origin (length).
        origin: [f64; 3],
        /// Quaternion (w, x, y, z) of the rotation, of any length but zero.
        quaternion: [f64; 4],
    },
    /// Anywhere in the plane.
    Planar {
        /// Origin (length).
        origin: [f64; 2],
        /// Image (c, s) of the local x axis, of any length but zero.
        direction: [f64; 2],
    },
}

impl Placement {
    /// Origin in global coordinates.
    pub fn origin(&self) -> [f64; 3] {
        match *self {
            Self::Identity => [0.0; 3],
            Self::Spatial { origin, .. } => origin,
            Self::Planar { origin, .. } => [origin[0], origin[1], 0.0],
        }
    }

    /// Rotation matrix by rows: `R v = q v q*` applied to the axes, for the normalised `q`.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        match *self {
            Self::Identity => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Spatial { quaternion: q, .. } => {
                let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
                let q = q.map(|v| v / length);
                let conjugate = [q[0], -q[1], -q[2], -q[3]];
                let mut rows = [[0.0; 3]; 3];
                for axis in 0..3 {
                    let mut pure = [0.0; 4];
                    pure[axis + 1] = 1.0;
                    let image = hamilton(hamilton(q, pure), conjugate);
                    for row in 0..3 {
                        rows[row][axis] = image[row + 1];
                    }
                }
                rows
            }
            Self::Planar {
                direction: [c, s], ..
            } => {
                let length = c.hypot(s);
                let (c, s) = (c / length, s / length);
                [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
            }
        }
    }

    /// What makes the placement unusable, if anything.
    pub fn defect(&self) -> Option<&'static str> {
        let length = match *self {
            Self::Identity => 1.0,
            Self::Spatial { quaternion, .. } => quaternion.iter().map(|v| v * v).sum(),
            Self::Planar { direction, .. } => direction.iter().map(|v| v * v).sum(),
        };
        let finite = f64::is_finite(length) && self.origin().iter().all(|v| v.is_finite());
        (!finite || length <= 0.0).then_some("placement without a rotation or an origin")
    }
}

/// Product of two quaternions (w, x, y, z).
fn hamilton(p: [f64; 4], q: [f64; 4]) -> [f64; 4] {
    [
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    ]
}
