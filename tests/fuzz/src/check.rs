//! What is asserted of outputs.

use std::hash::{DefaultHasher, Hash, Hasher};

use crate::memory::{CANARY, Output};
use crate::numbers::NUMBERS;

/// Entries of output per contact point.
pub const OUTPUT_SIZE: usize = contact_elements::OUTPUT_SIZE;

/// Nothing was written.
pub fn untouched(name: &str, output: &Output<f64>) -> Result<(), String> {
    output.check_margins(name)?;
    let touched = |value: &f64| value.to_bits() != CANARY;
    match output.values().iter().position(touched) {
        Some(entry) => Err(format!("{name}: entry {entry} was written")),
        None => Ok(()),
    }
}

/// Checks that the entries of `wanted` hold finite numbers and no other was written; `wanted` is in any order.
pub fn written(
    name: &str,
    output: &Output<f64>,
    wanted: impl Iterator<Item = usize>,
) -> Result<(), String> {
    output.check_margins(name)?;
    let values = output.values();
    let mut rest: Vec<bool> = values.iter().map(|v| v.to_bits() != CANARY).collect();
    for entry in wanted {
        match values.get(entry) {
            Some(value) if value.is_finite() => rest[entry] = false,
            Some(value) if value.to_bits() == CANARY => {
                return Err(format!("{name}: entry {entry} was not written"));
            }
            value => return Err(format!("{name}: entry {entry} is {value:?}")),
        }
    }
    match rest.iter().position(|&touched| touched) {
        Some(entry) => Err(format!("{name}: entry {entry} was written")),
        None => Ok(()),
    }
}

/// The array is as it was.
pub fn unchanged<T: Copy + Into<f64>>(
    name: &str,
    output: &Output<T>,
    before: &[T],
) -> Result<(), String> {
    output.check_margins(name)?;
    let bits = |value: T| value.into().to_bits();
    let pairs = output.values().iter().zip(before);
    match pairs
        .clone()
        .position(|(now, was)| bits(*now) != bits(*was))
    {
        Some(entry) => Err(format!("{name}: entry {entry} was written")),
        None => Ok(()),
    }
}

/// A number of a struct or an array that stands for a status.
pub fn is_status(name: &str, value: f64) -> Result<i32, String> {
    let status = value as i32;
    if f64::from(status) != value {
        return Err(format!("{name}: {value} is no status"));
    }
    NUMBERS.status(status).map_err(|e| format!("{name}: {e}"))?;
    Ok(status)
}

/// True for values that the interface accepts: finite, at most 1e30.
pub fn is_usable(value: f64) -> bool {
    value.abs() <= 1e30
}

/// A digest of bits.
pub fn digest(lists: &[&[f64]]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for list in lists {
        list.len().hash(&mut hasher);
        list.iter()
            .for_each(|value| value.to_bits().hash(&mut hasher));
    }
    hasher.finish()
}

/// Size of `cte_arguments` in interface 0.1.
pub const ARGUMENTS_IN_0_1: u32 = 312;
/// Size of `cte_batch` in interface 0.1.
pub const BATCH_IN_0_1: u32 = 336;
/// Size of `cte_info` in interface 0.1.
pub const INFO_IN_0_1: u32 = 152;
/// Size of `cte_patch` in interface 0.1.
pub const PATCH_IN_0_1: u32 = 120;

/// Whether a struct `T` that begins with this size must be refused: it is smaller than that of version 1.0, or laid
/// out as in 0.1.
pub fn is_refused<T>(struct_size: u32, in_0_1: u32) -> bool {
    (struct_size as usize) < size_of::<T>() || struct_size == in_0_1
}
