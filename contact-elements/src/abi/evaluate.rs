//! One element.

use super::pointers::{
    cells, check_pointers, history, if_wanted, nodes, optional, outputs, report, whole_arguments,
    workspace,
};
use super::types::Arguments;
use crate::codes::{argument, request};
use crate::describe::parameter_count;
use crate::element::receiver::{Call, OUTPUT_SIZE, Summary};
use crate::error::Error;
use crate::evaluation::inputs::{check_parameters, check_request, node_counts, scale, wanted};
use crate::evaluation::single::run;
use crate::evaluation::sizes::{extent, host_rows, strides};
use crate::evaluation::target::{Matrix, Strided, Target};
use crate::registered::Registered;

/// `cte_element_evaluate`.
///
/// # Safety
/// `element` comes from this interface or is null; `arguments` points to a struct whose pointers are
/// valid for the shapes that the header gives, or is null.
pub unsafe fn element_evaluate(element: *const Registered, arguments: *mut Arguments) -> i32 {
    // SAFETY: promised by the caller.
    let arguments = match unsafe { whole_arguments(arguments) } {
        Ok(arguments) => arguments,
        Err(code) => return code,
    };
    // SAFETY: promised by the caller.
    let result = match unsafe { element.as_ref() } {
        // SAFETY: promised by the caller.
        Some(element) => unsafe { evaluated(element, arguments) },
        None => Err(Error::missing(argument::ELEMENT)),
    };
    report(arguments, result)
}

/// # Safety
/// As [`element_evaluate`].
unsafe fn evaluated(element: &Registered, arguments: &Arguments) -> Result<Summary, Error> {
    let bits = arguments.request;
    check_request(
        element.requests(),
        bits,
        !arguments.history_accepted.is_null(),
    )?;
    check_pointers(arguments)?;
    let (n, nslave) = node_counts(element, arguments.nnode, arguments.nslave)?;
    let count = parameter_count(element, arguments.parameter_count);
    // SAFETY: promised by the caller.
    let parameters = unsafe { core::slice::from_raw_parts(arguments.parameters, count) };
    check_parameters(element, parameters)?;
    // SAFETY: promised by the caller.
    let nodes = unsafe { nodes(element, arguments, n)? };
    // SAFETY: promised by the caller.
    let mut target = unsafe { target(element, arguments, n)? };
    // SAFETY: promised by the caller.
    let (history, slave_row, memory) = unsafe {
        (
            history(arguments.history_accepted, element.history()),
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
        wanted: wanted(bits),
    };
    let symmetrise = bits & request::SYMMETRISE != 0;
    run(element, &call, &nodes, memory, &mut target, symmetrise)
}

/// The row and weight of an interpolated slave; empty for other slaves.
///
/// # Safety
/// `values` is null or has nslave + 1 entries.
#[inline]
pub(super) unsafe fn slave_row<'a>(
    element: &Registered,
    values: *const f64,
    nslave: usize,
) -> Result<&'a [f64], Error> {
    if !element.interpolated {
        return Ok(&[]);
    }
    // SAFETY: promised by the caller.
    unsafe { optional(values, nslave + 1) }.ok_or(Error::missing(argument::SLAVE_ROW))
}

/// Where the outputs go.
///
/// # Safety
/// As [`element_evaluate`].
#[inline(always)]
unsafe fn target<'a>(
    element: &Registered,
    arguments: &Arguments,
    n: usize,
) -> Result<Target<'a>, Error> {
    let bits = arguments.request;
    let asked = |bit: u32, pointer: *mut f64| if_wanted(bits, bit, pointer);
    let unknowns = element.unknowns(n);
    // SAFETY: promised by the caller.
    let map = unsafe { optional(arguments.unknown_map, unknowns) };
    let rows = host_rows(map, unknowns)?;
    let k = asked(request::TANGENT, arguments.k);
    // SAFETY: promised by the caller.
    let k = unsafe { matrix(k, map.is_some(), arguments, rows)? };
    let (f_scale, k_scale) = (scale(arguments.f_scale)?, scale(arguments.k_scale)?);
    // SAFETY: promised by the caller.
    unsafe {
        Ok(Target {
            unknowns,
            dimension: element.dimension,
            history_layout: element.history_layout(),
            f: cells(asked(request::RESIDUAL, arguments.f), rows),
            k,
            map,
            f_scale,
            k_scale,
            global_f: None,
            sparse: None,
            output: outputs(
                asked(request::OUTPUT, arguments.output),
                element.points * OUTPUT_SIZE,
            ),
            history: cells(
                asked(request::HISTORY, arguments.history_trial),
                element.history(),
            ),
            energy: outputs(asked(request::ENERGY, arguments.energy), 1),
        })
    }
}

/// The host's matrix with so many rows; null means no matrix.
///
/// # Safety
/// `k` is null or has an entry for every pair of rows at the strides of the arguments.
#[inline(always)]
unsafe fn matrix<'a>(
    k: *mut f64,
    is_mapped: bool,
    arguments: &Arguments,
    rows: usize,
) -> Result<Matrix<'a>, Error> {
    if k.is_null() {
        return Ok(Matrix::None);
    }
    let (row, column) = strides(arguments.k_row_stride, arguments.k_col_stride, rows)?;
    if !is_mapped && (row, column) == (rows, 1) {
        // SAFETY: promised by the caller; a dense matrix has no gaps.
        return Ok(Matrix::Dense(unsafe { outputs(k, rows * rows) }));
    }
    let last = rows.saturating_sub(1);
    let length = extent(&[(last, row), (last, column)]).unwrap_or(0);
    Ok(Matrix::Strided(Strided {
        // SAFETY: promised by the caller.
        cells: unsafe { cells(k, length) },
        row,
        column,
    }))
}
