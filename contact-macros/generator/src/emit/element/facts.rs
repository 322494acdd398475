//! What is known about an element before anything is emitted: its programs, sizes and parameters.

use proc_macro2::TokenStream;

use super::angle::Angle;
use super::expressions::nodes;
use super::friction::Friction;
use crate::emit::divisors::Divisors;
use crate::emit::parameters::{Parameters, master_shape, slave_shape};
use crate::emit::program::Emitted;
use crate::emit::rule::{WeightedPoint, gauss};
use crate::ir::Program;
use crate::linearise::{Kinematics, distance, gap, geometry, measure, normal, second_derivatives};
use crate::model::{Body, Element, Geometry, Master, Measure, Rule, Slave};

/// Facts about an element that several parts of the output need.
pub(super) struct Facts<'a> {
    pub(super) element: &'a Element,
    pub(super) kinematics: Kinematics,
    pub(super) parameters: Parameters,
    pub(super) points: Vec<WeightedPoint>,
    pub(super) slave_nodes: usize,
    pub(super) master_nodes: usize,
    pub(super) gap: Emitted,
    pub(super) tangent: Option<Emitted>,
    pub(super) measure: Option<Emitted>,
    pub(super) friction: Option<Friction>,
    pub(super) angle: Option<Angle>,
    pub(super) divisors: Divisors,
}

impl<'a> Facts<'a> {
    pub(super) fn new(element: &'a Element) -> Self {
        let kinematics = kinematics(element);
        let (gap, tangent) = match &element.master {
            Master::Distance { geometry, .. } => (
                distance::gap_program(geometry),
                distance::tangent_program(geometry),
            ),
            _ => (
                gap::gap_program(&kinematics),
                normal::tangent_program(&kinematics),
            ),
        };
        let measure = measure_program(element);
        let is_distance = matches!(element.master, Master::Distance { .. });
        let moves = element.measure == Measure::Current;
        Self {
            divisors: Divisors::new(
                is_distance.then_some(&tangent),
                measure.as_ref().filter(|_| moves),
            ),
            parameters: Parameters::new(element),
            points: points(element),
            slave_nodes: match &element.slave {
                Slave::Point => 1,
                Slave::Interpolated => 0,
                Slave::Projected(geometry) | Slave::Integrated { geometry, .. } => nodes(geometry),
            },
            master_nodes: match &element.master {
                Master::Point => 1,
                Master::Shape(geometry) => nodes(geometry),
                _ => 0,
            },
            friction: Friction::new(element, &kinematics),
            angle: Angle::new(element, &kinematics),
            element,
            kinematics,
            gap: Emitted::new(&gap, ""),
            tangent: (!element.residual_only).then(|| Emitted::new(&tangent, "")),
            measure: measure.map(|program| Emitted::new(&program, "")),
        }
    }

    pub(super) fn is_distance(&self) -> bool {
        matches!(self.element.master, Master::Distance { .. })
    }

    pub(super) fn projected_slave(&self) -> bool {
        matches!(self.element.slave, Slave::Projected(_))
    }

    /// D, P, H.
    pub(super) fn sizes(&self) -> (usize, usize, usize) {
        let p = if self.is_distance() {
            0
        } else {
            self.kinematics.projected()
        };
        (self.element.dimension, p, second_derivatives(p))
    }

    /// The programs of one contact point.
    pub(super) fn emitted(&self) -> impl Iterator<Item = &Emitted> {
        [
            Some(&self.gap),
            self.tangent.as_ref(),
            self.measure.as_ref(),
        ]
        .into_iter()
        .flatten()
        .chain(self.friction.iter().flat_map(Friction::emitted))
        .chain(self.angle.iter().flat_map(Angle::emitted))
    }

    /// The functions of the element's own programs; those of friction are shared.
    pub(super) fn functions(&self) -> impl Iterator<Item = TokenStream> {
        [
            Some(&self.gap),
            self.tangent.as_ref(),
            self.measure.as_ref(),
        ]
        .into_iter()
        .flatten()
        .map(Emitted::whole_function)
        .chain(
            self.angle
                .iter()
                .flat_map(Angle::emitted)
                .map(Emitted::guarded_function),
        )
    }

    /// Which nodes are tangent vectors.
    pub(super) fn vector_flags(&self) -> Vec<bool> {
        let mut flags = vec![];
        for (geometry, count) in [
            (slave_shape(self.element), self.slave_nodes),
            (master_shape(self.element), self.master_nodes),
        ] {
            match geometry.map(|geometry| &geometry.body) {
                Some(Body::Shape { vectors, .. }) => {
                    flags.extend((0..count).map(|a| vectors.contains(&a)));
                }
                _ => flags.extend(vec![false; count]),
            }
        }
        flags
    }
}

/// Which parameters move what, and where anything is curved.
pub(super) fn kinematics(element: &Element) -> Kinematics {
    let both = |slave: &Geometry, master: &Geometry| {
        let first = (
            geometry::curved(slave)[0],
            geometry::third_remaining(slave)[0],
        );
        let last = (
            geometry::curved(master)[0],
            geometry::third_remaining(master)[0],
        );
        (
            vec![first.0, false, last.0],
            vec![first.1, false, false, last.1],
        )
    };
    let (moving, (curved, third)) = match (&element.slave, &element.master) {
        (Slave::Projected(slave), Master::Shape(master)) => (vec![true, true], both(slave, master)),
        (
            Slave::Projected(slave),
            Master::Rigid {
                geometry: master, ..
            },
        ) => (vec![true, false], both(slave, master)),
        (_, Master::Shape(master)) => (
            vec![true; master.coordinates.len()],
            (geometry::curved(master), geometry::third_remaining(master)),
        ),
        (
            _,
            Master::Rigid {
                geometry: master, ..
            },
        ) => (
            vec![false; master.coordinates.len()],
            (geometry::curved(master), geometry::third_remaining(master)),
        ),
        (_, Master::Point | Master::Distance { .. }) => (vec![], (vec![], vec![])),
    };
    Kinematics {
        dimension: element.dimension,
        moving,
        curved,
        third,
        gap: element.gap,
        linearisation: element.linearisation,
    }
}

/// Integration points; without a rule one point without weight.
fn points(element: &Element) -> Vec<WeightedPoint> {
    match &element.slave {
        Slave::Integrated {
            geometry,
            rule: Rule::Gauss(counts),
        } => gauss(geometry, counts),
        _ => vec![([0.0; 2], 1.0)],
    }
}

/// The Jacobian of an integrated slave.
fn measure_program(element: &Element) -> Option<Program> {
    match &element.slave {
        Slave::Integrated {
            geometry,
            rule: Rule::Gauss(_),
        } => Some(measure::measure_program(
            element.dimension,
            geometry.coordinates.len(),
            element.measure == Measure::Current,
        )),
        _ => None,
    }
}
