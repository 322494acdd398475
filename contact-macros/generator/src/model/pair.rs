//! The two sides of an element: who may be slave, who may be master, and who may meet whom.

use std::rc::Rc;

use proc_macro2::Span;
use syn::Ident;

use super::registry::{Entry, Registry};
use super::rule::{default_rule, rule};
use super::types::{Body, Gap, Geometry, Master, Rule, Slave};
use crate::diagnostics::{Mistakes, element as messages, names};
use crate::syntax::{self, Word};

/// A side with the place of its name.
#[derive(Clone)]
pub(super) struct Side<T> {
    pub what: T,
    pub span: Span,
}

/// The geometry of that name; `None` after a mistake, here or in its declaration.
fn geometry(
    name: &Ident,
    entry: &str,
    registry: &Registry,
    suits: impl Fn(&Geometry) -> bool,
    mistakes: &mut Mistakes,
) -> Option<Rc<Geometry>> {
    let text = name.to_string();
    let message = match registry.get(name) {
        Some(Entry::Geometry(geometry)) => return Some(geometry.clone()),
        Some(Entry::Law(_)) => messages::law_as_geometry(&text, "normal", entry),
        Some(Entry::TangentialLaw(_)) => messages::law_as_geometry(&text, "tangential", entry),
        Some(Entry::Element | Entry::Broken) => return None,
        None => names::unknown_geometry(&text, &registry.geometries(suits)),
    };
    mistakes.report(name.span(), message);
    None
}

/// The name after the colon.
pub(super) fn name_of<'a>(entry: &'a syntax::Entry, mistakes: &mut Mistakes) -> Option<&'a Ident> {
    match &entry.word {
        Word::Name(name) => Some(name),
        Word::Number(_, span) => {
            mistakes.report(*span, messages::number_for_name(&entry.key.to_string()));
            None
        }
    }
}

/// An entry that is one word takes neither `at` nor `placed`.
pub(super) fn plain(entry: &syntax::Entry, mistakes: &mut Mistakes) {
    let key = entry.key.to_string();
    if let Some(rule) = &entry.rule {
        mistakes.report(rule.name.span(), messages::rule_not_here(&key));
    }
    if let Some(placed) = &entry.placed {
        mistakes.report(placed.span(), messages::placed_not_here(&key));
    }
}

/// The slave; `None` after a mistake.
pub(super) fn slave(
    entry: &syntax::Entry,
    registry: &Registry,
    mistakes: &mut Mistakes,
) -> Option<Side<Slave>> {
    let name = name_of(entry, mistakes)?;
    let text = name.to_string();
    if let Some(placed) = &entry.placed {
        mistakes.report(placed.span(), messages::placed_not_here(&text));
    }
    let side = |what| {
        Some(Side {
            what,
            span: name.span(),
        })
    };
    if text == "point" || text == "interpolated" {
        if let Some(rule) = &entry.rule {
            mistakes.report(rule.name.span(), messages::rule_of_point(&text));
        }
        return side(if text == "point" {
            Slave::Point
        } else {
            Slave::Interpolated
        });
    }
    let is_shape = |geometry: &Geometry| matches!(geometry.body, Body::Shape { .. });
    let geometry = geometry(name, "slave", registry, is_shape, mistakes)?;
    if !is_shape(&geometry) {
        mistakes.report(
            name.span(),
            messages::rigid_slave(&text, geometry.describe()),
        );
        return None;
    }
    match &entry.rule {
        Some(written) => {
            let rule = rule(written, &geometry, mistakes)?;
            side(Slave::Integrated { geometry, rule })
        }
        None if geometry.is_curve() => side(Slave::Projected(geometry)),
        None => {
            let message = messages::surface_slave_without_rule(&text, default_rule(&geometry));
            mistakes.report(name.span(), message);
            None
        }
    }
}

/// The master; `None` after a mistake.
pub(super) fn master(
    entry: &syntax::Entry,
    registry: &Registry,
    mistakes: &mut Mistakes,
) -> Option<Side<Master>> {
    let name = name_of(entry, mistakes)?;
    let text = name.to_string();
    if let Some(rule) = &entry.rule {
        mistakes.report(rule.name.span(), messages::rule_not_here("master"));
    }
    let placed = entry.placed.is_some();
    let what = match text.as_str() {
        "interpolated" => {
            mistakes.report(name.span(), messages::interpolated_master());
            return None;
        }
        "point" => Master::Point,
        _ => {
            let geometry = geometry(name, "master", registry, |_| true, mistakes)?;
            match geometry.body {
                Body::Shape { .. } => Master::Shape(geometry),
                Body::Rigid { .. } => Master::Rigid { geometry, placed },
                Body::Distance { .. } => Master::Distance { geometry, placed },
            }
        }
    };
    if let (Some(word), Master::Point | Master::Shape(_)) = (&entry.placed, &what) {
        mistakes.report(word.span(), messages::placed_not_here(&text));
    }
    Some(Side {
        what,
        span: name.span(),
    })
}

