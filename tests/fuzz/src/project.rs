//! `cte_element_project`.

use std::mem::offset_of;
use std::ptr::{null, null_mut};

use contact_elements::abi::{Arguments, Projection};

use crate::arguments::place;
use crate::called::mode;
use crate::check::{untouched, written};
use crate::element::info;
use crate::entropy::Entropy;
use crate::evaluate::{perform, plan};
use crate::fortran::project::{self as by_name, Project};
use crate::harness::{Checked, Harness};
use crate::ledger::{count, function};
use crate::memory::Output;
use crate::numbers::{NUMBERS, known};
use crate::plan::{Array, Plan};

const FUNCTION: usize = function("cte_element_project");
/// Codes that the header lists for this function.
const CODES: [&str; 8] = [
    "CTE_SUCCESS",
    "CTE_ERROR_NULL",
    "CTE_ERROR_STRUCT_SIZE",
    "CTE_ERROR_NODE_COUNT",
    "CTE_ERROR_PARAMETER",
    "CTE_ERROR_NOT_FINITE",
    "CTE_ERROR_STRIDE",
    "CTE_ERROR_ELEMENT",
];
/// Before a call in integers of results.
const UNSET: Projection = Projection {
    zeta: [-7.5; 2],
    distance: -7.5,
    definiteness: -7.5,
    verdict: -7,
    feature: -7,
    boxes: -7,
    steps: -7,
};

/// A projection; the history that it writes is one that an evaluation takes.
#[expect(
    clippy::too_many_lines,
    reason = "the memory lent to the call lives as long as the function"
)]
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let (plan, reach) = drawn(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    let no_result = entropy.chance(1, 50);
    let with_history = entropy.chance(2, 3);
    let by_fortran = entropy.chance(1, 3);
    let workspace = info(&harness.interface, element.pointer, plan.state.nodes as i32)?.workspace;
    let (arguments, arrays) = place(harness, &element, &plan, workspace)?;
    // SAFETY: a struct without padding is bytes.
    let bytes: [u8; size_of::<Arguments>()] = unsafe { std::mem::transmute(arguments) };
    let size = match plan.struct_size {
        0 => bytes.len(),
        size => (size as usize).clamp(4, bytes.len()),
    };
    let block = harness.slots.arguments.output(&bytes[..size], plan.edge);
    let results = vec![UNSET; element.points()];
    let results = harness.slots.result.output(&results, plan.edge);
    harness.show(
        "project",
        &(&plan, reach, no_result, with_history, by_fortran),
    );
    let handle = match plan.null {
        Some(Array::Element) => null(),
        _ => element.pointer,
    };
    let pointer = match plan.null {
        Some(Array::Arguments) => null_mut(),
        _ => block.pointer.cast(),
    };
    let result = if no_result {
        null_mut()
    } else {
        results.pointer
    };
    let history = if with_history {
        arrays.new.pointer
    } else {
        null_mut()
    };
    let project = harness.interface.table.element_project;
    // SAFETY: what the header demands, or what it says is refused.
    let call = || unsafe { project(handle, pointer, reach, result, history) };
    let fortran = match by_fortran {
        true => Project::new(harness, &plan, reach, element.points()),
        false => None,
    };
    let (function, (code, raised)) = match fortran {
        Some(fortran) => {
            // SAFETY: as above.
            let call = || unsafe { fortran.call(pointer, result, history) };
            let outcome = harness.noting(by_name::FUNCTION, mode(&element), call);
            fortran.check(outcome.0 < 0 && NUMBERS.code(outcome.0)? != "CTE_ERROR_ELEMENT")?;
            (by_name::FUNCTION, outcome)
        }
        None => (FUNCTION, harness.noting(FUNCTION, mode(&element), call)),
    };
    harness.ledger.code(function, code);
    if raised.is_some() {
        count(&harness.ledger.exceptions);
    }
    check_struct(
        code,
        &block,
        &bytes[..size],
        plan.null == Some(Array::Arguments) || plan.has_no_struct(),
    )?;
    check_results(harness, code, &results)?;
    let stays = NUMBERS.code(code)? != "CTE_ERROR_ELEMENT";
    match (code, with_history) {
        (0, true) => follow(harness, plan, &arrays.new),
        _ if stays => untouched("history", &arrays.new),
        _ => arrays.new.check_margins("history"),
    }
}

