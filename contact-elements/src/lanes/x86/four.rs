//! Four numbers: AVX2.

use core::arch::x86_64::*;
use core::ops::{BitAnd, BitOr, Not};

use crate::arithmetic::LARGEST_INPUT;
use crate::lanes::real::Real;
use crate::lanes::wide::{Quad, Wide, operators};

/// Four numbers: AVX2.
#[derive(Clone, Copy)]
pub struct Four(__m256d);

/// Its truth values.
#[derive(Clone, Copy)]
pub struct FourMask(__m256d);

operators!(
    Four,
    a,
    b,
    Four(lanes!(_mm256_add_pd(a.0, b.0))),
    Four(lanes!(_mm256_sub_pd(a.0, b.0))),
    Four(lanes!(_mm256_mul_pd(a.0, b.0))),
    Four(lanes!(_mm256_div_pd(a.0, b.0))),
    Four(lanes!(_mm256_xor_pd(a.0, _mm256_set1_pd(-0.0))))
);

impl Real for Four {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self(lanes!(_mm256_set1_pd(value)))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(lanes!(_mm256_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(lanes!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)))
    }
    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let mut values = [0.0; 4];
        Wide::store(self, &mut values);
        Self::load(&values.map(function))
    }
    #[inline(always)]
    fn map_two(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        let (mut first, mut second) = ([0.0; 4], [0.0; 4]);
        Wide::store(self, &mut first);
        Wide::store(other, &mut second);
        for (a, b) in first.iter_mut().zip(second) {
            *a = function(*a, b);
        }
        Self::load(&first)
    }
}

impl Wide for Four {
    const WIDTH: usize = 4;
    type Mask = FourMask;
    type Quad = Four;

    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        match from.first_chunk::<4>() {
            Some(from) => Self(lanes!(_mm256_loadu_pd(from.as_ptr()))),
            None => Self::constant(0.0),
        }
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        if let Some(to) = to.first_chunk_mut::<4>() {
            lanes!(_mm256_storeu_pd(to.as_mut_ptr(), self.0))
        }
    }
    #[inline(always)]
    unsafe fn load_at(from: *const f64) -> Self {
        Self(lanes!(_mm256_loadu_pd(from)))
    }
    #[inline(always)]
    unsafe fn store_at(self, to: *mut f64) {
        lanes!(_mm256_storeu_pd(to, self.0))
    }
    #[inline(always)]
    unsafe fn collect(from: &[*const f64; 8]) -> [Self; 4] {
        // SAFETY: promised by the caller.
        let [a, b, c, d] = unsafe { collect_four([from[0], from[1], from[2], from[3]]) };
        [Self(a), Self(b), Self(c), Self(d)]
    }
    #[inline(always)]
    fn deal(quadruple: [Self; 4], to: &mut [f64], apart: usize) {
        deal_four(quadruple.map(|lanes| lanes.0), to, apart);
    }
    #[inline(always)]
    fn below(self, other: Self) -> FourMask {
        FourMask(lanes!(compare_four::<_CMP_LT_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> FourMask {
        FourMask(lanes!(compare_four::<_CMP_LE_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> FourMask {
        FourMask(lanes!(compare_four::<_CMP_EQ_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self(lanes!(_mm256_max_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self(lanes!(_mm256_min_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: FourMask, yes: Self, no: Self) -> Self {
        Self(lanes!(select_of_four(mask.0, yes.0, no.0)))
    }
    #[inline(always)]
    fn is_usable(self) -> FourMask {
        // the sign of what is left of the room tells
        let room = lanes!(_mm256_sub_epi64(
            _mm256_set1_epi64x(LARGEST_INPUT.to_bits() as i64),
            _mm256_castpd_si256(self.abs().0)
        ));
        !FourMask(lanes!(_mm256_castsi256_pd(room)))
    }
    #[inline(always)]
    fn bits(mask: FourMask) -> u32 {
        (lanes!(_mm256_movemask_pd(mask.0))) as u32
    }
    #[inline(always)]
    fn mask(bits: u32) -> FourMask {
        let mut values = [0.0; 4];
        for (lane, value) in values.iter_mut().enumerate() {
            *value = f64::from_bits(u64::from(bits >> lane & 1).wrapping_neg());
        }
        FourMask(lanes!(_mm256_loadu_pd(values.as_ptr())))
    }
}

impl BitAnd for FourMask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(lanes!(_mm256_and_pd(self.0, other.0)))
    }
}
impl BitOr for FourMask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(lanes!(_mm256_or_pd(self.0, other.0)))
    }
}
impl Not for FourMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(lanes!(_mm256_xor_pd(
            self.0,
            _mm256_set1_pd(f64::from_bits(u64::MAX))
        )))
    }
}

/// # Safety
/// AVX2 is there.
#[inline(always)]
unsafe fn select_of_four(mask: __m256d, yes: __m256d, no: __m256d) -> __m256d {
    lanes!(_mm256_blendv_pd(no, yes, mask))
}

/// # Safety
/// AVX2 is there.
#[inline(always)]
unsafe fn compare_four<const HOW: i32>(a: __m256d, b: __m256d) -> __m256d {
    lanes!(_mm256_cmp_pd::<HOW>(a, b))
}

/// Four numbers of four contacts to their records.
#[inline(always)]
pub(crate) fn deal_four([a, b, c, d]: [__m256d; 4], to: &mut [f64], apart: usize) {
    if to.len() < 3 * apart + 4 {
        return;
    }
    let to = to.as_mut_ptr();
    // SAFETY: the processor has AVX2, see the module; the records reach so far.
    unsafe {
        let (ab_even, ab_odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
        let (cd_even, cd_odd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
        _mm256_storeu_pd(to, _mm256_permute2f128_pd::<0x20>(ab_even, cd_even));
        let second = _mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd);
        _mm256_storeu_pd(to.add(apart), second);
        let third = _mm256_permute2f128_pd::<0x31>(ab_even, cd_even);
        _mm256_storeu_pd(to.add(2 * apart), third);
        let fourth = _mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd);
        _mm256_storeu_pd(to.add(3 * apart), fourth);
    }
}

/// Four numbers of each of four contacts, taken to lanes.
///
/// # Safety
/// There are four numbers at every address.
#[inline(always)]
pub(crate) unsafe fn collect_four(from: [*const f64; 4]) -> [__m256d; 4] {
    // SAFETY: the processor has AVX2, see the module; the numbers are promised by the caller.
    unsafe {
        let (a, b) = (_mm256_loadu_pd(from[0]), _mm256_loadu_pd(from[1]));
        let (c, d) = (_mm256_loadu_pd(from[2]), _mm256_loadu_pd(from[3]));
        let (ab_even, ab_odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
        let (cd_even, cd_odd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
        [
            _mm256_permute2f128_pd::<0x20>(ab_even, cd_even),
            _mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd),
            _mm256_permute2f128_pd::<0x31>(ab_even, cd_even),
            _mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd),
        ]
    }
}

impl Quad for Four {
    #[inline(always)]
    fn new([a, b, c, d]: [f64; 4]) -> Self {
        Self(lanes!(_mm256_setr_pd(a, b, c, d)))
    }
    #[inline(always)]
    fn same(value: f64) -> Self {
        Self::constant(value)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        Wide::store(self, to);
    }
    #[inline(always)]
    unsafe fn store_at(self, to: *mut f64) {
        // SAFETY: promised by the caller.
        unsafe { Wide::store_at(self, to) }
    }
}