impl Slave {
    /// The curve or surface, unless the slave is a point.
    pub fn geometry(&self) -> Option<&Rc<Geometry>> {
        match self {
            Slave::Point | Slave::Interpolated => None,
            Slave::Projected(geometry) | Slave::Integrated { geometry, .. } => Some(geometry),
        }
    }

    /// Whether the integration points belong to the element.
    pub fn has_own_points(&self) -> bool {
        matches!(
            self,
            Slave::Integrated {
                rule: Rule::Gauss(_),
                ..
            }
        )
    }
}

impl Master {
    /// The curve, surface or distance function, unless the master is a point.
    pub fn geometry(&self) -> Option<&Rc<Geometry>> {
        match self {
            Master::Point => None,
            Master::Shape(geometry) => Some(geometry),
            Master::Rigid { geometry, .. } | Master::Distance { geometry, .. } => Some(geometry),
        }
    }

    /// The rigid geometry, a distance function included.
    pub fn rigid(&self) -> Option<&Rc<Geometry>> {
        self.geometry()
            .filter(|_| !matches!(self, Master::Shape(_)))
    }

    /// Whether a rigid motion given at run time applies to it.
    pub fn is_placed(&self) -> bool {
        matches!(
            self,
            Master::Rigid { placed: true, .. } | Master::Distance { placed: true, .. }
        )
    }

    /// Number of coordinates of the master that are projected.
    pub fn projected(&self) -> usize {
        match self {
            Master::Point | Master::Distance { .. } => 0,
            Master::Shape(geometry) | Master::Rigid { geometry, .. } => geometry.coordinates.len(),
        }
    }

    pub(super) fn name(&self) -> String {
        self.geometry()
            .map_or_else(|| "point".to_string(), |geometry| geometry.name.to_string())
    }
}

/// Number of projected coordinates of the pair: the directions in which it can slide.
pub(super) fn projected(slave: &Slave, master: &Master) -> usize {
    master.projected() + usize::from(matches!(slave, Slave::Projected(_)))
}

/// Whether the two sides can meet in that many dimensions; a mistake if not.
pub(super) fn check_pair(
    dimension: usize,
    slave: &Side<Slave>,
    master: &Side<Master>,
    mistakes: &mut Mistakes,
) -> bool {
    let before = mistakes.count();
    check_dimension(dimension, slave, master, mistakes);
    if let Slave::Projected(curve) = &slave.what {
        check_projected(curve, dimension, slave.span, &master.what, mistakes);
    }
    mistakes.count() == before
}

/// A slave curve whose own coordinate is projected meets curves in 3D only.
fn check_projected(
    curve: &Geometry,
    dimension: usize,
    span: Span,
    master: &Master,
    mistakes: &mut Mistakes,
) {
    let curve = curve.name.to_string();
    let meets_curve = master
        .geometry()
        .is_some_and(|geometry| geometry.is_curve());
    if !meets_curve {
        let is_point = matches!(master, Master::Point);
        let name = master.name();
        let message = messages::projected_slave_without_curve(&curve, &name, is_point);
        mistakes.report(span, message);
    } else if dimension == 2 {
        mistakes.report(span, messages::projected_slave_in_two_dimensions(&curve));
    }
}

/// Each side has as many dimensions as the element.
fn check_dimension(
    dimension: usize,
    slave: &Side<Slave>,
    master: &Side<Master>,
    mistakes: &mut Mistakes,
) {
    let sides = [
        (slave.what.geometry(), slave.span, "slave"),
        (master.what.geometry(), master.span, "master"),
    ];
    for (geometry, span, entry) in sides {
        let Some(geometry) = geometry else { continue };
        let name = geometry.name.to_string();
        if dimension == 2 && geometry.is_surface() {
            mistakes.report(span, messages::surface_in_two_dimensions(&name, entry));
        } else if let Some(space) = geometry.space()
            && space != dimension
        {
            mistakes.report(span, messages::dimension_mismatch(&name, space, dimension));
        }
    }
}

/// The only gap that a pair can have, with the reason; `None` where several are possible.
pub(super) fn only_gap(
    dimension: usize,
    slave: &Slave,
    master: &Master,
) -> Option<(Gap, &'static str)> {
    match (slave, master) {
        (Slave::Projected(_), _) => None,
        (_, Master::Distance { .. }) => Some((Gap::Signed, "a distance function has a sign")),
        (_, master) if master.projected() + 1 == dimension => {
            Some((Gap::Signed, "the master has two sides"))
        }
        _ => Some((
            Gap::Distance,
            "the master has no sides that a sign could tell apart",
        )),
    }
}
