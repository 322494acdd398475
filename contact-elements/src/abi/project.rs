//! Global projection of an element's contact points: no start is needed. [eq:global-projection]

use super::evaluate::{node_counts, nodes, parameters, slave_row};
use super::safe::Outcome;
use super::sides::Gathered;
use super::sizes::{Fault, reported};
use super::types::{Arguments, is_whole};
use super::{Descriptor, argument, code};
use crate::runtime::is_usable;
use crate::search::{Closest, Verdict, closest};

/// Checks the arguments, then searches for every contact point and hands it to `keep`.
///
/// # Safety
/// As [`element_project`].
unsafe fn project_all(
    element: &Descriptor,
    arguments: &Arguments,
    reach: f64,
    mut keep: impl FnMut(usize, &Closest),
) -> Result<(), Fault> {
    if arguments.x.is_null() {
        return Err((code::NULL, argument::X, 0));
    }
    if arguments.parameters.is_null() {
        return Err((code::NULL, argument::PARAMETERS, 0));
    }
    // by its bits: a comparison with a signalling NaN would raise an exception
    let is_negative = reach.to_bits() > (1 << 63);
    if !is_usable(reach) || is_negative {
        return Err((code::NOT_FINITE, argument::REACH, 0));
    }
    let (n, nslave) = node_counts(element, arguments)?;
    // SAFETY: promised by the caller.
    let (parameters, nodes, row) = unsafe {
        (
            parameters(element, arguments.parameters, arguments.parameter_count)?,
            nodes(element, arguments, n)?,
            slave_row(element, arguments.slave_row, nslave)?,
        )
    };
    if let Some((entry, weight)) = row.iter().enumerate().next_back()
        && !is_usable(*weight)
    {
        return Err((code::NOT_FINITE, argument::SLAVE_ROW, entry));
    }
    let gathered = Gathered::new(element, &nodes, parameters, row)?;
    let refused = (code::ELEMENT, argument::ELEMENT, 0);
    for number in 0..element.points {
        let sides = gathered.sides(number).ok_or(refused)?;
        if element.projected == 0 {
            keep(number, &Closest::NOTHING_PROJECTED);
            continue;
        }
        let [domain, _] = &element.domains;
        let declared = gathered.declared(&sides);
        let found = match declared.filter(|&zeta| domain.feature(zeta, 0.0) == 0) {
            Some(zeta) => Closest::at(&sides, zeta, reach),
            // beyond the domain the declared point says nothing
            None => closest(&sides, &element.domains, &element.periods, reach),
        };
        keep(number, &found.ok_or(refused)?);
    }
    Ok(())
}

/// What `cte_element_project` tells of a contact point: `cte_projection`.
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
    element: *const Descriptor,
    arguments: *mut Arguments,
    reach: f64,
    result: *mut Projection,
    history: *mut f64,
) -> i32 {
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
    let outcome = match unsafe { element.as_ref() } {
        None => Err((code::NULL, argument::ELEMENT, 0)),
        Some(_) if result.is_null() => Err((code::NULL, argument::RESULT, 0)),
        // SAFETY: promised by the caller.
        Some(element) => unsafe {
            project_all(element, arguments, reach, |number, closest| {
                *result.add(number) = closest.into();
                if !history.is_null() {
                    start(element, history, number, closest);
                }
            })
        },
    };
    let (code, name, index) = match outcome {
        Ok(()) => (code::SUCCESS, argument::NONE, 0),
        Err(fault) => fault,
    };
    (arguments.error_argument, arguments.error_index) = (name, reported(index));
    code
}

/// The initial history of a point at its closest point.
///
/// # Safety
/// `history` has room for the element's history.
unsafe fn start(element: &Descriptor, history: *mut f64, number: usize, closest: &Closest) {
    let (p, size) = (element.projected, element.point_history());
    // SAFETY: promised by the caller.
    let entries = unsafe { core::slice::from_raw_parts_mut(history.add(number * size), size) };
    // a foot so far away that no evaluation takes it is no start
    let at = |i: usize| {
        let (zeta, centre) = (closest.zeta.get(i), element.centre.get(i));
        let zeta = zeta.filter(|&&zeta| element.can_be_projection(i, zeta));
        zeta.or(centre).copied().unwrap_or(0.0)
    };
    for (index, entry) in entries.iter_mut().enumerate() {
        *entry = match index.checked_sub(1) {
            Some(i) if i < p => at(i),
            Some(i) if element.friction && i < 2 * p => at(i - p),
            _ => 0.0,
        };
    }
}

/// What a global projection goes by, from Rust.
#[derive(Clone, Copy, Debug, Default)]
pub struct Query<'a> {
    /// Reference coordinates \[nodes · dimension\].
    pub x: &'a [f64],
    /// Displacements \[nodes · dimension\]; empty: zero.
    pub u: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Nothing farther is looked for \[length\]; 0: no limit.
    pub reach: f64,
}

/// The closest points of all contact points of `element` over the whole domain of its master, found without a start.
/// `results`: one per contact point; `history`: empty, or room for the element's history, which then begins there.
/// Slices that are too short give the code and argument that a C host would get for a null pointer.
pub fn project(
    element: &Descriptor,
    query: &Query<'_>,
    results: &mut [Projection],
    history: &mut [f64],
) -> Outcome {
    let nslave = match element.interpolated {
        true => query.slave_row.len().saturating_sub(1),
        false => element.slave_nodes,
    };
    let n = element.nodes(nslave);
    let coordinates = n * element.dimension;
    let too_short = |argument: i32| Outcome {
        code: code::NULL,
        status: 0,
        closed: 0,
        argument,
        index: 0,
    };
    for (length, least, name) in [
        (query.x.len(), coordinates, argument::X),
        (results.len(), element.points, argument::RESULT),
    ] {
        if length < least {
            return too_short(name);
        }
    }
    if !query.u.is_empty() && query.u.len() < coordinates {
        return too_short(argument::U);
    }
    if !history.is_empty() && history.len() < element.history() {
        return too_short(argument::HISTORY_TRIAL);
    }
    let mut arguments = Arguments::EMPTY;
    arguments.nnode = n as i32;
    arguments.nslave = nslave as i32;
    arguments.parameter_count = query.parameters.len() as i32;
    arguments.parameters = query.parameters.as_ptr();
    arguments.x = query.x.as_ptr();
    let or_null = |slice: &[f64]| match slice {
        [] => core::ptr::null(),
        _ => slice.as_ptr(),
    };
    (arguments.u, arguments.slave_row) = (or_null(query.u), or_null(query.slave_row));
    let start = match history {
        [] => core::ptr::null_mut(),
        _ => history.as_mut_ptr(),
    };
    // SAFETY: every pointer is null or a slice of the length that the header asks for.
    let code = unsafe {
        let results = results.as_mut_ptr();
        element_project(element, &raw mut arguments, query.reach, results, start)
    };
    Outcome {
        code,
        status: 0,
        closed: 0,
        argument: arguments.error_argument,
        index: arguments.error_index,
    }
}
