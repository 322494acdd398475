//! What the closed forms need to know about a pair, and how derivatives are numbered.

use crate::model::{Gap, Linearisation};

/// What the closed forms need to know about a pair.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// Space dimension, 2 or 3.
    pub dimension: usize,
    /// Which relative positions move with the projected parameter i: r_,i has a shape row (false for
    /// the parameters of a rigid master). Its length is the number of projected parameters.
    pub moving: Vec<bool>,
    /// Which second derivatives r_,11 r_,12 r_,22 can be non-zero.
    pub curved: Vec<bool>,
    /// Which third derivatives r_,111 r_,112 r_,122 r_,222 can be non-zero.
    pub third: Vec<bool>,
    /// How the gap is measured.
    pub gap: Gap,
    /// Which form of the tangent.
    pub linearisation: Linearisation,
}

impl Kinematics {
    /// Number of projected parameters.
    pub fn projected(&self) -> usize {
        self.moving.len()
    }

    /// Directions that are neither normal nor tangential.
    pub fn complement(&self) -> usize {
        self.dimension - 1 - self.projected()
    }
}

/// Number of second derivatives of `p` parameters.
pub fn second_derivatives(p: usize) -> usize {
    p * (p + 1) / 2
}

/// Number of third derivatives of `p` parameters; i + j + k is the position of one.
pub fn third_derivatives(p: usize) -> usize {
    if p == 0 { 0 } else { 3 * p - 2 }
}

/// Position of the pair i, j in the order 11, 12, 22.
pub fn pair_index(i: usize, j: usize) -> usize {
    i + j
}
