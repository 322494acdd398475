//! `cte_f77_evaluate_`: everything by address; the same bits as by the struct.

use std::ptr::{null, null_mut};

use crate::called::{check_exceptions, mode};
use crate::check::{OUTPUT_SIZE, untouched, written};
use crate::entropy::Entropy;
use crate::evaluate::{perform, plan};
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Output;
use crate::numbers::NUMBERS;
use crate::plan::{Array, Plan, request};
use crate::state::State;

const FUNCTION: usize = function("cte_f77_evaluate_");
/// Slave nodes that the interface has scratch for.
const MOST_SLAVES: usize = 64;
/// `CTE_ERROR_INDEX`.
const NO_ELEMENT: i32 = -8;

/// Arrays that are written.
struct Arrays {
    f: Output<f64>,
    k: Output<f64>,
    new: Output<f64>,
    output: Output<f64>,
    energy: Output<f64>,
}

/// An evaluation through Fortran's door, and the same through C's.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let (plan, index, ldk) = call(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    let unknowns = element.unknowns(plan.state.nodes);
    let stride = usize::try_from(ldk).unwrap_or(0).clamp(1, 1 << 10);
    let (slots, edge) = (&mut harness.slots, plan.edge);
    let output = slots.output.canaries(element.points() * OUTPUT_SIZE, edge);
    let arrays = Arrays {
        f: slots.f.canaries(unknowns, edge),
        k: slots.k.canaries((unknowns - 1) * stride + unknowns, edge),
        new: slots.new.canaries(element.history(), edge),
        output,
        energy: slots.energy.canaries(1, edge),
    };
    harness.show("fortran", &(&plan, index, ldk));
    let (status, code, raised) = evaluate(harness, &plan, (index, ldk), &arrays)?;
    harness.ledger.code(FUNCTION, code);
    NUMBERS.code(code)?;
    check_exceptions(harness, &element, raised, code, status)?;
    check_arrays(&plan, unknowns, stride, code, &arrays)?;
    if code != NO_ELEMENT {
        harness.ledger.status(status);
        NUMBERS.status(status)?;
    }
    let fits = plan.state.nslave <= MOST_SLAVES && ldk >= unknowns as i32;
    match index == element.index && fits {
        true => compare(harness, plan, code, status, ldk),
        false => Ok(()),
    }
}

/// Calls; status, code and exceptions.
fn evaluate(
    harness: &mut Harness,
    plan: &Plan,
    (index, ldk): (i32, i32),
    arrays: &Arrays,
) -> Result<(i32, i32, Option<String>), String> {
    let (slots, edge, state) = (&mut harness.slots, plan.edge, &plan.state);
    let numbers = [
        index,
        plan.request as i32,
        plan.nnode,
        plan.nslave,
        plan.parameter_count,
        ldk,
    ];
    let mut rest = slots.integers.iter_mut();
    let [index, bits, nnode, nslave, count, ldk] = numbers.map(|number| {
        let slot = rest.next();
        slot.map_or(null(), |slot| slot.input(&[number], edge))
    });
    let status = slots.status.output(&[0x5a5a], edge);
    let code = slots.code.output(&[0x5a5a], edge);
    let given = usize::try_from(plan.parameter_count).unwrap_or(0);
    let parameters = &state.parameters[..given.min(state.parameters.len())];
    let or_null = |name, pointer| {
        if plan.null == Some(name) {
            null()
        } else {
            pointer
        }
    };
    let parameters = or_null(Array::Parameters, slots.parameters.input(parameters, edge));
    let x = or_null(Array::X, slots.x.input(&state.x, edge));
    let row = or_null(Array::Row, slots.row.input(&state.row, edge));
    let u = slots.u.input(&state.u, edge);
    let u = if plan.displaced { u } else { null() };
    let old = plan.old.as_ref().map(|old| slots.old.input(old, edge));
    let old = old.unwrap_or(null());
    let out = |bit: u32, name: Array, output: &Output<f64>| match plan.null {
        Some(null) if null == name => null_mut(),
        _ if plan.request & bit == 0 => (plan.unused & !7) as *mut f64,
        _ => output.pointer,
    };
    let new = out(request::HISTORY, Array::New, &arrays.new);
    let f = out(request::RESIDUAL, Array::F, &arrays.f);
    let k = out(request::TANGENT, Array::K, &arrays.k);
    let output = out(request::OUTPUT, Array::Output, &arrays.output);
    let energy = out(request::ENERGY, Array::Energy, &arrays.energy);
    let (to, result) = (status.pointer, code.pointer);
    let evaluate = harness.interface.fortran.evaluate;
    let mode = mode(&harness.elements[plan.element]);
    // SAFETY: what the header demands, or what it says is refused.
    let ((), raised) = harness.noting(FUNCTION, mode, || unsafe {
        evaluate(
            index, bits, nnode, nslave, x, u, parameters, count, old, new, row, f, k, ldk, output,
            energy, to, result,
        );
    });
    status.check_margins("status")?;
    code.check_margins("code")?;
    Ok((status.values()[0], code.values()[0], raised))
}

