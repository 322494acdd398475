//! Linear forms over the motion of one contact point: the rows in which a tangential linearisation is written.
//!
//! A form is written in the variations Z_k of the projected parameters and in the motions apart from them, along
//! the axes of the contact point; most of its entries vanish. Only its last step, over the declared parameters,
//! has vectors.

use super::point::Contact;
use crate::ir::{Scalar, Vector};
use crate::linearise::shared::{Kinematics, pair_index, second_derivatives};

/// Z_q = position·δr + turning_i n·δr_,i, i over the declared parameters.
pub struct Variation<'s> {
    /// Factor of δr.
    pub position: Vector<'s>,
    /// Factors of n·δr_,i.
    pub turning: Vec<Scalar<'s>>,
}

/// Z_q = −m_qr (e_r·δr + L n·δr_,r) [eq:variation]
pub fn variations<'s>(contact: &Contact<'s>, kinematics: &Kinematics) -> Vec<Variation<'s>> {
    let p = contact.p;
    let zero = contact.sheet.zero();
    (0..p)
        .map(|q| {
            let minus: Vec<Scalar> = (0..p).map(|r| -contact.m[(q, r)]).collect();
            let position = contact.along_axes(|r| minus[r]);
            let levers: Vec<Scalar> = minus.iter().map(|&m| m * contact.distance).collect();
            let turning = (0..p)
                .map(|i| match kinematics.moving[i] {
                    true => contact.on_declared(&levers, i),
                    false => zero,
                })
                .collect();
            Variation { position, turning }
        })
        .collect()
}

/// Coefficients of a linear form of δx.
#[derive(Clone)]
pub struct Form<'s> {
    /// Factors of Z_k.
    pub variation: Vec<Scalar<'s>>,
    /// Factor of n·δr.
    pub normal: Scalar<'s>,
    /// Factor of δr.
    pub position: Vector<'s>,
    /// Entry (q, r) is the factor of e_q·δr_,r.
    pub along: Vec<Vec<Scalar<'s>>>,
    /// Factors of n·δr_,r.
    pub lift: Vec<Scalar<'s>>,
    /// Factors of n·δr_,11, n·δr_,12, n·δr_,22 of the declared parameters.
    pub bending: Vec<Scalar<'s>>,
    /// Factor of the motion of the slave's tangent.
    pub slave: Vector<'s>,
}

/// A form over the declared parameters.
pub struct Declared<'s> {
    /// Factor of δr.
    pub position: Vector<'s>,
    /// Factors of δr_,i.
    pub turning: Vec<Vector<'s>>,
}

impl<'s> Form<'s> {
    /// The form that vanishes.
    pub fn zero(contact: &Contact<'s>) -> Self {
        let (zero, none) = (contact.sheet.zero(), contact.sheet.zeros(contact.d));
        let p = contact.p;
        Self {
            variation: vec![zero; p],
            normal: zero,
            position: none,
            along: vec![vec![zero; p]; p],
            lift: vec![zero; p],
            bending: vec![zero; second_derivatives(p)],
            slave: none,
        }
    }

    /// self + factor·other
    pub fn add_scaled(&mut self, factor: Scalar<'s>, other: &Self) {
        let add = |to: &mut Scalar<'s>, from: &Scalar<'s>| *to = *to + factor * *from;
        add(&mut self.normal, &other.normal);
        let own = [&mut self.variation, &mut self.lift, &mut self.bending];
        let others = [&other.variation, &other.lift, &other.bending];
        for (to, from) in own.into_iter().zip(others) {
            to.iter_mut().zip(from).for_each(|(to, from)| add(to, from));
        }
        let own = self.along.iter_mut().flatten();
        own.zip(other.along.iter().flatten())
            .for_each(|(to, from)| add(to, from));
        self.position = self.position + factor * other.position;
        self.slave = self.slave + factor * other.slave;
    }

    /// self + factor e_q·δr_,r
    pub fn add_along(&mut self, q: usize, r: usize, factor: Scalar<'s>) {
        self.along[q][r] = self.along[q][r] + factor;
    }

    /// The form over the declared parameters: δr_,q = E^i_q δr_,i. Rows of parameters that move with no
    /// unknown are left out.
    pub fn declared(
        &self,
        contact: &Contact<'s>,
        variations: &[Variation<'s>],
        moving: &[bool],
    ) -> Declared<'s> {
        let sheet = contact.sheet;
        let (d, p) = (contact.d, contact.p);
        let through = sheet.sum_vectors(d, 0..p, |k| self.variation[k] * variations[k].position);
        let position = through + self.normal * contact.n + self.position;
        let turning = (0..p).map(|i| {
            if !moving[i] {
                return sheet.zeros(d);
            }
            let along = contact.along_axes(|q| contact.on_declared(&self.along[q], i));
            let mut lift = contact.on_declared(&self.lift, i);
            for (&factor, variation) in self.variation.iter().zip(variations) {
                lift = lift + factor * variation.turning[i];
            }
            along + lift * contact.n
        });
        Declared {
            position,
            turning: turning.collect(),
        }
    }
}

/// v^i E^j_k + v^j E^i_k for i ≠ j, v^i E^i_k else: the factor of n·δr_,ij in Σ_ij v^i E^j_k n·δr_,ij.
pub fn symmetric_row<'s>(contact: &Contact<'s>, v: &[Scalar<'s>], k: usize) -> Vec<Scalar<'s>> {
    let p = v.len();
    let mut row = vec![contact.sheet.zero(); second_derivatives(p)];
    for (i, j) in (0..p).flat_map(|i| (0..p).map(move |j| (i, j))) {
        let entry = &mut row[pair_index(i, j)];
        *entry = *entry + v[i] * contact.frame[j][k];
    }
    row
}
