//! `cte_csr_map`, `cte_csr_blocks` and `cte_element_batch_workspace`.

use std::ptr::{null, null_mut};

use crate::element::{Element, info};
use crate::entropy::Entropy;
use crate::fortran::sparse::{self as fortran, Arrays};
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Edge;
use crate::numbers::NUMBERS;
use crate::pattern::Pattern;
use crate::state::State;

const MAPS: [usize; 2] = [function("cte_csr_map"), function("cte_csr_blocks")];
const WORKSPACE: usize = function("cte_element_batch_workspace");
/// Before a call in the map.
const UNSET: i64 = -77;
/// Arguments that can be null: connectivity, columns, rows, map, element.
const POINTERS: usize = 5;

/// A full pattern, changed in no or some places, for both maps.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let index = harness.element(entropy);
    let element = harness.elements[index].clone();
    workspace(harness, &element, entropy)?;
    let state = State::new(&element, entropy);
    let count = 1 + entropy.below(3);
    let mut pattern = Pattern::full(&element, &state, count, entropy);
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2, 4]) {
        pattern.change(&element, entropy);
    }
    let edge = entropy.pick(&[Edge::End, Edge::Start]);
    let missing = entropy.below(48);
    let by_fortran = entropy.chance(1, 3) && missing != 4;
    harness.show("sparse", &(&element.name, &pattern, missing, by_fortran));
    let mut codes = [0; 2];
    for (which, code) in codes.iter_mut().enumerate() {
        *code = make(
            harness,
            (&element, &pattern),
            which,
            (count, missing, edge),
            by_fortran,
        )?;
    }
    if missing < POINTERS {
        return match codes[0] == codes[1] {
            true => Ok(()),
            false => Err(format!("something is missing, codes {codes:?}")),
        };
    }
    pattern.check_codes(&element, codes)
}

/// One of both maps, checked; its code.
fn make(
    harness: &mut Harness,
    (element, pattern): (&Element, &Pattern),
    which: usize,
    (count, missing, edge): (usize, usize, Edge),
    by_fortran: bool,
) -> Result<i32, String> {
    let slots = &mut harness.slots;
    let or_null = |number, pointer| if missing == number { null() } else { pointer };
    let connectivity = or_null(0, slots.map.input(&pattern.connectivity, edge));
    let column = or_null(1, slots.csr_values.input(&pattern.column, edge));
    let start = slots.csr_map.input(&pattern.start, edge);
    let start = if missing == 2 { null() } else { start };
    let (nodes, unknowns) = (pattern.nodes, element.unknowns(pattern.nodes));
    let before = vec![UNSET; count * [unknowns * unknowns, nodes * (nodes + 1)][which]];
    let map = slots.k.output(&before, edge);
    let to = if missing == 3 {
        null_mut()
    } else {
        map.pointer
    };
    let handle = if missing == 4 {
        null()
    } else {
        element.pointer
    };
    let table = &harness.interface.table;
    let make = [table.csr_map, table.csr_blocks][which];
    let (n, nslave, rows) = (pattern.n, pattern.nslave, pattern.rows);
    // SAFETY: what the header demands, or what it says is refused.
    let call = || unsafe { make(handle, n, nslave, connectivity, rows, start, column, to) };
    let arrays = Arrays {
        connectivity,
        start,
        column,
        map: to,
    };
    let code = match by_fortran {
        true => fortran::make(harness, (element, pattern), which, arrays, edge)?,
        false => None,
    };
    let code = code.unwrap_or_else(|| harness.call(MAPS[which], call));
    harness.ledger.code(MAPS[which], code);
    NUMBERS.code(code)?;
    map.check_margins("map")?;
    if code != 0 || n == 0 {
        return match map.values() == before {
            true => Ok(code),
            false => Err(format!("map written, code {code}")),
        };
    }
    if missing < POINTERS {
        return Err("something is missing, but code 0".to_string());
    }
    match which {
        0 => pattern.check(element, map.values())?,
        _ => pattern.check(element, &Pattern::expanded(element, nodes, map.values()))?,
    }
    Ok(code)
}

fn workspace(harness: &mut Harness, element: &Element, entropy: &mut Entropy) -> Checked {
    let nslave = match entropy.below(3) {
        0 => entropy.strange_i32(element.info.slave_nodes),
        _ => element.slaves() as i32,
    };
    let is_null = entropy.chance(1, 16);
    let handle = if is_null { null() } else { element.pointer };
    let ask = harness.interface.table.element_batch_workspace;
    // SAFETY: null or an element.
    let needed = harness.call(WORKSPACE, || unsafe { ask(handle, nslave) });
    if needed < 0 {
        NUMBERS.code(needed as i32)?;
        return Ok(());
    }
    let own = if nslave == 0 {
        element.info.slave_nodes
    } else {
        nslave
    };
    let nodes = element.nodes(own as usize) as i32;
    let expected = info(&harness.interface, element.pointer, nodes)?.workspace;
    match needed == expected && !is_null {
        true => Ok(()),
        false => Err(format!(
            "{needed} doubles for {nslave} slaves, not {expected}"
        )),
    }
}
