//! Which oracle geometry and law each name of the built-in library is.

use contact_elements::ElementDescription;
use contact_elements::table::{AxisDescription, MasterDescription, SlaveDescription};

use crate::oracle::geometry::{
    DeclaredSurface, Interpolation, Placement, Region, RigidDistance, RigidParametric, Shape,
};
use crate::oracle::law::Law;
use crate::oracle::number::Number;
use crate::oracle::pair::Rolling;
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::pair::{IntegrationPoint, Master, Measure, Row, Slave};
use crate::oracle::tangential::TangentialLaw;

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

/// A circle run through clockwise, so that its left normal points outward.
#[derive(Debug)]
struct ClockwiseCircle {
    radius: f64,
}

impl DeclaredSurface for ClockwiseCircle {
    fn parameters(&self) -> usize {
        1
    }
    fn region(&self) -> Region {
        Region::FREE
    }
    fn window(&self) -> [[f64; 2]; 2] {
        [[-3.0, 3.0], [0.0, 0.0]]
    }
    fn point<D: Number>(&self, z: [D; 2]) -> [D; 3] {
        let position = -z[0];
        [
            position.cos() * self.radius,
            position.sin() * self.radius,
            D::from(0.0),
        ]
    }
}

/// Radius of the clockwise circle, which random states do not change.
pub(crate) const CIRCLE_RADIUS: f64 = 0.9;
/// Slave row and weight of interpolated elements.
/// The last two nodes are modes of a hierarchical discretisation, so the row does not sum to one.
const ROW: [f64; 4] = [0.125, 0.875, 0.3, -0.2];
const ROW_POSITIONS: [bool; 4] = [true, true, false, false];
const ROW_WEIGHT: f64 = 0.75;

fn shape(name: &str) -> Result<Interpolation, UnknownName> {
    let (shape, rational) = match name {
        "Line2" => (Shape::Line2, false),
        "Line3" => (Shape::Line3, false),
        "Hermite" => (Shape::Hermite, false),
        "BezierCurve2" => (Shape::BezierCurve(2), false),
        "BezierCurve3" => (Shape::BezierCurve(3), false),
        "RationalCurve2" => (Shape::BezierCurve(2), true),
        "RationalCurve3" => (Shape::BezierCurve(3), true),
        "Tri3" => (Shape::Tri3, false),
        "Tri6" => (Shape::Tri6, false),
        "Quad4" => (Shape::Quad4, false),
        "Quad9" => (Shape::Quad9, false),
        "BezierSurface2" => (Shape::BezierSurface(2), false),
        "RationalSurface2" => (Shape::BezierSurface(2), true),
        other => return Err(UnknownName(other.to_string())),
    };
    let weights = vec![1.0; shape.nodes()];
    Ok(if rational {
        Interpolation::rational(shape, weights)
    } else {
        Interpolation::new(shape)
    })
}

/// The slave of a declaration for the oracle.
pub(crate) fn slave(description: &ElementDescription) -> Result<Slave, UnknownName> {
    Ok(match &description.slave {
        SlaveDescription::Point => Slave::Point,
        SlaveDescription::Projected(geometry) => Slave::Curve(shape(geometry.name)?),
        SlaveDescription::Interpolated => Slave::Rows {
            rows: vec![Row {
                shape: ROW.to_vec(),
                weight: ROW_WEIGHT,
            }],
            positions: ROW_POSITIONS.to_vec(),
        },
        SlaveDescription::Given(geometry) => Slave::Fixed {
            geometry: shape(geometry.name)?,
            points: vec![IntegrationPoint {
                eta: [0.25, 0.25],
                weight: ROW_WEIGHT,
            }],
            measure: Measure::Unit,
        },
        SlaveDescription::Integrated(geometry, points) => Slave::Fixed {
            geometry: shape(geometry.name)?,
            points: points
                .iter()
                .map(|&(eta, weight)| IntegrationPoint { eta, weight })
                .collect(),
            measure: if description.current {
                Measure::Current
            } else {
                Measure::Reference
            },
        },
    })
}

