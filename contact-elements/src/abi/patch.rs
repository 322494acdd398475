//! Slave points against facets with their common edges and vertices.

use super::pointers::{
    cells, history, if_wanted, nodes, optional, report, whole_arguments, workspace, write,
};
use super::types::{Arguments, Info};
use super::versioned::{Versioned, is_whole};
use crate::codes::{argument, code, request};
use crate::element::receiver::{OUTPUT_SIZE, Summary};
use crate::error::Error;
use crate::evaluation::inputs::{check_offered, check_present_history, check_reach, scale};
use crate::evaluation::sizes::{extent, host_rows, reported, strides};
use crate::evaluation::target::Strided;
use crate::patch::checked::{Checked, HISTORY};
use crate::patch::run::{WORKSPACE, run};
use crate::patch::sums::Sums;
use crate::registered::Registered;

/// `cte_patch`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Patch {
    pub struct_size: u32,
    pub slave_points: i32,
    pub master_nodes: i32,
    pub facets: i32,
    pub facet: *const Registered,
    pub connectivity: *const i32,
    pub edge: *const Registered,
    pub vertex: *const Registered,
    pub reach: f64,
}

#[cfg(target_pointer_width = "64")]
const _: () = assert!(size_of::<Patch>() == 56);

// SAFETY: it is `repr(C)` and begins with `struct_size: u32`.
unsafe impl Versioned for Patch {
    const SIZE_IN_0_1: usize = 120;
}

impl Patch {
    /// `CTE_PATCH_INIT`: no facet.
    pub const EMPTY: Self = Self {
        struct_size: size_of::<Self>() as u32,
        slave_points: 0,
        master_nodes: 0,
        facets: 0,
        facet: core::ptr::null(),
        connectivity: core::ptr::null(),
        edge: core::ptr::null(),
        vertex: core::ptr::null(),
        reach: 0.0,
    };
}

/// The caller's patch, checked.
///
/// # Safety
/// `patch` points to a struct whose pointers are valid for the shapes that the header gives, or is null.
unsafe fn checked<'a>(patch: *const Patch) -> Result<Checked<'a>, Error> {
    if patch.is_null() {
        return Err(Error::missing(argument::PATCH));
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(patch) } {
        return Err(Error::new(code::STRUCT_SIZE, argument::PATCH, 0));
    }
    // SAFETY: the caller's struct is at least as large as ours.
    let patch = unsafe { &*patch };
    let count = |value: i32, name: i32| match usize::try_from(value) {
        Ok(value) if value > 0 => Ok(value),
        _ => Err(Error::new(code::NODE_COUNT, name, 0)),
    };
    let slave_points = count(patch.slave_points, argument::NSLAVE)?;
    let master_nodes = count(patch.master_nodes, argument::NNODE)?;
    let facets = count(patch.facets, argument::FACETS)?;
    check_reach(patch.reach)?;
    // SAFETY: promised by the caller; elements are static.
    unsafe {
        let facet = patch.facet.as_ref();
        let facet = facet.ok_or(Error::missing(argument::FACET))?;
        let entries = facets * facet.master_nodes;
        Checked::new(&crate::patch::Patch {
            facet,
            edge: patch.edge.as_ref(),
            vertex: patch.vertex.as_ref(),
            slave_points,
            master_nodes,
            connectivity: optional(patch.connectivity, entries).unwrap_or_default(),
            reach: patch.reach,
        })
    }
}

/// `cte_patch_info`.
///
/// # Safety
/// `patch` points to a struct whose pointers are valid for the shapes that the header gives; `info` and `argument`
/// to one of theirs, or they are null.
pub unsafe fn patch_info(patch: *const Patch, info: *mut Info, argument: *mut i32) -> i32 {
    // SAFETY: promised by the caller.
    let outcome = unsafe { checked(patch) };
    let outcome = match outcome {
        _ if info.is_null() => Err(Error::missing(argument::INFO)),
        // SAFETY: every struct begins with its size.
        _ if !unsafe { is_whole(info) } => Err(Error::new(code::STRUCT_SIZE, argument::INFO, 0)),
        outcome => outcome,
    };
    let (code, name) = match outcome {
        Ok(checked) => {
            // SAFETY: the caller's struct is at least as large as ours.
            unsafe { describe(&checked, &mut *info) };
            (code::SUCCESS, argument::NONE)
        }
        Err(error) => (error.code, error.argument),
    };
    // SAFETY: promised by the caller.
    unsafe { write(argument, name) };
    code
}

