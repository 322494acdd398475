//! What a declaration means.
//!
//! [`Model::build`] is the only way from [`crate::syntax`] to a [`Model`]: a model that exists has
//! passed every check, so later phases check nothing. All mistakes of a file are reported at once; an
//! item with a mistake is left out, and mentioning it elsewhere is no further mistake.
//!
//! | question | file |
//! | --- | --- |
//! | what do names of items stand for? | `registry` |
//! | what do names in expressions stand for? | `scope`, `expression` |
//! | which fields does a block have? | `fields` |
//! | is this a geometry, a law, an element? | `geometry` (`domain`), `law`, `tangential`, `element` (`entries`, `pair`, `rule`, `law_entries`, `rolling`, `angle`) |
//! | which parameters are there? | `parameter` |
//! | do the numbers agree? | `numeric` |

mod angle;
mod domain;
mod element;
mod entries;
mod expression;
mod fields;
mod geometry;
mod law;
mod law_entries;
mod numeric;
mod pair;
mod parameter;
mod registry;
mod rolling;
mod rule;
mod scope;
mod tangential;
#[cfg(test)]
mod tests;
mod types;

use std::rc::Rc;

pub use expression::{BinaryOperator, Expr, Function};
pub use parameter::{RESERVED, RESERVED_PREFIXES};
pub use types::{
    Angle, Axis, Body, Bound, ClosedProjection, Domain, Element, Enforcement, Gap, Geometry, Law,
    Linearisation, Master, Measure, Model, Parameter, Reference, Rolling, Rule, Slave, Tangential,
    TangentialLaw,
};

use crate::diagnostics::Mistakes;
use crate::syntax::{File, Item};
use registry::{Entry, Registry};

/// The text of the library, in the language itself.
const LIBRARY: [&str; 2] = [
    include_str!("../../library/geometries.contact"),
    include_str!("../../library/laws.contact"),
];

impl Model {
    /// Checks a file. Names are looked up in the file first, then in `library`.
    ///
    /// # Errors
    /// All mistakes of the file, those of the parser included, in the order of the text.
    pub fn build(file: &File, library: Option<&Model>) -> syn::Result<Model> {
        build(file, library, false)
    }

    /// The built-in geometries and laws; the library has no elements.
    ///
    /// # Panics
    /// If the library itself has a mistake: a test makes sure that it has no mistake.
    pub fn library() -> Model {
        let text = LIBRARY.concat();
        let file: File = syn::parse_str(&text).expect("the library consists of tokens");
        build(&file, None, true).unwrap_or_else(|error| panic!("mistake in the library: {error}"))
    }
}

fn build(file: &File, library: Option<&Model>, built_in: bool) -> syn::Result<Model> {
    let mut mistakes = Mistakes::new();
    file.mistakes
        .iter()
        .cloned()
        .for_each(|error| mistakes.push(error));
    registry::check_item_names(file, &mut mistakes);
    let mut registry = Registry::new(file, library);
    let mut model = Model::default();
    for item in &file.items {
        declare(item, built_in, &mut model, &mut registry, &mut mistakes);
    }
    for item in &file.items {
        if let Item::Element(item) = item {
            model
                .elements
                .extend(element::element(item, &registry, &mut mistakes));
        }
    }
    mistakes.finish().map(|()| model)
}

/// Checks a geometry or law and gives its name a meaning; elements wait until all names have one.
fn declare(
    item: &Item,
    built_in: bool,
    model: &mut Model,
    registry: &mut Registry,
    mistakes: &mut Mistakes,
) {
    let entry = match item {
        Item::Geometry(item) => geometry::geometry(item, built_in, mistakes)
            .map(Rc::new)
            .map(|geometry| {
                model.geometries.push(geometry.clone());
                Entry::Geometry(geometry)
            }),
        Item::Law(item) => law::law(item, built_in, mistakes).map(Rc::new).map(|law| {
            model.laws.push(law.clone());
            Entry::Law(law)
        }),
        Item::TangentialLaw(item) => tangential::tangential_law(item, built_in, mistakes)
            .map(Rc::new)
            .map(|law| {
                model.tangential_laws.push(law.clone());
                Entry::TangentialLaw(law)
            }),
        Item::Element(_) => Some(Entry::Element),
    };
    registry.insert(item.name(), entry.unwrap_or(Entry::Broken));
}
