//! `cte_element_evaluate` and the symbols of the elements.

use std::ptr::null;

use crate::called::{Outcome, make};
use crate::check::{is_usable, written};
use crate::element::{Element, info};
use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::ledger::{count, function};
use crate::memory::{Edge, Output};
use crate::numbers::NUMBERS;
use crate::plan::{Array, Plan, request};
use crate::state::State;

const FUNCTION: usize = function("cte_element_evaluate");
const SYMBOL: usize = function("element symbols");
const INIT: usize = function("cte_element_history_init");
const MESSAGE: usize = function("cte_element_message");

/// A valid call, changed in none, one or some places; the same once more at the other edge; and what it wrote as the
/// next history.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    let changes = entropy.pick(&[0, 0, 0, 1, 1, 1, 1, 2, 3, 5]);
    for _ in 0..changes {
        if entropy.chance(1, 2) {
            plan.state.change(&element, entropy);
        } else {
            plan.change(&element, entropy);
        }
    }
    let repeat = entropy.chance(1, 4);
    let outcome = perform(harness, &plan)?;
    if repeat {
        plan.edge = plan.edge.other();
        plan.symbol = !plan.symbol;
        let again = perform(harness, &plan)?;
        if again != outcome {
            return Err(format!("not the same twice: {outcome:?}, then {again:?}"));
        }
    }
    // forces beyond 1e30 are results, but no inputs
    let history = outcome
        .history
        .filter(|list| list.iter().all(|&value| is_usable(value)));
    if let (0, Some(history)) = (outcome.code, history) {
        plan.old = Some(history);
        let next = perform(harness, &plan)?;
        if next.code < 0 {
            let code = NUMBERS.code(next.code)?;
            return Err(format!("what was written as history is refused: {code}"));
        }
    }
    Ok(())
}

/// A valid call with a history as hosts have them.
pub fn plan(harness: &mut Harness, entropy: &mut Entropy) -> Result<Plan, String> {
    let index = harness.element(entropy);
    let element = harness.elements[index].clone();
    let state = State::new(&element, entropy);
    let mut plan = Plan::new(&element, state, entropy);
    plan.old = match entropy.below(8) {
        0 | 1 => None,
        2..=4 => Some(initial(harness, &element)?),
        _ => evaluated(harness, &element, &plan, entropy)?,
    };
    if plan.old.is_none() {
        plan.request &= 0x5f;
    }
    Ok(plan)
}

/// The initial history.
pub fn initial(harness: &mut Harness, element: &Element) -> Result<Vec<f64>, String> {
    let history = harness.slots.new.canaries(element.history(), Edge::End);
    let init = harness.interface.table.element_history_init;
    // SAFETY: the history has the element's length.
    let code = harness.call(INIT, || unsafe { init(element.pointer, history.pointer) });
    harness.ledger.code(INIT, code);
    if code != 0 {
        return Err(format!("cte_element_history_init returns {code}"));
    }
    written("history", &history, 0..element.history())?;
    Ok(history.values().to_vec())
}

/// The history that an evaluation of a neighbouring state writes.
fn evaluated(
    harness: &mut Harness,
    element: &Element,
    plan: &Plan,
    entropy: &mut Entropy,
) -> Result<Option<Vec<f64>>, String> {
    let mut before = plan.clone();
    before.request = request::HISTORY;
    before.old = Some(initial(harness, element)?);
    let step = entropy.power(-4.0, 0.0);
    for u in &mut before.state.u {
        *u += step * entropy.between(-1.0, 1.0);
    }
    Ok(perform(harness, &before)?.history)
}

/// Calls, and asserts what holds for every call.
pub fn perform(harness: &mut Harness, plan: &Plan) -> Result<Outcome, String> {
    let element = harness.elements[plan.element].clone();
    let workspace = info(&harness.interface, element.pointer, plan.state.nodes as i32)?.workspace;
    harness.show("evaluate", plan);
    // the symbol has no element that could be null
    let symbol = plan.symbol && plan.null != Some(Array::Element);
    let symbols = &harness.interface.symbols;
    let symbol = symbols.get(plan.element).copied().filter(|_| symbol);
    let evaluate = harness.interface.table.element_evaluate;
    let handle = match plan.null {
        Some(Array::Element) => null(),
        _ => element.pointer,
    };
    let call = |pointer| match symbol {
        // SAFETY: what the header demands, or what it says is refused.
        Some(symbol) => unsafe { symbol(pointer) },
        // SAFETY: as above.
        None => unsafe { evaluate(handle, pointer) },
    };
    let function = symbol.map_or(FUNCTION, |_| SYMBOL);
    let (outcome, block) = make(harness, &element, plan, (function, workspace), call)?;
    if outcome.code == 0 {
        count(&harness.ledger.evaluated[plan.element]);
        if outcome.scalars[1] > 0 {
            count(&harness.ledger.contacts[plan.element]);
        }
    }
    message(harness, &element, plan, outcome.code, &block)?;
    Ok(outcome)
}

/// `cte_element_message` about the call, into a text of any length.
fn message(
    harness: &mut Harness,
    element: &Element,
    plan: &Plan,
    code: i32,
    block: &Output<u8>,
) -> Checked {
    let room = (plan.unused % 200) as usize;
    if plan.unused & 0xf00 != 0 {
        return Ok(());
    }
    let text = harness.slots.output.output(&vec![0x5a_u8; room], plan.edge);
    let message = harness.interface.table.element_message;
    let arguments = match plan.null {
        Some(Array::Arguments) => null(),
        _ => block.pointer.cast_const().cast(),
    };
    let call = || unsafe {
        // SAFETY: the struct has the size that it begins with; the text has `room` bytes.
        message(element.pointer, arguments, code, text.pointer, room as i32)
    };
    let length = harness.call(MESSAGE, call);
    text.check_margins("text")?;
    let end = text.values().iter().position(|&byte| byte == 0);
    let whole = usize::try_from(length).unwrap_or(0);
    match end == (room > 0).then(|| whole.min(room.saturating_sub(1))) && whole > 0 {
        true => Ok(()),
        false => Err(format!(
            "a text of {length} bytes ends at {end:?} of {room}"
        )),
    }
}
