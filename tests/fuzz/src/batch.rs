//! `cte_element_evaluate_batch`, with and without threads: the same contacts one by one have to give the same bits.

use std::mem::offset_of;
use std::ptr::{null, null_mut};

use contact_elements::abi::Batch;

use crate::called::{Outcome, check_exceptions, mode};
use crate::check::{BATCH_IN_0_1, OUTPUT_SIZE, digest, is_refused, unchanged, untouched};
use crate::contacts::{Contacts, contacts, parameters};
use crate::element::{Element, info};
use crate::entropy::Entropy;
use crate::evaluate::perform;
use crate::fortran::batch::{self as by_name, ManyContacts};
use crate::harness::{Checked, Harness};
use crate::ledger::function;
use crate::memory::Output;
use crate::numbers::NUMBERS;
use crate::plan::request;
use crate::scatter::{self, PLACES};

const FUNCTION: usize = function("cte_element_evaluate_batch");
const BY_THREADS: usize = function("cte_element_evaluate_batch_threads");
/// Before a call in arrays of integers.
const UNSET: i32 = 0x5a5a_5a5a;

/// `CTE_STATUS_OPEN`.
const OPEN: i32 = 0;
/// `CTE_STATUS_OUTSIDE`.
const OUTSIDE: i32 = 4;
/// `CTE_CUT_BACK`.
const CUT_BACK: i32 = 1;
/// `CTE_ARGUMENT_HISTORY_ACCEPTED`.
const HISTORY_ACCEPTED: i32 = 8;

/// Arrays that are written.
pub struct Arrays {
    f: Output<f64>,
    k: Output<f64>,
    new: Output<f64>,
    output: Output<f64>,
    energy: Output<f64>,
    status: Output<i32>,
    code: Output<i32>,
    /// Sums of f.
    pub global_f: Output<f64>,
    /// Sums of K.
    pub csr_values: Output<f64>,
    workspace: Output<f64>,
}

/// Some contacts, some of them changed, in any layout.
pub fn case(harness: &mut Harness, entropy: &mut Entropy) -> Checked {
    let contacts = contacts(harness, entropy)?;
    let element = harness.elements[contacts.plan.element].clone();
    let (batch, arrays) = place(harness, &element, &contacts)?;
    // SAFETY: a struct without padding is bytes.
    let bytes: [u8; size_of::<Batch>()] = unsafe { std::mem::transmute(batch) };
    let size = match contacts.plan.struct_size {
        0 => bytes.len(),
        size => (size as usize).clamp(4, bytes.len()),
    };
    let block = harness
        .slots
        .arguments
        .output(&bytes[..size], contacts.plan.edge);
    harness.show("batch", &contacts);
    let evaluate = harness.interface.table.element_evaluate_batch;
    let by_threads = harness.interface.table.element_evaluate_batch_threads;
    let handle = match contacts.null {
        Some(0) => null(),
        _ => element.pointer,
    };
    let pointer = match contacts.null {
        Some(1) => null_mut(),
        _ => block.pointer.cast(),
    };
    // SAFETY: what the header demands, or what it says is refused.
    let call = || unsafe { evaluate(handle, contacts.n, pointer) };
    // SAFETY: as above.
    let call_threads = || unsafe { by_threads(handle, contacts.n, pointer, 2) };
    let fortran = match entropy.chance(1, 3) {
        true => ManyContacts::new(harness, &element, &contacts, &batch),
        false => None,
    };
    let (function, (code, raised)) = if let Some(fortran) = fortran {
        // SAFETY: as above.
        let call = || unsafe { fortran.call(pointer) };
        let outcome = harness.noting(by_name::FUNCTION, mode(&element), call);
        fortran.check()?;
        (by_name::FUNCTION, outcome)
    } else if contacts.n % 4 == 3 {
        (
            BY_THREADS,
            harness.noting(BY_THREADS, mode(&element), call_threads),
        )
    } else {
        (FUNCTION, harness.noting(FUNCTION, mode(&element), call))
    };
    harness.ledger.code(function, code);
    check_struct(&contacts, code, &block, &bytes[..size])?;
    check_whole(&contacts, code, &arrays)?;
    if raised.is_some() {
        let worst = arrays.status.values().iter().copied().max().unwrap_or(0);
        check_exceptions(harness, &element, raised, code, worst)?;
    }
    if code < 0 || contacts.n <= 0 {
        return Ok(());
    }
    let sums = scatter::sums(&arrays);
    check_contacts(harness, &element, &contacts, &arrays)?;
    scatter::by_entries(harness, &element, &contacts, (code, sums))
}

