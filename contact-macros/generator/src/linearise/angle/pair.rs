//! Two curves at their contact point: unit tangents, the cosine of their angle, the variation of the projection.
//!
//! q = sin²θ of the tangents u (slave) and v (master), each as long as its parameter makes it:
//!
//! ```text
//! q  = |τ_1×τ_2|² = 1 − c² ,   c = τ_1·τ_2 ,   τ_1 = u/|u| , τ_2 = v/|v|
//! δc = a_1·Du/|u| + a_2·Dv/|v| ,   a_1 = (τ_1×τ_2)×τ_1 = τ_2 − c τ_1 ,   a_2 = τ_2×(τ_1×τ_2) = τ_1 − c τ_2
//! Du = δr_,1 + r_,11 δζ¹ ,   δq = −2c δc
//! ```
//!
//! Regular at any angle: parallel, anti-parallel and crossing tangents alike.

use crate::ir::{Scalar, Sheet, Vector};
use crate::linearise::rolling::form::Motion;
use crate::linearise::shared::Kinematics;

/// What is known of the two curves when the code is made.
#[derive(Clone, Debug)]
pub struct Bends {
    /// Space dimension and projected parameters of the pair.
    pub kinematics: Kinematics,
    /// Whether the third derivatives of slave and master can be non-zero.
    pub third: [bool; 2],
}

pub const NO_CURVATURE: &str = "no projected curve has a second derivative";

/// One curve at the contact point.
pub struct Curve<'s> {
    pub tau: Vector<'s>,
    /// 1/|u|
    pub inverse: Scalar<'s>,
    /// a_c
    pub across: Vector<'s>,
    /// r_,cc and r_,ccc where the curve is projected, else zero.
    pub second: Vector<'s>,
    pub third: Vector<'s>,
    /// δζ^c; zero for a fixed point of the slave.
    pub shift: Motion<'s>,
}

