//! Residual and tangent of a multiplier that is an unknown. [eq:multiplier]

use crate::element::pass::{Contact, Pass};
use crate::element::receiver::Receiver;
use crate::element::traits::Element;
use crate::point::friction::{Tangential, TangentialLaw};
use crate::point::state::Point;

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// Node and unknown of the multiplier of a point.
    #[inline(always)]
    fn multiplier_at(&self, number: usize) -> (usize, usize) {
        let nodes = self.stage.x.len();
        (nodes + number, nodes * D + number)
    }

    /// Adds R_λ = −λ/c of an open point and its derivative; returns its energy. [eq:multiplier-open]
    #[inline(never)]
    pub(crate) fn open_multiplier(
        &mut self,
        number: usize,
        point: &Point<D, P, H>,
        weight: f64,
    ) -> f64 {
        let (node, unknown) = self.multiplier_at(number);
        let (multiplier, slope) = (point.multiplier, point.law.slope);
        if self.call.wanted.residual {
            let value = -weight * (multiplier / slope);
            self.receiver.multiplier((node, unknown), value);
        }
        if self.call.wanted.tangent {
            self.receiver.coupling(unknown, unknown, -weight / slope);
        }
        -0.5 * weight * multiplier * (multiplier / slope)
    }

    /// Adds R_λ = g of a closed point, ∂R_λ/∂x = n·δr and ∂R/∂λ = n·δr − h_q Z_q. [eq:multiplier-closed]
    #[inline(never)]
    pub(crate) fn closed_multiplier(&mut self, contact: &Contact<'_, D, P, H>) {
        let (node, unknown) = self.multiplier_at(contact.number);
        let (weight, n, receiver) = (contact.weight, contact.n, &mut *self.receiver);
        if self.call.wanted.residual {
            let value = weight * contact.point.gap.gap;
            receiver.multiplier((node, unknown), value);
        }
        if !self.call.wanted.tangent {
            return;
        }
        for (a, &s) in self.stage.rows.s.iter().enumerate() {
            for k in 0..D {
                let value = weight * s * n[k];
                receiver.coupling(unknown, a * D + k, value);
                receiver.coupling(a * D + k, unknown, value);
            }
        }
        if E::Tangential::ACTIVE {
            let back = Tangential {
                t: contact.state.tangential.h.map(|h| -h),
                ..Tangential::default()
            };
            self.couple(contact, &back, unknown);
        }
    }
}