fn describe(checked: &Checked<'_>, info: &mut Info) {
    let facet = checked.facet;
    let nodes = reported(checked.nodes());
    *info = Info {
        struct_size: info.struct_size,
        dimension: facet.dimension as i32,
        nodes_minimum: nodes,
        nodes_maximum: nodes,
        slave_nodes: reported(checked.slaves),
        master_nodes: reported(checked.masters),
        unknowns: reported(checked.unknowns()),
        parameters: reported(checked.parameters()),
        history: reported(checked.slaves * HISTORY),
        points: reported(checked.slaves),
        projected: facet.projected as i32,
        requests: checked.requests(),
        symmetric: i32::from(facet.symmetric),
        operations: facet.operations as i32,
        workspace: (checked.slaves * WORKSPACE) as i64,
        formulation: checked.formulation(),
        name: facet.name.as_ptr(),
        documentation: facet.documentation.as_ptr(),
    };
}

/// `cte_patch_evaluate`.
///
/// # Safety
/// `patch` and `arguments` point to structs whose pointers are valid for the shapes that the header gives, or are null.
pub unsafe fn patch_evaluate(patch: *const Patch, arguments: *mut Arguments) -> i32 {
    // SAFETY: promised by the caller.
    let arguments = match unsafe { whole_arguments(arguments) } {
        Ok(arguments) => arguments,
        Err(code) => return code,
    };
    // SAFETY: promised by the caller.
    let result = unsafe { evaluated(patch, arguments) };
    report(arguments, result)
}

/// # Safety
/// As [`patch_evaluate`].
unsafe fn evaluated(patch: *const Patch, arguments: &Arguments) -> Result<Summary, Error> {
    // SAFETY: promised by the caller.
    let checked = unsafe { with(checked(patch)?, arguments)? };
    // SAFETY: promised by the caller.
    let sums = unsafe { sums(&checked, arguments)? };
    // SAFETY: promised by the caller.
    let memory = unsafe {
        let needed = checked.slaves * WORKSPACE;
        workspace(arguments.workspace, arguments.workspace_size, needed)?
    };
    run(&checked, &sums, memory, arguments.request)
}

/// The patch with the inputs of the arguments.
///
/// # Safety
/// As [`patch_evaluate`].
unsafe fn with<'a>(checked: Checked<'a>, arguments: &Arguments) -> Result<Checked<'a>, Error> {
    check_offered(checked.requests(), arguments.request)?;
    let has_history = !arguments.history_accepted.is_null();
    check_present_history(arguments.request, has_history)?;
    if arguments.x.is_null() {
        return Err(Error::missing(argument::X));
    }
    if arguments.parameters.is_null() {
        return Err(Error::missing(argument::PARAMETERS));
    }
    let n = checked.nodes();
    match usize::try_from(arguments.nnode) {
        Ok(given) if given == 0 || given == n => {}
        _ => return Err(Error::new(code::NODE_COUNT, argument::NNODE, 0)),
    }
    let given = usize::try_from(arguments.parameter_count).unwrap_or(0);
    let count = given.min(checked.parameters());
    let length = checked.slaves * HISTORY;
    // SAFETY: promised by the caller.
    unsafe {
        let nodes = nodes(checked.facet, arguments, n)?;
        let values = core::slice::from_raw_parts(arguments.parameters, count);
        checked.with(nodes, values, history(arguments.history_accepted, length))
    }
}

/// Where the sums go; every requested output must be there.
///
/// # Safety
/// As [`patch_evaluate`].
unsafe fn sums<'a>(checked: &Checked<'a>, arguments: &Arguments) -> Result<Sums<'a>, Error> {
    let bits = arguments.request;
    let wanted = |bit: u32, pointer: *mut f64, name: i32| {
        if bits & bit != 0 && pointer.is_null() {
            return Err(Error::missing(name));
        }
        Ok(if_wanted(bits, bit, pointer))
    };
    let unknowns = checked.unknowns();
    let k = wanted(request::TANGENT, arguments.k, argument::K)?;
    // SAFETY: promised by the caller.
    let map = unsafe { optional(arguments.unknown_map, unknowns) };
    let rows = host_rows(map, unknowns)?;
    let f = wanted(request::RESIDUAL, arguments.f, argument::F)?;
    let (row, column) = if k.is_null() {
        (0, 0)
    } else {
        strides(arguments.k_row_stride, arguments.k_col_stride, rows)?
    };
    let last = rows.saturating_sub(1);
    let length = extent(&[(last, row), (last, column)]).unwrap_or(0);
    let (f_scale, k_scale) = (scale(arguments.f_scale)?, scale(arguments.k_scale)?);
    let output = wanted(request::OUTPUT, arguments.output, argument::OUTPUT)?;
    let trial = wanted(
        request::HISTORY,
        arguments.history_trial,
        argument::HISTORY_TRIAL,
    )?;
    let energy = wanted(request::ENERGY, arguments.energy, argument::ENERGY)?;
    // SAFETY: promised by the caller.
    unsafe {
        Ok(Sums {
            unknowns,
            f: cells(f, rows),
            k: Strided {
                cells: cells(k, length),
                row,
                column,
            },
            map,
            f_scale,
            k_scale,
            output: cells(output, checked.slaves * OUTPUT_SIZE),
            history: cells(trial, checked.slaves * HISTORY),
            energy: cells(energy, 1),
        })
    }
}
