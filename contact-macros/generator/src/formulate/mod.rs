//! From the checked model to all that is emitted: programs, the layout of parameters, what descriptors say.
//!
//! | file | question |
//! |---|---|
//! | `catalogue` | which programs does a geometry or law have? each is built once |
//! | `geometry`, `law` | the programs of a declared geometry or law |
//! | `budget` | is a declaration too large? |
//! | `element` | what is known of an element |
//! | `kinematics` | which parameters move what, where anything is curved |
//! | `friction`, `rolling`, `angle` | the programs of tangential contact, of moments, of the weight by an angle |
//! | `divisors` | what an element divides by |
//! | `parameters` | the parameter list and its offsets |
//! | `rule` | integration points |
//! | `description` | what the descriptor says |
//! | `routine`, `digest` | an optimised program with the name of its function; hashes |

mod angle;
mod budget;
mod catalogue;
mod description;
mod digest;
mod divisors;
mod element;
mod friction;
mod geometry;
mod kinematics;
mod law;
mod parameters;
mod rolling;
mod routine;
mod rule;

use std::rc::Rc;

use syn::Ident;

pub use crate::linearise::shared::{second_derivatives, third_derivatives};
use crate::model::Model;
use catalogue::Catalogue;

pub use angle::{AnglePrograms, MOST_PAIRS};
pub use budget::MOST_OPERATIONS;
pub use description::ProjectionMethod;
pub use divisors::Divisors;
pub use element::FormulatedElement;
pub use friction::FrictionPrograms;
pub use geometry::FormulatedGeometry;
pub use law::{FormulatedLaw, FormulatedTangentialLaw};
pub use parameters::{Entry, Parameters};
pub use rolling::RollingPrograms;
pub use routine::Routine;

/// All that is emitted for one model.
pub struct Formulation<'a> {
    /// What was declared.
    pub model: &'a Model,
    /// The declared geometries.
    pub geometries: Vec<Rc<FormulatedGeometry>>,
    /// The declared normal laws.
    pub laws: Vec<Rc<FormulatedLaw>>,
    /// The declared tangential laws.
    pub tangential_laws: Vec<Rc<FormulatedTangentialLaw>>,
    /// The declared elements.
    pub elements: Vec<FormulatedElement<'a>>,
}

impl Formulation<'_> {
    /// Names of geometries and laws, and the operations of the largest program of each.
    fn sizes(&self) -> impl Iterator<Item = (&Ident, usize)> {
        let geometries = self.geometries.iter();
        let laws = self.laws.iter();
        let tangential_laws = self.tangential_laws.iter();
        geometries
            .map(|own| (&own.declared.name, own.operations))
            .chain(laws.map(|own| (&own.declared.name, own.operations)))
            .chain(tangential_laws.map(|own| (&own.declared.name, own.operations)))
    }
}

/// Formulates everything that `model` declares.
///
/// # Errors
/// One message per geometry or law whose programs are too large, at its name.
pub fn formulate(model: &Model) -> syn::Result<Formulation<'_>> {
    let mut catalogue = Catalogue::default();
    let geometries = model.geometries.iter();
    let geometries = geometries.map(|own| catalogue.geometry(own)).collect();
    let laws = model.laws.iter().map(|own| catalogue.law(own)).collect();
    let tangential_laws = model.tangential_laws.iter();
    let tangential_laws = tangential_laws
        .map(|own| catalogue.tangential_law(own))
        .collect();
    let mut formulation = Formulation {
        model,
        geometries,
        laws,
        tangential_laws,
        elements: vec![],
    };
    budget::check(formulation.sizes())?;
    let elements = model.elements.iter();
    formulation.elements = elements
        .map(|element| FormulatedElement::new(element, &mut catalogue))
        .collect();
    Ok(formulation)
}
