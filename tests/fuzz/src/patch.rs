//! `cte_patch_info` and `cte_patch_evaluate`.

use std::ptr::{null, null_mut};

use contact_elements::Registered;
use contact_elements::abi::{Info, Patch};

use crate::called::{Outcome, make};
use crate::check::{INFO_IN_0_1, PATCH_IN_0_1, is_refused, is_usable};
use crate::element::Element;
use crate::entropy::Entropy;
use crate::facets::{Facets, KINDS};
use crate::fortran;
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Edge;
use crate::numbers::NUMBERS;
use crate::plan::{Array, Plan, request};
use crate::state::State;

const INFO: usize = function("cte_patch_info");
const FUNCTION: usize = function("cte_patch_evaluate");
/// Codes that the header lists for `cte_patch_info`.
const CODES: [&str; 7] = [
    "CTE_SUCCESS",
    "CTE_ERROR_NULL",
    "CTE_ERROR_STRUCT_SIZE",
    "CTE_ERROR_NODE_COUNT",
    "CTE_ERROR_INDEX",
    "CTE_ERROR_NOT_FINITE",
    "CTE_ERROR_ELEMENT",
];
/// `CTE_FREEZE_STATE` and what is written.
const OFFERED: u32 = 0x3f;
/// Doubles of history per slave point: status, facet, feature, two parameters.
const HISTORY: usize = 5;
/// Before a call in integers.
const UNSET: i32 = 0x5a5a_5a5a;

/// One of them.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let selected = &harness.selected;
    let is_kind = |&&at: &&usize| {
        KINDS
            .iter()
            .any(|kind| kind[0] == harness.elements[at].name)
    };
    let kinds: Vec<usize> = selected.iter().filter(is_kind).copied().collect();
    let facet = match kinds.is_empty() || entropy.chance(1, 16) {
        true => harness.element(entropy),
        false => entropy.pick(&kinds),
    };
    let (facets, state) = Facets::new(harness, facet, entropy);
    match entropy.chance(1, 4) {
        true => info(harness, facets, entropy),
        false => evaluate(harness, facets, state, entropy),
    }
}

/// The description of a patch, changed in no, one or some places.
fn info(harness: &mut Harness, mut facets: Facets, entropy: &mut Entropy) -> Checked {
    let edge = entropy.pick(&[Edge::End, Edge::Start]);
    for _ in 0..entropy.pick(&[0, 1, 1, 2]) {
        facets.change(harness, entropy);
    }
    if entropy.chance(1, 8) {
        // more than any array here could hold: only their number is checked
        facets.counts[0] = entropy.pick(&[1000, 1 << 20, 1 << 27]);
    }
    let size = entropy.struct_size::<Info>(INFO_IN_0_1);
    let mut before = vec![0x5a_u8; (size as usize).clamp(4, size_of::<Info>() + 64)];
    before[..4].copy_from_slice(&size.to_ne_bytes());
    let block = harness.slots.arguments.output(&before, edge);
    let fault = harness.slots.integers[0].output(&[UNSET], edge);
    let missing = entropy.below(16);
    let to = match missing {
        0 => null_mut(),
        _ => block.pointer.cast(),
    };
    let argument = match missing {
        1 => null_mut(),
        _ => fault.pointer,
    };
    harness.show("patch info", &(&facets, size, missing));
    let patch = place(harness, &facets, edge);
    let describe = harness.interface.table.patch_info;
    // SAFETY: null, or structs that begin with their size; the entries are those that the header asks for.
    let code = harness.call(INFO, || unsafe { describe(patch, to, argument) });
    harness.ledger.code(INFO, code);
    block.check_margins("info")?;
    fault.check_margins("argument")?;
    let (name, argument) = (NUMBERS.code(code)?, fault.values()[0]);
    let names = match missing {
        1 => argument == UNSET,
        _ => NUMBERS.argument(argument).is_ok() && (argument == 0) == (code == 0),
    };
    let no_struct = missing == 0 || is_refused::<Info>(size, INFO_IN_0_1);
    let no_patch = facets.struct_size == PATCH_IN_0_1;
    if !CODES.contains(&name) || !names || ((no_struct || no_patch) && code == 0) {
        return Err(format!("{name} names argument {argument}"));
    }
    if code != 0 {
        return match block.values() == before {
            true => Ok(()),
            false => Err(format!("info written, code {code}")),
        };
    }
    // SAFETY: a whole struct, aligned to 8.
    check_info(harness, &facets, unsafe { &*block.pointer.cast() })
}

