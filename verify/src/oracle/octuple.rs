//! Octuple precision: 237 bits, exponents of 19 bits. It is exact to 70 digits and neither overflows nor
//! underflows where doubles do, so it is the truth for numbers of 16 digits.
//!
//! The number is a leaf of [`num_dual`] with doubles as its primitive, so that whatever is written once for
//! all numbers, geometries above all, can be evaluated in it, derivatives included.

use std::cmp::Ordering;
use std::fmt;
use std::iter::{Product, Sum};
use std::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};

use f256::f256;
use num_dual::{DualNum, DualStruct, Mappable};
use num_traits::{FromPrimitive, Inv, Num, One, Signed, Zero};

/// A number of 70 digits.
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Octuple(f256);

/// Bits of the upper half of the encoding that belong to the fraction.
const UPPER_FRACTION: u32 = 108;
const EXPONENT: u32 = 19;
const BIAS: i32 = (1 << (EXPONENT - 1)) - 1;

impl Octuple {
    /// The nearest double or its neighbour; zero or infinity beyond the range of doubles.
    pub fn to_f64(self) -> f64 {
        if self.0.is_nan() {
            return f64::NAN;
        }
        let (upper, _) = self.0.to_bits();
        let exponent = ((upper >> UPPER_FRACTION) as i32) & ((1 << EXPONENT) - 1);
        let fraction = (upper & ((1 << UPPER_FRACTION) - 1)) as f64;
        let one = (UPPER_FRACTION as f64).exp2();
        let power = (exponent - BIAS).clamp(-2200, 2200);
        // in two halves: a subnormal result has a power that is no double itself
        let value = (1.0 + fraction / one) * f64::from(power / 2).exp2();
        (value * f64::from(power - power / 2).exp2()).copysign(if self.0.is_sign_negative() {
            -1.0
        } else {
            1.0
        })
    }

    /// Whether it is finite, that is neither infinite nor NaN.
    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    /// The greater of two numbers.
    pub fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident;)*) => {$(
        impl $trait for Octuple {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }
        impl $trait<&Octuple> for Octuple {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                $trait::$method(self, *other)
            }
        }
        impl $trait<f64> for Octuple {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                $trait::$method(self, Self::from(other))
            }
        }
        impl $assign for Octuple {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
        impl $assign<f64> for Octuple {
            #[inline]
            fn $assign_method(&mut self, other: f64) {
                *self = $trait::$method(*self, other);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
    Rem rem RemAssign rem_assign;
}

impl Neg for Octuple {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl From<f64> for Octuple {
    fn from(value: f64) -> Self {
        Self(f256::from(value))
    }
}

impl FromPrimitive for Octuple {
    fn from_i64(value: i64) -> Option<Self> {
        Some(Self(f256::from(value)))
    }
    fn from_u64(value: u64) -> Option<Self> {
        Some(Self(f256::from(value)))
    }
    fn from_f64(value: f64) -> Option<Self> {
        Some(Self::from(value))
    }
}

impl Zero for Octuple {
    fn zero() -> Self {
        Self(f256::ZERO)
    }
    fn is_zero(&self) -> bool {
        self.0.eq_zero()
    }
}

impl One for Octuple {
    fn one() -> Self {
        Self(f256::ONE)
    }
}

impl Num for Octuple {
    type FromStrRadixErr = <f256 as Num>::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        f256::from_str_radix(text, radix).map(Self)
    }
}

impl Signed for Octuple {
    fn abs(&self) -> Self {
        Self(self.0.abs())
    }
    fn abs_sub(&self, other: &Self) -> Self {
        (*self - *other).max(Self::zero())
    }
    fn signum(&self) -> Self {
        Self(self.0.signum())
    }
    fn is_positive(&self) -> bool {
        *self > 0.0
    }
    fn is_negative(&self) -> bool {
        *self < 0.0
    }
}

impl Inv for Octuple {
    type Output = Self;
    fn inv(self) -> Self {
        self.recip()
    }
}

impl Sum for Octuple {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::zero(), |sum, term| sum + term)
    }
}

impl Product for Octuple {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Self::one(), |product, factor| product * factor)
    }
}

impl PartialEq<f64> for Octuple {
    fn eq(&self, other: &f64) -> bool {
        *self == Self::from(*other)
    }
}

impl PartialOrd<f64> for Octuple {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        self.partial_cmp(&Self::from(*other))
    }
}

impl fmt::Display for Octuple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl fmt::Debug for Octuple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:e}", self.0)
    }
}

