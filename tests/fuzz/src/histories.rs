//! `cte_element_history_init`, `cte_history_augment`, `cte_history_transfer`.

use std::ptr::{null, null_mut};

use crate::called::Outcome;
use crate::check::{OUTPUT_SIZE, is_status, is_usable, unchanged};
use crate::entropy::Entropy;
use crate::evaluate::{initial, perform, plan};
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::{Edge, Output};
use crate::numbers::NUMBERS;
use crate::plan::{Plan, request};
use crate::state::change_list;

const INIT: usize = function("cte_element_history_init");
const AUGMENT: usize = function("cte_history_augment");
const TRANSFER: usize = function("cte_history_transfer");
const F77_INIT: usize = function("cte_f77_history_init_");
const F77_AUGMENT: usize = function("cte_f77_history_augment_");
const F77_TRANSFER: usize = function("cte_f77_history_transfer_");
/// `CTE_ERROR_INDEX`, which Fortran gets for an element that does not exist.
const NO_ELEMENT: i32 = -8;

/// One of the three.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    match entropy.below(8) {
        0 => init(harness, entropy),
        1..4 => augment(harness, entropy),
        _ => transfer(harness, entropy),
    }
}

fn init(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let index = harness.element(entropy);
    let element = harness.elements[index].clone();
    let edge = entropy.pick(&[Edge::End, Edge::Start]);
    let history = harness.slots.new.canaries(element.history(), edge);
    let missing = entropy.below(4);
    let to = if missing == 0 {
        null_mut()
    } else {
        history.pointer
    };
    let handle = if missing == 1 {
        null()
    } else {
        element.pointer
    };
    let code = if entropy.chance(1, 2) {
        let init = harness.interface.table.element_history_init;
        // SAFETY: null, or the element's length.
        harness.call(INIT, || unsafe { init(handle, to) })
    } else {
        let number = if missing == 1 {
            entropy.strange_i32(-1)
        } else {
            element.index
        };
        let known = usize::try_from(number).is_ok_and(|n| n < harness.elements.len());
        let to = if missing == 1 && known {
            null_mut()
        } else {
            to
        };
        let [number, result, ..] = integers(harness, [number, 0x5a5a], edge);
        let init = harness.interface.fortran.history_init;
        // SAFETY: as above.
        harness.call(F77_INIT, || unsafe {
            init(number.pointer, to, result.pointer)
        });
        result.check_margins("code")?;
        result.values()[0]
    };
    harness.ledger.code(INIT, code);
    NUMBERS.code(code)?;
    match code {
        0 if missing > 1 => crate::check::written("history", &history, 0..element.history()),
        0 => Err(format!("nothing to write to, but code {code}")),
        _ => crate::check::untouched("history", &history),
    }
}

/// Integers behind addresses.
fn integers<const N: usize>(
    harness: &mut Harness,
    values: [i32; N],
    edge: Edge,
) -> [Output<i32>; N] {
    let mut slots = harness.slots.integers.iter_mut();
    values.map(|value| {
        let slot = slots.next().expect("as many slots as integers");
        slot.output(&[value], edge)
    })
}

/// Trial and accepted history of one step.
fn step(harness: &mut Harness, entropy: &mut Entropy) -> Result<(Plan, Outcome), String> {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    plan.request = request::HISTORY | request::OUTPUT;
    plan.aliased = false;
    if plan.old.is_none() {
        plan.old = Some(initial(harness, &element)?);
    }
    let outcome = perform(harness, &plan)?;
    Ok((plan, outcome))
}

