//! The functions that describe: versions, elements, parameters, messages.

use std::ptr::{null, null_mut};

use contact_elements::abi::{ApiTable, Info};

use crate::check::{INFO_IN_0_1, is_refused};
use crate::element::text;
use crate::entropy::Entropy;
use crate::fortran::describe as fortran;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Edge;
use crate::numbers::NUMBERS;
use crate::parameters;

const VERSION: usize = function("cte_abi_version");
const API: usize = function("cte_api");
const COUNT: usize = function("cte_element_count");
const GET: usize = function("cte_element_get");
const FIND: usize = function("cte_element_find");
const INFO: usize = function("cte_element_info");
const UNKNOWN: usize = function("cte_element_unknown");
const CODE_MESSAGE: usize = function("cte_code_message");
const STATUS_MESSAGE: usize = function("cte_status_message");
const ARGUMENT_NAME: usize = function("cte_argument_name");
/// Before a call in integers.
pub(crate) const UNSET: i32 = 0x5a5a_5a5a;

/// One of them.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    match entropy.below(12) {
        0 => versions(harness, entropy),
        1 => get(harness, entropy),
        2 => find(harness, entropy),
        3 => info(harness, entropy),
        4 => unknown(harness, entropy),
        5 => parameters::describe(harness, entropy),
        6 => parameters::check(harness, entropy),
        7 => {
            let at = harness.element(entropy);
            let asked = (nodes(harness, at, entropy), edge(entropy));
            fortran::info(harness, entropy, asked)
        }
        8 => {
            let edge = edge(entropy);
            fortran::find(harness, entropy, edge)
        }
        9 => {
            let edge = edge(entropy);
            fortran::message(harness, entropy, edge)
        }
        _ => messages(harness, entropy),
    }
}

pub(crate) fn edge(entropy: &mut Entropy) -> Edge {
    entropy.pick(&[Edge::End, Edge::Start])
}

/// A failure that says what was expected.
pub(crate) fn expect(holds: bool, what: impl FnOnce() -> String) -> Checked {
    if holds { Ok(()) } else { Err(what()) }
}

fn versions(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let edge = edge(entropy);
    let version = harness.interface.abi_version;
    // SAFETY: no arguments.
    let version = harness.call(VERSION, || unsafe { version() });
    let major = entropy.pick(&[1, 1, 1, 0, 2, u32::MAX, version]);
    let size = entropy.struct_size::<ApiTable>(0);
    let room = (size as usize).clamp(4, size_of::<ApiTable>() + 64);
    let mut before = vec![0x5a_u8; room];
    before[..4].copy_from_slice(&size.to_ne_bytes());
    let table = harness.slots.arguments.output(&before, edge);
    let is_null = entropy.chance(1, 8);
    let pointer = if is_null {
        null_mut()
    } else {
        table.pointer.cast()
    };
    let api = harness.interface.api;
    // SAFETY: the table begins with its size.
    let code = harness.call(API, || unsafe { api(major, pointer) });
    harness.ledger.code(API, code);
    table.check_margins("table")?;
    let fine = !is_null && major == version >> 16 && size as usize >= size_of::<ApiTable>();
    let touched = table.values() != before;
    NUMBERS.code(code)?;
    expect((code == 0) == fine && touched == fine, || {
        format!("cte_api({major}) with {size} bytes returns {code}, touched {touched}")
    })
}

fn get(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let table = harness.interface.table;
    // SAFETY: no arguments.
    let count = harness.call(COUNT, || unsafe { (table.element_count)() });
    let index = entropy.strange_i32(count);
    // SAFETY: any index may be asked for.
    let element = harness.call(GET, || unsafe { (table.element_get)(index) });
    let known = usize::try_from(index)
        .ok()
        .and_then(|i| harness.elements.get(i));
    let expected = known.map_or(null(), |element| element.pointer);
    expect(
        count as usize == harness.elements.len() && element == expected,
        || format!("element {index} is {element:?}, not {expected:?}"),
    )
}

fn find(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let at = harness.element(entropy);
    let mut name = harness.elements[at].name.clone().into_bytes();
    match entropy.below(5) {
        0 => name.resize(name.len() + entropy.below(40), b' '),
        1 => name.truncate(entropy.below(name.len())),
        2 => {
            let byte = entropy.below(name.len());
            name[byte] = entropy.bits() as u8;
        }
        3 => {
            name = (0..entropy.below(64))
                .map(|_| entropy.bits() as u8)
                .collect()
        }
        _ => {}
    }
    let edge = edge(entropy);
    let length = match entropy.below(12) {
        0 => entropy.pick(&[-1, i32::MIN, 0]),
        _ => name.len() as i32,
    };
    let read = &name[..usize::try_from(length).unwrap_or(0).min(name.len())];
    let wanted = read.trim_ascii_end();
    let expected = harness
        .elements
        .iter()
        .position(|e| e.name.as_bytes() == wanted);
    let expected = expected.filter(|_| length >= 0);
    let missing = entropy.below(16);
    let text = harness.slots.x.input(read, edge);
    let text = if missing == 0 { null() } else { text };
    let index = harness.slots.integers[0].output(&[UNSET], edge);
    let to = if missing == 1 {
        null_mut()
    } else {
        index.pointer
    };
    let find = harness.interface.table.element_find;
    // SAFETY: the number of bytes that the length says, or null.
    let code = harness.call(FIND, || unsafe { find(text, length, to) });
    harness.ledger.code(FIND, code);
    NUMBERS.code(code)?;
    index.check_margins("index")?;
    let found = index.values()[0];
    let fine = match expected.filter(|_| missing > 1) {
        Some(position) => code == 0 && found == position as i32,
        None => code < 0 && found == UNSET,
    };
    expect(fine, || format!("{name:?} is element {found}, code {code}"))
}

