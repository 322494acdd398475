//! One element: checks, then the kernel.

use super::describe::bad_parameter;
use super::places::Map;
use super::sizes::{Fault, MOST_UNKNOWNS, extent, reported, slave_count, spacing};
use super::target::Target;
use super::threads::Turn;
use super::types::{Arguments, is_whole};
use super::{Descriptor, argument, code, request};
use crate::runtime::{Call, Coordinates, History, InputError, Nodes, Status, Summary, Wanted};

/// `cte_element_evaluate`.
///
/// # Safety
/// `element` comes from this interface or is null; `arguments` points to a struct whose pointers are
/// valid for the shapes that the header gives, or is null.
pub unsafe fn element_evaluate(element: *const Descriptor, arguments: *mut Arguments) -> i32 {
    if arguments.is_null() {
        return code::NULL;
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(arguments) } {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    let arguments = unsafe { &mut *arguments };
    // SAFETY: promised by the caller.
    let result = match unsafe { element.as_ref() } {
        // SAFETY: promised by the caller.
        Some(element) => unsafe { checked(element, arguments) },
        None => Err((code::NULL, argument::ELEMENT, 0)),
    };
    arguments.dt_ratio = 1.0;
    arguments.closed_points = 0;
    arguments.status = Status::Open as i32;
    (arguments.error_argument, arguments.error_index) = (argument::NONE, 0);
    match result {
        Ok(Ok(summary)) => {
            arguments.status = summary.status as i32;
            arguments.closed_points = summary.closed as i32;
            code::SUCCESS
        }
        Ok(Err(error)) => {
            if let Some(status) = error.status() {
                arguments.status = status as i32;
                arguments.dt_ratio = 0.5;
            }
            let (code, name, index) = fault_of(error);
            (arguments.error_argument, arguments.error_index) = (name, reported(index));
            code
        }
        Err((code, name, index)) => {
            (arguments.error_argument, arguments.error_index) = (name, reported(index));
            code
        }
    }
}

/// Return code, argument and entry of a kernel's error.
pub(super) fn fault_of(error: InputError) -> Fault {
    match error {
        InputError::Position(node) => (code::NOT_FINITE, argument::X, node),
        InputError::Displacement(node) => (code::NOT_FINITE, argument::U, node),
        InputError::History(entry) => (code::NOT_FINITE, argument::HISTORY_ACCEPTED, entry),
        InputError::Impossible(entry) => (code::HISTORY, argument::HISTORY_ACCEPTED, entry),
        InputError::NoHistory => (code::NULL, argument::HISTORY_ACCEPTED, 0),
        InputError::SlaveRow(entry) => (code::NOT_FINITE, argument::SLAVE_ROW, entry),
        InputError::Workspace => (code::WORKSPACE, argument::WORKSPACE, 0),
        InputError::Point(failure) => (code::CUT_BACK, argument::X, failure.point),
    }
}

/// Checks the arguments, then runs the kernel.
///
/// # Safety
/// As [`element_evaluate`].
unsafe fn checked(
    element: &Descriptor,
    arguments: &Arguments,
) -> Result<Result<Summary, InputError>, Fault> {
    check_request(
        element,
        arguments.request,
        arguments.history_accepted.is_null(),
    )?;
    check_outputs(arguments)?;
    let (n, nslave) = node_counts(element, arguments)?;
    // SAFETY: promised by the caller.
    let parameters =
        unsafe { parameters(element, arguments.parameters, arguments.parameter_count)? };
    // SAFETY: promised by the caller.
    let nodes = unsafe { nodes(element, arguments, n)? };
    // SAFETY: promised by the caller.
    let mut target = unsafe { target(element, arguments, n)? };
    // SAFETY: promised by the caller.
    let (history, slave_row, memory) = unsafe {
        (
            history(element, arguments.history_accepted),
            slave_row(element, arguments.slave_row, nslave)?,
            workspace(
                arguments.workspace,
                arguments.workspace_size,
                element.workspace(n),
            )?,
        )
    };
    let call = Call {
        parameters,
        history,
        slave_row,
        wanted: wanted(arguments.request),
    };
    let result = (element.kernel)(&call, &nodes, memory, &mut target);
    if result.is_ok() && arguments.request & request::SYMMETRISE != 0 && !target.k.is_null() {
        target.symmetrise();
    }
    Ok(result)
}

/// Where the coordinates stand.
///
/// # Safety
/// `x` has n nodes at its stride, `u` likewise where it is not null.
pub(super) unsafe fn nodes<'a>(
    element: &Descriptor,
    arguments: &Arguments,
    n: usize,
) -> Result<Nodes<'a>, Fault> {
    let d = element.dimension;
    let coordinates = |values: *const f64, stride: i64, name: i32| {
        let fault = (code::STRIDE, name, 0);
        let node_stride = spacing(stride, d).ok_or(fault)?;
        let length = extent(&[(n - 1, node_stride), (d - 1, 1)]).ok_or(fault)?;
        Ok(Coordinates {
            // SAFETY: promised by the caller.
            values: unsafe { core::slice::from_raw_parts(values, length) },
            offset: 0,
            node_stride,
            component_stride: 1,
        })
    };
    Ok(Nodes {
        x: coordinates(arguments.x, arguments.x_node_stride, argument::X)?,
        u: if arguments.u.is_null() {
            spacing(arguments.u_node_stride, d).ok_or((code::STRIDE, argument::U, 0))?;
            None
        } else {
            Some(coordinates(
                arguments.u,
                arguments.u_node_stride,
                argument::U,
            )?)
        },
        connectivity: None,
        count: n,
    })
}

