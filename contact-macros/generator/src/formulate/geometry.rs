//! The programs of a declared geometry, and what follows from them.

use std::rc::Rc;

use super::routine::Routine;
use crate::ir::Program;
use crate::linearise::normal::distance;
use crate::linearise::shared::geometry;
use crate::model::{Body, Geometry};

/// A geometry with its programs.
#[derive(Debug)]
pub struct FormulatedGeometry {
    /// The declaration.
    pub declared: Rc<Geometry>,
    /// Rows, position or gap as declared, before any pass.
    pub source: Program,
    /// The same after all passes.
    pub values: Routine,
    /// Third derivatives; a distance function has none.
    pub third: Option<Routine>,
    /// The closed projection, where one is declared.
    pub projection: Option<Routine>,
    /// The tangent of a distance function, before any pass.
    pub tangent: Option<Program>,
    /// Which second derivatives (11, 12, 22) can be non-zero.
    pub curved: Vec<bool>,
    /// Which third derivatives (111, 112, 122, 222) can be non-zero.
    pub third_remaining: Vec<bool>,
    /// The period of each parameter of a rigid geometry, or 0.
    pub periods: Vec<f64>,
    /// Operations of the largest program as declared.
    pub operations: usize,
}

impl FormulatedGeometry {
    /// The programs of `declared`.
    pub fn new(declared: &Rc<Geometry>) -> Self {
        let (source, third, tangent) = match &declared.body {
            Body::Shape { .. } => (
                geometry::shape_program(declared),
                Some(geometry::shape_third_program(declared)),
                None,
            ),
            Body::Rigid { .. } => (
                geometry::rigid_program(declared),
                Some(geometry::rigid_third_program(declared)),
                None,
            ),
            Body::Distance { .. } => (
                distance::gap_program(declared),
                None,
                Some(distance::tangent_program(declared)),
            ),
        };
        let largest = [third.as_ref(), tangent.as_ref()].into_iter().flatten();
        let largest = largest.map(Program::operations).max().unwrap_or(0);
        let third_remaining = third
            .as_ref()
            .map_or(vec![], |third| geometry::third_remaining(declared, third));
        Self {
            values: Routine::new(&source),
            third: third.as_ref().map(Routine::new),
            projection: geometry::projection_program(declared)
                .map(|program| Routine::new(&program)),
            curved: geometry::curved(declared, &source),
            third_remaining,
            periods: geometry::periods(declared, &source),
            operations: largest.max(match tangent {
                Some(_) => 0,
                None => source.operations(),
            }),
            declared: Rc::clone(declared),
            source,
            tangent,
        }
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        std::iter::once(&self.values)
            .chain(&self.third)
            .chain(&self.projection)
    }

    /// Whether any third derivative can be non-zero.
    pub fn has_third(&self) -> bool {
        self.third_remaining.contains(&true)
    }

    /// Whether all second derivatives vanish.
    pub fn is_affine(&self) -> bool {
        !self.curved.contains(&true)
    }
}