/// The sizes are those that the header gives.
fn check_info(harness: &Harness, facets: &Facets, info: &Info) -> Checked {
    let Some(facet) = facets.elements[0].map(|at| &harness.elements[at]) else {
        return Err("a patch without facets is described".to_string());
    };
    let [slaves, masters, _] = facets.counts;
    let is_rational = facet.name.contains("Rational");
    let weights = if is_rational {
        masters - facet.info.master_nodes
    } else {
        0
    };
    let nodes = slaves + masters;
    let expected = [
        facet.info.dimension,
        nodes,
        nodes,
        slaves,
        masters,
        nodes * facet.info.dimension,
        facet.info.parameters + weights,
        HISTORY as i32 * slaves,
        slaves,
        facet.info.projected,
    ];
    let found = [
        info.dimension,
        info.nodes_minimum,
        info.nodes_maximum,
        info.slave_nodes,
        info.master_nodes,
        info.unknowns,
        info.parameters,
        info.history,
        info.points,
        info.projected,
    ];
    match found == expected && info.requests & !OFFERED == 0 && info.workspace >= 0 {
        true => Ok(()),
        false => Err(format!("{info:?}, not {expected:?}")),
    }
}

/// The caller's struct and its connectivity, which the library may only read.
fn place(harness: &mut Harness, facets: &Facets, edge: Edge) -> *const Patch {
    let [facet, lower, vertex] = facets
        .elements
        .map(|at| at.map_or(null::<Registered>(), |at| harness.elements[at].pointer));
    let [slave_points, master_nodes, count] = facets.counts;
    let connectivity = harness.slots.connectivity.input(&facets.connectivity, edge);
    let whole = size_of::<Patch>();
    let patch = Patch {
        struct_size: match facets.struct_size {
            0 => whole as u32,
            size => size,
        },
        slave_points,
        master_nodes,
        facets: count,
        facet,
        edge: lower,
        vertex,
        connectivity: match facets.null {
            Some(1) => null(),
            _ => connectivity,
        },
        reach: facets.reach,
    };
    let size = (patch.struct_size as usize).clamp(4, whole + 64);
    // SAFETY: a struct without padding is bytes.
    let bytes: [u8; size_of::<Patch>()] = unsafe { std::mem::transmute(patch) };
    let mut bytes = bytes.to_vec();
    bytes.resize(size, 0x5a);
    let pointer = harness.slots.patch.input(&bytes, edge);
    match facets.null {
        Some(0) => null(),
        _ => pointer.cast(),
    }
}

/// A valid call, changed in none, one or some places; the same once more at the other edge; and what it wrote as the
/// next history.
fn evaluate(
    harness: &mut Harness,
    mut facets: Facets,
    state: State,
    entropy: &mut Entropy,
) -> Checked {
    let element = as_element(harness, &facets);
    let mut plan = Plan::new(&element, state, entropy);
    plan.old = match entropy.below(4) {
        0 => None,
        1 => Some(vec![0.0; element.history()]),
        _ => neighbour(harness, &facets, &element, &plan, entropy)?,
    };
    if plan.old.is_none() {
        plan.request &= !0x20;
    }
    for _ in 0..entropy.pick(&[0, 0, 0, 1, 1, 1, 1, 2, 3]) {
        match entropy.below(3) {
            0 => plan.state.change(&element, entropy),
            1 => plan.change(&element, entropy),
            _ => facets.change(harness, entropy),
        }
    }
    let outcome = perform(harness, &facets, &element, &plan)?;
    if entropy.chance(1, 4) {
        plan.edge = plan.edge.other();
        let again = perform(harness, &facets, &element, &plan)?;
        if again != outcome {
            return Err(format!("not the same twice: {outcome:?}, then {again:?}"));
        }
    }
    if entropy.chance(1, 3) {
        compare(harness, &facets, &element, (&plan, entropy))?;
    }
    if let Some(history) = outcome.history {
        plan.old = Some(history);
        let next = perform(harness, &facets, &element, &plan)?;
        if next.code < 0 {
            let code = NUMBERS.code(next.code)?;
            return Err(format!("what was written as history is refused: {code}"));
        }
    }
    Ok(())
}

