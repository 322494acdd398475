//! Global projection of an element's contact points: no start is needed. [eq:global-projection]

use super::evaluate::{node_counts, nodes, parameters, slave_row};
use super::fortran::blank;
use super::safe::Outcome;
use super::sizes::{Fault, reported};
use super::types::{Arguments, is_whole};
use super::{Descriptor, argument, code};
use crate::program::{GeometryPrograms, MasterDescription, SlaveDescription};
use crate::runtime::{Nodes, Placement, is_usable};
use crate::search::{Closest, Side, Sides, Verdict, closest};

/// Most nodes of a side that is searched.
const MOST_NODES: usize = 32;
/// Most outputs of a slave's shape functions.
const MOST_OUTPUTS: usize = 512;

/// Nodes of both sides in the frame of the search.
struct Gathered<'a> {
    element: &'a Descriptor,
    parameters: &'a [f64],
    slave: [[f64; 3]; MOST_NODES],
    master: [[f64; 3]; MOST_NODES],
}

/// Origin and axes of the search: the first slave node, or the frame of a rigid master.
struct Frame {
    origin: [f64; 3],
    shift: [f64; 3],
    placement: Placement<3>,
}

impl Frame {
    fn new(element: &Descriptor, nodes: &Nodes<'_>, parameters: &[f64]) -> Result<Self, Fault> {
        let rigid = element.master_nodes == 0;
        let mut placement = Placement::identity();
        if let Some(at) = element.layout.placement {
            let own = parameters.get(at..).unwrap_or(&[]);
            placement = if element.dimension == 3 {
                Placement::from_parameters(own)
            } else {
                spatial(&Placement::from_parameters(own))
            };
        }
        let (origin, shift) = if rigid {
            (placement.origin, [0.0; 3])
        } else {
            position(element, nodes, 0)?
        };
        Ok(Self {
            origin,
            shift,
            placement,
        })
    }

    /// A node in the frame of the search; a tangent vector is only turned.
    fn local(&self, (x, u): ([f64; 3], [f64; 3]), is_vector: bool) -> [f64; 3] {
        let value = core::array::from_fn(|k| {
            if is_vector {
                x[k] + u[k]
            } else {
                (x[k] - self.origin[k]) + (u[k] - self.shift[k])
            }
        });
        self.placement.vector_to_local(&value)
    }

    /// The origin of the coordinates, as seen from here.
    fn of_coordinates(&self) -> [f64; 3] {
        let back = core::array::from_fn(|k| -self.origin[k] - self.shift[k]);
        self.placement.vector_to_local(&back)
    }
}

/// A plane placement in space.
fn spatial(plane: &Placement<2>) -> Placement<3> {
    let mut placement = Placement::identity();
    for (row, own) in placement.rotation.iter_mut().zip(&plane.rotation) {
        for (entry, value) in row.iter_mut().zip(own) {
            *entry = *value;
        }
    }
    for (entry, value) in placement.origin.iter_mut().zip(plane.origin) {
        *entry = value;
    }
    placement
}

/// Reference position and displacement of a node, checked.
fn position(
    element: &Descriptor,
    nodes: &Nodes<'_>,
    a: usize,
) -> Result<([f64; 3], [f64; 3]), Fault> {
    let (mut x, mut u) = ([0.0; 3], [0.0; 3]);
    for k in (0..3).take(element.dimension) {
        x[k] = nodes.x.entry(nodes.number(a), k);
        u[k] = nodes.u.map_or(0.0, |u| u.entry(nodes.number(a), k));
        if !is_usable(x[k]) {
            return Err((code::NOT_FINITE, argument::X, a));
        }
        if !is_usable(u[k]) {
            return Err((code::NOT_FINITE, argument::U, a));
        }
    }
    Ok((x, u))
}

impl<'a> Gathered<'a> {
    /// Reads the nodes; of an interpolated slave its point alone.
    fn new(
        element: &'a Descriptor,
        nodes: &Nodes<'_>,
        parameters: &'a [f64],
        row: &[f64],
    ) -> Result<Self, Fault> {
        let frame = Frame::new(element, nodes, parameters)?;
        let slaves = if element.interpolated {
            row.len().saturating_sub(1)
        } else {
            element.slave_nodes
        };
        let positions = nodes.count.saturating_sub(element.multipliers());
        let flags = positions.saturating_sub(element.vectors.len());
        let is_vector = |a: usize| {
            let flag = a.checked_sub(flags).and_then(|a| element.vectors.get(a));
            flag.copied().unwrap_or(false)
        };
        let mut gathered = Self {
            element,
            parameters,
            slave: [[0.0; 3]; MOST_NODES],
            master: [[0.0; 3]; MOST_NODES],
        };
        let mut point = [0.0; 3];
        let mut excess = 1.0;
        for a in 0..positions {
            let x = frame.local(position(element, nodes, a)?, is_vector(a));
            match a.checked_sub(slaves) {
                Some(master) => put(&mut gathered.master, master, x)?,
                None if element.interpolated => {
                    let share = row.get(a).copied().unwrap_or(0.0);
                    if !is_usable(share) {
                        return Err((code::NOT_FINITE, argument::SLAVE_ROW, a));
                    }
                    excess -= share;
                    for (sum, x) in point.iter_mut().zip(x) {
                        *sum += share * x;
                    }
                }
                None => put(&mut gathered.slave, a, x)?,
            }
        }
        if element.interpolated {
            // a row that does not sum to one counts from the origin of the coordinates
            for (sum, x) in point.iter_mut().zip(frame.of_coordinates()) {
                *sum += excess * x;
            }
            gathered.slave[0] = point;
        }
        Ok(gathered)
    }

