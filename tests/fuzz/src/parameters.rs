//! The functions that describe and check the parameters of an element.

use std::ptr::{null, null_mut};

use crate::describe::{UNSET, edge, expect};
use crate::element::Range;
use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::numbers::NUMBERS;
use crate::state::{State, change_list};

const PARAMETER: usize = function("cte_element_parameter");
const CHECK: usize = function("cte_element_check_parameters");

/// Name, unit and range of a parameter.
pub fn describe(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let at = harness.element(entropy);
    let edge = edge(entropy);
    let element = harness.elements[at].clone();
    let index = match entropy.below(2) {
        0 => entropy.below(element.parameters.len()) as i32,
        _ => entropy.strange_i32(element.info.parameters),
    };
    let wanted = entropy.bits();
    let or_null = |bit: u64, pointer: *mut f64| match wanted >> bit & 1 {
        0 => null_mut(),
        _ => pointer,
    };
    let slots = &mut harness.slots;
    let (name, unit) = (slots.f.canaries(1, edge), slots.k.canaries(1, edge));
    let (lower, upper) = (slots.new.canaries(1, edge), slots.output.canaries(1, edge));
    let closed = slots.integers[0].output(&[UNSET], edge);
    let handle = if wanted & 0xf00 == 0 {
        null()
    } else {
        element.pointer
    };
    let call = harness.interface.table.element_parameter;
    // SAFETY: null, or room for each output; a pointer is as large as a double.
    let ask = || unsafe {
        call(
            handle,
            index,
            or_null(0, name.pointer).cast(),
            or_null(1, unit.pointer).cast(),
            or_null(2, lower.pointer),
            or_null(3, upper.pointer),
            if wanted >> 4 & 1 == 0 {
                null_mut()
            } else {
                closed.pointer
            },
        )
    };
    let code = harness.call(PARAMETER, ask);
    harness.ledger.code(PARAMETER, code);
    NUMBERS.code(code)?;
    closed.check_margins("closed")?;
    for (bit, output) in [name, unit, lower, upper].iter().enumerate() {
        let written = code == 0 && wanted >> bit & 1 == 1;
        output.check_margins("parameter")?;
        let touched = output.values()[0].to_bits() != crate::memory::CANARY;
        expect(touched == written, || format!("output {bit}: code {code}"))?;
    }
    let known = usize::try_from(index).is_ok_and(|i| i < element.parameters.len());
    expect((code == 0) == (known && !handle.is_null()), || {
        format!("parameter {index}: code {code}")
    })
}

/// Whether a list of parameters can be used.
pub fn check(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let at = harness.element(entropy);
    let (element, edge) = (harness.elements[at].clone(), edge(entropy));
    let mut values = State::new(&element, entropy).parameters;
    for _ in 0..entropy.below(3) {
        change_list(&mut values, entropy.chance(1, 8), entropy);
    }
    let count = match entropy.below(4) {
        0 => entropy.strange_i32(values.len() as i32),
        _ => values.len() as i32,
    };
    let given = usize::try_from(count).unwrap_or(0).min(values.len());
    let list = harness.slots.parameters.input(&values[..given], edge);
    let index = harness.slots.integers[0].output(&[UNSET], edge);
    let missing = entropy.below(16);
    let list = if missing == 0 { null() } else { list };
    let handle = if missing == 1 {
        null()
    } else {
        element.pointer
    };
    let to = if missing == 2 {
        null_mut()
    } else {
        index.pointer
    };
    let check = harness.interface.table.element_check_parameters;
    // SAFETY: the number of entries that are read, or null.
    let code = harness.call(CHECK, || unsafe { check(handle, list, count, to) });
    harness.ledger.code(CHECK, code);
    NUMBERS.code(code)?;
    index.check_margins("index")?;
    let first = first_bad(&element.parameters, &values[..given]);
    let found = index.values()[0];
    let fine = match first.filter(|_| missing > 1) {
        Some(first) => code < 0 && (found == first as i32 || missing == 2),
        None => (code == 0) == (missing > 1) && found == UNSET,
    };
    expect(fine, || {
        format!("first bad parameter {first:?}, index {found}, code {code}")
    })
}

/// The first parameter outside its range; else the upper end of a window of angles narrower than 1e-6 rad.
fn first_bad(ranges: &[Range], values: &[f64]) -> Option<usize> {
    let is_bad = |&at: &usize| match values.get(at) {
        None => true,
        Some(value) => {
            let range = &ranges[at];
            let inside = match range.closed {
                true => *value >= range.lower && *value <= range.upper,
                false => *value > range.lower && *value < range.upper,
            };
            !inside || !crate::check::is_usable(*value)
        }
    };
    (0..ranges.len()).find(is_bad).or_else(|| {
        let named = |name: &str| ranges.iter().position(|range| range.name == name);
        let (low, high) = (named("angle_low")?, named("angle_high")?);
        let is_window = values[high] - values[low] >= 1e-6;
        (!is_window).then_some(high)
    })
}
