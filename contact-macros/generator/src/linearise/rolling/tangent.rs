//! The tangent of moments about two curves. [eq:rolling-tangent]

use super::curves::{Curves, NO_CURVATURE, NO_THIRD, NOT_TURNED, Pair, signed};
use super::form::{Motion, Variation};
use crate::ir::{Program, Scalar, Sheet, Vector};
use crate::linearise::shared::Kinematics;
use crate::linearise::tangential::form::variations;

/// A and B of A⊙B or A⊗B.
type Product<'s> = [Motion<'s>; 2];

/// The contact point, M_c, ∂M_c/∂φ_c, ∂M_c/∂p, N' → pairs A, B of A⊙B, then pairs of A⊗B. [eq:rolling-tangent]
pub fn tangent_program(kinematics: &Kinematics, curves: Curves) -> Program {
    let sheet = Sheet::new("rolling_tangent");
    write(&sheet, kinematics, curves);
    sheet.finish()
}

fn write(sheet: &Sheet, kinematics: &Kinematics, curves: Curves) {
    let pair = Pair::new(sheet, kinematics, curves);
    let moments = sheet.input_vector("moment", 2);
    let law = Law {
        stiffness: sheet.input_vector("stiffness", 2),
        by_pressure: sheet.input_vector("by_pressure", 2),
        slope: sheet.input("slope"),
    };
    let moments = signed(&moments);
    let forms = Forms::new(kinematics, &pair);
    let mut symmetric = vec![distance(&pair, &forms, &moments)];
    symmetric.extend(tilt(&pair, &forms, &moments));
    symmetric.extend(reference(&pair, &forms, &moments));
    symmetric.extend(transport(&pair, &forms, &moments));
    let moved = moment(&pair, &forms, &law);
    for (name, products) in [("symmetric", &symmetric[..]), ("moment", &moved)] {
        for (k, [left, right]) in products.iter().enumerate() {
            left.output(sheet, &format!("{name}_{k}_left"));
            right.output(sheet, &format!("{name}_{k}_right"));
        }
    }
}

/// Derivatives of the law.
struct Law<'s> {
    /// ∂M_c/∂φ_c
    stiffness: Vector<'s>,
    /// ∂M_c/∂p
    by_pressure: Vector<'s>,
    /// N'
    slope: Scalar<'s>,
}

/// Forms of the total variations of one curve.
struct Turning<'s> {
    /// Dψ
    angle: Motion<'s>,
    /// Forms of r: X_g, U_f, U_g.
    arm: Motion<'s>,
    tilt: Motion<'s>,
    swing: Motion<'s>,
    /// Forms of w: X_f, X_g, X_τ + ½ U_f, U_g.
    stretch: Motion<'s>,
    turn: Motion<'s>,
    axial: Motion<'s>,
    twist: Motion<'s>,
}

/// δζ^i, and the forms of both curves.
struct Forms<'s> {
    shifts: [Motion<'s>; 2],
    /// n·Dr
    approach: Motion<'s>,
    curves: [Turning<'s>; 2],
}

impl<'s> Forms<'s> {
    fn new(kinematics: &Kinematics, pair: &Pair<'s>) -> Self {
        let contact = &pair.contact;
        let sheet = contact.sheet;
        let z = variations(contact, kinematics);
        let shifts = [0, 1].map(|i| Motion::of_parameter(contact.frame[i], contact.n, &z));
        let [b1, b2] = pair.tangents;
        let moved = [(b1, &shifts[0]), (b2, &shifts[1])];
        let position = Variation::new(sheet, |form| &mut form.position, &moved);
        let mut approach = Motion::zero(sheet);
        approach.position = contact.n;
        let curves = [0, 1].map(|c| Turning::new(pair, c, &position, &shifts[c]));
        Self {
            shifts,
            approach,
            curves,
        }
    }
}

impl<'s> Turning<'s> {
    fn new(pair: &Pair<'s>, c: usize, position: &Variation<'s>, shift: &Motion<'s>) -> Self {
        let sheet = pair.contact.sheet;
        let curve = &pair.curves[c];
        let moved = [(pair.second[c], shift)];
        let tangent = Variation::new(sheet, |form| &mut form.turning[c], &moved);
        let reference = match pair.frenet {
            true => {
                let moved = [(pair.third[c], shift)];
                Variation::new(sheet, |form| &mut form.bending[c], &moved)
            }
            false => Variation::none(sheet),
        };
        let arm = 1.0 / pair.contact.distance;
        let back = -curve.slope;
        let x = |a: Vector<'s>| {
            let form = reference.along(a).plus(back, &tangent.along(a));
            form.scaled(curve.lever)
        };
        let u = |a: Vector<'s>| tangent.along(a).scaled(curve.inverse);
        let half = sheet.constant(0.5);
        let along_normal = u(curve.normal);
        let axial = x(curve.tau).plus(half, &along_normal);
        let swept = position.along(curve.across).scaled(arm);
        let turn = x(curve.binormal);
        let angle = swept.plus(sheet.constant(-1.0), &turn);
        Self {
            angle,
            arm: swept,
            tilt: u(pair.contact.n),
            swing: u(curve.across),
            stretch: x(curve.normal),
            turn,
            axial,
            twist: u(curve.binormal),
        }
    }
}

