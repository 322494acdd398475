//! `cte_csr_map` and `cte_element_batch_workspace`.

use std::ptr::{null, null_mut};

use crate::element::{Element, info};
use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Edge;
use crate::numbers::NUMBERS;
use crate::state::State;

const MAP: usize = function("cte_csr_map");
const WORKSPACE: usize = function("cte_element_batch_workspace");
/// Before a call in the map.
const UNSET: i64 = -77;

/// A pattern and the elements that go into it.
#[derive(Debug)]
struct Pattern {
    n: i64,
    nslave: i32,
    nodes: usize,
    connectivity: Vec<i32>,
    rows: i64,
    start: Vec<i64>,
    column: Vec<i32>,
}

/// A full pattern, changed in none or some places.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let index = harness.element(entropy);
    let element = harness.elements[index].clone();
    workspace(harness, &element, entropy)?;
    let state = State::new(&element, entropy);
    let count = 1 + entropy.below(3);
    let mut pattern = full(&element, &state, count, entropy);
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2]) {
        pattern.change(&element, entropy);
    }
    let edge = entropy.pick(&[Edge::End, Edge::Start]);
    let unknowns = element.unknowns(state.nodes);
    let missing = entropy.below(48);
    harness.show("sparse", &(&element.name, &pattern, missing));
    let slots = &mut harness.slots;
    let or_null = |number, pointer| if missing == number { null() } else { pointer };
    let connectivity = or_null(0, slots.map.input(&pattern.connectivity, edge));
    let column = or_null(1, slots.csr_values.input(&pattern.column, edge));
    let start = slots.csr_map.input(&pattern.start, edge);
    let start = if missing == 2 { null() } else { start };
    let before = vec![UNSET; count * unknowns * unknowns];
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
    let make = harness.interface.table.csr_map;
    let (n, nslave, rows) = (pattern.n, pattern.nslave, pattern.rows);
    // SAFETY: what the header demands, or what it says is refused.
    let call = || unsafe { make(handle, n, nslave, connectivity, rows, start, column, to) };
    let code = harness.call(MAP, call);
    harness.ledger.code(MAP, code);
    NUMBERS.code(code)?;
    map.check_margins("map")?;
    if code != 0 || n == 0 {
        let touched = map.values() != before;
        return if touched {
            Err(format!("map written, code {code}"))
        } else {
            Ok(())
        };
    }
    if missing < 5 {
        return Err("something is missing, but code 0".to_string());
    }
    pattern.check(&element, map.values())
}

/// Every row has a column for every row.
fn full(element: &Element, state: &State, count: usize, entropy: &mut Entropy) -> Pattern {
    let (d, nodes) = (element.dimension(), state.nodes);
    let global = nodes + entropy.below(nodes * count);
    let rows = global * d;
    let mut connectivity = Vec::with_capacity(count * nodes);
    for _ in 0..count {
        let first = entropy.below(global);
        connectivity.extend((0..nodes).map(|a| ((first + a) % global) as i32));
    }
    Pattern {
        n: count as i64,
        nslave: state.nslave as i32,
        nodes,
        connectivity,
        rows: rows as i64,
        start: (0..=rows).map(|row| (row * rows) as i64).collect(),
        column: (0..rows * rows).map(|at| (at % rows) as i32).collect(),
    }
}

impl Pattern {
    fn change(&mut self, element: &Element, entropy: &mut Entropy) {
        match entropy.below(7) {
            0 => self.n = entropy.pick(&[0, -1, i64::MIN, i64::MAX, 1 << 60]),
            1 if element.interpolated() => {
                self.nslave = entropy.pick(&[0, -1, i32::MAX, 1 << 30]);
            }
            1 => self.nslave = entropy.strange_i32(self.nslave),
            2 => {
                let at = entropy.below(self.connectivity.len());
                self.connectivity[at] = entropy.strange_i32(self.connectivity[at]);
            }
            3 => {
                // the last one is the length of the columns
                let at = entropy.below(self.start.len() - 1);
                self.start[at] = entropy.pick(&[-1, i64::MIN, i64::MAX, 0, self.start[at] + 1]);
            }
            4 => {
                let at = entropy.below(self.column.len());
                self.column[at] = entropy.strange_i32(self.column[at]);
            }
            5 => {
                if let Some(last) = self.start.last_mut() {
                    *last = entropy.pick(&[-1, i64::MIN, i64::MAX, 0]);
                }
            }
            _ => self.rows = entropy.pick(&[-1, i64::MIN, i64::MAX, 0, self.rows - 1]),
        }
        // fewer rows end where their last one ends
        if let Some(&last) = usize::try_from(self.rows)
            .ok()
            .and_then(|r| self.start.get(r))
        {
            let room = i64::try_from(self.column.len()).unwrap_or(0);
            if last > room && last < 1 << 60 {
                self.rows = 0;
            }
        }
    }

    /// The place of every entry has its column.
    fn check(&self, element: &Element, map: &[i64]) -> Checked {
        let unknowns = element.unknowns(self.nodes);
        let (d, positions) = (element.dimension(), self.nodes - element.multipliers);
        for (at, &place) in map.iter().enumerate() {
            let (e, j) = (at / (unknowns * unknowns), at % unknowns);
            let (a, k) = match j.checked_sub(positions * d) {
                Some(multiplier) => (positions + multiplier, 0),
                None => (j / d, j % d),
            };
            let wanted = self.connectivity[e * self.nodes + a] * d as i32 + k as i32;
            let place = usize::try_from(place).unwrap_or(usize::MAX);
            if self.column.get(place) != Some(&wanted) {
                return Err(format!("map entry {at}: not at column {wanted}"));
            }
        }
        Ok(())
    }
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
