//! The values of some contacts, one column per value: structure of arrays.

use super::wide::Wide;
use crate::runtime::element::Element;

/// Contacts of a block.
pub const ROOM: usize = 16;

/// Most parameters of an element that is evaluated in lanes.
pub(super) const MOST_PARAMETERS: usize = 16;

/// One value of every contact of the block.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Column(pub(super) [f64; ROOM]);

impl Column {
    const ZERO: Self = Self([0.0; ROOM]);

    /// The entry of one contact.
    #[inline(always)]
    pub(super) fn at(&self, slot: usize) -> f64 {
        self.0[slot % ROOM]
    }

    #[inline(always)]
    pub(super) fn set(&mut self, slot: usize, value: f64) {
        self.0[slot % ROOM] = value;
    }
}

/// Inputs of a block of contacts.
pub(super) struct Inputs<'a, const D: usize, const P: usize, const N: usize> {
    pub(super) x: &'a mut [[Column; D]; N],
    pub(super) parameters: &'a mut [Column],
    pub(super) frozen: &'a mut Column,
    pub(super) zeta: &'a mut [Column; P],
}

/// Most unknowns of an element that is evaluated in lanes.
pub(super) const MOST_UNKNOWNS: usize = 40;

/// What residual and tangent of the closed contacts are made of, one record of quadruples for each.
pub struct Records<const N: usize> {
    /// n, the p_k, the left_j.
    pub(super) vectors: [[[f64; 4]; VECTORS]; ROOM],
    /// Of every node s_A, s_A,1, s_A,2, Σ_j s_A,j right_j[k], Σ_i s_A,i s_ji.
    pub(super) nodes: [[[f64; 8]; N]; ROOM],
    pub(super) traction: [f64; ROOM],
    pub(super) energy: [f64; ROOM],
}

/// Vectors of a record.
pub(super) const VECTORS: usize = 6;

impl<const N: usize> Records<N> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            vectors: [[[0.0; 4]; VECTORS]; ROOM],
            nodes: [[[0.0; 8]; N]; ROOM],
            traction: [0.0; ROOM],
            energy: [0.0; ROOM],
        }
    }

    /// Quadruple `number` of the vectors of the contacts from `rank` on.
    #[inline(always)]
    pub(super) fn deal_vector<T: Wide>(&mut self, rank: usize, number: usize, values: [T; 4]) {
        let to = self.vectors.as_flattened_mut();
        let rest = to.get_mut(rank * VECTORS + number..).unwrap_or(&mut []);
        T::deal(values, rest.as_flattened_mut(), 4 * VECTORS);
    }

    /// Quadruple `number` of the nodes of the contacts from `rank` on.
    #[inline(always)]
    pub(super) fn deal_node<T: Wide>(&mut self, rank: usize, number: usize, values: [T; 4]) {
        let to = self.nodes.as_flattened_mut().as_flattened_mut();
        let rest = to.get_mut(rank * 8 * N + 4 * number..).unwrap_or(&mut []);
        T::deal(values, rest, 8 * N);
    }
}

/// Values of a block of contacts. D columns per vector.
pub(super) struct Block<const D: usize, const P: usize, const H: usize, const N: usize> {
    /// Positions in the local frame.
    pub(super) x: [[Column; D]; N],
    pub(super) parameters: [Column; MOST_PARAMETERS],
    /// Status of the history.
    pub(super) frozen: Column,
    /// Start, then projection.
    pub(super) zeta: [Column; P],
    pub(super) b: [[Column; D]; P],
    pub(super) second: [[Column; D]; H],
    pub(super) n: [Column; D],
    pub(super) distance: Column,
    pub(super) gap: Column,
    pub(super) iterations: Column,
    pub(super) s: [Column; N],
    pub(super) ds: [[Column; N]; P],
    /// One bit per contact: stayed on the common path.
    pub(super) good: u32,
    /// Carries load.
    pub(super) closed: u32,
    /// The projection lies in the domain.
    pub(super) inside: u32,
}

/// What a report of a contact is made of.
pub struct Points<'a> {
    pub(super) zeta: &'a [Column],
    pub(super) b: &'a [Column],
    pub(super) n: &'a [Column],
    pub(super) gap: &'a Column,
    pub(super) iterations: &'a Column,
    pub(super) good: u32,
    pub(super) closed: u32,
    pub(super) inside: u32,
    /// The feature beyond which a projection lies.
    pub(super) feature: fn([f64; 2]) -> u8,
}

impl<const D: usize, const P: usize, const H: usize, const N: usize> Block<D, P, H, N> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        const ZERO: Column = Column::ZERO;
        Self {
            x: [[ZERO; D]; N],
            parameters: [ZERO; MOST_PARAMETERS],
            frozen: ZERO,
            zeta: [ZERO; P],
            b: [[ZERO; D]; P],
            second: [[ZERO; D]; H],
            n: [ZERO; D],
            distance: ZERO,
            gap: ZERO,
            iterations: ZERO,
            s: [ZERO; N],
            ds: [[ZERO; N]; P],
            good: 0,
            closed: 0,
            inside: 0,
        }
    }

    /// What the outputs are made of.
    #[inline(always)]
    pub(super) fn points<E: Element<D, P, H>>(&self) -> Points<'_> {
        Points {
            zeta: &self.zeta,
            b: self.b.as_flattened(),
            n: &self.n,
            gap: &self.gap,
            iterations: &self.iterations,
            good: self.good,
            closed: self.closed,
            inside: self.inside,
            feature: |zeta| E::feature(&core::array::from_fn(|i| zeta[i])),
        }
    }

    /// What the gathering of the inputs fills.
    #[inline(always)]
    pub(super) fn inputs(&mut self) -> Inputs<'_, D, P, N> {
        Inputs {
            x: &mut self.x,
            parameters: &mut self.parameters,
            frozen: &mut self.frozen,
            zeta: &mut self.zeta,
        }
    }
}
