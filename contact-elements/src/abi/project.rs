//! Global projection of an element's contact points.

use super::evaluate::slave_row;
use super::pointers::{nodes, refuse, whole_arguments};
use super::types::Arguments;
use crate::codes::{argument, code};
use crate::describe::parameter_count;
use crate::error::Error;
use crate::evaluation::inputs::{check_parameters, check_reach, node_counts};
use crate::evaluation::sizes::reported;
use crate::project::{closest_of, gather, start};
use crate::registered::Registered;
use crate::search::{Closest, Verdict};

/// What `cte_element_project` reports about a contact point: `cte_projection`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Projection {
    pub zeta: [f64; 2],
    pub distance: f64,
    pub definiteness: f64,
    pub verdict: i32,
    pub feature: i32,
    pub boxes: i32,
    pub steps: i32,
}

#[cfg(target_pointer_width = "64")]
const _: () = assert!(size_of::<Projection>() == 48);

impl From<&Closest> for Projection {
    fn from(closest: &Closest) -> Self {
        Self {
            zeta: closest.zeta,
            distance: closest.distance,
            definiteness: closest.definiteness,
            verdict: match closest.verdict {
                Verdict::Inside => 0,
                Verdict::Boundary => 1,
                Verdict::NotUnique => 2,
                Verdict::Beyond => 3,
                Verdict::Undecided => 4,
            },
            feature: i32::from(closest.feature),
            boxes: reported(closest.boxes as usize),
            steps: reported(closest.steps as usize),
        }
    }
}

/// `cte_element_project`.
///
/// # Safety
/// `element` comes from this interface or is null; `arguments` points to a struct whose pointers are valid for the
/// shapes that the header gives, or is null; `result` has one entry per contact point or is null, `history` room for
/// the element's history or is null.
pub unsafe fn element_project(
    element: *const Registered,
    arguments: *mut Arguments,
    reach: f64,
    result: *mut Projection,
    history: *mut f64,
) -> i32 {
    // SAFETY: promised by the caller.
    let arguments = match unsafe { whole_arguments(arguments) } {
        Ok(arguments) => arguments,
        Err(code) => return code,
    };
    // SAFETY: promised by the caller.
    let outcome = match unsafe { element.as_ref() } {
        None => Err(Error::missing(argument::ELEMENT)),
        Some(_) if result.is_null() => Err(Error::missing(argument::RESULT)),
        // SAFETY: promised by the caller.
        Some(element) => unsafe { projected(element, arguments, reach, result, history) },
    };
    (arguments.error_argument, arguments.error_index) = (argument::NONE, 0);
    match outcome {
        Ok(()) => code::SUCCESS,
        Err(error) => refuse(arguments, error),
    }
}

/// Searches for every contact point.
///
/// # Safety
/// As [`element_project`]; `result` is not null.
unsafe fn projected(
    element: &Registered,
    arguments: &Arguments,
    reach: f64,
    result: *mut Projection,
    history: *mut f64,
) -> Result<(), Error> {
    if arguments.x.is_null() {
        return Err(Error::missing(argument::X));
    }
    if arguments.parameters.is_null() {
        return Err(Error::missing(argument::PARAMETERS));
    }
    check_reach(reach)?;
    let (n, nslave) = node_counts(element, arguments.nnode, arguments.nslave)?;
    let count = parameter_count(element, arguments.parameter_count);
    // SAFETY: promised by the caller.
    let parameters = unsafe { core::slice::from_raw_parts(arguments.parameters, count) };
    check_parameters(element, parameters)?;
    // SAFETY: promised by the caller.
    let (nodes, row) = unsafe {
        (
            nodes(element, arguments, n)?,
            slave_row(element, arguments.slave_row, nslave)?,
        )
    };
    let gathered = gather(element, &nodes, parameters, row)?;
    let size = element.point_history();
    for number in 0..element.points {
        let closest = closest_of(element, &gathered, number, reach)?;
        // SAFETY: promised by the caller: an entry, and a history, for every contact point.
        unsafe {
            *result.add(number) = Projection::from(&closest);
            if !history.is_null() {
                let own = history.add(number * size);
                start(
                    element,
                    &closest,
                    core::slice::from_raw_parts_mut(own, size),
                );
            }
        }
    }
    Ok(())
}
