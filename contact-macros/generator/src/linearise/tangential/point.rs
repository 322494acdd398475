//! What the tangential forms share: the contact point in the orthonormal frame, and the slip with its force.
//! [eq:frame] [eq:F]

use crate::ir::{Scalar, Sheet, Symmetric, Vector, pairs};
use crate::linearise::shared::{Kinematics, pair_index, second_derivatives, third_derivatives};
use crate::model::{Axis, Linearisation};

/// Quantities at the contact point that the terms share, in the orthonormal frame.
pub struct Contact<'s> {
    pub sheet: &'s Sheet,
    pub n: Vector<'s>,
    /// L, or 0 on the tangent plane.
    pub distance: Scalar<'s>,
    /// E^i_q, one row for each i
    pub frame: Vec<Vector<'s>>,
    pub e: Vec<Vector<'s>>,
    /// r_,qr
    pub second: Vec<Vector<'s>>,
    /// m = (1 − Lκ)⁻¹
    pub m: Symmetric<'s>,
    pub d: usize,
    pub p: usize,
}

impl<'s> Contact<'s> {
    /// n, L, b_i, r_,ij, E
    pub fn new(sheet: &'s Sheet, kinematics: &Kinematics) -> Self {
        let (d, p) = (kinematics.dimension, kinematics.projected());
        let vectors = |name: &str, count: usize, n: usize| -> Vec<Vector<'s>> {
            let names = (0..count).map(|i| format!("{name}_{i}"));
            names.map(|name| sheet.input_vector(&name, n)).collect()
        };
        let n = sheet.input_vector("n", d);
        let distance = sheet.input("distance");
        let b = vectors("b", p, d);
        let second = vectors("r", second_derivatives(p), d);
        let frame = vectors("E", p, p);
        let distance = match kinematics.linearisation {
            Linearisation::Exact => distance,
            Linearisation::TangentPlane => sheet.zero(),
        };
        let declared: Vec<Vector> = (second.into_iter().zip(&kinematics.curved))
            .map(|(vector, &curved)| if curved { vector } else { sheet.zeros(d) })
            .collect();
        let e = (0..p)
            .map(|q| sheet.sum_vectors(d, 0..p, |i| frame[i][q] * b[i]))
            .collect();
        let second = framed_second(&frame, &declared, d);
        Self {
            m: inverse_of_f(n, distance, &second, p),
            sheet,
            n,
            distance,
            frame,
            e,
            second,
            d,
            p,
        }
    }

    /// r_,qr
    pub fn second(&self, q: usize, r: usize) -> Vector<'s> {
        self.second[pair_index(q, r)]
    }

    /// Σ_q factor(q) e_q
    pub fn along_axes(&self, factor: impl Fn(usize) -> Scalar<'s>) -> Vector<'s> {
        let sheet = self.sheet;
        sheet.sum_vectors(self.d, 0..self.p, |q| factor(q) * self.e[q])
    }

    /// −τ_q = −m_qr t_r
    pub fn minus_raised(&self, t: &[Scalar<'s>]) -> Vec<Scalar<'s>> {
        let raised: Vec<Scalar> = (0..self.p)
            .map(|q| self.sheet.sum(0..self.p, |r| self.m[(q, r)] * t[r]))
            .collect();
        raised.into_iter().map(|tau| -tau).collect()
    }

    /// v^i = E^i_q v_q
    pub fn on_declared(&self, v: &[Scalar<'s>], i: usize) -> Scalar<'s> {
        self.sheet.sum(0..v.len(), |q| self.frame[i][q] * v[q])
    }

    /// τ^i n·r_,iqr for the pair q, r: the declared third derivatives, once with a vector, twice in the frame.
    pub fn framed_third(
        &self,
        third: &[Scalar<'s>],
        v: &[Scalar<'s>],
        pair: (usize, usize),
    ) -> Scalar<'s> {
        let factors = framing(&self.frame, pair);
        self.sheet
            .sum(pairs(self.p).zip(factors), |((j, k), factor)| {
                factor * self.sheet.sum(0..v.len(), |i| v[i] * third[i + j + k])
            })
    }
}

/// Factors of the entries 11, 12, 22 of a symmetric tensor in E^i_q E^j_r T_ij.
fn framing<'s>(frame: &[Vector<'s>], (q, r): (usize, usize)) -> Vec<Scalar<'s>> {
    pairs(frame.len())
        .map(|(i, j)| match i == j {
            true => frame[i][q] * frame[j][r],
            false => frame[i][q] * frame[j][r] + frame[j][q] * frame[i][r],
        })
        .collect()
}

/// r_,qr = E^i_q E^j_r r_,ij
fn framed_second<'s>(frame: &[Vector<'s>], declared: &[Vector<'s>], d: usize) -> Vec<Vector<'s>> {
    pairs(frame.len())
        .map(|pair| {
            let factors = framing(frame, pair);
            let sheet = factors[0].sheet();
            sheet.sum_vectors(d, 0..factors.len(), |h| factors[h] * declared[h])
        })
        .collect()
}

/// m = F⁻¹ with F = 1 − Lκ, κ_qr = −n·r_,qr: F of `normal::tangent` in the orthonormal basis, where a = 1. [eq:F]
fn inverse_of_f<'s>(
    n: Vector<'s>,
    distance: Scalar<'s>,
    second: &[Vector<'s>],
    p: usize,
) -> Symmetric<'s> {
    let sheet = distance.sheet();
    let one = sheet.one();
    let bend = Symmetric::new(sheet, p, |(q, r)| {
        distance * n.dot(second[pair_index(q, r)])
    });
    let diagonal: Vec<Scalar> = (0..p).map(|q| one + bend[(q, q)]).collect();
    let f = Symmetric::new(sheet, p, |(q, r)| match q == r {
        true => diagonal[q],
        false => bend[(q, r)],
    });
    f.inverse(one)
}

/// Further inputs of the tangent.
pub struct Sliding<'s> {
    /// n·r_,ijk of the declared parameters, by the sum of the indices.
    pub third: Vec<Scalar<'s>>,
    pub slip: Vector<'s>,
    pub t: Vector<'s>,
    /// Factor of δζ̂^q: t_q, with rolling also the share of the moments.
    pub force: Vector<'s>,
    /// C_qr = ∂t_q/∂s_r, row by row
    pub c: Vec<Scalar<'s>>,
    /// h_q = ∂t_q/∂p
    pub h: Vector<'s>,
    /// N'
    pub slope: Scalar<'s>,
    pub slave_tangent: Option<Vector<'s>>,
}