/// The master of a declaration for the oracle.
pub(crate) fn master(description: &ElementDescription) -> Result<Master, UnknownName> {
    let placement = match (description.placed, description.descriptor.dimension) {
        (false, _) => Placement::Identity,
        (true, 3) => Placement::Spatial {
            origin: [0.0; 3],
            quaternion: [1.0, 0.0, 0.0, 0.0],
        },
        (true, _) => Placement::Planar {
            origin: [0.0; 2],
            direction: [1.0, 0.0],
        },
    };
    Ok(match &description.master {
        MasterDescription::Point => Master::Point,
        MasterDescription::Shape(geometry) => Master::Shape(shape(geometry.name)?),
        MasterDescription::Rigid(geometry) => Master::Parametric {
            surface: parametric(geometry.name)?,
            placement,
        },
        MasterDescription::Distance(geometry) => Master::Distance {
            body: distance(geometry.name)?,
            placement,
        },
    })
}

fn parametric(name: &str) -> Result<RigidParametric, UnknownName> {
    Ok(match name {
        "Plane" => RigidParametric::Plane,
        "Cylinder" => RigidParametric::Cylinder { radius: 1.0 },
        "Sphere" => RigidParametric::Sphere { radius: 1.0 },
        "Cone" => RigidParametric::Cone { alpha: 0.5 },
        "Torus" => RigidParametric::Torus {
            major: 1.0,
            minor: 0.3,
        },
        "Circle" => RigidParametric::Circle { radius: 1.0 },
        "Helix" => RigidParametric::Helix {
            radius: 1.0,
            pitch_over_2pi: 0.2,
        },
        "Circle2d" => RigidParametric::Declared(std::sync::Arc::new(ClockwiseCircle {
            radius: CIRCLE_RADIUS,
        })),
        other => return Err(UnknownName(other.to_string())),
    })
}

fn distance(name: &str) -> Result<RigidDistance, UnknownName> {
    Ok(match name {
        "PlaneDistance" => RigidDistance::Plane,
        "CylinderDistance" => RigidDistance::Cylinder { radius: 1.0 },
        "SphereDistance" => RigidDistance::Sphere { radius: 1.0 },
        "ConeDistance" => RigidDistance::Cone { alpha: 0.5 },
        "TorusDistance" => RigidDistance::Torus {
            major: 1.0,
            minor: 0.3,
        },
        "CircleDistance2d" => RigidDistance::Circle { radius: 1.0 },
        other => return Err(UnknownName(other.to_string())),
    })
}

/// The law of that name with parameters to be replaced.
pub(crate) fn law(name: &str) -> Result<Law, UnknownName> {
    Ok(match name {
        "Penalty" => Law::Penalty { eps_n: 1000.0 },
        "PowerLaw" => Law::Power {
            eps_n: 1000.0,
            exponent: 1.5,
        },
        "LogBarrier" => Law::Barrier {
            kappa: 10.0,
            distance: 0.1,
        },
        other => return Err(UnknownName(other.to_string())),
    })
}

/// The tangential law and axis of a declaration with parameters to be replaced.
pub(crate) fn tangential(
    description: &ElementDescription,
) -> Result<Option<Tangential>, UnknownName> {
    let Some(programs) = description.tangential else {
        return Ok(None);
    };
    let law = tangential_law(programs.name)?;
    let axis = match description.axis {
        AxisDescription::None => None,
        AxisDescription::Convected => Some(Axis::Convected([1.0, 0.5])),
        AxisDescription::Slave => Some(Axis::SlaveCurve),
    };
    let rolling = match description.rolling {
        None => None,
        Some(rolling) => Some(Rolling {
            law: tangential_law(rolling.law.name)?,
            directors: rolling.layout.directors.map(|_| DIRECTORS),
        }),
    };
    Ok(Some(Tangential {
        law,
        axis,
        tangent_plane: description.tangent_plane,
        rolling,
    }))
}

/// Directors to be replaced.
const DIRECTORS: [[f64; 3]; 2] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];

/// The tangential law of that name with parameters to be replaced.
fn tangential_law(name: &str) -> Result<TangentialLaw, UnknownName> {
    let (eps_t, mu) = (500.0, 0.3);
    Ok(match name {
        "Stick" => TangentialLaw::Stick { eps_t },
        // a lever arm times the pressure is the same function
        "Coulomb" | "RollingResistance" => TangentialLaw::Coulomb { eps_t, mu },
        "CoulombAdhesive" => TangentialLaw::Adhesive {
            eps_t,
            mu,
            cohesion: 5.0,
        },
        "CoulombStaticKinetic" => TangentialLaw::StaticKinetic {
            eps_t,
            mu_s: 0.4,
            mu_k: mu,
            decay: 0.1,
        },
        "CoulombOrthotropic" => TangentialLaw::Orthotropic {
            eps_t: [eps_t; 2],
            mu: [mu; 2],
        },
        other => return Err(UnknownName(other.to_string())),
    })
}
