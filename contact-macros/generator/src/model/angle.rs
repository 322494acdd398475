//! Checks of `angle`: contact of two curves at large or at small angles.

use std::rc::Rc;

use proc_macro2::Span;

use super::numeric::energy_begins_at_zero;
use super::pair::Side;
use super::types::{Enforcement, Gap, Law, Linearisation, Master, Measure, Slave};
use crate::diagnostics::{Mistakes, angle as messages};

/// Gap, linearisation and enforcement; `None` after a mistake.
pub(super) type Choices = (Option<Gap>, Option<Linearisation>, Option<Enforcement>);

/// The entries on which an angle depends.
pub(super) struct Others<'a> {
    pub pair: Option<(usize, &'a Slave, &'a Master)>,
    pub law: Option<&'a Side<Rc<Law>>>,
    pub choices: Choices,
    pub measure: Option<Measure>,
}

/// Two interpolated curves in space, without friction, whose contact has an energy.
pub(super) fn check_angle(
    others: &Others<'_>,
    has_friction: bool,
    span: Span,
    mistakes: &mut Mistakes,
) {
    let (gap, linearisation, enforcement) = others.choices;
    check_curves(others.pair, gap, span, mistakes);
    if has_friction {
        mistakes.report(span, messages::angle_with_friction());
    }
    if linearisation == Some(Linearisation::TangentPlane) {
        mistakes.report(span, messages::angle_on_tangent_plane());
    }
    if enforcement.is_some_and(|chosen| chosen != Enforcement::Penalty) {
        mistakes.report(span, messages::angle_with_multiplier());
    }
    if others.measure == Some(Measure::Current) {
        mistakes.report(span, messages::angle_with_current_measure());
    }
    let Some(law) = others.law else { return };
    let name = law.what.name.to_string();
    if law.what.energy.is_none() {
        mistakes.report(span, messages::angle_without_energy(&name));
    } else if !energy_begins_at_zero(&law.what) {
        mistakes.report(span, messages::angle_with_jump_of_energy(&name));
    }
}

/// Both sides are curves with nodes, in space, a distance apart.
fn check_curves(
    pair: Option<(usize, &Slave, &Master)>,
    gap: Option<Gap>,
    span: Span,
    mistakes: &mut Mistakes,
) {
    let Some((dimension, slave, master)) = pair else {
        return;
    };
    let slave_is_curve = match slave {
        Slave::Projected(_) => true,
        Slave::Integrated { geometry, .. } => geometry.is_curve(),
        Slave::Point | Slave::Interpolated => false,
    };
    let master_is_curve = matches!(master, Master::Shape(geometry) if geometry.is_curve());
    if dimension != 3 || !slave_is_curve || !master_is_curve {
        mistakes.report(span, messages::angle_without_curves());
    } else if gap.is_some_and(|gap| gap != Gap::Distance) {
        mistakes.report(span, messages::angle_of_edges());
    }
}
