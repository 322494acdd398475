//! The struct of an evaluation and the arrays behind it.

use std::ptr::{null, null_mut};

use contact_elements::abi::Arguments;

use crate::check::OUTPUT_SIZE;
use crate::element::Element;
use crate::harness::Harness;
use crate::memory::Output;
use crate::plan::{Array, Plan, request};

/// Arrays of one evaluation.
pub struct Arrays {
    /// Residual.
    pub f: Output<f64>,
    /// Tangent.
    pub k: Output<f64>,
    /// Trial history.
    pub new: Output<f64>,
    /// Output.
    pub output: Output<f64>,
    /// Energy.
    pub energy: Output<f64>,
    /// Workspace.
    pub workspace: Output<f64>,
}

/// Puts all arrays where they can be watched; `workspace`: doubles that the call needs.
pub fn place(
    harness: &mut Harness,
    element: &Element,
    plan: &Plan,
    workspace: i64,
) -> Result<(Arguments, Arrays), String> {
    let (state, edge, d) = (&plan.state, plan.edge, element.dimension());
    let workspace_size = workspace.saturating_sub(plan.short);
    let room = workspace_size.clamp(0, workspace + 1000) as usize;
    let (arrays, old) = outputs(harness, element, plan, room);
    let slots = &mut harness.slots;
    let count = usize::try_from(plan.parameter_count).unwrap_or(0);
    let parameters = &state.parameters[..count.min(state.parameters.len())];
    let mut a = Arguments::EMPTY;
    if plan.struct_size != 0 {
        a.struct_size = plan.struct_size;
    }
    (a.request, a.nnode, a.nslave) = (plan.request, plan.nnode, plan.nslave);
    a.parameter_count = plan.parameter_count;
    a.x = slots.x.input(&strided(&state.x, d, plan.strides[0]), edge);
    if plan.displaced {
        a.u = slots.u.input(&strided(&state.u, d, plan.strides[1]), edge);
    }
    [a.x_node_stride, a.u_node_stride] = plan.strides;
    a.parameters = slots.parameters.input(parameters, edge);
    a.history_accepted = old;
    if element.interpolated() {
        a.slave_row = slots.row.input(&state.row, edge);
    }
    if let Some(map) = &plan.map {
        a.unknown_map = slots.map.input(map, edge);
    }
    [a.k_row_stride, a.k_col_stride] = plan.k_strides;
    [a.f_scale, a.k_scale] = plan.scales;
    (a.workspace, a.workspace_size) = (arrays.workspace.pointer, workspace_size);
    fill_pointers(&mut a, plan, &arrays);
    Ok((a, arrays))
}

/// What is written, with `room` doubles of workspace, and the accepted history.
fn outputs(
    harness: &mut Harness,
    element: &Element,
    plan: &Plan,
    room: usize,
) -> (Arrays, *const f64) {
    let (slots, edge) = (&mut harness.slots, plan.edge);
    let unknowns = element.unknowns(plan.state.nodes);
    let rows = plan.rows(unknowns);
    let k_length = plan.k_layout(unknowns).map_or(1, |[row, column]| {
        rows.saturating_sub(1) * (row + column) + 1
    });
    let (old, new) = match &plan.old {
        Some(old) if plan.aliased => {
            let both = slots.new.output(old, edge);
            (both.pointer.cast_const(), both)
        }
        old => {
            let old = old.as_ref().map(|old| slots.old.input(old, edge));
            let new = slots.new.canaries(element.history(), edge);
            (old.unwrap_or(null()), new)
        }
    };
    let output = slots.output.canaries(element.points() * OUTPUT_SIZE, edge);
    let arrays = Arrays {
        f: slots.f.canaries(rows, edge),
        k: slots.k.canaries(k_length, edge),
        new,
        output,
        energy: slots.energy.canaries(1, edge),
        workspace: slots.workspace.canaries(room, edge),
    };
    (arrays, old)
}

/// Outputs, what is null, and what is not used.
fn fill_pointers(a: &mut Arguments, plan: &Plan, arrays: &Arrays) {
    let nowhere = (plan.unused & !7) as *mut f64;
    let pointer = |bit: u32, name: Array, output: &Output<f64>| match plan.null {
        Some(null) if null == name => null_mut(),
        _ if plan.dangling && plan.request & bit == 0 => nowhere,
        _ => output.pointer,
    };
    a.f = pointer(request::RESIDUAL, Array::F, &arrays.f);
    a.k = pointer(request::TANGENT, Array::K, &arrays.k);
    a.history_trial = pointer(request::HISTORY, Array::New, &arrays.new);
    a.output = pointer(request::OUTPUT, Array::Output, &arrays.output);
    a.energy = pointer(request::ENERGY, Array::Energy, &arrays.energy);
    match plan.null {
        Some(Array::X) => a.x = null(),
        Some(Array::Parameters) => a.parameters = null(),
        Some(Array::Row) => a.slave_row = null(),
        Some(Array::Workspace) => a.workspace = null_mut(),
        _ => {}
    }
    // documented as not read
    let (unused, low) = (plan.unused, plan.unused as i32);
    (a.u_old, a.v) = (nowhere, nowhere);
    (a.dt, a.dt_ratio, a.padding) = (f64::from_bits(unused), f64::NAN, low);
    (a.status, a.closed_points) = (low, low);
    (a.error_argument, a.error_index) = (low, low);
}

/// Node by node at a stride; a signalling NaN between them. Strides that must be refused: dense.
pub fn strided(values: &[f64], d: usize, stride: i64) -> Vec<f64> {
    let stride = match usize::try_from(stride) {
        Ok(stride) if (d..1 << 16).contains(&stride) => stride,
        _ => d,
    };
    let mut list = Vec::with_capacity(values.len() / d * stride);
    for node in values.chunks(d) {
        if !list.is_empty() {
            let next = list.len() + stride - d;
            list.resize(next, f64::from_bits(0x7ff4_0000_0000_0000));
        }
        list.extend_from_slice(node);
    }
    list
}
