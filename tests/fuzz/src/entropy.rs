//! Where decisions come from: a generator with a seed, or bytes that somebody else chose.

use rand::RngCore;
use rand_pcg::Pcg64Mcg;

/// A stream of decisions.
pub struct Entropy {
    /// What is left of the given bytes, the next one last.
    bytes: Vec<u8>,
    generator: Pcg64Mcg,
}

impl Entropy {
    /// The stream of one call: it depends on nothing that came before.
    pub fn of_call(seed: u64, call: u64) -> Self {
        let mixed = (u128::from(seed) << 64) | u128::from(call);
        let mixed = mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835);
        let mut generator = Pcg64Mcg::new(mixed ^ (mixed >> 61));
        generator.next_u64();
        Self {
            bytes: Vec::new(),
            generator,
        }
    }

    /// The stream that begins with these bytes; what they do not decide is always decided in the same way, so that
    /// few bytes make a whole call, and more of them change one decision each.
    pub fn of_bytes(bytes: &[u8]) -> Self {
        Self {
            bytes: bytes.iter().rev().copied().collect(),
            ..Self::of_call(0, 0)
        }
    }

    /// `count` bytes as a number.
    fn number(&mut self, count: usize) -> u64 {
        if let Some(rest) = self.bytes.len().checked_sub(count) {
            let taken = self.bytes.drain(rest..);
            return taken.fold(0, |number, byte| number << 8 | u64::from(byte));
        }
        self.generator.next_u64() >> (64 - 8 * count)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.number(8)
    }

    /// A whole number below `limit`, which is at least 1.
    pub fn below(&mut self, limit: usize) -> usize {
        let limit = limit as u64;
        let count = if limit <= 1 << 8 { 2 } else { 4 };
        (self.number(count) % limit) as usize
    }

    /// True in `part` of `whole` cases.
    pub fn chance(&mut self, part: usize, whole: usize) -> bool {
        self.below(whole) < part
    }

    /// One of the values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.number(4) as f64 / 4_294_967_296.0
    }

    /// A number in [lower, upper).
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    /// Ten to a power in [lower, upper).
    pub fn power(&mut self, lower: f64, upper: f64) -> f64 {
        10.0_f64.powf(self.between(lower, upper))
    }

    /// The size that a struct of a call may begin with: mostly its own; also the one it had in interface 0.1.
    pub fn struct_size<T>(&mut self, in_0_1: u32) -> u32 {
        let whole = size_of::<T>() as u32;
        let wrong = [u32::MAX, whole - 1, 4, 0, in_0_1];
        match self.below(2) {
            0 => self.pick(&[whole, whole, whole, whole + 8]),
            _ => self.pick(&wrong),
        }
    }

    /// A double as nobody would send it on purpose; `other` is the value it replaces or one beside it.
    pub fn strange(&mut self, other: f64) -> f64 {
        let sign = if self.chance(1, 2) { -1.0 } else { 1.0 };
        match self.below(24) {
            0 => f64::NAN,
            1 => f64::from_bits(0x7ff4_0000_0000_0000), // signalling
            2 => f64::from_bits(0x7ff0_0000_0000_0001 | self.bits() >> 12),
            3 => sign * f64::INFINITY,
            4 => -0.0,
            5 => 0.0,
            6 => sign * f64::from_bits(1),
            7 => sign * f64::from_bits(self.bits() >> 12), // denormal
            8 => sign * f64::MAX,
            9 => sign * 1e300,
            10 => sign * 1e30,
            11 => sign * f64::from_bits(1e30_f64.to_bits() + 1),
            12 => sign * 1e-30,
            13 => sign * 1e-300,
            14 | 15 => sign * self.power(-30.0, 30.0),
            16 => sign * self.power(-8.0, 8.0),
            17 => f64::from_bits(other.to_bits() ^ 1),
            18 => -other,
            19 => other * f64::from(1_u32 << self.below(31)),
            20 => sign * f64::from(self.below(10) as u32),
            21 => sign * 1e16,
            22 => sign * f64::MIN_POSITIVE,
            _ => f64::from_bits(self.bits()),
        }
    }

    /// A count or an index as nobody would send it on purpose.
    pub fn strange_i32(&mut self, other: i32) -> i32 {
        match self.below(8) {
            0 => -1,
            1 => i32::MIN,
            2 => i32::MAX,
            3 => other.wrapping_add(1),
            4 => other.wrapping_sub(1),
            5 => 0,
            6 => (1 << 30) - 1,
            _ => self.bits() as i32,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_stands_for_itself() {
        let first = |seed, call| Entropy::of_call(seed, call).bits();
        assert_eq!(first(1, 5), first(1, 5));
        assert_ne!(first(1, 5), first(1, 6));
        assert_ne!(first(1, 5), first(2, 5));
        assert_ne!(first(1, 2), first(2, 1));
    }

    #[test]
    fn bytes_decide_as_long_as_there_are_any() {
        let mut given = Entropy::of_bytes(&[0, 1, 2]);
        assert_eq!([given.number(2), given.number(1)], [0x0100, 2]);
        let mut other = Entropy::of_bytes(&[]);
        let mut ended = Entropy::of_bytes(&[7]);
        assert_eq!(ended.number(1), 7);
        assert_eq!(ended.bits(), other.bits());
    }
}
