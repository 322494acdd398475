//! Checks of geometries.

use super::domain::domain;
use super::expression::Expr;
use super::fields::{Fields, bindings, list, no_arguments, single, written_list};
use super::numeric;
use super::parameter::parameters;
use super::scope::{Role, Scope};
use super::types::{Body, ClosedProjection, Geometry};
use crate::diagnostics::{Mistakes, geometry as messages};
use crate::syntax::{self, Field, GeometryItem, GeometryKind};

/// The geometry an item describes; `None` after a mistake.
pub(super) fn geometry(
    item: &GeometryItem,
    built_in: bool,
    mistakes: &mut Mistakes,
) -> Option<Geometry> {
    let before = mistakes.count();
    let mut scope = Scope::default();
    for name in &item.head.coordinates {
        scope.declare(name, Role::Coordinate, mistakes);
    }
    let parameters = parameters(&item.head.parameters, &mut scope, mistakes);
    coordinate_count(item, mistakes);
    kind_rules(item, mistakes);
    let domain = domain(item, mistakes);
    let body = match item.kind {
        GeometryKind::Surface | GeometryKind::Curve => shape(item, scope, mistakes),
        GeometryKind::RigidSurface | GeometryKind::RigidCurve => rigid(item, scope, mistakes),
        GeometryKind::Distance => distance(item, scope, mistakes),
    };
    if mistakes.count() > before || !item.body.complete {
        return None;
    }
    let (bindings, body) = body?;
    let geometry = Geometry {
        name: item.name.clone(),
        docs: item.docs.clone(),
        coordinates: item.head.coordinates.clone(),
        parameters,
        domain: domain?,
        bindings,
        body,
        built_in,
    };
    numeric_rules(item, &geometry, mistakes);
    (mistakes.count() == before).then_some(geometry)
}

/// Bindings with the body that uses them.
type Parts = (Vec<(syn::Ident, Expr)>, Body);

fn coordinate_count(item: &GeometryItem, mistakes: &mut Mistakes) {
    let found = item.head.coordinates.len();
    let (fits, needed, example) = match item.kind {
        GeometryKind::Surface | GeometryKind::RigidSurface => (
            found == 2,
            "two coordinates",
            format!("{}(u, v)", item.name),
        ),
        GeometryKind::Curve | GeometryKind::RigidCurve => {
            (found == 1, "one coordinate", format!("{}(u)", item.name))
        }
        GeometryKind::Distance => (
            found == 2 || found == 3,
            "two or three coordinates",
            format!("{}(x, y, z)", item.name),
        ),
    };
    if !fits {
        let kind = item.kind.describe();
        let message = messages::wrong_coordinate_count(kind, needed, found, &example);
        mistakes.report(item.name.span(), message);
    }
}

/// Checks entries that only some kinds may have.
fn kind_rules(item: &GeometryItem, mistakes: &mut Mistakes) {
    let is_shape = matches!(item.kind, GeometryKind::Surface | GeometryKind::Curve);
    if let Some(word) = &item.rational
        && !is_shape
    {
        mistakes.report(word.span(), messages::rational_rigid());
    }
    if is_shape {
        for parameter in &item.head.parameters {
            let message = messages::parameter_of_shape(&parameter.name.to_string());
            mistakes.report(parameter.name.span(), message);
        }
    }
}

fn shape(item: &GeometryItem, mut scope: Scope, mistakes: &mut Mistakes) -> Option<Parts> {
    let known = ["N", "vectors"];
    let fields = Fields::new(
        &item.name,
        item.kind.describe(),
        &known,
        &item.body,
        mistakes,
    );
    let bindings = bindings(&item.body, &mut scope, mistakes);
    let example = "N = [.., ..];";
    let functions = fields.require("N", example, mistakes).and_then(|field| {
        no_arguments(field, mistakes);
        list(field, example, &scope, mistakes)
    });
    let mut vectors = Vec::new();
    if let Some(field) = fields.get("vectors") {
        if item.rational.is_some() {
            mistakes.report(field.name.span(), messages::rational_with_vectors());
        }
        vectors = indices(
            field,
            functions.as_ref().map_or(usize::MAX, Vec::len),
            mistakes,
        );
    }
    let body = Body::Shape {
        functions: functions?,
        vectors,
        rational: item.rational.is_some(),
    };
    Some((bindings, body))
}

/// The indices in `vectors`.
fn indices(field: &Field, controls: usize, mistakes: &mut Mistakes) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    no_arguments(field, mistakes);
    for value in written_list(field, "vectors = [1, 3];", mistakes).unwrap_or_default() {
        match value {
            syntax::Expr::Number(index, span)
                if index.fract() == 0.0 && *index < controls as f64 =>
            {
                let index = *index as usize;
                if found.last().is_some_and(|last| *last >= index) {
                    mistakes.report(*span, messages::vectors_not_ascending());
                }
                found.push(index);
            }
            syntax::Expr::Number(index, span) => {
                let message = messages::vector_out_of_range(&format!("{index}"), controls);
                mistakes.report(*span, message);
            }
            other => {
                let message = messages::vector_out_of_range("this", controls);
                mistakes.report(other.span(), message);
            }
        }
    }
    found
}

