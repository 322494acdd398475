//! The values of some contacts, one column per value: structure of arrays.

use crate::element::traits::Element;
use crate::lanes::Wide;

/// Contacts of a block.
pub const ROOM: usize = 16;

/// Most parameters of an element that is evaluated in lanes.
pub(crate) const MOST_PARAMETERS: usize = 16;

/// One value of every contact of the block.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Column(pub(crate) [f64; ROOM]);

impl Column {
    const ZERO: Self = Self([0.0; ROOM]);

    /// The entry of one contact.
    #[inline(always)]
    pub(crate) fn at(&self, slot: usize) -> f64 {
        self.0[slot % ROOM]
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, slot: usize, value: f64) {
        self.0[slot % ROOM] = value;
    }
}

/// Inputs of a block of contacts.
pub(crate) struct Inputs<'a, const D: usize, const P: usize, const N: usize> {
    pub(crate) x: &'a mut [[Column; D]; N],
    pub(crate) parameters: &'a mut [Column],
    pub(crate) frozen: &'a mut Column,
    pub(crate) zeta: &'a mut [Column; P],
}

/// Most unknowns of an element that is evaluated in lanes.
pub(crate) const MOST_UNKNOWNS: usize = 40;

/// Data of residual and tangent of the closed contacts, one record of quadruples for each.
pub struct Records<const N: usize> {
    /// n, the p_k, the left_j.
    pub(crate) vectors: [[[f64; 4]; VECTORS]; ROOM],
    /// For every node s_A, s_A,1, s_A,2, Σ_j s_A,j right_j[k], Σ_i s_A,i s_ji.
    pub(crate) nodes: [[[f64; 8]; N]; ROOM],
    pub(crate) traction: [f64; ROOM],
    pub(crate) energy: [f64; ROOM],
}

/// Vectors of a record.
pub(crate) const VECTORS: usize = 6;

impl<const N: usize> Records<N> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self {
            vectors: [[[0.0; 4]; VECTORS]; ROOM],
            nodes: [[[0.0; 8]; N]; ROOM],
            traction: [0.0; ROOM],
            energy: [0.0; ROOM],
        }
    }

    /// Quadruple `number` of the vectors of the contacts from `rank` on.
    #[inline(always)]
    pub(crate) fn deal_vector<T: Wide>(&mut self, rank: usize, number: usize, values: [T; 4]) {
        let to = self.vectors.as_flattened_mut();
        let rest = to.get_mut(rank * VECTORS + number..).unwrap_or(&mut []);
        T::deal(values, rest.as_flattened_mut(), 4 * VECTORS);
    }

    /// Quadruple `number` of the nodes of the contacts from `rank` on.
    #[inline(always)]
    pub(crate) fn deal_node<T: Wide>(&mut self, rank: usize, number: usize, values: [T; 4]) {
        let to = self.nodes.as_flattened_mut().as_flattened_mut();
        let rest = to.get_mut(rank * 8 * N + 4 * number..).unwrap_or(&mut []);
        T::deal(values, rest, 8 * N);
    }
}

/// Values of a block of contacts. D columns per vector.
pub(crate) struct Block<const D: usize, const P: usize, const H: usize, const N: usize> {
    /// Positions in the local frame.
    pub(crate) x: [[Column; D]; N],
    pub(crate) parameters: [Column; MOST_PARAMETERS],
    /// Status of the history.
    pub(crate) frozen: Column,
    /// Start, then projection.
    pub(crate) zeta: [Column; P],
    pub(crate) b: [[Column; D]; P],
    pub(crate) second: [[Column; D]; H],
    pub(crate) n: [Column; D],
    pub(crate) distance: Column,
    pub(crate) gap: Column,
    pub(crate) iterations: Column,
    pub(crate) s: [Column; N],
    pub(crate) ds: [[Column; N]; P],
    /// One bit per contact: stayed on the common path.
    pub(crate) good: u32,
    /// Carries load.
    pub(crate) closed: u32,
    /// The projection lies in the domain.
    pub(crate) inside: u32,
}

/// Data of the report of a contact.
pub struct Points<'a> {
    pub(crate) zeta: &'a [Column],
    pub(crate) b: &'a [Column],
    pub(crate) n: &'a [Column],
    pub(crate) gap: &'a Column,
    pub(crate) iterations: &'a Column,
    pub(crate) good: u32,
    pub(crate) closed: u32,
    pub(crate) inside: u32,
    /// The feature beyond which a projection lies.
    pub(crate) feature: fn([f64; 2]) -> u8,
}

impl<const D: usize, const P: usize, const H: usize, const N: usize> Block<D, P, H, N> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
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

    /// Data of the outputs.
    #[inline(always)]
    pub(crate) fn points<E: Element<D, P, H>>(&self) -> Points<'_> {
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

    /// Arrays that the gathering of the inputs fills.
    #[inline(always)]
    pub(crate) fn inputs(&mut self) -> Inputs<'_, D, P, N> {
        Inputs {
            x: &mut self.x,
            parameters: &mut self.parameters,
            frozen: &mut self.frozen,
            zeta: &mut self.zeta,
        }
    }
}

/// Lanes from `group` on.
#[inline(always)]
pub(crate) fn load_lanes<T: Wide>(column: &Column, group: usize) -> T {
    T::load(column.0.get(group..).unwrap_or(&[]))
}

#[inline(always)]
pub(crate) fn store_lanes<T: Wide>(value: T, column: &mut Column, group: usize) {
    value.store(column.0.get_mut(group..).unwrap_or(&mut []));
}
