//! Two lanes of plain arithmetic, for processors without lanes of their own here.

use super::Contacts;
use super::block::{Points, Records};
use super::outputs::write;
use super::wide::{Wide, operators};
use crate::runtime::Real;
use crate::runtime::lanes::Lanes;

/// Two numbers.
#[derive(Clone, Copy)]
pub struct Two([f64; 2]);

operators!(
    Two,
    a,
    b,
    Two([a.0[0] + b.0[0], a.0[1] + b.0[1]]),
    Two([a.0[0] - b.0[0], a.0[1] - b.0[1]]),
    Two([a.0[0] * b.0[0], a.0[1] * b.0[1]]),
    Two([a.0[0] / b.0[0], a.0[1] / b.0[1]]),
    Two([-a.0[0], -a.0[1]])
);

impl Real for Two {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; 2])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(Real::sqrt)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(Real::abs)
    }
    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(function))
    }
    #[inline(always)]
    fn map_two(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b], [c, d]) = (self.0, other.0);
        Self([function(a, c), function(b, d)])
    }
}

/// One bit per lane.
#[derive(Clone, Copy)]
pub struct TwoMask(u32);

impl core::ops::BitAnd for TwoMask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}
impl core::ops::BitOr for TwoMask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}
impl core::ops::Not for TwoMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0 & 0b11)
    }
}

impl Two {
    #[inline(always)]
    fn compare(self, other: Self, holds: impl Fn(f64, f64) -> bool) -> TwoMask {
        let ([a, b], [c, d]) = (self.0, other.0);
        TwoMask(u32::from(holds(a, c)) | u32::from(holds(b, d)) << 1)
    }
}

impl Wide for Two {
    const WIDTH: usize = 2;
    type Mask = TwoMask;
    type Quad = Lanes;

    #[inline(never)]
    fn write<C: Contacts, const D: usize, const P: usize, const N: usize>(
        points: &Points<'_>,
        contacts: &mut C,
        place: (usize, usize),
        records: &Records<N>,
    ) {
        write::<C, Self, D, P, N>(points, contacts, place, records);
    }

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self(from.first_chunk().copied().unwrap_or([0.0; 2]))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        if let Some(to) = to.first_chunk_mut() {
            *to = self.0;
        }
    }
    #[inline(always)]
    unsafe fn store_at(self, to: *mut f64) {
        // SAFETY: promised by the caller.
        unsafe { *to.cast() = self.0 }
    }
    #[inline(always)]
    fn deal(quadruple: [Self; 4], to: &mut [f64], apart: usize) {
        for (lane, record) in to.chunks_mut(apart.max(1)).enumerate().take(2) {
            for (to, value) in record.iter_mut().zip(quadruple) {
                *to = value.0[lane];
            }
        }
    }
    #[inline(always)]
    fn below(self, other: Self) -> TwoMask {
        self.compare(other, |a, b| a < b)
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> TwoMask {
        self.compare(other, |a, b| a <= b)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> TwoMask {
        self.compare(other, |a, b| a == b)
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.map_two(other, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        self.map_two(other, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn select(mask: TwoMask, yes: Self, no: Self) -> Self {
        let ([a, b], [c, d]) = (yes.0, no.0);
        let pick = |bit: u32, yes: f64, no: f64| if mask.0 & bit != 0 { yes } else { no };
        Self([pick(1, a, c), pick(2, b, d)])
    }
    #[inline(always)]
    fn bits(mask: TwoMask) -> u32 {
        mask.0
    }
    #[inline(always)]
    fn mask(bits: u32) -> TwoMask {
        TwoMask(bits & 0b11)
    }
}