pub(super) fn wanted(bits: u32) -> Wanted {
    Wanted {
        residual: bits & request::RESIDUAL != 0,
        tangent: bits & request::TANGENT != 0,
        freeze: bits & request::FREEZE_STATE != 0,
        projection_given: bits & request::PROJECTION_GIVEN != 0,
    }
}

pub(super) fn check_request(
    element: &Descriptor,
    bits: u32,
    no_history: bool,
) -> Result<(), Fault> {
    let refused = bits & !element.requests();
    if refused != 0 {
        return Err((
            code::REQUEST,
            argument::REQUEST,
            refused.trailing_zeros() as usize,
        ));
    }
    if bits & (request::FREEZE_STATE | request::PROJECTION_GIVEN) != 0 && no_history {
        return Err((code::NULL, argument::HISTORY_ACCEPTED, 0));
    }
    Ok(())
}

fn check_outputs(arguments: &Arguments) -> Result<(), Fault> {
    let bits = arguments.request;
    let missing = |bit: u32, pointer: *mut f64| bits & bit != 0 && pointer.is_null();
    let name = if arguments.x.is_null() {
        argument::X
    } else if arguments.parameters.is_null() {
        argument::PARAMETERS
    } else if missing(request::RESIDUAL, arguments.f) {
        argument::F
    } else if missing(request::TANGENT, arguments.k) {
        argument::K
    } else if missing(request::HISTORY, arguments.history_trial) {
        argument::HISTORY_TRIAL
    } else if missing(request::OUTPUT, arguments.output) {
        argument::OUTPUT
    } else if missing(request::ENERGY, arguments.energy) {
        argument::ENERGY
    } else {
        return Ok(());
    };
    Err((code::NULL, name, 0))
}

pub(super) fn node_counts(
    element: &Descriptor,
    arguments: &Arguments,
) -> Result<(usize, usize), Fault> {
    let nslave = slave_count(element, arguments.nslave)?;
    let n = element.nodes(nslave);
    match usize::try_from(arguments.nnode) {
        Ok(given) if given == 0 || given == n => Ok((n, nslave)),
        _ => Err((code::NODE_COUNT, argument::NNODE, 0)),
    }
}

/// The parameters as a checked slice.
///
/// # Safety
/// `values` points to `count` numbers.
pub(super) unsafe fn parameters<'a>(
    element: &Descriptor,
    values: *const f64,
    count: i32,
) -> Result<&'a [f64], Fault> {
    let count = usize::try_from(count).unwrap_or(0);
    let count = count.min(element.parameters.len());
    // SAFETY: promised by the caller.
    let values = unsafe { core::slice::from_raw_parts(values, count) };
    match bad_parameter(element, values) {
        None => Ok(values),
        Some((code, index)) => Err((code, argument::PARAMETERS, index)),
    }
}

/// The old history as cells, because the new one may be the same array.
///
/// # Safety
/// `values` is null or has the element's history.
pub(super) unsafe fn history<'a>(element: &Descriptor, values: *const f64) -> Option<History<'a>> {
    if values.is_null() {
        return None;
    }
    // SAFETY: promised by the caller; Cell<f64> has the layout of f64.
    let values = unsafe { core::slice::from_raw_parts(values.cast(), element.history()) };
    Some(History::Shared(values))
}

