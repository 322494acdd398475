//! What the descriptor of an element says beyond its declaration.

use super::digest::Digest;
use super::element::FormulatedElement;
use crate::ir::interpret;
use crate::model::{Body, Domain, Enforcement, Master, Measure, Slave};

/// Limits of a batch in lanes; the kernels assert them.
const MOST_UNKNOWNS: usize = 40;
const MOST_PARAMETERS: usize = 16;

/// How the closest point is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionMethod {
    /// There is nothing to find, or a closed form was declared.
    Closed,
    /// The position is affine in the parameters: one linear solve.
    Affine,
    /// Newton's method.
    Newton,
}

impl FormulatedElement<'_> {
    /// How the closest point is found.
    pub fn projection_method(&self) -> ProjectionMethod {
        let closed = match &self.declared.master {
            Master::Point | Master::Distance { .. } => true,
            Master::Rigid { geometry, .. } => {
                let declared = matches!(
                    &geometry.body,
                    Body::Rigid {
                        projection: Some(_),
                        ..
                    }
                );
                declared && !self.projected_slave()
            }
            Master::Shape(_) => false,
        };
        if closed {
            ProjectionMethod::Closed
        } else if !self.kinematics.curved.contains(&true) {
            ProjectionMethod::Affine
        } else {
            ProjectionMethod::Newton
        }
    }

    /// Domains of the projected parameters: of both curves, or of the master alone.
    pub fn domains(&self) -> [Domain; 2] {
        let master = match &self.declared.master {
            Master::Shape(geometry) | Master::Rigid { geometry, .. } => geometry.domain,
            _ => Domain::Unbounded,
        };
        match &self.declared.slave {
            Slave::Projected(geometry) => [geometry.domain, master],
            _ => [master, Domain::Unbounded],
        }
    }

    /// Periods of the parameters of a rigid master, or 0.
    pub fn periods(&self) -> [f64; 2] {
        match (&self.declared.master, &self.master) {
            (Master::Rigid { .. }, Some(master)) => {
                [0, 1].map(|i| master.periods.get(i).copied().unwrap_or(0.0))
            }
            _ => [0.0; 2],
        }
    }

    /// N_A, N_A,i, N_A,ij of the slave at each integration point, from the rows as declared.
    pub fn shape_values(&self) -> Vec<Vec<f64>> {
        let Some(slave) = &self.slave else {
            return vec![];
        };
        let p = slave.declared.coordinates.len();
        let points = self.points.iter();
        points
            .map(|(point, _)| interpret(&slave.source, &point[..p]))
            .collect()
    }

    /// Whether the tangent is symmetric.
    pub fn is_symmetric(&self) -> bool {
        self.declared.measure == Measure::Reference && self.friction.is_none()
    }

    /// Whether multipliers come with it.
    pub fn has_multiplier(&self) -> bool {
        self.declared.enforcement != Enforcement::Penalty
    }

    /// Whether a batch of it is evaluated in lanes.
    pub fn in_lanes(&self) -> bool {
        let nodes = self.slave_nodes + self.master_nodes;
        let fits = nodes * self.declared.dimension <= MOST_UNKNOWNS
            && self.parameters.entries.len() <= MOST_PARAMETERS;
        self.declared.lanes && fits
    }

    /// Whether open contacts may be told without their projection: a point against a facet of codimension one.
    pub fn can_screen(&self) -> bool {
        let (d, p, _) = self.sizes();
        matches!(self.declared.slave, Slave::Point) && self.master_nodes > 0 && p + 1 == d
    }

    /// Operations of one evaluation of the point programs, the laws included.
    pub fn operations(&self) -> usize {
        let laws = self.tangential_laws.iter().flat_map(|law| law.routines());
        self.routines()
            .chain([&self.law.law])
            .chain(laws)
            .map(|routine| routine.operations())
            .sum()
    }

    /// Hash of the programs and of what they are applied to.
    pub fn formulation(&self) -> u64 {
        let mut digest = Digest::new();
        for routine in self.routines() {
            digest.program(&routine.program);
        }
        let geometries = [&self.slave, &self.master].into_iter().flatten();
        for geometry in geometries {
            digest.program(&geometry.values.program);
        }
        let tangential = self.tangential_laws.iter().flat_map(|law| law.routines());
        for routine in self.law.routines().chain(tangential) {
            digest.program(&routine.program);
        }
        digest.value(&self.domains());
        digest.value(&self.points);
        digest.value(&self.vector_flags());
        digest.value(&self.parameters.layout);
        digest.value(&self.declared.enforcement);
        digest.finish()
    }
}
