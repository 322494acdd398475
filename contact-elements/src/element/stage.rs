//! Nodes and scratch of an evaluation, which every step of it uses.

use crate::element::traits::Element;
use crate::point::placement::Placement;
use crate::point::values::Rows;

/// Nodes and scratch of an evaluation; `element::kernel` makes them.
#[derive(Debug)]
pub struct Stage<'a, const D: usize, const P: usize, const H: usize> {
    /// Positions in the local frame, slave nodes first.
    pub x: &'a [[f64; D]],
    /// Reference positions of the slave nodes, for the reference measure.
    pub reference: &'a [[f64; D]],
    /// Multipliers that are unknowns, one per point.
    pub multipliers: &'a [f64],
    /// Rows s_A, s_A,i; zero on entry.
    pub rows: Rows<'a, P>,
    /// Scratch of the contraction.
    pub temporaries: Temporaries<'a, D, P>,
    /// w N ∂J/∂x, where the measure moves.
    pub variation: &'a mut [f64],
    /// Rows of tangential contact.
    pub tangential: TangentialRows<'a, H>,
}

/// Scratch of the contraction: vectors over all unknowns, each at least as long as their number.
#[derive(Debug)]
pub struct Temporaries<'a, const D: usize, const P: usize> {
    /// One per row component k.
    pub u: [&'a mut [f64]; D],
    /// One per projected parameter.
    pub g: [&'a mut [f64]; P],
    /// Σ_j s_A,j g_j of the node at hand.
    pub h: &'a mut [f64],
    /// The row at hand.
    pub row: &'a mut [f64],
}

/// Rows of scratch over all unknowns, 2 (P + D), at most.
pub(crate) const MOST_COLUMNS: usize = 10;

/// Rows of second derivatives and of the slave's tangent, and more scratch of the contraction.
#[derive(Debug)]
pub struct TangentialRows<'a, const H: usize> {
    /// s_A,ij per node.
    pub second: [&'a mut [f64]; H],
    /// Row of the slave's tangent per node; zero on the master.
    pub slave: &'a mut [f64],
    /// 2 (P + D) rows over all unknowns.
    pub columns: &'a mut [f64],
}

#[inline(always)]
pub(crate) fn placement<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> Option<Placement<D>> {
    E::LAYOUT
        .placement
        .map(|at| Placement::from_parameters(parameters.get(at..).unwrap_or(&[])))
}

#[inline(always)]
pub(crate) fn orientation<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    parameters: &[f64],
) -> f64 {
    match E::LAYOUT.orientation.and_then(|at| parameters.get(at)) {
        Some(&value) if value < 0.0 => -1.0,
        _ => 1.0,
    }
}

/// `factor` w ∂J/∂x in the global frame.
#[inline(always)]
pub(crate) fn scale_variation<const D: usize>(
    variation: &mut [f64],
    factor: f64,
    placement: &Option<Placement<D>>,
) {
    let (blocks, _) = variation.as_chunks_mut::<D>();
    for block in blocks {
        if let Some(placement) = placement {
            *block = placement.vector_to_global(block);
        }
        for entry in block {
            *entry *= factor;
        }
    }
}
