//! `cte_f77_find_`, `cte_f77_info_` and `cte_f77_message_`.

use std::ptr::{null, null_mut};

use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::{Edge, Output};
use crate::numbers::NUMBERS;

const FIND: usize = function("cte_f77_find_");
const INFO: usize = function("cte_f77_info_");
const MESSAGE: usize = function("cte_f77_message_");
/// Before a call in integers.
const UNSET: i32 = 0x5a5a_5a5a;

/// A name that an element has, or another one, or codes that are no characters.
pub fn find(harness: &mut Harness, entropy: &mut Entropy, edge: Edge) -> Checked {
    let at = harness.element(entropy);
    let name = harness.elements[at].name.clone();
    let mut codes: Vec<i32> = name.bytes().map(i32::from).collect();
    let whole = codes.len();
    let blanks = entropy.below(200);
    codes.resize(whole + blanks, 32);
    let changed = entropy.chance(1, 2);
    if changed {
        let place = entropy.below(codes.len());
        codes[place] = entropy.strange_i32(codes[place]);
    }
    let missing = entropy.below(16);
    let length = match entropy.below(12) {
        0 => entropy.pick(&[-1, 0, i32::MIN]),
        _ => codes.len() as i32,
    };
    let is_same = length as usize == codes.len() && {
        let text: Vec<u8> = codes
            .iter()
            .map(|&code| u8::try_from(code).unwrap_or(0))
            .collect();
        text.trim_ascii_end() == name.as_bytes() && codes.iter().all(|code| (0..128).contains(code))
    };
    let text = harness.slots.map.input(&codes, edge);
    let text = if missing == 0 { null() } else { text };
    let [first, second, third, ..] = &mut harness.slots.integers;
    let length = first.input(&[length], edge);
    let index = second.output(&[UNSET], edge);
    let code = third.output(&[UNSET], edge);
    let to = if missing == 1 {
        null_mut()
    } else {
        index.pointer
    };
    let find = harness.interface.fortran.find;
    // SAFETY: as many codes as the length says, or null.
    harness.call(FIND, || unsafe { find(text, length, to, code.pointer) });
    index.check_margins("index")?;
    code.check_margins("code")?;
    let (index, code) = (index.values()[0], code.values()[0]);
    harness.ledger.code(FIND, code);
    NUMBERS.code(code)?;
    let fine = match is_same && missing > 1 {
        true => code == 0 && index == harness.elements[at].index,
        // another name may be that of another element
        false => (code < 0 && index == UNSET) || (changed && missing > 1 && code == 0),
    };
    match fine {
        true => Ok(()),
        false => Err(format!("{name}: index {index}, code {code}")),
    }
}

/// Sizes of an element, or −1.
pub fn info(harness: &mut Harness, entropy: &mut Entropy, (nnode, edge): (i32, Edge)) -> Checked {
    let at = harness.element(entropy);
    let index = match entropy.below(4) {
        0 => entropy.strange_i32(at as i32),
        _ => harness.elements[at].index,
    };
    let [first, second, third, fourth, ..] = &mut harness.slots.integers;
    let (index, nnode) = (first.input(&[index], edge), second.input(&[nnode], edge));
    let sizes: Output<i32> = third.output(&[UNSET; 13], edge);
    let code = fourth.output(&[UNSET], edge);
    let info = harness.interface.fortran.info;
    // SAFETY: integers, and thirteen of them.
    harness.call(INFO, || unsafe {
        info(index, nnode, sizes.pointer, code.pointer)
    });
    sizes.check_margins("sizes")?;
    code.check_margins("code")?;
    let (values, code) = (sizes.values(), code.values()[0]);
    NUMBERS.code(code)?;
    let fine = match code {
        0 => values.iter().all(|&value| value >= 0) && !values.contains(&UNSET),
        _ => values.iter().all(|&value| value == -1),
    };
    match fine {
        true => Ok(()),
        false => Err(format!("code {code}: {values:?}")),
    }
}

/// A message about anything, into room of any size.
pub fn message(harness: &mut Harness, entropy: &mut Entropy, edge: Edge) -> Checked {
    let room = entropy.below(300);
    let at = harness.element(entropy) as i32;
    let index = entropy.strange_i32(at);
    let number = match entropy.below(2) {
        0 => entropy.below(20) as i32 - 14,
        _ => entropy.strange_i32(0),
    };
    let state = [0, 0, entropy.below(50) as i32 - 3, entropy.strange_i32(1)];
    let text = harness.slots.output.output(&vec![UNSET; room], edge);
    let [first, second, third, fourth, fifth, ..] = &mut harness.slots.integers;
    let (index, number) = (first.input(&[index], edge), second.input(&[number], edge));
    let state = third.input(&state, edge);
    let size = fourth.input(&[room as i32], edge);
    let length = fifth.output(&[UNSET], edge);
    let message = harness.interface.fortran.message;
    let (to, needed) = (text.pointer, length.pointer);
    // SAFETY: integers, and as many as the size says.
    harness.call(MESSAGE, || unsafe {
        message(index, number, state, to, size, needed)
    });
    text.check_margins("text")?;
    length.check_margins("length")?;
    let needed = usize::try_from(length.values()[0]).unwrap_or(0);
    let is_plain = |&code: &i32| (32..128).contains(&code);
    let blank = text.values().iter().skip(needed).all(|&code| code == 32);
    match needed > 0 && blank && text.values().iter().all(is_plain) {
        true => Ok(()),
        false => Err(format!("{needed}: {:?}", text.values())),
    }
}