impl<'s> Sliding<'s> {
    /// r_,ijk, s, t, C, h, N' and, where they matter, the share of the moments and the slave's tangent.
    pub fn new(
        kinematics: &Kinematics,
        contact: &Contact<'s>,
        axis: Option<Axis>,
        rolls: bool,
    ) -> Self {
        let (sheet, d, p) = (contact.sheet, contact.d, contact.p);
        let third: Vec<Vector> = (0..third_derivatives(p))
            .map(|k| sheet.input_vector(&format!("third_{k}"), d))
            .collect();
        let slip = sheet.input_vector("s", p);
        let t = sheet.input_vector("t", p);
        let rows = (0..p).map(|q| sheet.input_vector(&format!("c_{q}"), p));
        let c = rows.flat_map(|row| row.to_vec()).collect();
        let h = sheet.input_vector("h", p);
        let slope = sheet.input("slope");
        let force = match rolls {
            true => sheet.input_vector("force", p),
            false => t,
        };
        let slave_tangent =
            (axis == Some(Axis::Slave)).then(|| sheet.input_vector("slave_tangent", d));
        let third = (third.into_iter().zip(&kinematics.third))
            .map(|(third, &remains)| match remains {
                true => contact.n.dot(third),
                false => sheet.zero(),
            })
            .collect();
        Self {
            third,
            slip,
            t,
            force,
            c,
            h,
            slope,
            slave_tangent,
        }
    }
}
