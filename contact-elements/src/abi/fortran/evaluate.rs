//! One evaluation.

use super::super::describe::Registry;
use super::super::evaluate::element_evaluate;
use super::super::pointers::write;
use super::super::types::Arguments;
use super::addresses::{element, refuse, report, state_of, value};
use crate::codes::argument;
use crate::error::Error;

/// Addresses that an evaluation of an element and of a patch have in common.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Addresses {
    pub request: *const i32,
    pub nnode: *const i32,
    pub x: *const f64,
    pub ldx: *const i32,
    pub u: *const f64,
    pub ldu: *const i32,
    pub parameters: *const f64,
    pub parameter_count: *const i32,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub mapped: *const i32,
    pub map: *const i32,
    pub f_scale: *const f64,
    pub k_scale: *const f64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub ldk: *const i32,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub workspace: *mut f64,
    pub workspace_size: *const i32,
}

impl Addresses {
    /// The struct of the C interface.
    ///
    /// # Safety
    /// Every address is null or valid for the shape that the header gives.
    pub(super) unsafe fn arguments(&self) -> Result<Arguments, Error> {
        // SAFETY: promised by the caller.
        unsafe {
            let is_mapped = value(self.mapped, argument::UNKNOWN_MAP)? != 0;
            if is_mapped && self.map.is_null() {
                return Err(Error::missing(argument::UNKNOWN_MAP));
            }
            let workspace_size = value(self.workspace_size, argument::WORKSPACE)?;
            Ok(Arguments {
                request: value(self.request, argument::REQUEST)? as u32,
                nnode: value(self.nnode, argument::NNODE)?,
                parameter_count: value(self.parameter_count, argument::PARAMETERS)?,
                x: self.x,
                u: self.u,
                parameters: self.parameters,
                history_accepted: self.history_accepted,
                history_trial: self.history_trial,
                f: self.f,
                k: self.k,
                output: self.output,
                energy: self.energy,
                f_scale: value(self.f_scale, argument::SCALE)?,
                k_scale: value(self.k_scale, argument::SCALE)?,
                k_row_stride: 1,
                k_col_stride: i64::from(value(self.ldk, argument::K_STRIDE)?),
                unknown_map: if is_mapped {
                    self.map
                } else {
                    core::ptr::null()
                },
                x_node_stride: i64::from(value(self.ldx, argument::X)?),
                u_node_stride: i64::from(value(self.ldu, argument::U)?),
                workspace: self.workspace,
                workspace_size: i64::from(workspace_size),
                ..Arguments::EMPTY
            })
        }
    }
}

/// `CTE_F77_EVALUATE`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn evaluate(
    elements: Registry<'_>,
    index: *const i32,
    nslave: *const i32,
    slave_row: *const f64,
    addresses: Addresses,
    state: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let filled = element(elements, index, argument::ELEMENT).and_then(|element| {
            let arguments = Arguments {
                nslave: value(nslave, argument::NSLAVE)?,
                slave_row,
                ..addresses.arguments()?
            };
            Ok((element, arguments))
        });
        match filled {
            Ok((element, mut arguments)) => {
                write(result, element_evaluate(element, &raw mut arguments));
                report(state, state_of(&arguments));
            }
            Err(fault) => refuse(state, result, fault),
        }
    }
}
