//! Eight numbers: AVX-512.

use core::arch::x86_64::*;
use core::ops::{BitAnd, BitOr, Not};

use super::four::{Four, collect_four, deal_four};
use crate::arithmetic::LARGEST_INPUT;
use crate::lanes::real::Real;
use crate::lanes::wide::{Wide, operators};

/// Eight numbers: AVX-512.
#[derive(Clone, Copy)]
pub struct Eight(__m512d);

/// Truth values of eight numbers.
#[derive(Clone, Copy)]
pub struct EightMask(__mmask8);

operators!(
    Eight,
    a,
    b,
    Eight(lanes!(_mm512_add_pd(a.0, b.0))),
    Eight(lanes!(_mm512_sub_pd(a.0, b.0))),
    Eight(lanes!(_mm512_mul_pd(a.0, b.0))),
    Eight(lanes!(_mm512_div_pd(a.0, b.0))),
    Eight(lanes!(_mm512_xor_pd(a.0, _mm512_set1_pd(-0.0))))
);

impl Real for Eight {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self(lanes!(_mm512_set1_pd(value)))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(lanes!(_mm512_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(lanes!(_mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0)))
    }
    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let mut values = [0.0; 8];
        Wide::store(self, &mut values);
        Self::load(&values.map(function))
    }
    #[inline(always)]
    fn map_two(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        let (mut first, mut second) = ([0.0; 8], [0.0; 8]);
        Wide::store(self, &mut first);
        Wide::store(other, &mut second);
        for (a, b) in first.iter_mut().zip(second) {
            *a = function(*a, b);
        }
        Self::load(&first)
    }
}

impl Wide for Eight {
    const WIDTH: usize = 8;
    type Mask = EightMask;
    type Quad = Four;

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        match from.first_chunk::<8>() {
            Some(from) => Self(lanes!(_mm512_loadu_pd(from.as_ptr()))),
            None => Self::constant(0.0),
        }
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        if let Some(to) = to.first_chunk_mut::<8>() {
            lanes!(_mm512_storeu_pd(to.as_mut_ptr(), self.0))
        }
    }
    #[inline(always)]
    unsafe fn load_at(from: *const f64) -> Self {
        Self(lanes!(_mm512_loadu_pd(from)))
    }
    #[inline(always)]
    unsafe fn store_at(self, to: *mut f64) {
        lanes!(_mm512_storeu_pd(to, self.0))
    }
    #[inline(always)]
    unsafe fn collect(from: &[*const f64; 8]) -> [Self; 4] {
        let [a, b, c, d, e, f, g, h] = *from;
        // SAFETY: promised by the caller.
        let (low, high) = unsafe { (collect_four([a, b, c, d]), collect_four([e, f, g, h])) };
        let mut all = [Self::constant(0.0); 4];
        for ((to, low), high) in all.iter_mut().zip(low).zip(high) {
            let low = lanes!(_mm512_castpd256_pd512(low));
            *to = Self(lanes!(_mm512_insertf64x4::<1>(low, high)));
        }
        all
    }
    #[inline(always)]
    fn deal(quadruple: [Self; 4], to: &mut [f64], apart: usize) {
        let low = quadruple.map(|lanes| lanes!(_mm512_extractf64x4_pd::<0>(lanes.0)));
        let high = quadruple.map(|lanes| lanes!(_mm512_extractf64x4_pd::<1>(lanes.0)));
        deal_four(low, to, apart);
        deal_four(high, to.get_mut(4 * apart..).unwrap_or(&mut []), apart);
    }
    #[inline(always)]
    fn below(self, other: Self) -> EightMask {
        EightMask(lanes!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> EightMask {
        EightMask(lanes!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> EightMask {
        EightMask(lanes!(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(lanes!(_mm512_max_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self(lanes!(_mm512_min_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: EightMask, yes: Self, no: Self) -> Self {
        Self(lanes!(_mm512_mask_blend_pd(mask.0, no.0, yes.0)))
    }
    #[inline(always)]
    fn is_usable(self) -> EightMask {
        EightMask(lanes!(_mm512_cmple_epu64_mask(
            _mm512_castpd_si512(self.abs().0),
            _mm512_set1_epi64(LARGEST_INPUT.to_bits() as i64)
        )))
    }
    #[inline(always)]
    fn bits(mask: EightMask) -> u32 {
        u32::from(mask.0)
    }
    #[inline(always)]
    fn mask(bits: u32) -> EightMask {
        EightMask(bits as u8)
    }
}

impl BitAnd for EightMask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}
impl BitOr for EightMask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}
impl Not for EightMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}
