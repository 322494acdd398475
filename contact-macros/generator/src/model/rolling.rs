//! Checks of `rolling`: moments about two curves, and the directions from which their angles are measured.

use std::rc::Rc;

use super::numeric::{Degree, degree};
use super::pair::Side;
use super::types::{Master, Reference, Slave, TangentialLaw};
use crate::diagnostics::{Mistakes, element as messages};

/// The law has one stiffness, the pair is two interpolated curves, and each has a principal normal unless a
/// director is given.
pub(super) fn check_reference(
    law: &Side<Rc<TangentialLaw>>,
    reference: Reference,
    pair: Option<(usize, &Slave, &Master)>,
    mistakes: &mut Mistakes,
) {
    let name = law.what.name.to_string();
    if law.what.stiffness.len() == 2 {
        mistakes.report(law.span, messages::rolling_with_axes(&name));
    }
    let Some((_, slave, master)) = pair else {
        return;
    };
    let curves = match (slave, master) {
        (Slave::Projected(slave), Master::Shape(master)) => [slave, master],
        (Slave::Projected(_), Master::Rigid { geometry, .. }) => {
            let rigid = geometry.name.to_string();
            mistakes.report(law.span, messages::rolling_on_rigid_curve(&name, &rigid));
            return;
        }
        _ => {
            mistakes.report(law.span, messages::rolling_without_curves(&name));
            return;
        }
    };
    if reference == Reference::Director {
        return;
    }
    for (number, curve) in curves.into_iter().enumerate() {
        if number == 1 && Rc::ptr_eq(curves[0], curve) {
            continue;
        }
        let of = curve.name.to_string();
        match degree(curve) {
            Degree::Straight => mistakes.report(law.span, messages::rolling_of_straight_curve(&of)),
            Degree::Cubic => {}
            Degree::Higher => mistakes.report(law.span, messages::rolling_of_higher_curve(&of)),
        }
    }
}
