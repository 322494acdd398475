//! Interval arithmetic with outward rounding: every real result lies within. [eq:interval]
//!
//! Bounds are finite, at most [`HUGE`]: nothing overflows, and no operation is invalid.

use crate::arithmetic;
use crate::table::{Operation, Table};

/// Stands for a missing bound.
pub(super) const HUGE: f64 = 1e150;
/// Relative error that the elementary functions may have.
const ELEMENTARY: f64 = 4.0 * f64::EPSILON;
const PI: f64 = core::f64::consts::PI;

/// All numbers from `lower` to `upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) lower: f64,
    pub(super) upper: f64,
}

impl Interval {
    pub(super) const ZERO: Self = Self::exactly(0.0);
    /// No bounds at all.
    const WHOLE: Self = Self {
        lower: -HUGE,
        upper: HUGE,
    };

    /// One number.
    pub(super) const fn exactly(value: f64) -> Self {
        Self {
            lower: value,
            upper: value,
        }
    }

    /// Between two numbers.
    pub(super) fn between(a: f64, b: f64) -> Self {
        Self {
            lower: a.min(b),
            upper: a.max(b),
        }
    }

    /// A [`step`] outwards, within the finite range; everything if a bound is NaN.
    fn outward(lower: f64, upper: f64) -> Self {
        if lower >= -HUGE && upper <= HUGE && lower <= upper {
            Self {
                lower: lower - step(lower),
                upper: upper + step(upper),
            }
        } else {
            Self {
                lower: if (-HUGE..=HUGE).contains(&lower) {
                    lower - step(lower)
                } else {
                    -HUGE
                },
                upper: if (-HUGE..=HUGE).contains(&upper) {
                    upper + step(upper)
                } else {
                    HUGE
                },
            }
        }
    }

    /// Values of an elementary function at the ends, in any order.
    fn elementary(a: f64, b: f64) -> Self {
        let slack = ELEMENTARY * arithmetic::abs(a).max(arithmetic::abs(b));
        Self::outward(a.min(b) - slack, a.max(b) + slack)
    }

    /// Intersection of two enclosures of the same value.
    pub(super) fn common(self, other: Self) -> Self {
        let (lower, upper) = (self.lower.max(other.lower), self.upper.min(other.upper));
        if lower <= upper {
            Self { lower, upper }
        } else {
            self
        }
    }

    pub(super) fn contains_zero(self) -> bool {
        self.lower <= 0.0 && self.upper >= 0.0
    }

    /// The smallest magnitude.
    pub(super) fn least_magnitude(self) -> f64 {
        if self.contains_zero() {
            0.0
        } else {
            arithmetic::abs(self.lower).min(arithmetic::abs(self.upper))
        }
    }

    pub(super) fn add(self, other: Self) -> Self {
        Self::outward(self.lower + other.lower, self.upper + other.upper)
    }

    pub(super) fn subtract(self, other: Self) -> Self {
        Self::outward(self.lower - other.upper, self.upper - other.lower)
    }

    pub(super) fn multiply(self, other: Self) -> Self {
        let products = [
            self.lower * other.lower,
            self.lower * other.upper,
            self.upper * other.lower,
            self.upper * other.upper,
        ];
        let [first, rest @ ..] = products;
        // comparisons, since products of finite bounds are never NaN
        let lower = rest.iter().fold(
            first,
            |least, &value| if value < least { value } else { least },
        );
        let upper = rest.iter().fold(
            first,
            |most, &value| if value > most { value } else { most },
        );
        Self::outward(lower, upper)
    }

    pub(super) fn times(self, factor: f64) -> Self {
        let (lower, upper) = (self.lower * factor, self.upper * factor);
        if factor < 0.0 {
            Self::outward(upper, lower)
        } else {
            Self::outward(lower, upper)
        }
    }

    pub(super) fn square(self) -> Self {
        let least = self.least_magnitude();
        let most = arithmetic::abs(self.lower).max(arithmetic::abs(self.upper));
        let square = Self::outward(least * least, most * most);
        Self {
            lower: square.lower.max(0.0),
            ..square
        }
    }

