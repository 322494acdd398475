//! Names of items: what each stands for, in the file first, then in the library.

use std::collections::HashMap;
use std::rc::Rc;

use syn::Ident;

use super::types::{Geometry, Law, Model, TangentialLaw};
use crate::diagnostics::{Mistakes, names as messages};
use crate::syntax::{File, Item};

/// What a name stands for.
#[derive(Debug, Clone)]
pub(super) enum Entry {
    Geometry(Rc<Geometry>),
    Law(Rc<Law>),
    TangentialLaw(Rc<TangentialLaw>),
    Element,
    /// Declared, but with mistakes that were reported already.
    Broken,
}

/// All names that a declaration can mention.
#[derive(Debug, Default)]
pub(super) struct Registry {
    entries: HashMap<String, Entry>,
}

impl Registry {
    /// The names of the library and those of items that could not be read.
    pub fn new(file: &File, library: Option<&Model>) -> Self {
        let mut registry = Registry::default();
        if let Some(library) = library {
            for geometry in &library.geometries {
                registry.insert(&geometry.name, Entry::Geometry(geometry.clone()));
            }
            for law in &library.laws {
                registry.insert(&law.name, Entry::Law(law.clone()));
            }
            for law in &library.tangential_laws {
                registry.insert(&law.name, Entry::TangentialLaw(law.clone()));
            }
        }
        for name in &file.broken {
            registry.insert(name, Entry::Broken);
        }
        registry
    }

    /// Gives a name its meaning; the latest counts.
    pub fn insert(&mut self, name: &Ident, entry: Entry) {
        self.entries.insert(name.to_string(), entry);
    }

    /// The geometry or law of that name; `None` if it does not exist.
    pub fn get(&self, name: &Ident) -> Option<&Entry> {
        self.entries
            .get(&name.to_string())
            .filter(|entry| !matches!(entry, Entry::Element))
    }

    /// Names of all geometries that `suits` accepts, in alphabetical order.
    pub fn geometries(&self, suits: impl Fn(&Geometry) -> bool) -> Vec<String> {
        self.names(|entry| matches!(entry, Entry::Geometry(geometry) if suits(geometry)))
    }

    /// Names of all normal laws, in alphabetical order.
    pub fn laws(&self) -> Vec<String> {
        self.names(|entry| matches!(entry, Entry::Law(_)))
    }

    /// Names of all tangential laws, in alphabetical order.
    pub fn tangential_laws(&self) -> Vec<String> {
        self.names(|entry| matches!(entry, Entry::TangentialLaw(_)))
    }

    fn names(&self, suits: impl Fn(&Entry) -> bool) -> Vec<String> {
        let found = self.entries.iter().filter(|(_, entry)| suits(entry));
        let mut names: Vec<String> = found.map(|(name, _)| name.clone()).collect();
        names.sort_unstable();
        names
    }
}

/// Reports names that are declared twice, or that are not in camel case.
pub(super) fn check_item_names(file: &File, mistakes: &mut Mistakes) {
    let mut seen: HashMap<String, &Ident> = HashMap::new();
    for name in file.items.iter().map(Item::name) {
        let text = name.to_string();
        let plain = text.chars().all(|c| c.is_ascii_alphanumeric());
        if !plain || !text.starts_with(|c: char| c.is_ascii_uppercase()) {
            mistakes.report(name.span(), messages::not_camel_case(&text));
        }
        if let Some(first) = seen.get(&text) {
            mistakes.report(name.span(), messages::duplicate_item(&text));
            mistakes.report(first.span(), messages::first_declared_here(&text));
        } else {
            seen.insert(text, name);
        }
    }
}
