//! Elementary functions of the kernels: the same bits on every platform, no standard library.

/// √x, correctly rounded.
#[inline(always)]
pub fn sqrt(x: f64) -> f64 {
    // libm's assembly has the legacy encoding, which is slow between AVX instructions
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    {
        use core::arch::x86_64::{_mm_cvtsd_f64, _mm_set_sd, _mm_sqrt_sd};
        // SAFETY: SSE2 belongs to every x86-64 target.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }
    #[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
    libm::sqrt(x)
}

/// a/b for a divisor that was found to be positive; its size is limited to 1e30. The compiler may divide before the
/// branch that tests the divisor, and hosts run with traps for invalid and overflow.
#[inline(always)]
pub(crate) fn quotient(a: f64, b: f64) -> f64 {
    let least = 1e-30 * abs(a) + 1e-200;
    a / if b > least { b } else { least }
}

/// sin x, x in radians.
#[inline]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// cos x, x in radians.
#[inline]
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// tan x, x in radians.
#[inline]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// eˣ
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// xʸ
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Angle of the point (x, y) in (−π, π].
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// |x|
#[inline(always)]
pub fn abs(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !(1 << 63))
}

/// `x`, or ±1 where it is 0: the divisor of a guarded program. It works on the bits, so that no optimisation
/// turns it into a choice between two quotients.
#[inline(always)]
pub fn divisor(x: f64) -> f64 {
    f64::from_bits(x.to_bits() | (u64::from(x == 0.0) * 1.0f64.to_bits()))
}

/// `x`, or 0 where it is negative: the argument of a root in a guarded program.
#[inline(always)]
pub fn radicand(x: f64) -> f64 {
    let bits = x.to_bits();
    f64::from_bits(bits & ((bits >> 63).wrapping_sub(1)))
}

/// Largest magnitude of a coordinate [length].
pub(crate) const LARGEST_INPUT: f64 = 1e30;

/// True for finite values within the supported magnitude; looks at the bits only, so that a signalling
/// NaN raises nothing.
#[inline(always)]
pub(crate) fn is_usable(value: f64) -> bool {
    (value.to_bits() & !(1 << 63)) <= LARGEST_INPUT.to_bits()
}

/// True where all values are usable.
#[inline(always)]
pub(crate) fn are_usable(values: &[f64]) -> bool {
    let mut signs = 0;
    for &value in values {
        signs |= room(value);
    }
    signs >> 63 == 0
}

/// Negative as an integer for values that are not usable.
#[inline(always)]
fn room(value: f64) -> u64 {
    LARGEST_INPUT
        .to_bits()
        .wrapping_sub(value.to_bits() & !(1 << 63))
}