    fn divide(self, other: Self) -> Self {
        // a quotient by less than this might overflow
        if other.least_magnitude() < 1.0 / HUGE {
            return Self::WHOLE;
        }
        // limited, though it is large enough here: the compiler may divide before the branch above
        let bounded = |value: f64| arithmetic::abs(value).max(1.0 / HUGE).copysign(value);
        let inverse = Self::outward(1.0 / bounded(other.upper), 1.0 / bounded(other.lower));
        self.multiply(inverse)
    }

    fn sqrt(self) -> Self {
        let root = |value: f64| arithmetic::sqrt(value.max(0.0));
        let value = Self::outward(root(self.lower), root(self.upper));
        Self {
            lower: value.lower.max(0.0),
            ..value
        }
    }

    /// sin, by the crests that lie within.
    fn sin(self) -> Self {
        let most = arithmetic::abs(self.lower).max(arithmetic::abs(self.upper));
        // far out the argument itself is known too badly
        if self.upper - self.lower >= 2.0 * PI || most > 1e9 {
            return Self {
                lower: -1.0,
                upper: 1.0,
            };
        }
        let slack = 1e-15 + 4.0 * f64::EPSILON * most;
        let holds = |crest: f64| {
            let turns = |value: f64| floor((value - crest) / (2.0 * PI));
            turns(self.upper + slack) > turns(self.lower - slack)
        };
        let ends = Self::elementary(arithmetic::sin(self.lower), arithmetic::sin(self.upper));
        Self {
            lower: if holds(-0.5 * PI) {
                -1.0
            } else {
                ends.lower.max(-1.0)
            },
            upper: if holds(0.5 * PI) {
                1.0
            } else {
                ends.upper.min(1.0)
            },
        }
    }

    fn cos(self) -> Self {
        self.add(Self::between(0.5 * PI, (0.5 * PI).next_up()))
            .sin()
    }

    fn exp(self) -> Self {
        let exp = |value: f64| arithmetic::exp(value.clamp(-345.0, 345.0));
        let value = Self::elementary(exp(self.lower), exp(self.upper));
        Self {
            lower: if self.lower < -345.0 {
                0.0
            } else {
                value.lower.max(0.0)
            },
            upper: if self.upper > 345.0 {
                HUGE
            } else {
                value.upper
            },
        }
    }

    fn ln(self) -> Self {
        if self.upper <= 0.0 {
            return Self::WHOLE;
        }
        let upper = arithmetic::ln(self.upper);
        if self.lower <= 1.0 / HUGE {
            return Self::outward(-HUGE, upper + ELEMENTARY * arithmetic::abs(upper));
        }
        Self::elementary(arithmetic::ln(self.lower), upper)
    }

    fn pow(self, other: Self) -> Self {
        if self.lower > 0.0 {
            return self.ln().multiply(other).exp();
        }
        Self::WHOLE
    }
}

/// One or two units of the last place: at least the step to the next number.
fn step(value: f64) -> f64 {
    arithmetic::abs(value) * f64::EPSILON + f64::MIN_POSITIVE
}

/// The largest whole number that is not above, of magnitudes up to 1e15.
fn floor(value: f64) -> f64 {
    let whole = value as i64 as f64;
    if whole > value { whole - 1.0 } else { whole }
}

/// Results of all operations of a program.
pub(super) type Scratch = [Interval; MOST_OPERATIONS];

/// Most operations of a geometry that can be searched.
pub(super) const MOST_OPERATIONS: usize = 2048;

/// The outputs of a program over a box of inputs, which the caller picks from `scratch` by their places; false
/// where it has too many operations.
pub(super) fn evaluate(program: &Table, inputs: &[Interval], scratch: &mut Scratch) -> bool {
    if program.operations.len() > MOST_OPERATIONS {
        return false;
    }
    for (index, operation) in program.operations.iter().enumerate() {
        let value = apply(operation, inputs, scratch);
        if let Some(place) = scratch.get_mut(index) {
            *place = value;
        }
    }
    true
}