fn augment(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let (mut plan, outcome) = step(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    let mut accepted = plan.old.take().unwrap_or_default();
    let mut trial = outcome.history.unwrap_or_else(|| accepted.clone());
    for _ in 0..entropy.pick(&[0, 0, 1, 2]) {
        let list = if entropy.chance(1, 2) {
            &mut trial
        } else {
            &mut accepted
        };
        change_list(list, entropy.chance(1, 8), entropy);
    }
    let edge = plan.edge;
    let missing = entropy.below(24);
    let from = harness.slots.old.input(&trial, edge);
    let from = if missing == 0 { null() } else { from };
    let to = harness.slots.new.output(&accepted, edge);
    let pointer = if missing == 1 { null_mut() } else { to.pointer };
    harness.show("augment", &(&element.name, &trial, &accepted, missing));
    let fortran = entropy.chance(1, 3);
    let number = if missing == 2 {
        i32::MIN
    } else {
        element.index
    };
    let [number, fault, result] = integers(harness, [number, 0x5a5a, 0x5a5a], edge);
    let code = if fortran {
        let augment = harness.interface.fortran.history_augment;
        // SAFETY: null, or of the length that the header gives.
        harness.call(F77_AUGMENT, || unsafe {
            augment(number.pointer, from, pointer, fault.pointer, result.pointer);
        });
        result.values()[0]
    } else {
        let augment = harness.interface.table.history_augment;
        let handle = if missing == 2 {
            null()
        } else {
            element.pointer
        };
        let fault = if missing == 3 {
            null_mut()
        } else {
            fault.pointer
        };
        // SAFETY: as above.
        harness.call(AUGMENT, || unsafe { augment(handle, from, pointer, fault) })
    };
    harness.ledger.code(AUGMENT, code);
    if fortran || missing != 3 {
        check_fault(code, &fault, [19, 9, 8])?;
    }
    if missing < 3 && (code == 0 || (code == NO_ELEMENT) != (fortran && missing == 2)) {
        return Err(format!("something is missing, but code {code}"));
    }
    check_carried(harness, plan, code, &to, &accepted)
}

/// The argument that an error names, one of these; 0 without an error.
fn check_fault<const N: usize>(code: i32, fault: &Output<i32>, named: [i32; N]) -> Checked {
    fault.check_margins("argument")?;
    let name = NUMBERS.code(code)?;
    let argument = fault.values()[0];
    match if code == 0 {
        argument == 0
    } else {
        named.contains(&argument)
    } {
        true => Ok(()),
        false => Err(format!("{name} names argument {argument}")),
    }
}

/// On anything but 0 the history is as it was; else an evaluation takes it.
fn check_carried(
    harness: &mut Harness,
    mut plan: Plan,
    code: i32,
    to: &Output<f64>,
    before: &[f64],
) -> Checked {
    if code != 0 {
        return unchanged("history", to, before);
    }
    to.check_margins("history")?;
    if let Some(entry) = to.values().iter().position(|value| !value.is_finite()) {
        return Err(format!("history: entry {entry} is {}", to.values()[entry]));
    }
    harness.ledger.status(is_status("history", to.values()[0])?);
    let whole = to.values().len() == harness.elements[plan.element].history();
    let usable = to.values().iter().all(|&value| is_usable(value));
    if to.values() == before || !whole || !usable {
        return Ok(());
    }
    plan.old = Some(to.values().to_vec());
    let next = perform(harness, &plan)?;
    match next.code < 0 {
        true => Err(format!("the history is refused: {next:?}")),
        false => Ok(()),
    }
}

/// Output and history of one contact point.
fn point(plan: &Plan, outcome: &Outcome, harness: &Harness) -> Option<[Vec<f64>; 2]> {
    let size = harness.elements[plan.element].point_history();
    let output = outcome.output.as_ref()?.get(..OUTPUT_SIZE)?.to_vec();
    Some([output, outcome.history.as_ref()?.get(..size)?.to_vec()])
}

/// What a transfer is called with.
#[derive(Debug)]
struct Transfer {
    /// Indices of both elements.
    pair: [usize; 2],
    /// Output and history of both.
    values: [[Vec<f64>; 2]; 2],
    /// Number of what is null or no element; beyond 5 nothing.
    missing: usize,
    fortran: bool,
    edge: Edge,
}

fn transfer(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let (from_plan, from) = step(harness, entropy)?;
    let (mut to_plan, mut to) = step(harness, entropy)?;
    if entropy.chance(3, 4) {
        // the same element elsewhere
        to_plan = from_plan.clone();
        for x in &mut to_plan.state.x {
            *x += 0.1 * entropy.between(-1.0, 1.0);
        }
        to = perform(harness, &to_plan)?;
    }
    let points = [
        point(&from_plan, &from, harness),
        point(&to_plan, &to, harness),
    ];
    let [Some(first), Some(second)] = points else {
        return Ok(());
    };
    let mut call = Transfer {
        pair: [from_plan.element, to_plan.element],
        values: [first, second],
        missing: entropy.below(48),
        fortran: entropy.chance(1, 3),
        edge: from_plan.edge,
    };
    for list in call.values.as_flattened_mut() {
        for _ in 0..entropy.pick(&[0, 0, 0, 0, 0, 1, 2]) {
            change_list(list, entropy.chance(1, 8), entropy);
        }
    }
    let (code, fault, to) = call.make(harness);
    harness.ledger.code(TRANSFER, code);
    check_fault(code, &fault, [26, 27, 28, 29, 30, 31])?;
    if call.missing < 6 && code >= 0 {
        return Err(format!("something is missing, but code {code}"));
    }
    let [_, [_, before]] = &call.values;
    check_carried(harness, to_plan, code, &to, before)
}

impl Transfer {
    /// Code, argument and history.
    fn make(&self, harness: &mut Harness) -> (i32, Output<i32>, Output<f64>) {
        harness.show("transfer", self);
        let (edge, missing) = (self.edge, self.missing);
        let or_null = |number, pointer| if missing == number { null() } else { pointer };
        let slots = &mut harness.slots;
        let [[output, history], [to_output, to_history]] = &self.values;
        let output = or_null(0, slots.x.input(output, edge));
        let history = or_null(1, slots.old.input(history, edge));
        let to_output = or_null(2, slots.u.input(to_output, edge));
        let to = slots.new.output(to_history, edge);
        let pointer = if missing == 3 { null_mut() } else { to.pointer };
        let at = |side: usize| &harness.elements[self.pair[side]];
        let handles = [0, 1].map(|side| match missing == 4 + side {
            true => (null(), -1),
            false => (at(side).pointer, at(side).index),
        });
        let [(from, first), (into, second)] = handles;
        let [first, second, fault, result] =
            integers(harness, [first, second, 0x5a5a, 0x5a5a], edge);
        let code = if self.fortran {
            let transfer = harness.interface.fortran.history_transfer;
            let (first, second) = (first.pointer, second.pointer);
            let (fault, code) = (fault.pointer, result.pointer);
            // SAFETY: null, or of the length that the header gives.
            harness.call(F77_TRANSFER, || unsafe {
                transfer(
                    first, output, history, second, to_output, pointer, fault, code,
                );
            });
            result.values()[0]
        } else {
            let transfer = harness.interface.table.history_transfer;
            let fault = fault.pointer;
            // SAFETY: as above.
            harness.call(TRANSFER, || unsafe {
                transfer(from, output, history, into, to_output, pointer, fault)
            })
        };
        (code, fault, to)
    }
}
