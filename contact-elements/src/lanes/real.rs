//! Numbers that the emitted programs work on: one, or several side by side.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::arithmetic;

/// A number, or one number per lane. Every operation rounds as that of f64 does, so that a lane holds the same
/// bits as a scalar evaluation.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same number everywhere.
    fn constant(value: f64) -> Self;
    /// √x
    fn sqrt(self) -> Self;
    /// |x|
    fn abs(self) -> Self;
    /// The number given by a function of numbers.
    fn map(self, function: impl Fn(f64) -> f64) -> Self;
    /// The number given by a function of two.
    fn map_two(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self;

    /// sin x
    #[inline(always)]
    fn sin(self) -> Self {
        self.map(arithmetic::sin)
    }
    /// cos x
    #[inline(always)]
    fn cos(self) -> Self {
        self.map(arithmetic::cos)
    }
    /// tan x
    #[inline(always)]
    fn tan(self) -> Self {
        self.map(arithmetic::tan)
    }
    /// eˣ
    #[inline(always)]
    fn exp(self) -> Self {
        self.map(arithmetic::exp)
    }
    /// Natural logarithm.
    #[inline(always)]
    fn ln(self) -> Self {
        self.map(arithmetic::ln)
    }
    /// xʸ
    #[inline(always)]
    fn pow(self, exponent: Self) -> Self {
        self.map_two(exponent, arithmetic::pow)
    }
    /// Angle of the point (x, y), y first.
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.map_two(x, arithmetic::atan2)
    }
}

impl Real for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        arithmetic::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        arithmetic::abs(self)
    }
    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        function(self)
    }
    #[inline(always)]
    fn map_two(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        function(self, other)
    }
}
