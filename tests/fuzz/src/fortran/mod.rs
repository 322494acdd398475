//! The Fortran 77 set: the calls of the C interface with the same arrays, and every number behind an address. The
//! harness checks them as calls of C, and both have to give the same bits.

pub mod batch;
pub mod describe;
mod numbers;
pub mod patch;
pub mod project;
pub mod sparse;

use contact_elements::abi::Arguments;

use crate::called::make;
use crate::element::{Element, info};
use crate::entropy::Entropy;
use crate::evaluate::{perform, plan};
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::plan::{Array, Plan};

use numbers::{Call, Numbers};

const FUNCTION: usize = function("cte_f77_evaluate_");
/// `CTE_ERROR_INDEX`.
const NO_ELEMENT: i32 = -8;
/// `CTE_ERROR_NULL`.
const NULL: i32 = -1;

/// An evaluation through Fortran's door, and the same through C's.
#[expect(
    clippy::too_many_lines,
    reason = "the memory lent to the call lives as long as the function"
)]
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2, 4]) {
        match entropy.below(2) {
            0 => plan.change(&element, entropy),
            _ => plan.state.change(&element, entropy),
        }
    }
    let ldk = restrict(&mut plan, &element, entropy);
    let index = match entropy.below(32) {
        0 => entropy.pick(&[-1, i32::MIN, i32::MAX, harness.elements.len() as i32]),
        _ => element.index,
    };
    let workspace = info(&harness.interface, element.pointer, plan.state.nodes as i32)?.workspace;
    let mut numbers = Numbers::new(harness, &plan, ldk, workspace);
    let [index_at, nslave] = numbers.integers(harness, [index, plan.nslave]);
    let missing = entropy.below(64);
    let or_null = |at: usize, address: *const i32| match at == missing {
        true => std::ptr::null(),
        false => address,
    };
    if missing < Numbers::COUNT {
        numbers.remove(missing);
    }
    harness.show("fortran", &(&plan, index, ldk, missing));
    let evaluate = harness.interface.fortran.evaluate;
    let n = numbers;
    let call = |pointer: *mut Arguments| {
        // SAFETY: the struct is whole and its pointers are what the header demands, or what it says is refused.
        unsafe {
            let a = &mut *pointer;
            evaluate(
                or_null(20, index_at),
                n.request,
                n.nnode,
                or_null(21, nslave),
                a.x,
                n.ldx,
                a.u,
                n.ldu,
                a.parameters,
                n.count,
                a.history_accepted,
                a.history_trial,
                a.slave_row,
                n.mapped,
                a.unknown_map,
                n.f_scale,
                n.k_scale,
                a.f,
                a.k,
                n.ldk,
                a.output,
                a.energy,
                a.workspace,
                n.workspace_size,
                n.state.pointer,
                n.code.pointer,
            );
            n.fill(a)
        }
    };
    let (outcome, _) = make(harness, &element, &plan, (FUNCTION, workspace), call)?;
    n.check()?;
    match (
        missing < Numbers::COUNT || missing == 20 || missing == 21,
        index == element.index,
    ) {
        (true, _) if outcome.code == NULL || outcome.code == NO_ELEMENT => Ok(()),
        (true, _) => Err(format!(
            "number {missing} is null, but code {}",
            outcome.code
        )),
        (false, false) if outcome.code == NO_ELEMENT => Ok(()),
        (false, false) => Err(format!("no element {index}, but code {}", outcome.code)),
        (false, true) => same(harness, &plan, &outcome),
    }
}

/// The call through C gives the same.
fn same(harness: &mut Harness, plan: &Plan, outcome: &Call) -> Checked {
    let by_c = perform(harness, plan)?;
    match by_c == *outcome {
        true => Ok(()),
        false => Err(format!("Fortran: {outcome:?}; C: {by_c:?}")),
    }
}

/// Keeps what Fortran can say: strides that are integers, K by columns, a struct that is one. Returns LDK.
pub fn restrict(plan: &mut Plan, element: &Element, entropy: &mut Entropy) -> i32 {
    let rows = plan.rows(element.unknowns(plan.state.nodes)) as i32;
    let ldk = match entropy.below(16) {
        0 => entropy.pick(&[0, -1, 1, rows - 1, i32::MIN]),
        1..4 => rows + entropy.below(5) as i32,
        _ => rows,
    };
    plan.k_strides = [1, i64::from(ldk)];
    plan.strides = plan.strides.map(|stride| match i32::try_from(stride) {
        Ok(stride) => i64::from(stride),
        Err(_) => -1,
    });
    (plan.symbol, plan.struct_size) = (false, 0);
    if matches!(plan.null, Some(Array::Element | Array::Arguments)) {
        plan.null = None;
    }
    ldk
}
