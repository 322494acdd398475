//! What is known about an element before anything is emitted: its programs, sizes and parameters.

use std::rc::Rc;

use super::angle::AnglePrograms;
use super::catalogue::Catalogue;
use super::divisors::Divisors;
use super::friction::FrictionPrograms;
use super::geometry::FormulatedGeometry;
use super::kinematics::kinematics;
use super::law::{FormulatedLaw, FormulatedTangentialLaw};
use super::parameters::Parameters;
use super::rolling::RollingPrograms;
use super::routine::Routine;
use super::rule::{WeightedPoint, gauss};
use crate::ir::Program;
use crate::linearise::normal::{gap, tangent};
use crate::linearise::shared::{Kinematics, measure, second_derivatives};
use crate::model::{Body, Element, Master, Measure, Rule, Slave};

/// Everything about an element that is emitted.
pub struct FormulatedElement<'a> {
    /// The declaration.
    pub declared: &'a Element,
    /// What the closed forms know of the pair.
    pub kinematics: Kinematics,
    /// The parameter list.
    pub parameters: Parameters,
    /// Integration points; one without weight where there are none.
    pub points: Vec<WeightedPoint>,
    /// Nodes of the slave; 0 where a host interpolates.
    pub slave_nodes: usize,
    /// Nodes of the master.
    pub master_nodes: usize,
    /// The slave's curve or surface.
    pub slave: Option<Rc<FormulatedGeometry>>,
    /// The master's geometry.
    pub master: Option<Rc<FormulatedGeometry>>,
    /// The normal law.
    pub law: Rc<FormulatedLaw>,
    /// The tangential law and that of rolling.
    pub tangential_laws: Vec<Rc<FormulatedTangentialLaw>>,
    /// Normal, distance and gap.
    pub gap: Routine,
    /// The tangent of normal contact, unless the element has a residual only.
    pub tangent: Option<Routine>,
    /// The Jacobian of an integrated slave.
    pub measure: Option<Routine>,
    /// Programs of tangential contact.
    pub friction: Option<FrictionPrograms>,
    /// Programs of the weight by an angle.
    pub angle: Option<AnglePrograms>,
    /// What the element divides by.
    pub divisors: Divisors,
}

impl<'a> FormulatedElement<'a> {
    /// The programs and numbers of `declared`.
    pub(super) fn new(declared: &'a Element, catalogue: &mut Catalogue) -> Self {
        let slave = declared.slave.geometry().map(|own| catalogue.geometry(own));
        let master = declared
            .master
            .geometry()
            .map(|own| catalogue.geometry(own));
        let (of_slave, of_master) = (slave.as_deref(), master.as_deref());
        let kinematics = kinematics(declared, of_slave, of_master);
        let (gap, tangent) = normal_programs(&kinematics, of_master);
        let measure = measure_program(declared);
        let distance = of_master.and_then(|master| master.tangent.as_ref());
        let moves = declared.measure == Measure::Current;
        let rolling = RollingPrograms::new(declared, &kinematics, of_slave, of_master);
        let laws = [
            declared.tangential.as_ref().map(|own| &own.law),
            declared.rolling.as_ref().map(|own| &own.law),
        ];
        Self {
            divisors: Divisors::new(distance, measure.as_ref().filter(|_| moves)),
            parameters: Parameters::new(declared),
            points: points(declared),
            slave_nodes: match &declared.slave {
                Slave::Point => 1,
                Slave::Interpolated => 0,
                Slave::Projected(geometry) | Slave::Integrated { geometry, .. } => geometry.nodes(),
            },
            master_nodes: match &declared.master {
                Master::Point => 1,
                Master::Shape(geometry) => geometry.nodes(),
                _ => 0,
            },
            friction: FrictionPrograms::new(declared, &kinematics, rolling),
            angle: AnglePrograms::new(declared, &kinematics, of_slave, of_master),
            law: catalogue.law(&declared.law),
            tangential_laws: (laws.into_iter().flatten())
                .map(|law| catalogue.tangential_law(law))
                .collect(),
            gap: Routine::new(&gap),
            tangent: (!declared.residual_only).then(|| Routine::new(&tangent)),
            measure: measure.as_ref().map(Routine::new),
            declared,
            kinematics,
            slave,
            master,
        }
    }

    /// Whether the master is a distance function.
    pub fn is_distance(&self) -> bool {
        matches!(self.declared.master, Master::Distance { .. })
    }

    /// Whether the slave's own parameter is projected.
    pub fn projected_slave(&self) -> bool {
        matches!(self.declared.slave, Slave::Projected(_))
    }

    /// D, P, H: space dimension, projected parameters, second derivatives.
    pub fn sizes(&self) -> (usize, usize, usize) {
        let p = self.kinematics.projected();
        (self.declared.dimension, p, second_derivatives(p))
    }

    /// The programs of the moments about two curves.
    pub fn rolling(&self) -> Option<&RollingPrograms> {
        self.friction.as_ref()?.rolling.as_ref()
    }

    /// The element's own programs of one contact point; those of friction are shared.
    pub fn own_routines(&self) -> impl Iterator<Item = &Routine> {
        std::iter::once(&self.gap)
            .chain(&self.tangent)
            .chain(&self.measure)
    }

    /// The programs of one contact point.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        self.own_routines()
            .chain(self.friction.iter().flat_map(FrictionPrograms::routines))
            .chain(self.angle.iter().flat_map(AnglePrograms::routines))
    }

    /// Which nodes are tangent vectors.
    pub fn vector_flags(&self) -> Vec<bool> {
        let mut flags = vec![];
        for (geometry, count) in [
            (&self.slave, self.slave_nodes),
            (&self.master, self.master_nodes),
        ] {
            match geometry.as_ref().map(|geometry| &geometry.declared.body) {
                Some(Body::Shape { vectors, .. }) => {
                    flags.extend((0..count).map(|a| vectors.contains(&a)));
                }
                _ => flags.extend(vec![false; count]),
            }
        }
        flags
    }
}

/// Gap and tangent of normal contact.
fn normal_programs(
    kinematics: &Kinematics,
    master: Option<&FormulatedGeometry>,
) -> (Program, Program) {
    match master.map(|master| (&master.source, &master.tangent)) {
        Some((gap, Some(tangent))) => (gap.clone(), tangent.clone()),
        _ => (
            gap::gap_program(kinematics),
            tangent::tangent_program(kinematics),
        ),
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