/// −M̂_c X_f⊙X_g of r: X_f = n·Dr/L for both curves. [eq:rolling-distance]
fn distance<'s>(pair: &Pair<'s>, forms: &Forms<'s>, moments: &[Scalar<'s>]) -> Product<'s> {
    let sheet = pair.contact.sheet;
    let moments = sheet.terms("rolling-distance", moments, "");
    let mut right = Motion::zero(sheet);
    for (curve, &moment) in forms.curves.iter().zip(&moments) {
        right = right.plus(-moment / pair.contact.distance, &curve.arm);
    }
    [forms.approach, right]
}

/// −M̂ (X_τ⊙U_g + ½ U_f⊙U_g) of r = ½ M̂ U_f⊙U_g, because r·u = 0 makes X_τ = −U_f. [eq:rolling-tilt]
fn tilt<'s>(pair: &Pair<'s>, forms: &Forms<'s>, moments: &[Scalar<'s>]) -> [Product<'s>; 2] {
    let moments = pair.contact.sheet.terms("rolling-tilt", moments, "");
    [0, 1].map(|c| {
        let curve = &forms.curves[c];
        [curve.tilt.scaled(0.5 * moments[c]), curve.swing]
    })
}

/// M̂ (X_f⊙X_g + (X_τ + ½ U_f)⊙U_g) of w. [eq:rolling-normal] [eq:rolling-twist]
fn reference<'s>(pair: &Pair<'s>, forms: &Forms<'s>, moments: &[Scalar<'s>]) -> Vec<Product<'s>> {
    let sheet = pair.contact.sheet;
    let normal = sheet.terms("rolling-normal", moments, "");
    let twist = sheet.terms("rolling-twist", moments, "");
    let curves = forms.curves.iter().enumerate();
    let products = curves.flat_map(|(c, curve)| {
        [
            [curve.stretch.scaled(normal[c]), curve.turn],
            [curve.axial.scaled(twist[c]), curve.twist],
        ]
    });
    products.collect()
}

/// δζ^i ⊙ M̂_c (p_r·δr_,i + ½ p_r·r_,ii δζ^i) + δζ^i ⊙ M̂_i (p_u·δr_,ii + p_w·δr_,iii + ½ p_u·r_,iii δζ^i):
/// the second variations of r, u, w without D²ζ. [eq:rolling-arm-turn] [eq:rolling-arm-curvature]
/// [eq:rolling-axis-turn] [eq:rolling-axis-curvature] [eq:rolling-bend-turn]
fn transport<'s>(pair: &Pair<'s>, forms: &Forms<'s>, moments: &[Scalar<'s>]) -> [Product<'s>; 2] {
    let sheet = pair.contact.sheet;
    let without_bend = if pair.frenet { NO_THIRD } else { NOT_TURNED };
    let arm = sheet.terms("rolling-arm-turn", moments, "");
    let curvature = sheet.terms("rolling-arm-curvature", moments, NO_CURVATURE);
    let axis = sheet.terms("rolling-axis-turn", moments, NO_CURVATURE);
    let third = sheet.terms("rolling-axis-curvature", moments, NO_THIRD);
    let bend = sheet.terms("rolling-bend-turn", moments, without_bend);
    let half = sheet.constant(0.5);
    [0, 1].map(|i| {
        let mut form = Motion::zero(sheet);
        let mut own = sheet.zero();
        for (c, curve) in pair.curves.iter().enumerate() {
            form.turning[i] = form.turning[i] + arm[c] * curve.by_position;
            own = own + curvature[c] * curve.by_position.dot(pair.second[i]);
        }
        let curve = &pair.curves[i];
        if pair.bends[i] {
            form.bending[i] = axis[i] * curve.by_tangent;
        }
        own = own + third[i] * curve.by_tangent.dot(pair.third[i]);
        if pair.frenet && pair.twists[i] {
            form.third[i] = bend[i] * curve.by_reference;
        }
        [form.plus(half * own, &forms.shifts[i]), forms.shifts[i]]
    })
}

/// Dφ_c ⊗ (∂M_c/∂φ_c Dφ_c + ∂M_c/∂p Δp), Δp = −N' n·Δr. [eq:rolling-stiffness] [eq:rolling-pressure]
fn moment<'s>(pair: &Pair<'s>, forms: &Forms<'s>, law: &Law<'s>) -> [Product<'s>; 2] {
    let sheet = pair.contact.sheet;
    let stiffness = sheet.terms("rolling-stiffness", &law.stiffness, "");
    let by_pressure = sheet.terms("rolling-pressure", &law.by_pressure, "");
    let by_pressure = signed(&by_pressure);
    let minus = -law.slope;
    [0, 1].map(|c| {
        let angle = forms.curves[c].angle;
        let mut right = angle.scaled(stiffness[c]);
        right.position = right.position + by_pressure[c] * minus * pair.contact.n;
        [angle, right]
    })
}
