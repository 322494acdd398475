//! A call with `cte_arguments`, of an element or a patch, and what is asserted of each.

use std::mem::offset_of;
use std::ptr::null_mut;

use contact_elements::abi::Arguments;

use crate::arguments::{Arrays, place};
use crate::check::{OUTPUT_SIZE, digest, is_status, is_usable, untouched, written};
use crate::element::Element;
use crate::harness::{Checked, Harness};
use crate::ledger::count;
use crate::memory::Output;
use crate::numbers::NUMBERS;
use crate::plan::{Array, Plan, request};
use crate::traps::Exceptions;

/// What an evaluation ended with.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Return code.
    pub code: i32,
    /// Status, closed points, argument and index of an error.
    pub scalars: [i32; 4],
    /// Digest of everything written.
    pub digest: u64,
    /// Trial history, if requested and written.
    pub history: Option<Vec<f64>>,
    /// Output, if requested and written.
    pub output: Option<Vec<f64>>,
}

/// Calls with the arguments of a plan, and asserts what holds for every such call; the struct after it. `call`: index of
/// the function, doubles of workspace that it needs, and the call itself.
pub fn make(
    harness: &mut Harness,
    element: &Element,
    plan: &Plan,
    (function, workspace): (usize, i64),
    call: impl FnOnce(*mut Arguments) -> i32,
) -> Result<(Outcome, Output<u8>), String> {
    let (arguments, arrays) = place(harness, element, plan, workspace)?;
    let size = match plan.struct_size {
        0 => size_of::<Arguments>(),
        size => (size as usize).clamp(4, size_of::<Arguments>() + 64),
    };
    let mut bytes = vec![0x5a; size.max(size_of::<Arguments>())];
    // SAFETY: a struct without padding is bytes, and there is room for it.
    unsafe {
        bytes
            .as_mut_ptr()
            .cast::<Arguments>()
            .write_unaligned(arguments)
    };
    bytes.truncate(size);
    let block = harness.slots.arguments.output(&bytes, plan.edge);
    let pointer = match plan.null {
        Some(Array::Arguments) => null_mut(),
        _ => block.pointer.cast::<Arguments>(),
    };
    let (code, raised) = harness.noting(function, mode(element), || call(pointer));
    harness.ledger.code(function, code);
    let scalars = check_struct(harness, (element, plan), code, &block, &bytes)?;
    check_exceptions(harness, element, raised, code, scalars[0])?;
    check_refusal(element, plan, code)?;
    let outcome = check_arrays(harness, element, plan, code, scalars, &arrays)?;
    Ok((outcome, block))
}

/// Elements of which the header says that an exception may be raised before the status says so: rational geometries
/// beyond their domain, laws whose values leave the range of a double.
pub fn mode(element: &Element) -> Exceptions {
    let excused = ["Rational", "PowerLaw", "LogBarrier"];
    match excused.iter().any(|part| element.name.contains(part)) {
        true => Exceptions::Note,
        false => Exceptions::Trap,
    }
}

/// An exception has to end in a status that the header names; where a rational geometry raised it beyond its domain,
/// the search within the domain may have gone on.
pub fn check_exceptions(
    harness: &Harness,
    element: &Element,
    raised: Option<String>,
    code: i32,
    status: i32,
) -> Checked {
    let Some(raised) = raised else {
        return Ok(());
    };
    count(&harness.ledger.exceptions);
    match (code, status) {
        (1, 5 | 7 | 8) => Ok(()),
        (0 | 1, _) if element.name.contains("Rational") => Ok(()),
        _ => Err(format!("{raised} raised, but code {code}, status {status}")),
    }
}

/// The struct: nothing but its last scalars may change, and they say what the header says.
fn check_struct(
    harness: &Harness,
    (element, plan): (&Element, &Plan),
    code: i32,
    block: &Output<u8>,
    before: &[u8],
) -> Result<[i32; 4], String> {
    NUMBERS.code(code)?;
    block.check_margins("arguments")?;
    let after = block.values();
    let (first, last) = (offset_of!(Arguments, dt_ratio), size_of::<Arguments>());
    let refused = plan.null == Some(Array::Arguments) || plan.has_no_struct();
    let same = |range: std::ops::Range<usize>| after.get(range.clone()) == before.get(range);
    if refused {
        return match code < 0 && same(0..before.len()) {
            true => Ok([0; 4]),
            false => Err(format!("a struct that is none: code {code} or written")),
        };
    }
    if !same(0..first) || !same(last..before.len()) {
        return Err("arguments: an input of the struct was written".to_string());
    }
    // SAFETY: the block holds a whole struct, aligned to 8.
    let a = unsafe { &*block.pointer.cast::<Arguments>() };
    let scalars = [a.status, a.closed_points, a.error_argument, a.error_index];
    harness.ledger.status(a.status);
    NUMBERS.status(a.status)?;
    NUMBERS.argument(a.error_argument)?;
    let points = element.info.points;
    let as_documented = match code {
        0 => a.status <= 4 && a.dt_ratio == 1.0 && a.error_argument == 0,
        1 => a.status >= 5 && a.dt_ratio == 0.5 && a.error_argument != 0 && a.error_index < points,
        _ => a.dt_ratio == 1.0 && a.error_argument != 0,
    };
    let counted = (0..=points).contains(&a.closed_points) && a.error_index >= 0;
    match as_documented && counted {
        true => Ok(scalars),
        false => Err(format!(
            "code {code} with {scalars:?}, dt_ratio {}",
            a.dt_ratio
        )),
    }
}

