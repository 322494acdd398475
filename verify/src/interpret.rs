//! Programs interpreted from their tables: in `f64` bit for bit the emitted code, over dual numbers its
//! derivatives, and with one term of a linearisation changed.

use contact_elements::arithmetic;
use contact_elements::table::{Operation, Table};
use num_dual::{Dual64, DualNum};

/// Numbers a program can be interpreted over.
pub trait Arithmetic: Copy {
    /// A constant.
    fn constant(value: f64) -> Self;
    /// −a
    fn negate(self) -> Self;
    /// a + b
    fn add(self, other: Self) -> Self;
    /// a − b
    fn subtract(self, other: Self) -> Self;
    /// a·b
    fn multiply(self, other: Self) -> Self;
    /// a/b
    fn divide(self, other: Self) -> Self;
    /// √a
    fn sqrt(self) -> Self;
    /// sin a
    fn sin(self) -> Self;
    /// cos a
    fn cos(self) -> Self;
    /// tan a
    fn tan(self) -> Self;
    /// eᵃ
    fn exp(self) -> Self;
    /// ln a
    fn ln(self) -> Self;
    /// aᵇ
    fn pow(self, other: Self) -> Self;
    /// Angle of the point (other, self).
    fn atan2(self, other: Self) -> Self;
}

macro_rules! basic {
    () => {
        fn negate(self) -> Self {
            -self
        }
        fn add(self, other: Self) -> Self {
            self + other
        }
        fn subtract(self, other: Self) -> Self {
            self - other
        }
        fn multiply(self, other: Self) -> Self {
            self * other
        }
        fn divide(self, other: Self) -> Self {
            self / other
        }
    };
}

impl Arithmetic for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    basic!();
    fn sqrt(self) -> Self {
        arithmetic::sqrt(self)
    }
    fn sin(self) -> Self {
        arithmetic::sin(self)
    }
    fn cos(self) -> Self {
        arithmetic::cos(self)
    }
    fn tan(self) -> Self {
        arithmetic::tan(self)
    }
    fn exp(self) -> Self {
        arithmetic::exp(self)
    }
    fn ln(self) -> Self {
        arithmetic::ln(self)
    }
    fn pow(self, other: Self) -> Self {
        arithmetic::pow(self, other)
    }
    fn atan2(self, other: Self) -> Self {
        arithmetic::atan2(self, other)
    }
}

impl Arithmetic for Dual64 {
    fn constant(value: f64) -> Self {
        Self::from_re(value)
    }
    basic!();
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
    fn sin(self) -> Self {
        DualNum::sin(&self)
    }
    fn cos(self) -> Self {
        DualNum::cos(&self)
    }
    fn tan(self) -> Self {
        DualNum::tan(&self)
    }
    fn exp(self) -> Self {
        DualNum::exp(&self)
    }
    fn ln(self) -> Self {
        DualNum::ln(&self)
    }
    fn pow(self, other: Self) -> Self {
        if other.eps == 0.0 {
            DualNum::powf(&self, other.re)
        } else {
            DualNum::powd(&self, other)
        }
    }
    fn atan2(self, other: Self) -> Self {
        DualNum::atan2(&self, other)
    }
}

/// One term whose coefficient is multiplied by a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// Number of the term in its program.
    pub term: usize,
    /// 0: dropped, 2: doubled, −1: flipped.
    pub factor: f64,
}

/// Values of the outputs. Inputs that are missing count as 0.
pub fn interpret<T: Arithmetic>(program: &Table, inputs: &[T], change: Option<Change>) -> Vec<T> {
    let zero = T::constant(0.0);
    let mut values: Vec<T> = Vec::with_capacity(program.operations.len());
    for operation in program.operations {
        let at = |index: u16| values.get(usize::from(index)).copied().unwrap_or(zero);
        let value = match *operation {
            Operation::Constant(value) => T::constant(value),
            Operation::Input(index) => inputs.get(usize::from(index)).copied().unwrap_or(zero),
            Operation::Negate(a) => at(a).negate(),
            Operation::Add(a, b) => at(a).add(at(b)),
            Operation::Subtract(a, b) => at(a).subtract(at(b)),
            Operation::Multiply(a, b) => at(a).multiply(at(b)),
            Operation::Divide(a, b) => at(a).divide(at(b)),
            Operation::Sqrt(a) => at(a).sqrt(),
            Operation::Sin(a) => at(a).sin(),
            Operation::Cos(a) => at(a).cos(),
            Operation::Tan(a) => at(a).tan(),
            Operation::Exp(a) => at(a).exp(),
            Operation::Ln(a) => at(a).ln(),
            Operation::Pow(a, b) => at(a).pow(at(b)),
            Operation::Atan2(a, b) => at(a).atan2(at(b)),
            Operation::Term(a, term) => match change {
                Some(change) if change.term == usize::from(term) => {
                    at(a).multiply(T::constant(change.factor))
                }
                _ => at(a),
            },
        };
        values.push(value);
    }
    program
        .outputs
        .iter()
        .map(|&(_, index)| values.get(usize::from(index)).copied().unwrap_or(zero))
        .collect()
}
