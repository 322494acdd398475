//! Global projection.

use super::super::describe::Registry;
use super::super::pointers::write;
use super::super::project::{Projection, element_project};
use super::super::types::Arguments;
use super::addresses::{element, refuse, report, state_of, value};
use crate::codes::{argument, code};
use crate::error::Error;

/// Doubles of a projection: the four of [`Projection`], then its four integers as numbers.
const PROJECTION_NUMBERS: usize = 8;

/// Addresses of a global projection.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct ProjectAddresses {
    pub nnode: *const i32,
    pub nslave: *const i32,
    pub x: *const f64,
    pub ldx: *const i32,
    pub u: *const f64,
    pub ldu: *const i32,
    pub parameters: *const f64,
    pub parameter_count: *const i32,
    pub slave_row: *const f64,
    pub reach: *const f64,
    pub result: *mut f64,
    pub history: *mut f64,
}

/// `CTE_F77_PROJECT`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn project(
    elements: Registry<'_>,
    index: *const i32,
    addresses: ProjectAddresses,
    state: *mut i32,
    result: *mut i32,
) {
    let to = addresses.result;
    // SAFETY: promised by the caller; a projection takes less room in `to` than its numbers do.
    unsafe {
        let filled = element(elements, index, argument::ELEMENT).and_then(|element| {
            let reach = value(addresses.reach, argument::REACH)?;
            Ok((element, reach, addresses.arguments()?))
        });
        match filled {
            Ok((element, reach, mut arguments)) => {
                let found = to.cast::<Projection>();
                let history = addresses.history;
                let code = element_project(element, &raw mut arguments, reach, found, history);
                if code == code::SUCCESS {
                    spread(to, (&*element).points);
                }
                write(result, code);
                report(state, state_of(&arguments));
            }
            Err(fault) => refuse(state, result, fault),
        }
    }
}

impl ProjectAddresses {
    /// The struct of the C interface.
    ///
    /// # Safety
    /// Every address is null or valid for the shape that the header gives.
    unsafe fn arguments(&self) -> Result<Arguments, Error> {
        // SAFETY: promised by the caller.
        unsafe {
            Ok(Arguments {
                nnode: value(self.nnode, argument::NNODE)?,
                nslave: value(self.nslave, argument::NSLAVE)?,
                parameter_count: value(self.parameter_count, argument::PARAMETERS)?,
                x: self.x,
                u: self.u,
                parameters: self.parameters,
                x_node_stride: i64::from(value(self.ldx, argument::X)?),
                u_node_stride: i64::from(value(self.ldu, argument::U)?),
                slave_row: self.slave_row,
                ..Arguments::EMPTY
            })
        }
    }
}

/// Makes numbers of the projections that stand at the start of their room, the last first.
///
/// # Safety
/// `to` has eight entries per point and begins with a projection per point.
unsafe fn spread(to: *mut f64, points: usize) {
    for point in (0..points).rev() {
        // SAFETY: promised by the caller.
        unsafe {
            let found = to.cast::<Projection>().add(point).read();
            let counts = [found.verdict, found.feature, found.boxes, found.steps].map(f64::from);
            let numbers = to.add(PROJECTION_NUMBERS * point);
            let [first, second] = found.zeta;
            let values = [first, second, found.distance, found.definiteness];
            core::ptr::copy_nonoverlapping(values.as_ptr(), numbers, values.len());
            core::ptr::copy_nonoverlapping(counts.as_ptr(), numbers.add(4), counts.len());
        }
    }
}