impl DualStruct for Octuple {
    type Real = f64;
    type Inner = f64;
    fn re(&self) -> f64 {
        self.to_f64()
    }
    fn from_inner(inner: &f64) -> Self {
        Self::from(*inner)
    }
}

impl Mappable<Octuple> for Octuple {
    type Output<O> = O;
    fn map_dual<M: Fn(Octuple) -> O, O>(self, f: M) -> O {
        f(self)
    }
}

macro_rules! functions {
    ($($name:ident)*) => {$(
        fn $name(&self) -> Self {
            Self(f256::$name(&self.0))
        }
    )*};
}

impl DualNum for Octuple {
    type Primitive = f64;
    type InnerDual = f64;
    const NDERIV: usize = 0;

    functions! { exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan }

    fn from_re(re: f64) -> Self {
        Self::from(re)
    }
    fn scale(self, factor: &f64) -> Self {
        self * *factor
    }
    fn recip(&self) -> Self {
        Self(self.0.recip())
    }
    fn powi(&self, n: i32) -> Self {
        Self(self.0.powi(n))
    }
    fn powf(&self, n: f64) -> Self {
        Self(self.0.powf(&f256::from(n)))
    }
    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }
    fn cbrt(&self) -> Self {
        Self(self.0.cbrt())
    }
    fn log(&self, base: f64) -> Self {
        Self(self.0.log(&f256::from(base)))
    }
    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
    fn atan2(&self, other: Self) -> Self {
        Self(self.0.atan2(&other.0))
    }
    fn sinh(&self) -> Self {
        let m = self.exp_m1();
        (m + m / (m + 1.0)) / 2.0
    }
    fn cosh(&self) -> Self {
        let e = self.exp();
        (e + e.recip()) / 2.0
    }
    fn tanh(&self) -> Self {
        let m = (*self * 2.0).exp_m1();
        m / (m + 2.0)
    }
    fn asinh(&self) -> Self {
        let x = self.abs();
        let root = (x * x + 1.0).sqrt();
        (x + x * x / (root + 1.0)).ln_1p() * self.signum()
    }
    fn acosh(&self) -> Self {
        (*self + (*self * *self - 1.0).sqrt()).ln()
    }
    fn atanh(&self) -> Self {
        (*self * 2.0 / (-*self + 1.0)).ln_1p() / 2.0
    }
    fn sph_j0(&self) -> Self {
        if self.is_zero() {
            return Self::one();
        }
        self.sin() / *self
    }
    fn sph_j1(&self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        (self.sph_j0() - self.cos()) / *self
    }
    fn sph_j2(&self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        self.sph_j1() * 3.0 / *self - self.sph_j0()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual;

    #[test]
    fn doubles_go_in_and_come_back() {
        for value in [
            0.0,
            -0.0,
            1.0,
            -0.1,
            1e-300,
            -5e-324,
            1.7e308,
            std::f64::consts::PI,
        ] {
            let back = Octuple::from(value).to_f64();
            assert_eq!(back.to_bits(), value.to_bits(), "{value:e}");
        }
        assert_eq!((Octuple::from(1e-300) * 1e-300).to_f64(), 0.0);
        assert_eq!((Octuple::from(-1e300) * 1e300).to_f64(), f64::NEG_INFINITY);
        assert!(Octuple::from(f64::NAN).to_f64().is_nan());
        let tiny = (-1000.0f64).exp2();
        assert_eq!((Octuple::from(tiny) * tiny / tiny).to_f64(), tiny);
    }

    #[test]
    fn seventy_digits_are_kept() {
        let tiny = |error: Octuple| error.abs() < 1e-68;
        let x = Octuple::from(0.7);
        assert!(tiny(x.sqrt() * x.sqrt() - x));
        assert!(tiny(x / 3.0 * 3.0 - x));
        assert!(tiny(x.sin() * x.sin() + x.cos() * x.cos() - 1.0));
        assert!(tiny(x.exp().ln() - x));
        for (there, back) in [
            (x.sinh(), x.sinh().asinh()),
            (x.tanh(), x.tanh().atanh()),
            (x.cosh(), x.cosh().acosh()),
        ] {
            assert!(there.is_finite() && (back - x).abs() < 1e-66);
        }
        let j = [x.sph_j0(), x.sph_j1(), x.sph_j2()];
        assert!(tiny(j[0] + j[2] - j[1] * 3.0 / x));
    }

    #[test]
    fn derivatives_have_as_many() {
        let x = Dual::new(Octuple::from(0.3), Octuple::one());
        let y = (x * x + 1.0).sqrt().recip();
        let exact = -x.re / (x.re * x.re + 1.0).powf(1.5);
        assert!((y.eps - exact).abs() < 1e-66);
    }
}
