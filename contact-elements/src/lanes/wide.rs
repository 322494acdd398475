//! Several numbers side by side, one per contact.
//!
//! Every operation rounds lane by lane as that of f64 does, and none is fused, so that a lane holds the bits of
//! the scalar evaluation.

use core::ops::{Add, BitAnd, BitOr, Mul, Not};

use super::real::Real;

/// Four numbers side by side: the components of a vector.
pub trait Quad: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// Four numbers.
    fn new(values: [f64; 4]) -> Self;
    /// The same number four times.
    fn same(value: f64) -> Self;
    /// Writes to the first places; does nothing if there are too few.
    fn store(self, to: &mut [f64]);
    /// Writes to `to`.
    ///
    /// # Safety
    /// There is room for four numbers.
    unsafe fn store_at(self, to: *mut f64);
}

/// Several numbers side by side.
pub trait Wide: Real {
    /// Four numbers by the same instructions.
    type Quad: Quad;

    /// How many.
    const WIDTH: usize;
    /// A truth value per lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    /// The first entries; zero if there are too few.
    fn load(from: &[f64]) -> Self;
    /// Writes to the first places; does nothing if there are too few.
    fn store(self, to: &mut [f64]);
    /// The numbers from `from` on.
    ///
    /// # Safety
    /// There are as many numbers as there are lanes.
    unsafe fn load_at(from: *const f64) -> Self;
    /// Writes to `to`.
    ///
    /// # Safety
    /// There is room for as many numbers as there are lanes.
    unsafe fn store_at(self, to: *mut f64);
    /// Four numbers of every contact, from where they begin.
    ///
    /// # Safety
    /// There are four numbers at the first addresses, one for each lane.
    unsafe fn collect(from: &[*const f64; 8]) -> [Self; 4];
    /// Writes four numbers of every contact to its record; records are `apart` numbers apart. Nothing is written beyond their end.
    fn deal(quadruple: [Self; 4], to: &mut [f64], apart: usize);
    /// self < other
    fn below(self, other: Self) -> Self::Mask;
    /// self ≤ other
    fn at_most(self, other: Self) -> Self::Mask;
    /// self = other
    fn equals(self, other: Self) -> Self::Mask;
    /// The larger one; `other` where they are equal or one is NaN.
    fn larger(self, other: Self) -> Self;
    /// The smaller one; `other` where they are equal or one is NaN.
    fn smaller(self, other: Self) -> Self;
    /// `yes` where the mask holds, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Finite and within the supported magnitude, by the bits alone: a signalling NaN raises nothing.
    fn is_usable(self) -> Self::Mask;
    /// One bit per lane, the first lowest.
    fn bits(mask: Self::Mask) -> u32;
    /// A mask from bits.
    fn mask(bits: u32) -> Self::Mask;

    /// True where the value is finite.
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.abs().at_most(Self::constant(f64::MAX))
    }

    /// The bits of a mask that holds everywhere.
    #[inline(always)]
    fn all() -> u32 {
        (1 << Self::WIDTH) - 1
    }

    /// The number of one lane everywhere.
    #[inline(always)]
    fn spread(self, lane: usize) -> Self {
        let mut values = [0.0; 8];
        self.store(&mut values);
        Self::constant(values.get(lane).copied().unwrap_or(0.0))
    }
}

/// Arithmetic of a lane type: its two operands, then what each operation is.
macro_rules! operators {
    ($lanes:ident, $a:ident, $b:ident, $add:expr, $subtract:expr, $multiply:expr, $divide:expr, $negate:expr) => {
        operators!($lanes, $a, $b, Add, add, $add);
        operators!($lanes, $a, $b, Sub, sub, $subtract);
        operators!($lanes, $a, $b, Mul, mul, $multiply);
        operators!($lanes, $a, $b, Div, div, $divide);
        impl core::ops::Neg for $lanes {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let $a = self;
                $negate
            }
        }
    };
    ($lanes:ident, $a:ident, $b:ident, $operation:ident, $name:ident, $value:expr) => {
        impl core::ops::$operation for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $name(self, $b: Self) -> Self {
                let $a = self;
                $value
            }
        }
    };
}
pub(super) use operators;