impl<'s> Curve<'s> {
    /// a_c·v/|u|
    pub fn bend(&self, vector: Vector<'s>) -> Scalar<'s> {
        self.across.dot(vector) * self.inverse
    }
}

/// Both curves, slave first.
pub struct Pair<'s> {
    pub sheet: &'s Sheet,
    pub n: Vector<'s>,
    /// r = L n
    pub r: Vector<'s>,
    pub cosine: Scalar<'s>,
    pub curves: [Curve<'s>; 2],
    /// b_i of the projected parameters.
    pub tangents: Vec<Vector<'s>>,
    /// m^ij, i and j over the projected parameters.
    pub m: Vec<Vec<Scalar<'s>>>,
    /// Which curve a projected parameter belongs to.
    pub projected: Vec<usize>,
}

/// u, v and, of the projected curves, the derivatives beyond.
struct Inputs<'s> {
    n: Vector<'s>,
    distance: Scalar<'s>,
    tangents: [Vector<'s>; 2],
    second: [Vector<'s>; 2],
    third: [Vector<'s>; 2],
}

impl<'s> Inputs<'s> {
    fn new(sheet: &'s Sheet, bends: &Bends, with_third: bool) -> Self {
        let n = sheet.input_vector("n", 3);
        let distance = sheet.input("distance");
        let tangents = ["u", "v"].map(|name| sheet.input_vector(name, 3));
        let first = 2 - bends.kinematics.projected();
        let of_projected = |name: &str, remains: [bool; 2]| {
            [0, 1].map(|c| {
                let vector = (c >= first).then(|| sheet.input_vector(&format!("{name}_{c}"), 3));
                match vector {
                    Some(vector) if remains[c] => vector,
                    _ => sheet.zeros(3),
                }
            })
        };
        let curved = &bends.kinematics.curved;
        let curved = match first {
            0 => [curved[0], curved[2]],
            _ => [false, curved[0]],
        };
        let second = of_projected("second", curved);
        let third = match with_third {
            true => of_projected("third", bends.third),
            false => [sheet.zeros(3); 2],
        };
        Self {
            n,
            distance,
            tangents,
            second,
            third,
        }
    }
}

impl<'s> Pair<'s> {
    /// n, L, u, v, r_,cc and, `with_third`, r_,ccc.
    pub fn new(sheet: &'s Sheet, bends: &Bends, with_third: bool) -> Self {
        let inputs = Inputs::new(sheet, bends, with_third);
        let Inputs { n, tangents, .. } = inputs;
        let r = inputs.distance * n;
        let projected: Vec<usize> = (2 - bends.kinematics.projected()..2).collect();
        let m = inverse_of_f(r, &tangents, &inputs.second, &projected);
        let own: Vec<Vector> = projected.iter().map(|&c| tangents[c]).collect();
        let shifts = shifts(r, &own, &m, &projected);
        let one = sheet.one();
        let [(first, first_inverse), (last, last_inverse)] = tangents.map(|tangent| {
            let inverse = one / tangent.norm();
            (inverse * tangent, inverse)
        });
        let cosine = first.dot(last);
        let axis = first.cross(last);
        let curve = |c: usize, tau, inverse, across| Curve {
            tau,
            inverse,
            across,
            second: inputs.second[c],
            third: inputs.third[c],
            shift: shifts[c],
        };
        let curves = [
            curve(0, first, first_inverse, axis.cross(first)),
            curve(1, last, last_inverse, last.cross(axis)),
        ];
        Self {
            sheet,
            n,
            r,
            cosine,
            curves,
            tangents: own,
            m,
            projected,
        }
    }

    /// −2c factor: the factor of δc where `factor` is that of δq.
    pub fn by_cosine(&self, factor: Scalar<'s>) -> Scalar<'s> {
        -2.0 * self.cosine * factor
    }
}

/// m = F⁻¹, F_ij = a_ij + r·r_,ij with r_,12 = 0; det F from |b_1×b_2|², which keeps its digits where the tangents are
/// nearly parallel: `Symmetric::inverse` would lose them. [eq:F] [eq:det-F]
fn inverse_of_f<'s>(
    r: Vector<'s>,
    tangents: &[Vector<'s>; 2],
    second: &[Vector<'s>; 2],
    projected: &[usize],
) -> Vec<Vec<Scalar<'s>>> {
    let one = r[0].sheet().one();
    let square = |c: usize| tangents[c].dot(tangents[c]);
    let bend = |c: usize| r.dot(second[c]);
    if let [only] = *projected {
        let (a, h) = (square(only), bend(only));
        return vec![vec![one / (a + h)]];
    }
    let (a11, a22) = (square(0), square(1));
    let (h11, h22) = (bend(0), bend(1));
    let (f11, f22) = (a11 + h11, a22 + h22);
    let f12 = tangents[0].dot(tangents[1]);
    let area = tangents[0].cross(tangents[1]);
    // det(a + h) = det a + a_11 h_22 + h_11 F_22
    let (area, first, last) = (area.dot(area), a11 * h22, h11 * f22);
    let inverse = one / (area + first + last);
    let mixed = -(f12 * inverse);
    let (m11, m22) = (f22 * inverse, f11 * inverse);
    vec![vec![m11, mixed], vec![mixed, m22]]
}

/// δζ^i = −m^ij (b_j·δr + r·δr_,j) of both curves. [eq:variation]
fn shifts<'s>(
    r: Vector<'s>,
    tangents: &[Vector<'s>],
    m: &[Vec<Scalar<'s>>],
    projected: &[usize],
) -> [Motion<'s>; 2] {
    [0, 1].map(|c| {
        let mut form = Motion::zero(r[0].sheet());
        let Some(i) = projected.iter().position(|&owner| owner == c) else {
            return form;
        };
        for (j, &owner) in projected.iter().enumerate() {
            let minus = -m[i][j];
            form.position = form.position + minus * tangents[j];
            form.turning[owner] = minus * r;
        }
        form
    })
}
