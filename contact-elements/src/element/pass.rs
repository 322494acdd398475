//! An evaluation at work: inputs, scratch and outputs in one place.

use core::marker::PhantomData;

use crate::element::receiver::{Call, Receiver, Write};
use crate::element::stage::{Stage, placement};
use crate::element::traits::Element;
use crate::point::placement::Placement;
use crate::point::state::{Point, Sliding};

/// What every step of an evaluation of element E works on.
pub(crate) struct Pass<'p, 'a, E, R, const D: usize, const P: usize, const H: usize> {
    pub(crate) call: &'p Call<'p>,
    pub(crate) stage: &'p mut Stage<'a, D, P, H>,
    /// The frame of a placed geometry.
    pub(crate) placement: Option<Placement<D>>,
    pub(crate) receiver: &'p mut R,
    element: PhantomData<E>,
}

/// A closed point in the second pass.
#[derive(Clone, Copy)]
pub(crate) struct Contact<'c, const D: usize, const P: usize, const H: usize> {
    pub(crate) number: usize,
    pub(crate) point: &'c Point<D, P, H>,
    pub(crate) state: &'c Sliding<P>,
    /// Normal in the global frame.
    pub(crate) n: [f64; D],
    /// Integration weight times Jacobian.
    pub(crate) weight: f64,
    /// How residual and tangent of the normal law reach the outputs.
    pub(crate) write: Write,
}

impl<'p, 'a, E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'p, 'a, E, R, D, P, H>
{
    #[inline(always)]
    pub(crate) fn new(
        call: &'p Call<'p>,
        stage: &'p mut Stage<'a, D, P, H>,
        receiver: &'p mut R,
    ) -> Self {
        Self {
            call,
            stage,
            placement: placement::<E, D, P, H>(call.parameters),
            receiver,
            element: PhantomData,
        }
    }

    /// A vector of the local frame in the global one.
    #[inline(always)]
    pub(crate) fn to_global(&self, vector: &[f64; D]) -> [f64; D] {
        match &self.placement {
            Some(placement) => placement.vector_to_global(vector),
            None => *vector,
        }
    }

    /// The slave's fixed row: from the declaration, or from the call.
    #[inline(always)]
    pub(crate) fn load_slave(&mut self, number: usize) {
        let s = &mut *self.stage.rows.s;
        if E::SLAVE_NODES == 0 {
            let slaves = self.call.slave_row.len().saturating_sub(1);
            for (s, &value) in s.iter_mut().zip(self.call.slave_row.iter().take(slaves)) {
                *s = value;
            }
        } else {
            E::slave(number, self.call.parameters, s);
        }
    }
}
