//! The laws that an element names: `normal`, `tangential` and its `axis`, `rolling`.

use std::rc::Rc;

use proc_macro2::Span;
use syn::Ident;

use super::pair::{Side, name_of, plain, projected};
use super::registry::{Entry, Registry};
use super::types::{Axis, Law, Master, Parameter, Slave, TangentialLaw};
use crate::diagnostics::{Mistakes, element as messages, names};
use crate::syntax;

/// The normal law; `None` after a mistake.
pub(super) fn normal(
    entry: &syntax::Entry,
    registry: &Registry,
    mistakes: &mut Mistakes,
) -> Option<Side<Rc<Law>>> {
    plain(entry, mistakes);
    let name = name_of(entry, mistakes)?;
    match registry.get(name) {
        Some(Entry::Law(law)) => Some(Side {
            what: law.clone(),
            span: name.span(),
        }),
        other => {
            not_the_law(name, other, "normal", &registry.laws(), mistakes);
            None
        }
    }
}

/// The tangential law of the entry `key`, `tangential` or `rolling`; `None` after a mistake.
pub(super) fn tangential_law(
    entry: &syntax::Entry,
    key: &str,
    registry: &Registry,
    mistakes: &mut Mistakes,
) -> Option<Side<Rc<TangentialLaw>>> {
    plain(entry, mistakes);
    let name = name_of(entry, mistakes)?;
    match registry.get(name) {
        Some(Entry::TangentialLaw(law)) => Some(Side {
            what: law.clone(),
            span: name.span(),
        }),
        other => {
            let known = registry.tangential_laws();
            not_the_law(name, other, key, &known, mistakes);
            None
        }
    }
}

/// Reports what a name stands for instead of a law of the kind `entry`.
fn not_the_law(
    name: &Ident,
    found: Option<&Entry>,
    entry: &str,
    known: &[String],
    mistakes: &mut Mistakes,
) {
    let text = name.to_string();
    let message = match found {
        Some(Entry::Geometry(geometry)) => {
            messages::geometry_as_law(&text, geometry.describe(), entry)
        }
        Some(Entry::Law(_)) => messages::law_as_other_law(&text, "normal", entry),
        Some(Entry::TangentialLaw(_)) => messages::law_as_other_law(&text, "tangential", entry),
        Some(Entry::Element | Entry::Broken) => return,
        None => names::unknown_law(entry, &text, known),
    };
    mistakes.report(name.span(), message);
}

/// Parameters of the laws and of a rigid master share one list.
pub(super) fn check_parameters(
    master: Option<&Side<Master>>,
    normal: Option<&Side<Rc<Law>>>,
    tangential: [Option<&Side<Rc<TangentialLaw>>>; 2],
    mistakes: &mut Mistakes,
) {
    let geometry = master.and_then(|master| master.what.geometry());
    let mut owners: Vec<(&Ident, &[Parameter])> = geometry
        .map(|geometry| (&geometry.name, geometry.parameters.as_slice()))
        .into_iter()
        .collect();
    let normal = normal.map(|law| (&law.what.name, law.what.parameters.as_slice(), law.span));
    let tangential = tangential.into_iter().flatten();
    let tangential =
        tangential.map(|law| (&law.what.name, law.what.parameters.as_slice(), law.span));
    for (law, parameters, span) in normal.into_iter().chain(tangential) {
        for name in parameters.iter().map(|parameter| &parameter.name) {
            let has_it = |parameters: &[Parameter]| parameters.iter().any(|p| p.name == *name);
            if let Some((owner, _)) = owners.iter().find(|(_, known)| has_it(known)) {
                let (law, owner) = (law.to_string(), owner.to_string());
                let message = messages::parameter_of_both(&name.to_string(), &law, &owner);
                mistakes.report(span, message);
            }
        }
        owners.push((law, parameters));
    }
}

/// The entry `axis` as written: its key, and its word unless that is unknown.
pub(super) struct WrittenAxis {
    pub key: Span,
    pub word: Option<(Axis, Span)>,
}

/// The pair has the directions of sliding that the law needs, and the first of two axes is there.
///
/// An axis that is not there is a mistake if all entries could be read (`whole`).
pub(super) fn check_tangential(
    law: &Side<Rc<TangentialLaw>>,
    axis: Option<&WrittenAxis>,
    pair: Option<(usize, &Slave, &Master)>,
    whole: bool,
    mistakes: &mut Mistakes,
) {
    let name = law.what.name.to_string();
    let has_axes = law.what.stiffness.len() == 2;
    if let Some(axis) = axis
        && !has_axes
    {
        mistakes.report(axis.key, messages::axis_of_isotropic_law(&name));
    }
    let Some((_, slave, master)) = pair else {
        return;
    };
    match projected(slave, master) {
        0 => {
            let is_point = matches!(master, Master::Point);
            let message = messages::tangential_without_projection(&name, &master.name(), is_point);
            mistakes.report(law.span, message);
        }
        1 if has_axes => mistakes.report(law.span, messages::axes_of_one_direction(&name)),
        _ if has_axes => check_axis(law, axis, slave, whole, mistakes),
        _ => {}
    }
}

/// The first of two axes: it is there, and the slave has it.
fn check_axis(
    law: &Side<Rc<TangentialLaw>>,
    axis: Option<&WrittenAxis>,
    slave: &Slave,
    whole: bool,
    mistakes: &mut Mistakes,
) {
    let is_curve = matches!(slave, Slave::Integrated { geometry, .. } if geometry.is_curve());
    match axis {
        None if whole => {
            let message = messages::axis_missing(&law.what.name.to_string(), is_curve);
            mistakes.report(law.span, message);
        }
        Some(WrittenAxis {
            word: Some((Axis::Slave, span)),
            ..
        }) if !is_curve => mistakes.report(*span, messages::slave_without_direction()),
        _ => {}
    }
}
