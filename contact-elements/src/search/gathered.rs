//! Both sides of a contact point for the global projection, in the frame of the search.

use super::pair::{Side, Sides};
use crate::arithmetic::is_usable;
use crate::arithmetic::sqrt;
use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::element::gather::Nodes;
use crate::error::Error;
use crate::point::placement::Placement;
use crate::point::values::dot;
use crate::table::{GeometryPrograms, MasterDescription, SlaveDescription};

/// Most nodes of a side that is searched.
const MOST_NODES: usize = 32;
/// Most outputs of a slave's shape functions.
const MOST_OUTPUTS: usize = 512;

/// Nodes of both sides in the frame of the search.
pub(crate) struct Gathered<'a> {
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
    fn new(element: &Descriptor, nodes: &Nodes<'_>, parameters: &[f64]) -> Result<Self, Error> {
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
) -> Result<([f64; 3], [f64; 3]), Error> {
    let (mut x, mut u) = ([0.0; 3], [0.0; 3]);
    for k in (0..3).take(element.dimension) {
        x[k] = nodes.x.entry(nodes.number(a), k);
        u[k] = nodes.u.map_or(0.0, |u| u.entry(nodes.number(a), k));
        if !is_usable(x[k]) {
            return Err(Error::new(code::NOT_FINITE, argument::X, a));
        }
        if !is_usable(u[k]) {
            return Err(Error::new(code::NOT_FINITE, argument::U, a));
        }
    }
    Ok((x, u))
}

impl<'a> Gathered<'a> {
    /// Reads the nodes; of an interpolated slave its point alone.
    pub(crate) fn new(
        element: &'a Descriptor,
        nodes: &Nodes<'_>,
        parameters: &'a [f64],
        row: &[f64],
    ) -> Result<Self, Error> {
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
                        return Err(Error::new(code::NOT_FINITE, argument::SLAVE_ROW, a));
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

    /// The middle of the master's nodes as seen from the first slave node, and how far they are from it.
    pub(crate) fn surroundings(&self) -> ([f64; 3], f64) {
        let nodes = self.master.get(..self.element.master_nodes).unwrap_or(&[]);
        let mut middle = [0.0; 3];
        for node in nodes {
            for (sum, x) in middle.iter_mut().zip(node) {
                *sum += x / nodes.len() as f64;
            }
        }
        let away = |node: &[f64; 3]| {
            let away: [f64; 3] = core::array::from_fn(|k| node[k] - middle[k]);
            sqrt(dot(&away, &away))
        };
        (middle, nodes.iter().map(away).fold(0.0, f64::max))
    }

    /// Both sides of contact point `number`.
    pub(crate) fn sides(&self, number: usize) -> Option<Sides<'_>> {
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
    pub(crate) fn declared(&self, sides: &Sides<'_>) -> Option<[f64; 2]> {
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

fn put(list: &mut [[f64; 3]; MOST_NODES], a: usize, x: [f64; 3]) -> Result<(), Error> {
    let too_many = Error::new(code::ELEMENT, argument::ELEMENT, 0);
    *list.get_mut(a).ok_or(too_many)? = x;
    Ok(())
}