/// The batch and its arrays.
pub fn place(
    harness: &mut Harness,
    element: &Element,
    contacts: &Contacts,
) -> Result<(Batch, Arrays), String> {
    let plan = &contacts.plan;
    let (edge, nodes, d) = (plan.edge, plan.state.nodes, element.dimension());
    let workspace = info(&harness.interface, element.pointer, nodes as i32)?.workspace;
    let workspace_size = workspace.saturating_sub(plan.short);
    let room = workspace_size.clamp(0, workspace + 1000) as usize;
    let arrays = outputs(harness, element, contacts, room);
    let slots = &mut harness.slots;
    let mut b = Batch::EMPTY;
    if plan.struct_size != 0 {
        b.struct_size = plan.struct_size;
    }
    (b.request, b.nslave, b.parameter_count) = (plan.request, plan.nslave, plan.parameter_count);
    b.x = slots
        .x
        .input(&contacts.laid_out(|state| &state.x, 0, d), edge);
    if plan.displaced {
        b.u = slots
            .u
            .input(&contacts.laid_out(|state| &state.u, 1, d), edge);
    }
    [b.x_element_stride, b.x_node_stride, b.x_component_stride] = contacts.strides[0];
    [b.u_element_stride, b.u_node_stride, b.u_component_stride] = contacts.strides[1];
    if let Some(list) = &contacts.connectivity {
        b.connectivity = slots.map.input(list, edge);
    }
    b.global_nodes = contacts.global_nodes;
    b.parameters = slots.parameters.input(&parameters(contacts), edge);
    b.parameter_element_stride = contacts.parameter_stride;
    if let Some(old) = &contacts.old {
        b.history_accepted = slots.old.input(old, edge);
    }
    if element.interpolated() {
        let rows: Vec<f64> = contacts.states.iter().flat_map(|s| s.row.clone()).collect();
        b.slave_row = slots.row.input(&rows, edge);
    }
    if contacts.scattered {
        b.csr_map = slots.csr_map.input(&contacts.map, edge);
    }
    [b.f_element_stride, b.k_element_stride] = contacts.output_strides;
    [b.f_scale, b.k_scale] = plan.scales;
    b.workspace_size = workspace_size;
    fill_pointers(&mut b, contacts, &arrays);
    Ok((b, arrays))
}

/// What is written, with `room` doubles of workspace.
fn outputs(harness: &mut Harness, element: &Element, contacts: &Contacts, room: usize) -> Arrays {
    let (slots, edge) = (&mut harness.slots, contacts.plan.edge);
    let (count, nodes) = (contacts.states.len(), contacts.plan.state.nodes);
    let unknowns = element.unknowns(nodes);
    let length =
        |which: usize, least: usize| (count - 1) * contacts.output_stride(which, least) + least;
    let zeros = vec![0.0; nodes * count * element.dimension()];
    let output = count * element.points() * OUTPUT_SIZE;
    Arrays {
        f: slots.f.canaries(length(0, unknowns), edge),
        k: slots.k.canaries(length(1, unknowns * unknowns), edge),
        new: slots.new.canaries(count * element.history(), edge),
        output: slots.output.canaries(output, edge),
        energy: slots.energy.canaries(count, edge),
        status: slots.status.output(&vec![UNSET; count], edge),
        code: slots.code.output(&vec![UNSET; count], edge),
        global_f: slots.global_f.output(&zeros, edge),
        csr_values: slots.csr_values.output(&[0.0; PLACES], edge),
        workspace: slots.workspace.canaries(room, edge),
    }
}

