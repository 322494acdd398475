//! Patches: slave points against facets with their common edges and vertices. [eq:transition]
//!
//! Each slave point takes part in one pair: its facet where it projects inside, else the edge or vertex that holds
//! the closest point of the whole patch. The first pass finds the pairs and tries them, the second adds them up, so
//! that a failure leaves everything as it was.

mod boundary;
mod checked;
mod pair;
mod place;
mod safe;
mod side;
mod sink;

pub use safe::{Facets, evaluate_patch};

use checked::Checked;
use pair::Pair;
use sink::Sink;

use super::evaluate::workspace;
use super::sizes::{Fault, reported};
use super::types::{Arguments, Info, is_whole};
use super::{Descriptor, argument, code, request};
use crate::runtime::Status;

/// Doubles of history per slave point: status, number of the facet from 1, feature, two parameters.
pub(crate) const HISTORY: usize = 5;
/// Doubles of workspace per slave point: place, side and how its foot is found.
const WORKSPACE: usize = 6;

/// `cte_patch`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Patch {
    pub struct_size: u32,
    pub slave_points: i32,
    pub master_nodes: i32,
    pub facets: i32,
    pub facet: *const Descriptor,
    pub connectivity: *const i32,
    pub edge: *const Descriptor,
    pub vertex: *const Descriptor,
    pub reach: f64,
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

/// The caller's patch, if it is one.
///
/// # Safety
/// `patch` points to a struct that begins with its size, or is null.
unsafe fn whole<'a>(patch: *const Patch) -> Result<&'a Patch, Fault> {
    if patch.is_null() {
        return Err((code::NULL, argument::PATCH, 0));
    }
    // SAFETY: every struct begins with its size.
    if !unsafe { is_whole(patch) } {
        return Err((code::STRUCT_SIZE, argument::PATCH, 0));
    }
    // SAFETY: the caller's struct is at least as large as ours.
    Ok(unsafe { &*patch })
}

/// `cte_patch_info`.
///
/// # Safety
/// `patch` points to a struct whose pointers are valid for the shapes that the header gives; `info` and `argument`
/// to one of theirs, or they are null.
pub unsafe fn patch_info(patch: *const Patch, info: *mut Info, argument: *mut i32) -> i32 {
    // SAFETY: promised by the caller.
    let outcome = unsafe { whole(patch).and_then(|patch| Checked::new(patch)) };
    let outcome = match outcome {
        _ if info.is_null() => Err((code::NULL, argument::INFO, 0)),
        // SAFETY: every struct begins with its size.
        _ if !unsafe { is_whole(info) } => Err((code::STRUCT_SIZE, argument::INFO, 0)),
        outcome => outcome,
    };
    let (code, name) = match outcome {
        Ok(checked) => {
            // SAFETY: the caller's struct is at least as large as ours.
            unsafe { describe(&checked, &mut *info) };
            (code::SUCCESS, argument::NONE)
        }
        Err((code, name, _)) => (code, name),
    };
    // SAFETY: promised by the caller.
    unsafe { super::describe::write(argument, name) };
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
    let result = unsafe { whole(patch).and_then(|patch| run(patch, arguments)) };
    arguments.dt_ratio = 1.0;
    arguments.closed_points = 0;
    arguments.status = Status::Open as i32;
    (arguments.error_argument, arguments.error_index) = (argument::NONE, 0);
    let failed = match result {
        Ok(Ok(summary)) => {
            arguments.status = summary.0 as i32;
            arguments.closed_points = reported(summary.1);
            return code::SUCCESS;
        }
        Ok(Err((status, point))) => {
            arguments.status = status as i32;
            arguments.dt_ratio = 0.5;
            (code::CUT_BACK, argument::X, point)
        }
        Err(fault) => fault,
    };
    (arguments.error_argument, arguments.error_index) = (failed.1, reported(failed.2));
    failed.0
}

/// Status of the patch and its closed points; or the status of a point that failed, and its number.
type Outcome = Result<(Status, usize), (Status, usize)>;

/// Checks everything, then runs both passes.
///
/// # Safety
/// As [`patch_evaluate`].
unsafe fn run(patch: &Patch, arguments: &Arguments) -> Result<Outcome, Fault> {
    // SAFETY: promised by the caller.
    let checked = unsafe { Checked::new(patch)?.with(arguments)? };
    // SAFETY: promised by the caller.
    let sink = unsafe { Sink::new(&checked, arguments)? };
    // SAFETY: promised by the caller.
    let memory = unsafe {
        let needed = checked.slaves * WORKSPACE;
        workspace(arguments.workspace, arguments.workspace_size, needed)?
    };
    let reads = request::FREEZE_STATE & arguments.request;
    let mut answer = pair::Answer::new();
    for (slave, kept) in memory.chunks_exact_mut(WORKSPACE).enumerate() {
        let place = match place::find(&checked, slave) {
            Ok(place) => place,
            Err(place::Error::Fault(fault)) => return Err(fault),
            Err(place::Error::Status(status)) => return Ok(Err((status, slave))),
        };
        let pair = match place {
            Some(place) => Pair::new(&checked, slave, &place)?,
            None => None,
        };
        let Some(mut pair) = pair else {
            kept.fill(0.0);
            continue;
        };
        let outcome = pair.evaluate(&checked, &mut answer, reads);
        if outcome.code != code::SUCCESS {
            return match outcome.status() {
                Some(status) => Ok(Err((status, slave))),
                None => Err((outcome.code, outcome.argument, slave)),
            };
        }
        pair.keep(kept);
    }
    Ok(Ok(add_up(&checked, &sink, memory, arguments)?))
}

/// The second pass: what every pair gives is added.
fn add_up(
    checked: &Checked<'_>,
    sink: &Sink,
    memory: &[f64],
    arguments: &Arguments,
) -> Result<(Status, usize), Fault> {
    let (mut status, mut closed, mut energy) = (Status::Outside, 0, 0.0);
    let mut answer = pair::Answer::new();
    sink.clear();
    for (slave, kept) in memory.chunks_exact(WORKSPACE).enumerate() {
        let Some(mut pair) = Pair::kept(checked, slave, kept)? else {
            sink.report(slave, None, &answer);
            continue;
        };
        let outcome = pair.evaluate(checked, &mut answer, arguments.request);
        let Some(own) = outcome.status() else {
            return Err((outcome.code, outcome.argument, slave));
        };
        if closed == 0 && (own.is_closed() || status == Status::Outside) {
            status = own;
        }
        if own.is_closed() {
            closed += 1;
            energy += answer.energy;
            sink.add(&pair, &answer);
        }
        sink.report(slave, Some(&pair), &answer);
    }
    sink.energy(energy);
    Ok((status, closed))
}