/// The row and weight of an interpolated slave.
///
/// # Safety
/// `values` is null or has nslave + 1 entries.
pub(super) unsafe fn slave_row<'a>(
    element: &Descriptor,
    values: *const f64,
    nslave: usize,
) -> Result<&'a [f64], Fault> {
    match (element.interpolated, values.is_null()) {
        (false, _) => Ok(&[]),
        (true, true) => Err((code::NULL, argument::SLAVE_ROW, 0)),
        // SAFETY: promised by the caller.
        (true, false) => Ok(unsafe { core::slice::from_raw_parts(values, nslave + 1) }),
    }
}

/// The workspace, where one is needed.
///
/// # Safety
/// `memory` is null or has `size` entries.
pub(super) unsafe fn workspace<'a>(
    memory: *mut f64,
    size: i64,
    needed: usize,
) -> Result<&'a mut [f64], Fault> {
    if needed == 0 {
        return Ok(&mut []);
    }
    if memory.is_null() {
        return Err((code::NULL, argument::WORKSPACE, 0));
    }
    match usize::try_from(size) {
        Ok(size) if size >= needed => {
            // SAFETY: promised by the caller.
            Ok(unsafe { core::slice::from_raw_parts_mut(memory, needed) })
        }
        _ => Err((code::WORKSPACE, argument::WORKSPACE, 0)),
    }
}

/// A scale factor that is a number.
pub(super) fn scale(value: f64) -> Result<f64, Fault> {
    if crate::runtime::is_usable(value) {
        Ok(value)
    } else {
        Err((code::NOT_FINITE, argument::SCALE, 0))
    }
}

/// Where the outputs go.
///
/// # Safety
/// As [`element_evaluate`].
unsafe fn target(element: &Descriptor, arguments: &Arguments, n: usize) -> Result<Target, Fault> {
    let bits = arguments.request;
    let unknowns = element.unknowns(n);
    // SAFETY: promised by the caller.
    let rows = unsafe { host_rows(arguments.unknown_map, unknowns)? };
    let (row_stride, column_stride) = if bits & request::TANGENT == 0 {
        (0, 0)
    } else {
        strides(arguments.k_row_stride, arguments.k_col_stride, rows)?
    };
    let if_wanted = |bit: u32, pointer: *mut f64| {
        if bits & bit != 0 {
            pointer
        } else {
            core::ptr::null_mut()
        }
    };
    Ok(Target {
        unknowns,
        history_layout: element.history_layout(),
        f: if_wanted(request::RESIDUAL, arguments.f),
        k: if_wanted(request::TANGENT, arguments.k),
        row_stride,
        column_stride,
        map: arguments.unknown_map,
        f_scale: scale(arguments.f_scale)?,
        k_scale: scale(arguments.k_scale)?,
        global_f: core::ptr::null_mut(),
        connectivity: core::ptr::null(),
        dimension: element.dimension,
        csr_values: core::ptr::null_mut(),
        csr_map: Map::NONE,
        turn: Turn::FREE,
        output: if_wanted(request::OUTPUT, arguments.output),
        history: if_wanted(request::HISTORY, arguments.history_trial).cast(),
        energy: if_wanted(request::ENERGY, arguments.energy),
    })
}

/// Number of host rows that the map reaches.
///
/// # Safety
/// `map` is null or has `unknowns` entries.
pub(super) unsafe fn host_rows(map: *const i32, unknowns: usize) -> Result<usize, Fault> {
    if map.is_null() {
        return Ok(unknowns);
    }
    // SAFETY: promised by the caller.
    let map = unsafe { core::slice::from_raw_parts(map, unknowns) };
    let mut rows = 0;
    for (index, &row) in map.iter().enumerate() {
        match usize::try_from(row) {
            Ok(row) => rows = rows.max(row + 1),
            Err(_) => return Err((code::INDEX, argument::UNKNOWN_MAP, index)),
        }
    }
    Ok(rows)
}

/// Strides that keep all entries apart; 0, 0 stands for dense row-major.
pub(super) fn strides(row: i64, column: i64, rows: usize) -> Result<(usize, usize), Fault> {
    let fault = (code::STRIDE, argument::K_STRIDE, 0);
    if row == 0 && column == 0 && rows <= MOST_UNKNOWNS {
        return Ok((rows, 1));
    }
    let (Ok(row), Ok(column)) = (usize::try_from(row), usize::try_from(column)) else {
        return Err(fault);
    };
    let last = rows.saturating_sub(1);
    let apart = |small: usize, large: usize| large.checked_div(small).is_some_and(|n| n >= rows);
    let fits = extent(&[(last, row), (last, column)]).is_some();
    if fits && (apart(column, row) || apart(row, column)) {
        Ok((row, column))
    } else {
        Err(fault)
    }
}
