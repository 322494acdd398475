//! Patches.

use super::super::describe::Registry;
use super::super::patch::{self, Patch};
use super::super::pointers::write;
use super::super::types::Info;
use super::addresses::{element_at, refuse, report, state_of, value};
use super::describe::write_sizes;
use super::evaluate::Addresses;
use crate::codes::{argument, code};
use crate::error::Error;

/// Numbers that describe a patch.
const PATCH_NUMBERS: usize = 6;
/// What stands for no edge or vertex of a patch.
const NO_ELEMENT: i32 = -1;

/// Addresses of a patch.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct PatchAddresses {
    pub numbers: *const i32,
    pub connectivity: *const i32,
    pub reach: *const f64,
}

impl PatchAddresses {
    /// The struct of the C interface.
    ///
    /// # Safety
    /// Every address is null or valid for the shape that the header gives.
    unsafe fn patch(&self, elements: Registry<'_>) -> Result<Patch, Error> {
        // SAFETY: promised by the caller.
        let numbers = unsafe { value(self.numbers.cast(), argument::PATCH)? };
        let [slave_points, master_nodes, facets, facet, edge, vertex]: [i32; PATCH_NUMBERS] =
            numbers;
        let lower = |index: i32, name: i32| match index {
            NO_ELEMENT => Ok(core::ptr::null()),
            index => element_at(elements, index, name),
        };
        Ok(Patch {
            slave_points,
            master_nodes,
            facets,
            facet: element_at(elements, facet, argument::FACET)?,
            connectivity: self.connectivity,
            edge: lower(edge, argument::EDGE)?,
            vertex: lower(vertex, argument::VERTEX)?,
            // SAFETY: promised by the caller.
            reach: unsafe { value(self.reach, argument::REACH)? },
            ..Patch::EMPTY
        })
    }
}

/// `CTE_F77_PATCH_EVALUATE`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn patch_evaluate(
    elements: Registry<'_>,
    patch: PatchAddresses,
    addresses: Addresses,
    state: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let patch = patch.patch(elements);
        match patch.and_then(|patch| Ok((patch, addresses.arguments()?))) {
            Ok((patch, mut arguments)) => {
                let code = patch::patch_evaluate(&raw const patch, &raw mut arguments);
                write(result, code);
                report(state, state_of(&arguments));
            }
            Err(fault) => refuse(state, result, fault),
        }
    }
}

/// `CTE_F77_PATCH_INFO`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn patch_info(
    elements: Registry<'_>,
    patch: PatchAddresses,
    sizes: *mut i32,
    fault: *mut i32,
    result: *mut i32,
) {
    let mut info = Info::EMPTY;
    let mut name = argument::NONE;
    // SAFETY: promised by the caller.
    unsafe {
        let code = match patch.patch(elements) {
            Ok(_) if sizes.is_null() => {
                name = argument::INFO;
                code::NULL
            }
            Ok(patch) => patch::patch_info(&raw const patch, &raw mut info, &raw mut name),
            Err(error) => {
                name = error.argument;
                error.code
            }
        };
        write_sizes(sizes, code, &info);
        write(fault, name);
        write(result, code);
    }
}