/// A number of nodes: fitting, or any.
fn nodes(harness: &Harness, at: usize, entropy: &mut Entropy) -> i32 {
    let smallest = harness.elements[at].info.nodes_minimum;
    match entropy.below(4) {
        0 => 0,
        1 => smallest,
        2 => smallest + entropy.below(1000) as i32,
        _ => entropy.strange_i32(smallest),
    }
}

fn info(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let at = harness.element(entropy);
    let (nnode, edge) = (nodes(harness, at, entropy), edge(entropy));
    let size = entropy.struct_size::<Info>(INFO_IN_0_1);
    let room = (size as usize).clamp(4, size_of::<Info>() + 64);
    let mut before = vec![0x5a_u8; room];
    before[..4].copy_from_slice(&size.to_ne_bytes());
    let block = harness.slots.arguments.output(&before, edge);
    let missing = entropy.below(16);
    let handle = if missing == 0 {
        null()
    } else {
        harness.elements[at].pointer
    };
    let pointer = if missing == 1 {
        null_mut()
    } else {
        block.pointer.cast()
    };
    let describe = harness.interface.table.element_info;
    // SAFETY: the struct begins with its size.
    let code = harness.call(INFO, || unsafe { describe(handle, nnode, pointer) });
    harness.ledger.code(INFO, code);
    NUMBERS.code(code)?;
    block.check_margins("info")?;
    if code != 0 {
        return expect(block.values() == before, || {
            format!("info written, code {code}")
        });
    }
    // SAFETY: a whole struct, aligned to 8.
    let info = unsafe { &*block.pointer.cast::<Info>() };
    let element = &harness.elements[at];
    let n = if nnode == 0 {
        element.info.nodes_minimum
    } else {
        nnode
    };
    let fits = info.unknowns as usize == element.unknowns(n as usize)
        && info.struct_size == size
        && !is_refused::<Info>(size, INFO_IN_0_1)
        && info.history == element.info.history
        && (info.workspace > 0) == element.interpolated();
    // SAFETY: static, zero-terminated texts.
    let texts = unsafe { text(info.name) == element.name && !text(info.documentation).is_empty() };
    expect(fits && texts && missing > 1, || format!("{info:?}"))
}

fn unknown(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let at = harness.element(entropy);
    let (nnode, edge) = (nodes(harness, at, entropy), edge(entropy));
    let element = harness.elements[at].clone();
    let index = match entropy.below(2) {
        0 => entropy.below(element.info.unknowns as usize) as i32,
        _ => entropy.strange_i32(element.info.unknowns),
    };
    let [first, second, ..] = &mut harness.slots.integers;
    let (node, kind) = (first.output(&[UNSET], edge), second.output(&[UNSET], edge));
    let missing = entropy.below(16);
    let handle = if missing == 0 {
        null()
    } else {
        element.pointer
    };
    let pointer = if missing == 1 {
        null_mut()
    } else {
        kind.pointer
    };
    let call = harness.interface.table.element_unknown;
    // SAFETY: null, or integers.
    let ask = || unsafe { call(handle, nnode, index, node.pointer, pointer) };
    let code = harness.call(UNKNOWN, ask);
    harness.ledger.code(UNKNOWN, code);
    NUMBERS.code(code)?;
    node.check_margins("node")?;
    kind.check_margins("kind")?;
    let (node, kind) = (node.values()[0], kind.values()[0]);
    let fine = match code {
        0 => NUMBERS.kinds.contains_key(&kind) && node >= 0 && missing > 1,
        _ => node == UNSET && kind == UNSET,
    };
    expect(fine, || {
        format!("unknown {index}: node {node}, kind {kind}, code {code}")
    })
}

fn messages(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let table = harness.interface.table;
    let number = match entropy.below(2) {
        0 => entropy.below(50) as i32 - 14,
        _ => entropy.bits() as i32,
    };
    let functions = [
        (CODE_MESSAGE, table.code_message),
        (STATUS_MESSAGE, table.status_message),
        (ARGUMENT_NAME, table.argument_name),
    ];
    for (name, message) in functions {
        // SAFETY: any number may be asked for; the text is static and zero-terminated.
        let found = unsafe { text(harness.call(name, || message(number))) };
        let plain = found.chars().all(|c| !c.is_control());
        expect(!found.is_empty() && plain, || {
            format!("{number}: `{found}`")
        })?;
    }
    Ok(())
}