/// Outputs, and what is null.
fn fill_pointers(b: &mut Batch, contacts: &Contacts, arrays: &Arrays) {
    let or_null = |wanted: bool, pointer: *mut f64| if wanted { pointer } else { null_mut() };
    b.f = or_null(contacts.own, arrays.f.pointer);
    b.k = or_null(contacts.own, arrays.k.pointer);
    b.global_f = or_null(contacts.scattered, arrays.global_f.pointer);
    b.csr_values = or_null(contacts.scattered, arrays.csr_values.pointer);
    (b.history_trial, b.output) = (arrays.new.pointer, arrays.output.pointer);
    (b.energy, b.status) = (arrays.energy.pointer, arrays.status.pointer);
    b.workspace = arrays.workspace.pointer;
    if contacts.codes {
        b.code = arrays.code.pointer;
    }
    match contacts.null {
        Some(2) => b.x = null(),
        Some(3) => b.parameters = null(),
        Some(4) => b.slave_row = null(),
        Some(5) => b.f = null_mut(),
        Some(6) => b.k = null_mut(),
        Some(7) => b.history_trial = null_mut(),
        Some(8) => b.output = null_mut(),
        Some(9) => b.energy = null_mut(),
        Some(10) => b.status = null_mut(),
        Some(11) => b.workspace = null_mut(),
        _ => {}
    }
    if contacts.n == 0 {
        // any pointers
        let nowhere = (contacts.plan.unused & !7) as *mut f64;
        (b.x, b.f, b.k, b.output) = (nowhere, nowhere, nowhere, nowhere);
        b.status = nowhere.cast();
    }
}

fn check_struct(contacts: &Contacts, code: i32, block: &Output<u8>, before: &[u8]) -> Checked {
    NUMBERS.code(code)?;
    block.check_margins("batch")?;
    let after = block.values();
    let first = offset_of!(Batch, failed);
    let size = contacts.plan.struct_size;
    let refused = size != 0 && is_refused::<Batch>(size, BATCH_IN_0_1);
    if contacts.null == Some(1) || refused {
        return match code < 0 && after == before {
            true => Ok(()),
            false => Err(format!("a struct that is none: code {code} or written")),
        };
    }
    if after[..first] != before[..first] {
        return Err("batch: an input of the struct was written".to_string());
    }
    // SAFETY: the block holds a whole struct, aligned to 8.
    let b = unsafe { &*block.pointer.cast::<Batch>() };
    NUMBERS.argument(b.error_argument)?;
    let as_documented = match code {
        0 => b.failed == 0 && b.error_argument == 0,
        1 => (1..=contacts.n).contains(&b.failed) && b.error_argument != 0,
        _ => b.failed == 0 && b.error_argument != 0,
    };
    match as_documented && b.error_index >= 0 {
        true => Ok(()),
        false => Err(format!(
            "code {code} with failed {}, {}",
            b.failed, b.error_argument
        )),
    }
}

/// Margins, and that a refused batch wrote nothing.
fn check_whole(contacts: &Contacts, code: i32, arrays: &Arrays) -> Checked {
    arrays.workspace.check_margins("workspace")?;
    let zero =
        |name, output: &Output<f64>| unchanged(name, output, &vec![0.0; output.values().len()]);
    let own = [
        ("f", &arrays.f),
        ("k", &arrays.k),
        ("history_trial", &arrays.new),
        ("output", &arrays.output),
        ("energy", &arrays.energy),
    ];
    let sums = [
        ("global_f", &arrays.global_f),
        ("csr_values", &arrays.csr_values),
    ];
    let whole = [("status", &arrays.status), ("code", &arrays.code)];
    if code < 0 || contacts.n == 0 {
        own.iter()
            .try_for_each(|(name, output)| untouched(name, output))?;
        sums.iter()
            .try_for_each(|(name, output)| zero(name, output))?;
        let unset = vec![UNSET; contacts.states.len()];
        return whole
            .iter()
            .try_for_each(|(name, output)| unchanged(name, output, &unset));
    }
    for (name, output) in own.iter().chain(&sums) {
        output.check_margins(name)?;
    }
    whole
        .iter()
        .try_for_each(|(name, output)| output.check_margins(name))?;
    for (name, output) in sums {
        if let Some(entry) = output.values().iter().position(|value| !value.is_finite()) {
            return Err(format!(
                "{name}: entry {entry} is {}",
                output.values()[entry]
            ));
        }
    }
    Ok(())
}