fn rigid(item: &GeometryItem, mut scope: Scope, mistakes: &mut Mistakes) -> Option<Parts> {
    let known = ["rho", "projection"];
    let fields = Fields::new(
        &item.name,
        item.kind.describe(),
        &known,
        &item.body,
        mistakes,
    );
    let bindings = bindings(&item.body, &mut scope, mistakes);
    let is_surface = item.kind == GeometryKind::RigidSurface;
    let example = if is_surface {
        "rho = [x, y, z];"
    } else {
        "rho = [x, y];"
    };
    let position = fields.require("rho", example, mistakes).and_then(|field| {
        no_arguments(field, mistakes);
        let position = list(field, example, &scope, mistakes)?;
        if !(position.len() == 3 || (position.len() == 2 && !is_surface)) {
            let kind = if is_surface { "surface" } else { "curve" };
            let message = messages::wrong_component_count(kind, position.len());
            mistakes.report(field.name.span(), message);
        }
        Some(position)
    });
    let components = position.as_ref().map(Vec::len);
    let projection = fields
        .get("projection")
        .and_then(|field| closed_projection(field, item, components, &scope, mistakes));
    Some((
        bindings,
        Body::Rigid {
            position: position?,
            projection,
        },
    ))
}

fn closed_projection(
    field: &Field,
    item: &GeometryItem,
    components: Option<usize>,
    scope: &Scope,
    mistakes: &mut Mistakes,
) -> Option<ClosedProjection> {
    let Some(point) = &field.arguments else {
        mistakes.report(field.name.span(), messages::projection_without_point());
        return None;
    };
    if let Some(components @ (2 | 3)) = components
        && components != point.len()
    {
        let message = messages::wrong_projection_point(point.len(), components);
        mistakes.report(field.name.span(), message);
    }
    let place = "a projection";
    let mut scope = scope.only(Role::Parameter, place, "the point and the parameters");
    for name in point {
        scope.declare(name, Role::Coordinate, mistakes);
    }
    let values = list(field, "projection(x, y, z) = [..];", &scope, mistakes)?;
    let coordinates = &item.head.coordinates;
    if values.len() != coordinates.len() {
        let names: Vec<String> = coordinates.iter().map(ToString::to_string).collect();
        let message = messages::wrong_projection_values(values.len(), &names);
        mistakes.report(field.name.span(), message);
    }
    Some(ClosedProjection {
        coordinates: point.clone(),
        values,
    })
}

fn distance(item: &GeometryItem, mut scope: Scope, mistakes: &mut Mistakes) -> Option<Parts> {
    let fields = Fields::new(
        &item.name,
        item.kind.describe(),
        &["d"],
        &item.body,
        mistakes,
    );
    let bindings = bindings(&item.body, &mut scope, mistakes);
    let example = "d = ..;";
    let field = fields.require("d", example, mistakes)?;
    let value = single(field, example, &scope, mistakes)?;
    Some((bindings, Body::Distance { value }))
}

/// Checks that need numbers.
fn numeric_rules(item: &GeometryItem, geometry: &Geometry, mistakes: &mut Mistakes) {
    let field = |name: &str| {
        item.body
            .statements
            .iter()
            .find_map(|statement| match statement {
                syntax::Statement::Field(field) if field.name == name => Some(field.name.span()),
                _ => None,
            })
    };
    if let Some(span) = field("N")
        && let Some(message) = numeric::partition_of_unity(geometry)
    {
        mistakes.report(span, message);
    }
    if let Some(span) = field("projection")
        && let Some(message) = numeric::projection(geometry)
    {
        mistakes.report(span, message);
    }
}

impl Geometry {
    /// Components of a position: 2 or 3 for rigid geometries, `None` for shapes, which take any.
    pub fn space(&self) -> Option<usize> {
        match &self.body {
            Body::Shape { .. } => None,
            Body::Rigid { position, .. } => Some(position.len()),
            Body::Distance { .. } => Some(self.coordinates.len()),
        }
    }

    /// Number of controls of a shape; 0 for rigid geometries.
    pub fn controls(&self) -> usize {
        match &self.body {
            Body::Shape { functions, .. } => functions.len(),
            _ => 0,
        }
    }

    /// Whether the geometry is a curve, deformable or rigid.
    pub fn is_curve(&self) -> bool {
        !matches!(self.body, Body::Distance { .. }) && self.coordinates.len() == 1
    }

    /// Whether the geometry is a surface, deformable or rigid.
    pub fn is_surface(&self) -> bool {
        !matches!(self.body, Body::Distance { .. }) && self.coordinates.len() == 2
    }

    /// What messages call it.
    pub fn describe(&self) -> &'static str {
        match (&self.body, self.is_curve()) {
            (Body::Shape { .. }, true) => "curve",
            (Body::Shape { .. }, false) => "surface",
            (Body::Rigid { .. }, true) => "rigid curve",
            (Body::Rigid { .. }, false) => "rigid surface",
            (Body::Distance { .. }, _) => "distance function",
        }
    }
}