    /// Both sides of contact point `number`.
    fn sides(&self, number: usize) -> Option<Sides<'_>> {
        let element = self.element;
        let layout = &element.layout;
        let from = |at: usize| self.parameters.get(at..).unwrap_or(&[]);
        let slave = match element.slave {
            SlaveDescription::Point | SlaveDescription::Interpolated => Side::Fixed(self.slave[0]),
            SlaveDescription::Projected(geometry) => Side::Shape {
                program: &geometry.values,
                nodes: self.slave.get(..element.slave_nodes)?,
                weights: from(layout.slave_weights),
                p: 1,
            },
            SlaveDescription::Given(geometry) => {
                self.slave_point(geometry, from(layout.point), from(layout.slave_weights))
            }
            SlaveDescription::Integrated(geometry, points) => {
                let (eta, _) = points.get(number)?;
                self.slave_point(geometry, eta, from(layout.slave_weights))
            }
        };
        let own = match element.slave {
            SlaveDescription::Projected(_) => 1,
            _ => 0,
        };
        let p = element.projected.saturating_sub(own);
        let master = match element.master {
            MasterDescription::Point => Side::Fixed(self.master[0]),
            MasterDescription::Distance(_) => Side::Fixed([0.0; 3]),
            MasterDescription::Shape(geometry) => Side::Shape {
                program: &geometry.values,
                nodes: self.master.get(..element.master_nodes)?,
                weights: from(layout.master_weights),
                p,
            },
            MasterDescription::Rigid(geometry) => Side::Rigid {
                program: &geometry.values,
                parameters: from(layout.geometry),
                p,
                d: element.dimension,
            },
        };
        Some(Sides { slave, master })
    }

    /// The slave's point at fixed parameters.
    fn slave_point(&self, geometry: &GeometryPrograms, eta: &[f64], weights: &[f64]) -> Side<'_> {
        let program = &geometry.values;
        let n = self.element.slave_nodes;
        // values, p rows of slopes and p (p + 1)/2 of curvatures
        let p = if program.outputs.len() >= 6 * n { 2 } else { 1 };
        let (mut inputs, mut outputs) = ([0.0; 2 + MOST_NODES], [0.0; MOST_OUTPUTS]);
        let values = eta.iter().take(p).chain(weights);
        for (input, &value) in inputs.iter_mut().zip(values) {
            *input = value;
        }
        let mut sum = [0.0; 3];
        if let (Some(inputs), Some(outputs)) = (
            inputs.get(..program.inputs.len()),
            outputs.get_mut(..program.outputs.len()),
        ) {
            (program.compiled)(inputs, outputs);
            for (shape, node) in outputs.iter().zip(&self.slave).take(n) {
                for (sum, x) in sum.iter_mut().zip(node) {
                    *sum += shape * x;
                }
            }
        }
        Side::Fixed(sum)
    }

    /// The closest point of a geometry that declares it.
    fn declared(&self, sides: &Sides<'_>) -> Option<[f64; 2]> {
        let (MasterDescription::Rigid(geometry), Side::Fixed(x)) =
            (self.element.master, sides.slave)
        else {
            return None;
        };
        let program = geometry.projection.as_ref()?;
        let (mut inputs, mut zeta) = ([0.0; 3 + MOST_NODES], [0.0; 2]);
        let own = self.parameters.get(self.element.layout.geometry..)?;
        let x = x.iter().take(self.element.dimension);
        for (input, &value) in inputs.iter_mut().zip(x.chain(own)) {
            *input = value;
        }
        let inputs = inputs.get(..program.inputs.len())?;
        (program.compiled)(inputs, zeta.get_mut(..program.outputs.len())?);
        Some(zeta)
    }
}

fn put(list: &mut [[f64; 3]; MOST_NODES], a: usize, x: [f64; 3]) -> Result<(), Fault> {
    let too_many = (code::ELEMENT, argument::ELEMENT, 0);
    *list.get_mut(a).ok_or(too_many)? = x;
    Ok(())
}

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
    if !unsafe { is_whole::<Arguments>(arguments.cast()) } {
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
    let at = |i: usize| closest.zeta.get(i).copied().unwrap_or(0.0);
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
        return too_short(argument::HISTORY_NEW);
    }
    let mut arguments = blank();
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