/// The arrays: on 0 what was asked for and nothing else, on anything else nothing.
fn check_arrays(
    harness: &Harness,
    element: &Element,
    plan: &Plan,
    code: i32,
    scalars: [i32; 4],
    arrays: &Arrays,
) -> Result<Outcome, String> {
    arrays.workspace.check_margins("workspace")?;
    let unknowns = element.unknowns(plan.state.nodes);
    let wants = |bit: u32| code == 0 && plan.request & bit != 0;
    let host = |i: usize| plan.map.as_ref().map_or(i, |map| map[i] as usize);
    let all = |bit: u32, name: &str, array: &Output<f64>| match wants(bit) {
        true => written(name, array, 0..array.values().len()),
        false => untouched(name, array),
    };
    match wants(request::RESIDUAL) {
        true => written("f", &arrays.f, (0..unknowns).map(host))?,
        false => untouched("f", &arrays.f)?,
    }
    match plan.k_layout(unknowns).filter(|_| wants(request::TANGENT)) {
        Some([row, column]) => {
            let pairs = (0..unknowns).flat_map(|i| (0..unknowns).map(move |j| (i, j)));
            let entry = |(i, j)| host(i) * row + host(j) * column;
            written("k", &arrays.k, pairs.map(entry))?;
        }
        None => untouched("k", &arrays.k)?,
    }
    all(request::OUTPUT, "output", &arrays.output)?;
    all(request::ENERGY, "energy", &arrays.energy)?;
    let old = plan.old.as_ref().filter(|_| plan.aliased);
    match (wants(request::HISTORY), old) {
        (false, Some(old)) => crate::check::unchanged("history_accepted", &arrays.new, old)?,
        _ => all(request::HISTORY, "history_trial", &arrays.new)?,
    }
    outcome(harness, (element, plan), code, scalars, arrays)
}

/// What the arrays hold.
fn outcome(
    harness: &Harness,
    (element, plan): (&Element, &Plan),
    code: i32,
    scalars: [i32; 4],
    arrays: &Arrays,
) -> Result<Outcome, String> {
    let wants = |bit: u32| code == 0 && plan.request & bit != 0;
    let values = |array: &Output<f64>| array.values().to_vec();
    let history = wants(request::HISTORY).then(|| values(&arrays.new));
    let output = wants(request::OUTPUT).then(|| values(&arrays.output));
    let per_point = element.point_history();
    for (list, size) in [(&history, per_point), (&output, OUTPUT_SIZE)] {
        for point in list.iter().flat_map(|list| list.chunks(size)) {
            harness
                .ledger
                .status(is_status("status of a point", point[0])?);
        }
    }
    let lists = [
        &arrays.f,
        &arrays.k,
        &arrays.new,
        &arrays.output,
        &arrays.energy,
    ];
    let digest = digest(&lists.map(|output| output.values()));
    Ok(Outcome {
        code,
        scalars,
        digest,
        history,
        output,
    })
}

/// What cannot be used must have been refused.
fn check_refusal(element: &Element, plan: &Plan, code: i32) -> Checked {
    let d = element.dimension();
    let read = element.unknowns(plan.state.nodes) - element.multipliers;
    let multipliers = plan.state.u.get(read..).unwrap_or(&[]).iter().step_by(d);
    let u = plan.state.u[..read].iter().chain(multipliers);
    let lists = plan.state.x[..read].iter().chain(&plan.state.parameters);
    let row = plan.state.row.iter().chain(plan.old.iter().flatten());
    let used = lists.chain(row).chain(u.filter(|_| plan.displaced));
    let unusable = used.chain(&plan.scales).any(|&value| !is_usable(value));
    match unusable && code >= 0 {
        true => Err(format!("a value that cannot be used is taken: code {code}")),
        false => Ok(()),
    }
}
