//! `cte_f77_patch_info_` and `cte_f77_patch_evaluate_`.

use contact_elements::abi::Arguments;

use super::numbers::{Call, Numbers};
use crate::called::make;
use crate::element::Element;
use crate::facets::Facets;
use crate::harness::Harness;
use crate::ledger::function;
use crate::plan::Plan;

const INFO: usize = function("cte_f77_patch_info_");
const FUNCTION: usize = function("cte_f77_patch_evaluate_");
/// Before a call in integers.
const UNSET: i32 = 0x5a5a_5a5a;
/// Numbers of a description, and which of them is the workspace.
const SIZES: usize = 13;
const WORKSPACE: usize = 12;

/// True where Fortran can describe the patch.
pub fn can_describe(facets: &Facets) -> bool {
    facets.struct_size == 0 && facets.null.is_none() && facets.elements[0].is_some()
}

/// Describes and evaluates a patch whose K goes by columns of `ldk` entries.
#[expect(
    clippy::too_many_lines,
    reason = "the memory lent to the call lives as long as the function"
)]
pub fn perform(
    harness: &mut Harness,
    facets: &Facets,
    element: &Element,
    (plan, ldk): (&Plan, i32),
) -> Result<Call, String> {
    let edge = plan.edge;
    let elements = facets.elements.map(|at| at.map_or(-1, |at| at as i32));
    let [slaves, masters, count] = facets.counts;
    let own = [
        slaves,
        masters,
        count,
        elements[0],
        elements[1],
        elements[2],
    ];
    let slots = &mut harness.slots;
    let patch = slots.patch.input(&own, edge);
    let connectivity = slots.connectivity.input(&facets.connectivity, edge);
    let reach = slots.result.input(&[facets.reach], edge);
    let [sizes, fault, code, ..] = &mut slots.integers;
    let sizes = sizes.output(&[UNSET; SIZES], edge);
    let (fault, code) = (fault.output(&[UNSET], edge), code.output(&[UNSET], edge));
    let (to, argument, result) = (sizes.pointer, fault.pointer, code.pointer);
    let describe = harness.interface.fortran.patch_info;
    // SAFETY: what the header demands, or what it says is refused.
    harness.call(INFO, || unsafe {
        describe(patch, connectivity, reach, to, argument, result)
    });
    for (name, array) in [("sizes", &sizes), ("argument", &fault), ("code", &code)] {
        array.check_margins(name)?;
    }
    let described = code.values()[0];
    harness.ledger.code(INFO, described);
    let as_documented = match described {
        0 => fault.values()[0] == 0 && sizes.values().iter().all(|&size| size >= 0),
        _ => fault.values()[0] > 0 && sizes.values().iter().all(|&size| size == -1),
    };
    if !as_documented {
        return Err(format!("F77 patch_info: {described}, {:?}", sizes.values()));
    }
    // of a patch that is refused, none is known
    let workspace = i64::from(sizes.values()[WORKSPACE].max(0));
    let n = Numbers::new(harness, plan, ldk, workspace);
    let evaluate = harness.interface.fortran.patch_evaluate;
    let call = |pointer: *mut Arguments| {
        // SAFETY: the struct is whole and its pointers are what the header demands, or what it says is refused.
        unsafe {
            let a = &mut *pointer;
            evaluate(
                patch,
                connectivity,
                reach,
                n.request,
                n.nnode,
                a.x,
                n.ldx,
                a.u,
                n.ldu,
                a.parameters,
                n.count,
                a.history_accepted,
                a.history_trial,
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
    let (outcome, _) = make(harness, element, plan, (FUNCTION, workspace), call)?;
    n.check()?;
    Ok(outcome)
}