/// A plan and a reach, with some changes.
fn drawn(harness: &mut Harness, entropy: &mut Entropy) -> Result<(Plan, f64), String> {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    plan.aliased = false;
    let mut reach = entropy.pick(&[0.0, 0.0, 0.1, 1.0, 100.0]);
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2, 4]) {
        match entropy.below(4) {
            0 => reach = entropy.strange(reach),
            1 => plan.change(&element, entropy),
            _ => plan.state.change(&element, entropy),
        }
    }
    Ok((plan, reach))
}

/// The history is whole, and an evaluation begins with it.
fn follow(harness: &mut Harness, mut plan: Plan, history: &Output<f64>) -> Checked {
    written("history", history, 0..history.values().len())?;
    plan.old = Some(history.values().to_vec());
    plan.request = harness.elements[plan.element].info.requests & 0x1f;
    // what a projection does not look at
    (plan.short, plan.scales, plan.map, plan.k_strides) = (0, [1.0; 2], None, [0; 2]);
    (plan.null, plan.struct_size) = (None, 0);
    let next = perform(harness, &plan)?;
    let element = &harness.elements[plan.element];
    // a projection does not read multipliers, and they may be no numbers
    let [.., argument, node] = next.scalars;
    let of_multiplier = NUMBERS.argument(argument)? == "CTE_ARGUMENT_U"
        && usize::try_from(node).is_ok_and(|node| node >= plan.state.nodes - element.multipliers);
    match next.code < 0 && !of_multiplier {
        true => Err(format!("its history is refused: {next:?}")),
        false => Ok(()),
    }
}

fn check_struct(code: i32, block: &Output<u8>, before: &[u8], refused: bool) -> Checked {
    let name = NUMBERS.code(code)?;
    if !CODES.contains(&name) {
        return Err(format!("{name} is not documented for this function"));
    }
    block.check_margins("arguments")?;
    let after = block.values();
    let first = offset_of!(Arguments, error_argument);
    if refused {
        return match code < 0 && after == before {
            true => Ok(()),
            false => Err(format!("a struct that is none: code {code} or written")),
        };
    }
    if after[..first] != before[..first] {
        return Err("arguments: more than the error was written".to_string());
    }
    // SAFETY: the block holds a whole struct, aligned to 8.
    let a = unsafe { &*block.pointer.cast::<Arguments>() };
    NUMBERS.argument(a.error_argument)?;
    match (a.error_argument == 0) == (code == 0) && a.error_index >= 0 {
        true => Ok(()),
        false => Err(format!("code {code} names argument {}", a.error_argument)),
    }
}

fn check_results(harness: &Harness, code: i32, results: &Output<Projection>) -> Checked {
    results.check_margins("result")?;
    let written = results.values().iter().filter(|result| **result != UNSET);
    if code != 0 {
        let stays = NUMBERS.code(code)? != "CTE_ERROR_ELEMENT";
        return match stays && written.count() > 0 {
            true => Err("result: written".to_string()),
            false => Ok(()),
        };
    }
    for result in results.values() {
        known(&NUMBERS.verdicts, result.verdict, "verdict")?;
        count(&harness.ledger.verdicts[result.verdict as usize]);
        let numbers = [
            result.zeta[0],
            result.zeta[1],
            result.distance,
            result.definiteness,
        ];
        let counts = [result.feature, result.boxes, result.steps];
        let fine = numbers.iter().all(|number| number.is_finite())
            && result.distance >= 0.0
            && counts.iter().all(|&number| number >= 0)
            && result.feature <= 8
            && result.boxes <= 20000;
        if !fine {
            return Err(format!("{result:?}"));
        }
    }
    Ok(())
}
