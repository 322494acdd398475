//! The values of some contacts, one column per value: structure of arrays.

use super::wide::Quad;
use crate::runtime::element::Element;

/// Contacts of a block.
pub(super) const ROOM: usize = 32;

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
pub(super) struct Inputs<'a> {
    /// D columns per node.
    pub(super) x: &'a mut [Column],
    pub(super) parameters: &'a mut [Column],
    pub(super) frozen: &'a mut Column,
    pub(super) zeta: &'a mut [Column],
}

/// What the outputs of a block are made of; D columns per vector.
pub struct Points<'a> {
    pub(super) s: &'a [Column],
    /// One row of nodes per parameter.
    pub(super) ds: &'a [Column],
    pub(super) zeta: &'a [Column],
    pub(super) b: &'a [Column],
    pub(super) n: &'a [Column],
    pub(super) gap: &'a Column,
    pub(super) iterations: &'a Column,
    pub(super) traction: &'a Column,
    pub(super) energy: &'a Column,
    pub(super) p: &'a [Column],
    pub(super) left: &'a [Column],
    pub(super) right_turn: &'a [Column],
    pub(super) left_turn: &'a [Column],
    pub(super) good: u32,
    pub(super) closed: u32,
    pub(super) inside: u32,
    /// The feature beyond which a projection lies.
    pub(super) feature: fn([f64; 2]) -> u8,
}

impl Points<'_> {
    /// The components of one of several vectors.
    #[inline(always)]
    pub(super) fn vector<Q: Quad, const D: usize>(
        &self,
        columns: &[Column],
        number: usize,
        slot: usize,
    ) -> Q {
        let mut values = [0.0; 4];
        if let Some(columns) = columns.as_chunks::<D>().0.get(number) {
            for k in 0..D {
                values[k] = columns[k].at(slot);
            }
        }
        Q::new(values)
    }
}

/// Values of a block of contacts.
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
    pub(super) traction: Column,
    pub(super) energy: Column,
    pub(super) p: [[Column; D]; D],
    pub(super) left: [[Column; D]; P],
    /// s_A,j right_j[k]
    pub(super) right_turn: [[Column; D]; N],
    /// s_A,i s_ij
    pub(super) left_turn: [[Column; P]; N],
    /// One bit per contact: stayed on the common path.
    pub(super) good: u32,
    /// Carries load.
    pub(super) closed: u32,
    /// The projection lies in the domain.
    pub(super) inside: u32,
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
            traction: ZERO,
            energy: ZERO,
            p: [[ZERO; D]; D],
            left: [[ZERO; D]; P],
            right_turn: [[ZERO; D]; N],
            left_turn: [[ZERO; P]; N],
            good: 0,
            closed: 0,
            inside: 0,
        }
    }

    /// What the outputs are made of.
    #[inline(always)]
    pub(super) fn points<E: Element<D, P, H>>(&self) -> Points<'_> {
        Points {
            s: &self.s,
            ds: self.ds.as_flattened(),
            zeta: &self.zeta,
            b: self.b.as_flattened(),
            n: &self.n,
            gap: &self.gap,
            iterations: &self.iterations,
            traction: &self.traction,
            energy: &self.energy,
            p: self.p.as_flattened(),
            left: self.left.as_flattened(),
            right_turn: self.right_turn.as_flattened(),
            left_turn: self.left_turn.as_flattened(),
            good: self.good,
            closed: self.closed,
            inside: self.inside,
            feature: |zeta| E::feature(&core::array::from_fn(|i| zeta[i])),
        }
    }

    /// What the gathering of the inputs fills.
    #[inline(always)]
    pub(super) fn inputs(&mut self) -> Inputs<'_> {
        Inputs {
            x: self.x.as_flattened_mut(),
            parameters: &mut self.parameters,
            frozen: &mut self.frozen,
            zeta: &mut self.zeta,
        }
    }
}
