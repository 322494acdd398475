//! The programs of geometries and laws by their declarations: each is built once.

use std::collections::HashMap;
use std::rc::Rc;

use super::geometry::FormulatedGeometry;
use super::law::{FormulatedLaw, FormulatedTangentialLaw};
use crate::model::{Geometry, Law, TangentialLaw};

/// What was formulated so far.
#[derive(Default)]
pub struct Catalogue {
    geometries: Known<Geometry, FormulatedGeometry>,
    laws: Known<Law, FormulatedLaw>,
    tangential_laws: Known<TangentialLaw, FormulatedTangentialLaw>,
}

/// What was formulated, by the address of its declaration, which it keeps alive.
type Known<D, F> = HashMap<*const D, Rc<F>>;

impl Catalogue {
    /// The programs of a geometry.
    pub fn geometry(&mut self, declared: &Rc<Geometry>) -> Rc<FormulatedGeometry> {
        let entry = self.geometries.entry(Rc::as_ptr(declared));
        Rc::clone(entry.or_insert_with(|| Rc::new(FormulatedGeometry::new(declared))))
    }

    /// The programs of a normal law.
    pub fn law(&mut self, declared: &Rc<Law>) -> Rc<FormulatedLaw> {
        let entry = self.laws.entry(Rc::as_ptr(declared));
        Rc::clone(entry.or_insert_with(|| Rc::new(FormulatedLaw::new(declared))))
    }

    /// The programs of a tangential law.
    pub fn tangential_law(&mut self, declared: &Rc<TangentialLaw>) -> Rc<FormulatedTangentialLaw> {
        let entry = self.tangential_laws.entry(Rc::as_ptr(declared));
        Rc::clone(entry.or_insert_with(|| Rc::new(FormulatedTangentialLaw::new(declared))))
    }
}