/// A plan, the index of the element and LDK.
fn call(harness: &mut Harness, entropy: &mut Entropy) -> Result<(Plan, i32, i32), String> {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    if element.interpolated() && entropy.chance(1, 64) {
        let nslave = MOST_SLAVES - 2 + entropy.below(6);
        plan.state = State::with_slaves(&element, entropy, nslave);
        (plan.nslave, plan.nnode) = (nslave as i32, 0);
    }
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2, 4]) {
        match entropy.below(2) {
            0 => plan.change(&element, entropy),
            _ => plan.state.change(&element, entropy),
        }
    }
    let unknowns = element.unknowns(plan.state.nodes) as i32;
    let index = match entropy.below(32) {
        0 => entropy.pick(&[-1, i32::MIN, i32::MAX, harness.elements.len() as i32]),
        _ => element.index,
    };
    let ldk = match entropy.below(16) {
        0 => entropy.pick(&[0, -1, 1, unknowns - 1, i32::MIN]),
        1..4 => unknowns + entropy.below(5) as i32,
        _ => unknowns,
    };
    (plan.map, plan.aliased, plan.short) = (None, false, 0);
    (plan.scales, plan.strides, plan.struct_size) = ([1.0; 2], [0; 2], 0);
    if matches!(
        plan.null,
        Some(Array::Element | Array::Arguments | Array::Workspace)
    ) {
        plan.null = None;
    }
    Ok((plan, index, ldk))
}

fn check_arrays(
    plan: &Plan,
    unknowns: usize,
    stride: usize,
    code: i32,
    arrays: &Arrays,
) -> Checked {
    let square =
        move || (0..unknowns).flat_map(move |i| (0..unknowns).map(move |j| i + j * stride));
    let lists = [
        ("history_trial", request::HISTORY, &arrays.new),
        ("f", request::RESIDUAL, &arrays.f),
        ("output", request::OUTPUT, &arrays.output),
        ("energy", request::ENERGY, &arrays.energy),
    ];
    let wants = |bit: u32| code == 0 && plan.request & bit != 0;
    for (name, bit, output) in lists {
        match wants(bit) {
            true => written(name, output, 0..output.values().len())?,
            false => untouched(name, output)?,
        }
    }
    match wants(request::TANGENT) {
        true => written("k", &arrays.k, square()),
        false => untouched("k", &arrays.k),
    }
}

/// The same through the struct.
fn compare(harness: &mut Harness, mut plan: Plan, code: i32, status: i32, ldk: i32) -> Checked {
    plan.symbol = false;
    plan.k_strides = [1, i64::from(ldk)];
    let same = perform(harness, &plan)?;
    match same.code == code && same.scalars[0] == status {
        true => Ok(()),
        false => Err(format!(
            "Fortran: code {code}, status {status}; C: {same:?}"
        )),
    }
}
