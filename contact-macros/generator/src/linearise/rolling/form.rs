//! Linear forms over the motion of two curves: the rows in which a linearisation of their angles is written.
//!
//! A form multiplies s_A and, for either curve i, s_A,i, s_A,ii and s_A,iii by a vector each.

use crate::ir::{Scalar, Sheet, Vector};
use crate::linearise::tangential::form::Variation as Projected;

/// Coefficients of a linear form of δx.
#[derive(Clone, Copy)]
pub struct Motion<'s> {
    /// Factor of δr.
    pub position: Vector<'s>,
    /// Factors of δr_,i.
    pub turning: [Vector<'s>; 2],
    /// Factors of δr_,ii.
    pub bending: [Vector<'s>; 2],
    /// Factors of δr_,iii.
    pub third: [Vector<'s>; 2],
}

impl<'s> Motion<'s> {
    /// The zero form.
    pub fn zero(sheet: &'s Sheet) -> Self {
        let none = sheet.zeros(3);
        Self {
            position: none,
            turning: [none; 2],
            bending: [none; 2],
            third: [none; 2],
        }
    }

    /// δζ^i = E^i_q Z_q from the forms Z_q of the frame: `row` is E^i.
    pub fn of_parameter(row: Vector<'s>, n: Vector<'s>, projection: &[Projected<'s>]) -> Self {
        let mut result = Self::zero(n[0].sheet());
        for (&factor, form) in row.iter().zip(projection) {
            result.position = result.position + factor * form.position;
            for (to, &lever) in result.turning.iter_mut().zip(&form.turning) {
                *to = *to + lever * factor * n;
            }
        }
        result
    }

    /// All vectors, in the order of the outputs.
    fn vectors(&self) -> impl Iterator<Item = &Vector<'s>> {
        let rows = self.turning.iter().chain(&self.bending).chain(&self.third);
        std::iter::once(&self.position).chain(rows)
    }

    fn vectors_mut(&mut self) -> impl Iterator<Item = &mut Vector<'s>> {
        let rows = self.turning.iter_mut().chain(&mut self.bending);
        let rows = rows.chain(&mut self.third);
        std::iter::once(&mut self.position).chain(rows)
    }

    /// self + factor·other
    pub fn plus(mut self, factor: Scalar<'s>, other: &Self) -> Self {
        for (to, &from) in self.vectors_mut().zip(other.vectors()) {
            *to = *to + factor * from;
        }
        self
    }

    /// factor·self
    pub fn scaled(&self, factor: Scalar<'s>) -> Self {
        Self::zero(factor.sheet()).plus(factor, self)
    }

    /// Adds the outputs of the form.
    pub fn output(&self, sheet: &Sheet, name: &str) {
        for (k, vector) in self.vectors().enumerate() {
            sheet.outputs(&format!("{name}_{k}"), vector);
        }
    }

    /// Adds the outputs of a form without third derivatives.
    pub fn output_lower(&self, sheet: &Sheet, name: &str) {
        for (k, vector) in self.vectors().take(5).enumerate() {
            sheet.outputs(&format!("{name}_{k}"), vector);
        }
    }
}

/// The total variation of a vector of the two curves, as the three forms of its components.
#[derive(Clone, Copy)]
pub struct Variation<'s>([Motion<'s>; 3]);

impl<'s> Variation<'s> {
    /// Forms of a vector that does not move.
    pub fn none(sheet: &'s Sheet) -> Self {
        Self([Motion::zero(sheet); 3])
    }

    /// The unit row `row` of every component, and factor·δζ for each (factor, δζ).
    pub fn new(
        sheet: &'s Sheet,
        row: impl for<'a> Fn(&'a mut Motion<'s>) -> &'a mut Vector<'s>,
        shifts: &[(Vector<'s>, &Motion<'s>)],
    ) -> Self {
        let one = sheet.one();
        Self([0, 1, 2].map(|k| {
            let mut form = Motion::zero(sheet);
            row(&mut form).set(k, one);
            let shifts = shifts.iter();
            shifts.fold(form, |form, (slope, shift)| form.plus(slope[k], shift))
        }))
    }

    /// direction·D
    pub fn along(&self, direction: Vector<'s>) -> Motion<'s> {
        let zero = Motion::zero(direction[0].sheet());
        let parts = self.0.iter().zip(direction.iter());
        parts.fold(zero, |sum, (form, &component)| sum.plus(component, form))
    }
}
