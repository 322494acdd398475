//! Two curves at their contact point: the triads about their tangents and the derivatives of their angles.
//! [eq:rolling-angle]

use crate::ir::{Scalar, Sheet, Vector};
use crate::linearise::shared::Kinematics;
use crate::linearise::tangential::point::Contact;
use crate::model::Reference;

pub const NOT_TURNED: &str = "the reference direction does not move with the curve";
pub const NO_CURVATURE: &str = "no curve has a second derivative";
pub const NO_THIRD: &str = "no curve has a third derivative";

/// What is known of the two curves when the code is made.
#[derive(Clone, Copy, Debug)]
pub struct Curves {
    /// The directions from which the angles are measured.
    pub reference: Reference,
    /// Whether r_,111 and r_,222 can be non-zero.
    pub third: [bool; 2],
}

/// σ_c: the shortest distance leaves curve c along −σ_c n.
pub const SIGNS: [f64; 2] = [1.0, -1.0];

/// σ_c x_c
pub fn signed<'s>(values: &[Scalar<'s>]) -> Vec<Scalar<'s>> {
    let pairs = values.iter().zip(SIGNS);
    pairs.map(|(&value, sign)| sign * value).collect()
}

/// The triad of w about u: g = u×w/|u×w|, so that nothing cancels where w is nearly along u.
pub struct Triad<'s> {
    /// τ = u/|u|
    pub tau: Vector<'s>,
    /// 1/|u|
    pub inverse: Scalar<'s>,
    /// g
    pub binormal: Vector<'s>,
    /// |u×w|
    pub area: Scalar<'s>,
}

impl<'s> Triad<'s> {
    pub fn new(u: Vector<'s>, w: Vector<'s>) -> Self {
        let one = u[0].sheet().one();
        let inverse = one / u.norm();
        let tau = inverse * u;
        let cross = u.cross(w);
        let area = cross.norm();
        Self {
            tau,
            inverse,
            binormal: one / area * cross,
            area,
        }
    }

    /// f = g×τ
    pub fn normal(&self) -> Vector<'s> {
        self.binormal.cross(self.tau)
    }
}

/// One curve's triads and derivatives of its angle ψ.
pub struct Curve<'s> {
    /// 1/|u|
    pub inverse: Scalar<'s>,
    pub tau: Vector<'s>,
    /// g of r: τ×n.
    pub across: Vector<'s>,
    /// f, g of w.
    pub normal: Vector<'s>,
    pub binormal: Vector<'s>,
    /// 1/h of w.
    pub lever: Scalar<'s>,
    /// c/|u| of w.
    pub slope: Scalar<'s>,
    /// ∂ψ/∂r, ∂ψ/∂u, ∂ψ/∂w.
    pub by_position: Vector<'s>,
    pub by_tangent: Vector<'s>,
    pub by_reference: Vector<'s>,
}

impl<'s> Curve<'s> {
    fn new(contact: &Contact<'s>, u: Vector<'s>, w: Vector<'s>) -> Self {
        let one = contact.sheet.one();
        let triad = Triad::new(u, w);
        let (tau, inverse, binormal) = (triad.tau, triad.inverse, triad.binormal);
        let normal = triad.normal();
        let lever = u.norm() / triad.area;
        let slope = w.dot(tau) * inverse;
        let across = tau.cross(contact.n);
        let arm = one / contact.distance;
        let minus = -lever;
        let tilt = slope * lever;
        Self {
            by_position: arm * across,
            by_tangent: tilt * binormal,
            by_reference: minus * binormal,
            inverse,
            tau,
            across,
            normal,
            binormal,
            lever,
            slope,
        }
    }
}

/// w_c as inputs: r_,cc, or σ_c times the director.
pub fn references(sheet: &Sheet, reference: Reference) -> [Vector<'_>; 2] {
    [0, 1].map(|c| match reference {
        Reference::PrincipalNormal => sheet.input_vector(&format!("w_{c}"), 3),
        Reference::Director => {
            let director = sheet.input_vector(&format!("director_{c}"), 3);
            sheet.constant(SIGNS[c]) * director
        }
    })
}

/// The contact point with both curves.
pub struct Pair<'s> {
    pub contact: Contact<'s>,
    pub curves: [Curve<'s>; 2],
    pub tangents: [Vector<'s>; 2],
    /// r_,cc and r_,ccc.
    pub second: [Vector<'s>; 2],
    pub third: [Vector<'s>; 2],
    /// Which of them can be non-zero, and with them the rows s_A,cc and s_A,ccc.
    pub bends: [bool; 2],
    pub twists: [bool; 2],
    pub frenet: bool,
}

impl<'s> Pair<'s> {
    /// n, L, b_i, r_,ij, E, r_,ijk and, where given, the directors.
    pub fn new(sheet: &'s Sheet, kinematics: &Kinematics, curves: Curves) -> Self {
        let contact = Contact::new(sheet, kinematics);
        let none = sheet.zeros(3);
        let tangents = [0, 1].map(|c| sheet.existing_vector(&format!("b_{c}"), 3));
        let bends = [kinematics.curved[0], kinematics.curved[2]];
        let second = [0, 1].map(|c| match bends[c] {
            true => sheet.existing_vector(&format!("r_{}", 2 * c), 3),
            false => none,
        });
        let third = [0, 1, 2, 3].map(|k| sheet.input_vector(&format!("third_{k}"), 3));
        let third = [0, 1].map(|c| if curves.third[c] { third[3 * c] } else { none });
        let references = match curves.reference {
            Reference::PrincipalNormal => second,
            Reference::Director => references(sheet, curves.reference),
        };
        Self {
            curves: [0, 1].map(|c| Curve::new(&contact, tangents[c], references[c])),
            contact,
            tangents,
            second,
            third,
            bends,
            twists: curves.third,
            frenet: curves.reference == Reference::PrincipalNormal,
        }
    }
}