/// The same call through Fortran's door and through C's.
fn compare(
    harness: &mut Harness,
    facets: &Facets,
    element: &Element,
    (plan, entropy): (&Plan, &mut Entropy),
) -> Checked {
    let mut plan = plan.clone();
    let ldk = fortran::restrict(&mut plan, element, entropy);
    if !fortran::patch::can_describe(facets) {
        return Ok(());
    }
    let by_fortran = fortran::patch::perform(harness, facets, element, (&plan, ldk))?;
    let by_c = perform(harness, facets, element, &plan)?;
    match by_fortran == by_c {
        true => Ok(()),
        false => Err(format!("Fortran: {by_fortran:?}; C: {by_c:?}")),
    }
}

/// The patch as an element with all its nodes: sizes as the header gives them.
fn as_element(harness: &Harness, facets: &Facets) -> Element {
    let mut element = harness.elements[facets.elements[0].unwrap_or(0)].clone();
    let count = |number: usize| number as i32;
    let info = &mut element.info;
    info.nodes_minimum = count(facets.slaves + facets.masters);
    info.nodes_maximum = info.nodes_minimum;
    (info.slave_nodes, info.points) = (count(facets.slaves), count(facets.slaves));
    info.master_nodes = count(facets.masters);
    info.history = count(HISTORY * facets.slaves);
    info.requests &= OFFERED;
    let own = element.parameters.len();
    if element.name.contains("Rational") {
        let weights = harness.elements[element.index as usize].masters();
        info.parameters = count(own.saturating_sub(weights) + facets.masters);
    }
    element.multipliers = 0;
    element.vectors.clear();
    element
}

/// The history of an evaluation of a neighbouring state.
fn neighbour(
    harness: &mut Harness,
    facets: &Facets,
    element: &Element,
    plan: &Plan,
    entropy: &mut Entropy,
) -> Result<Option<Vec<f64>>, String> {
    let mut before = plan.clone();
    before.request = request::HISTORY;
    let step = entropy.power(-4.0, 0.0);
    for u in &mut before.state.u {
        *u += step * entropy.between(-1.0, 1.0);
    }
    Ok(perform(harness, facets, element, &before)?.history)
}

/// Calls, and asserts what holds for every call.
fn perform(
    harness: &mut Harness,
    facets: &Facets,
    element: &Element,
    plan: &Plan,
) -> Result<Outcome, String> {
    harness.show("patch", &(facets, plan));
    let patch = match plan.null {
        Some(Array::Element) => null(),
        _ => place(harness, facets, plan.edge),
    };
    let mut info = Info::EMPTY;
    let describe = harness.interface.table.patch_info;
    // SAFETY: the patch is null or as the header demands; no argument is asked for.
    let described = harness.call(INFO, || unsafe { describe(patch, &mut info, null_mut()) });
    harness.ledger.code(INFO, described);
    NUMBERS.code(described)?;
    let call = harness.interface.table.patch_evaluate;
    // SAFETY: as above.
    let call = |pointer| unsafe { call(patch, pointer) };
    let (outcome, _) = make(harness, element, plan, (FUNCTION, info.workspace), call)?;
    let is_bad = !is_usable(facets.reach) || facets.reach < 0.0;
    if outcome.code >= 0 && (described != 0 || is_bad) {
        return Err(format!("refused with {described}, but evaluated"));
    }
    let points = outcome.history.iter().flat_map(|list| list.chunks(HISTORY));
    for point in points {
        check_place(point, facets.count)?;
    }
    Ok(outcome)
}

/// Facet and feature of a point's history are numbers of some; a point without a facet is outside.
fn check_place(point: &[f64], count: usize) -> Checked {
    let up_to = |value: f64, most: usize| (0..=most).any(|number| number as f64 == value);
    let is_outside = point[1] == 0.0 && point[0] != 4.0;
    match up_to(point[1], count) && up_to(point[2], 8) && !is_outside {
        true => Ok(()),
        false => Err(format!("the history of a point is {point:?}")),
    }
}
