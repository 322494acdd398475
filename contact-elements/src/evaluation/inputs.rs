//! Checks of the inputs that every call has: request, parameters, nodes, scratch.

use super::sizes::{extent, slave_count, spacing};
use crate::arithmetic::is_usable;
use crate::codes::{argument, code, request};
use crate::descriptor::{Descriptor, Parameter};
use crate::element::receiver::Wanted;
use crate::error::Error;

/// Least width of a window of angles [rad].
const LEAST_WINDOW: f64 = 1e-6;

/// The bits of a request as flags of a kernel.
#[inline(always)]
pub(crate) fn wanted(bits: u32) -> Wanted {
    Wanted {
        residual: bits & request::RESIDUAL != 0,
        tangent: bits & request::TANGENT != 0,
        freeze: bits & request::FREEZE_STATE != 0,
        projection_given: bits & request::PROJECTION_GIVEN != 0,
    }
}

/// Checks that all bits are offered and have the history that they need.
#[inline]
pub(crate) fn check_request(offered: u32, bits: u32, has_history: bool) -> Result<(), Error> {
    check_offered(offered, bits)?;
    check_present_history(bits, has_history)
}

/// Checks that there is a history if a bit says that something is to be taken from it.
#[inline]
pub(crate) fn check_present_history(bits: u32, has_history: bool) -> Result<(), Error> {
    if bits & (request::FREEZE_STATE | request::PROJECTION_GIVEN) != 0 && !has_history {
        return Err(Error::missing(argument::HISTORY_ACCEPTED));
    }
    Ok(())
}

/// Checks that only offered bits are set.
#[inline]
pub(crate) fn check_offered(offered: u32, bits: u32) -> Result<(), Error> {
    let refused = bits & !offered;
    if refused == 0 {
        return Ok(());
    }
    let bit = refused.trailing_zeros() as usize;
    Err(Error::new(code::REQUEST, argument::REQUEST, bit))
}

/// Nodes of a call, and how many of them are slave nodes; 0 stands for the element's own.
#[inline]
pub(crate) fn node_counts(
    element: &Descriptor,
    nnode: i32,
    nslave: i32,
) -> Result<(usize, usize), Error> {
    let nslave = slave_count(element, nslave)?;
    let n = element.nodes(nslave);
    match usize::try_from(nnode) {
        Ok(given) if given == 0 || given == n => Ok((n, nslave)),
        _ => Err(Error::new(code::NODE_COUNT, argument::NNODE, 0)),
    }
}

/// Distance from node to node (0: nodes are contiguous), and entries of the array.
#[inline]
pub(crate) fn node_extent(
    nodes: usize,
    dimension: usize,
    stride: i64,
    name: i32,
) -> Result<(usize, usize), Error> {
    let fault = Error::new(code::STRIDE, name, 0);
    let stride = spacing(stride, dimension).ok_or(fault)?;
    let length = extent(&[(nodes - 1, stride), (dimension - 1, 1)]).ok_or(fault)?;
    Ok((stride, length))
}

/// Checks that the parameters lie within their ranges and have the element's number.
#[inline]
pub(crate) fn check_parameters(element: &Descriptor, values: &[f64]) -> Result<(), Error> {
    let can_be = |(bounds, &value): (&Parameter, &f64)| is_usable(value) && bounds.allows(value);
    let mut pairs = element.parameters.iter().zip(values);
    if values.len() < element.parameters.len() || !pairs.all(can_be) {
        return Err(first_refused(element, values));
    }
    let Some(at) = element.angle else {
        return Ok(());
    };
    let angle = |index: usize| values.get(index).copied().unwrap_or(0.0);
    if angle(at + 1) - angle(at) >= LEAST_WINDOW {
        Ok(())
    } else {
        Err(Error::new(code::PARAMETER, argument::PARAMETERS, at + 1))
    }
}

/// The error of the first parameter that is missing, not a number or out of its range.
#[cold]
fn first_refused(element: &Descriptor, values: &[f64]) -> Error {
    let refused = |code: i32, index: usize| Error::new(code, argument::PARAMETERS, index);
    for (index, (bounds, &value)) in element.parameters.iter().zip(values).enumerate() {
        if !is_usable(value) {
            return refused(code::NOT_FINITE, index);
        }
        if !bounds.allows(value) {
            return refused(code::PARAMETER, index);
        }
    }
    refused(code::PARAMETER, values.len())
}

/// Checks a distance beyond which the search ignores everything: it must not be negative or NaN.
pub(crate) fn check_reach(reach: f64) -> Result<(), Error> {
    // by its bits: a comparison with a signalling NaN would raise an exception
    let is_negative = reach.to_bits() > (1 << 63);
    if is_usable(reach) && !is_negative {
        Ok(())
    } else {
        Err(Error::new(code::NOT_FINITE, argument::REACH, 0))
    }
}

/// Checks that a scale factor is finite.
#[inline]
pub(crate) fn scale(value: f64) -> Result<f64, Error> {
    if is_usable(value) {
        Ok(value)
    } else {
        Err(Error::new(code::NOT_FINITE, argument::SCALE, 0))
    }
}

/// The first `needed` entries of a workspace.
#[inline]
pub(crate) fn scratch(memory: &mut [f64], needed: usize) -> Result<&mut [f64], Error> {
    let too_small = Error::new(code::WORKSPACE, argument::WORKSPACE, 0);
    memory.get_mut(..needed).ok_or(too_small)
}