fn apply(operation: &Operation, inputs: &[Interval], scratch: &Scratch) -> Interval {
    let at = |index: u16| {
        let value = scratch.get(usize::from(index));
        value.copied().unwrap_or(Interval::WHOLE)
    };
    match *operation {
        Operation::Constant(value) => Interval::exactly(value),
        Operation::Input(index) => {
            let value = inputs.get(usize::from(index));
            value.copied().unwrap_or(Interval::WHOLE)
        }
        Operation::Negate(a) => Interval::ZERO.subtract(at(a)),
        Operation::Add(a, b) => at(a).add(at(b)),
        Operation::Subtract(a, b) => at(a).subtract(at(b)),
        Operation::Multiply(a, b) if a == b => at(a).square(),
        Operation::Multiply(a, b) => at(a).multiply(at(b)),
        Operation::Divide(a, b) => at(a).divide(at(b)),
        Operation::Sqrt(a) => at(a).sqrt(),
        Operation::Sin(a) => at(a).sin(),
        Operation::Cos(a) => at(a).cos(),
        Operation::Tan(a) => at(a).sin().divide(at(a).cos()),
        Operation::Exp(a) => at(a).exp(),
        Operation::Ln(a) => at(a).ln(),
        Operation::Pow(a, b) => at(a).pow(at(b)),
        Operation::Atan2(..) => Interval::between(-PI.next_up(), PI.next_up()),
        Operation::Term(a, _) => at(a),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of a function at points of an interval lie within its range.
    fn encloses(range: fn(Interval) -> Interval, function: fn(f64) -> f64, ends: [f64; 2]) {
        let [low, high] = ends;
        let found = range(Interval::between(low, high));
        for k in 0..=1000 {
            let x = (low + (high - low) * f64::from(k) / 1000.0).min(high);
            let value = function(x);
            assert!(
                found.lower <= value && value <= found.upper,
                "{x}: {value} outside {found:?}"
            );
        }
        assert!(found.upper - found.lower < 1e3, "{found:?}");
    }

    #[test]
    fn ranges_enclose_values() {
        for ends in [
            [0.1, 0.2],
            [-3.0, 3.0],
            [1.5, 1.6],
            [-1.6, 4.8],
            [100.0, 100.5],
            [-0.2, 7.0],
        ] {
            encloses(Interval::sin, arithmetic::sin, ends);
            encloses(Interval::cos, arithmetic::cos, ends);
            encloses(Interval::square, |x| x * x, ends);
        }
        for ends in [[0.1, 0.2], [1.0, 3.0], [1e-3, 6.0]] {
            encloses(Interval::sqrt, arithmetic::sqrt, ends);
            encloses(Interval::ln, arithmetic::ln, ends);
            encloses(Interval::exp, arithmetic::exp, ends);
            encloses(|x| Interval::exactly(1.0).divide(x), |x| 1.0 / x, ends);
            encloses(
                |x| x.pow(Interval::exactly(1.5)),
                |x| arithmetic::pow(x, 1.5),
                ends,
            );
        }
    }

    #[test]
    fn steps_reach_the_next_number() {
        for value in [
            0.0,
            1.0,
            1.0_f64.next_up(),
            2.0_f64.next_down(),
            0.1,
            -7.3,
            1e-300,
            -1e149,
        ] {
            let found = Interval::outward(value, value);
            assert!(found.lower <= value.next_down() && found.upper >= value.next_up());
            assert!(found.upper - found.lower <= 5.0 * f64::EPSILON * value.abs() + 1e-300);
        }
    }

    #[test]
    fn crests_are_met() {
        assert_eq!(Interval::between(1.0, 2.0).sin().upper, 1.0);
        assert_eq!(Interval::between(4.0, 5.0).sin().lower, -1.0);
        assert!(Interval::between(0.1, 0.2).sin().upper < 0.2);
        assert_eq!(
            Interval::between(-1.0, 1.0).divide(Interval::between(-1.0, 1.0)),
            Interval::WHOLE
        );
    }
}
