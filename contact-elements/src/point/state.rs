//! A contact point after the first pass.

use crate::point::blend::Blend;
use crate::point::friction::Tangential;
use crate::point::law::Traction;
use crate::point::motion::Rolling;
use crate::point::values::{Frame, Gap, Status, Vectors};

/// A point after the first pass.
#[derive(Clone, Copy)]
pub(crate) struct Point<const D: usize, const P: usize, const H: usize> {
    pub(crate) status: Status,
    pub(crate) feature: u8,
    pub(crate) zeta: [f64; P],
    pub(crate) vectors: Vectors<D, P, H>,
    pub(crate) gap: Gap<D>,
    /// ±1, factor of the normal.
    pub(crate) orientation: f64,
    /// Traction of a closed point, and of every point that has a multiplier.
    pub(crate) law: Traction,
    /// Effect of the weight by the angle.
    pub(crate) blend: Blend,
    /// λ; 0 without a multiplier.
    pub(crate) multiplier: f64,
    pub(crate) iterations: u32,
}

/// Tangential state of a closed point.
#[derive(Clone, Copy)]
pub(crate) struct Sliding<const P: usize> {
    pub(crate) frame: Frame<P>,
    pub(crate) tangential: Tangential,
    /// For the next step.
    pub(crate) anchor: [f64; P],
    /// For the next step.
    pub(crate) path: f64,
    /// Moments about two curves.
    pub(crate) rolling: Rolling,
}

impl<const P: usize> Default for Sliding<P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            frame: Frame::default(),
            tangential: Tangential::default(),
            anchor: [0.0; P],
            path: 0.0,
            rolling: Rolling::default(),
        }
    }
}
