//! The programs of declared laws.

use std::rc::Rc;

use super::routine::Routine;
use crate::linearise::{normal, tangential};
use crate::model::{Law, TangentialLaw};

/// A normal law with its programs.
#[derive(Debug)]
pub struct FormulatedLaw {
    /// The declaration.
    pub declared: Rc<Law>,
    /// N, N', W.
    pub law: Routine,
    /// Where there is contact.
    pub active: Routine,
    /// Where the law is defined, if not everywhere.
    pub valid: Option<Routine>,
    /// Operations as declared.
    pub operations: usize,
}

impl FormulatedLaw {
    /// The programs of `declared`.
    pub fn new(declared: &Rc<Law>) -> Self {
        let program = normal::law::law_program(declared);
        let bound =
            |name: &str, bound| Routine::new(&normal::law::bound_program(declared, name, bound));
        Self {
            operations: program.operations(),
            law: Routine::new(&program),
            active: bound("active", &declared.active),
            valid: declared.valid.as_ref().map(|valid| bound("valid", valid)),
            declared: Rc::clone(declared),
        }
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        [&self.law, &self.active].into_iter().chain(&self.valid)
    }
}

/// A tangential law with its programs.
#[derive(Debug)]
pub struct FormulatedTangentialLaw {
    /// The declaration.
    pub declared: Rc<TangentialLaw>,
    /// Stiffness and bound.
    pub friction: Routine,
    /// The force beyond the bound, where there is one.
    pub sliding: Option<Routine>,
    /// Operations of the stiffness and the bound as declared.
    pub operations: usize,
}

impl FormulatedTangentialLaw {
    /// The programs of `declared`.
    pub fn new(declared: &Rc<TangentialLaw>) -> Self {
        let program = tangential::law::friction_program(declared);
        let bounded = !declared.bound.is_empty();
        Self {
            operations: program.operations(),
            friction: Routine::new(&program),
            sliding: bounded.then(|| Routine::new(&tangential::law::sliding_program(declared))),
            declared: Rc::clone(declared),
        }
    }

    /// All programs.
    pub fn routines(&self) -> impl Iterator<Item = &Routine> {
        std::iter::once(&self.friction).chain(&self.sliding)
    }
}