/// True for a contact that `CTE_SCREEN` may leave unprojected, by its evaluation alone: it is open or outside, its
/// projection fails, or its history is refused that nobody asks for. Whatever else is refused is refused with it too.
fn may_be_left_out(bits: u32, alone: &Outcome) -> bool {
    let never = bits & (request::FREEZE_STATE | request::PROJECTION_GIVEN) != 0;
    if bits & request::SCREEN == 0 || never {
        return false;
    }
    match alone.code {
        0 => [OPEN, OUTSIDE].contains(&alone.scalars[0]),
        CUT_BACK => true,
        _ => {
            let is_asked_for = bits & (request::HISTORY | request::OUTPUT) != 0;
            alone.scalars[2] == HISTORY_ACCEPTED && !is_asked_for
        }
    }
}

/// Every contact against its evaluation alone.
fn check_contacts(
    harness: &mut Harness,
    element: &Element,
    contacts: &Contacts,
    arrays: &Arrays,
) -> Checked {
    let own = contacts.own && !matches!(contacts.null, Some(5 | 6));
    let statuses = arrays.status.values().to_vec();
    let codes = arrays.code.values().to_vec();
    // the evaluations alone use the same memory
    let digests: Vec<u64> = (0..contacts.states.len())
        .map(|e| digest_of(element, contacts, arrays, e))
        .collect();
    // a node that stands twice in the connectivity has the coordinates of one of them
    let moved = contacts.connectivity.as_ref().is_some_and(|list| {
        let mut sorted = list.clone();
        sorted.sort_unstable();
        sorted.windows(2).any(|pair| pair[0] == pair[1])
    });
    for (e, status) in statuses.iter().enumerate() {
        NUMBERS.status(*status)?;
        harness.ledger.status(*status);
        if contacts.codes {
            NUMBERS.code(codes[e])?;
        }
        if moved {
            continue;
        }
        let alone = perform(harness, &contacts.alone(element, e))?;
        let is_settled = *status == OPEN && (!contacts.codes || codes[e] == 0);
        if is_settled && may_be_left_out(contacts.plan.request, &alone) {
            continue;
        }
        if alone.scalars[0] != *status || (contacts.codes && alone.code != codes[e]) {
            return Err(format!(
                "contact {e} alone: {alone:?}, in the batch status {status}"
            ));
        }
        if own && alone.digest != digests[e] {
            return Err(format!("contact {e} has other bits alone"));
        }
    }
    Ok(())
}

/// Digest of what one contact has written, as of an evaluation with dense arrays.
fn digest_of(element: &Element, contacts: &Contacts, arrays: &Arrays, e: usize) -> u64 {
    let unknowns = element.unknowns(contacts.plan.state.nodes);
    let (history, size) = (element.history(), element.points() * OUTPUT_SIZE);
    let square = unknowns * unknowns;
    let slots = [
        (&arrays.f, contacts.output_stride(0, unknowns), unknowns),
        (&arrays.k, contacts.output_stride(1, square), square),
        (&arrays.new, history, history),
        (&arrays.output, size, size),
        (&arrays.energy, 1, 1),
    ];
    let slot = |(output, stride, length): (&Output<f64>, usize, usize)| {
        output.values()[e * stride..][..length].to_vec()
    };
    let lists = slots.map(slot);
    digest(&lists.each_ref().map(Vec::as_slice))
}
