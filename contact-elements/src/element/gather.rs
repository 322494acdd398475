//! Coordinates of an element's nodes, from anywhere in memory to the local origin.

use crate::arithmetic::{abs, are_usable, is_usable};
use crate::element::receiver::InputError;
use crate::element::traits::Element;
use crate::point::placement::Placement;

/// Where the coordinates of the nodes stand.
#[derive(Clone, Copy, Debug)]
pub struct Coordinates<'a> {
    /// The array.
    pub values: &'a [f64],
    /// Position of node 0; unused with a connectivity.
    pub offset: usize,
    /// Distance from node to node.
    pub node_stride: usize,
    /// Distance from component to component.
    pub component_stride: usize,
}

impl<'a> Coordinates<'a> {
    /// Nodes one behind the other, from the first entry on.
    pub fn one_by_one(values: &'a [f64], dimension: usize) -> Self {
        Self {
            values,
            offset: 0,
            node_stride: dimension,
            component_stride: 1,
        }
    }
}

/// The nodes of one element.
#[derive(Clone, Copy, Debug)]
pub struct Nodes<'a> {
    /// Reference coordinates.
    pub x: Coordinates<'a>,
    /// Displacements; `None` for zero.
    pub u: Option<Coordinates<'a>>,
    /// Numbers of the nodes in the arrays; `None` for 0, 1, 2 …
    pub connectivity: Option<&'a [i32]>,
    /// Number of nodes.
    pub count: usize,
}

impl Coordinates<'_> {
    /// One component of a node; NaN if it does not exist.
    pub(crate) fn entry(&self, node: Option<usize>, component: usize) -> f64 {
        let place = node
            .map(|node| self.offset + node * self.node_stride + component * self.component_stride);
        let value = place.and_then(|place| self.values.get(place));
        value.copied().unwrap_or(f64::NAN)
    }

    /// The first `count` nodes, where they stand one after another.
    #[inline(always)]
    fn dense<const D: usize>(&self, count: usize) -> Option<&[[f64; D]]> {
        if self.component_stride == 1 && self.node_stride == D {
            let (nodes, _) = self.values.get(self.offset..)?.as_chunks::<D>();
            nodes.get(..count)
        } else {
            None
        }
    }

    #[inline(always)]
    fn node<const D: usize>(&self, node: usize) -> Option<[f64; D]> {
        let start = self.offset + node * self.node_stride;
        if self.component_stride == 1 {
            return self.values.get(start..)?.first_chunk::<D>().copied();
        }
        let mut value = [0.0; D];
        for (k, value) in value.iter_mut().enumerate() {
            *value = *self.values.get(start + k * self.component_stride)?;
        }
        Some(value)
    }
}

impl Nodes<'_> {
    /// Positions and displacements of the first `count` nodes, where they stand one after another and can be used.
    #[inline(always)]
    #[allow(clippy::type_complexity)]
    fn dense<const D: usize>(&self, count: usize) -> Option<(&[[f64; D]], Option<&[[f64; D]]>)> {
        if self.connectivity.is_some() {
            return None;
        }
        let x = self.x.dense::<D>(count)?;
        let u = match &self.u {
            Some(u) => Some(u.dense::<D>(count)?),
            None => None,
        };
        let can = are_usable(x.as_flattened()) & u.is_none_or(|u| are_usable(u.as_flattened()));
        can.then_some((x, u))
    }

    /// Checks all coordinates of the first `count` nodes before they are used.
    #[inline(always)]
    pub(crate) fn check<const D: usize>(&self, count: usize) -> Result<(), InputError> {
        let mut can = true;
        for a in 0..count {
            can &= are_usable(&self.reference::<D>(a)?);
            can &= are_usable(&self.displacement::<D>(a)?);
        }
        if can {
            Ok(())
        } else {
            Err(self.first_unusable::<D>(count))
        }
    }

    /// What [`Nodes::check`] found.
    #[cold]
    fn first_unusable<const D: usize>(&self, count: usize) -> InputError {
        let unusable = |value: [f64; D]| !value.into_iter().all(is_usable);
        for a in 0..count {
            if self.reference(a).is_ok_and(unusable) {
                return InputError::Position(a);
            }
            if self.displacement(a).is_ok_and(unusable) {
                return InputError::Displacement(a);
            }
        }
        InputError::Position(0)
    }

    #[inline(always)]
    pub(crate) fn reference<const D: usize>(&self, a: usize) -> Result<[f64; D], InputError> {
        self.number(a)
            .and_then(|node| self.x.node(node))
            .ok_or(InputError::Position(a))
    }

    #[inline(always)]
    pub(crate) fn displacement<const D: usize>(&self, a: usize) -> Result<[f64; D], InputError> {
        match &self.u {
            None => Ok([0.0; D]),
            Some(u) => self
                .number(a)
                .and_then(|node| u.node(node))
                .ok_or(InputError::Displacement(a)),
        }
    }

    #[inline(always)]
    pub(crate) fn number(&self, a: usize) -> Option<usize> {
        match self.connectivity {
            None => Some(a),
            Some(list) => usize::try_from(*list.get(a)?).ok(),
        }
    }
}

/// Gathers the nodes relative to a local origin: the first slave node, or the frame of a placed geometry.
/// Reference coordinates and displacements are subtracted separately, so that nothing is lost far
/// from the origin. [eq:local-origin] Returns the origin in the local frame.
#[inline(always)]
pub(crate) fn gather<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    nodes: &Nodes<'_>,
    parameters: &[f64],
    is_vector: impl Fn(usize) -> bool,
    x: &mut [[f64; D]],
    reference: &mut [[f64; D]],
) -> Result<[f64; D], InputError> {
    let rigid = E::MASTER_NODES == 0;
    if rigid {
        let placement: Option<Placement<D>> = E::LAYOUT
            .placement
            .map(|at| Placement::from_parameters(parameters.get(at..).unwrap_or(&[])));
        return gather_each(nodes, (rigid, &placement), is_vector, x, reference);
    }
    if let Some(dense) = nodes.dense::<D>(x.len())
        && let Some(origin) = gather_dense(dense, &is_vector, x, reference)
    {
        return Ok(origin);
    }
    gather_spread(nodes, &is_vector, x, reference)
}

/// [`gather`] for nodes anywhere in memory: a call, because it would otherwise be repeated in every kernel.
#[inline(never)]
fn gather_spread<const D: usize>(
    nodes: &Nodes<'_>,
    is_vector: &dyn Fn(usize) -> bool,
    x: &mut [[f64; D]],
    reference: &mut [[f64; D]],
) -> Result<[f64; D], InputError> {
    gather_each(nodes, (false, &None), is_vector, x, reference)
}

/// [`gather`] node by node.
#[inline(always)]
fn gather_each<const D: usize>(
    nodes: &Nodes<'_>,
    (rigid, placement): (bool, &Option<Placement<D>>),
    is_vector: impl Fn(usize) -> bool,
    x: &mut [[f64; D]],
    reference: &mut [[f64; D]],
) -> Result<[f64; D], InputError> {
    nodes.check::<D>(x.len())?;
    let (mut origin, mut shift) = ([0.0; D], [0.0; D]);
    if let Some(placement) = placement {
        origin = placement.origin;
    } else if !rigid {
        origin = nodes.reference(0)?;
        shift = nodes.displacement(0)?;
    }
    for (a, local) in x.iter_mut().enumerate() {
        let position: [f64; D] = nodes.reference(a)?;
        let displacement: [f64; D] = nodes.displacement(a)?;
        let is_vector = is_vector(a);
        let mut value = [0.0; D];
        if is_vector {
            for k in 0..D {
                value[k] = position[k] + displacement[k];
            }
        } else if a > 0 || rigid {
            for k in 0..D {
                value[k] = position[k] - origin[k];
            }
            if nodes.u.is_some() {
                for k in 0..D {
                    value[k] += displacement[k] - shift[k];
                }
            }
        }
        if let Some(reference) = reference.get_mut(a) {
            for k in 0..D {
                reference[k] = if is_vector {
                    position[k]
                } else {
                    position[k] - origin[k]
                };
            }
        }
        *local = match placement {
            Some(placement) => placement.vector_to_local(&value),
            None => value,
        };
    }
    for k in 0..D {
        origin[k] += shift[k];
    }
    if let Some(placement) = placement {
        origin = placement.vector_to_local(&origin);
    }
    Ok(origin)
}

/// [`gather`] for nodes that stand one after another; without displacements they are zero.
#[inline(always)]
fn gather_dense<const D: usize>(
    (positions, displacements): (&[[f64; D]], Option<&[[f64; D]]>),
    is_vector: impl Fn(usize) -> bool,
    x: &mut [[f64; D]],
    reference: &mut [[f64; D]],
) -> Option<[f64; D]> {
    let mut origin = *positions.first()?;
    for (a, (local, position)) in x.iter_mut().zip(positions).enumerate() {
        *local = *position;
        if !is_vector(a) {
            for k in 0..D {
                local[k] -= origin[k];
            }
        }
    }
    for (to, from) in reference.iter_mut().zip(x.iter()) {
        *to = *from;
    }
    let Some(displacements) = displacements else {
        return Some(origin);
    };
    let shift = *displacements.first()?;
    for (a, (local, displacement)) in x.iter_mut().zip(displacements).enumerate() {
        for k in 0..D {
            local[k] += if is_vector(a) {
                displacement[k]
            } else {
                displacement[k] - shift[k]
            };
        }
    }
    for k in 0..D {
        origin[k] += shift[k];
    }
    Some(origin)
}

/// The multipliers: first component of the displacement of the nodes from `first` on.
#[inline(never)]
pub(crate) fn multipliers(
    nodes: &Nodes<'_>,
    first: usize,
    to: &mut [f64],
) -> Result<(), InputError> {
    for (q, to) in to.iter_mut().enumerate() {
        let [value] = nodes.displacement::<1>(first + q)?;
        if !is_usable(value) {
            return Err(InputError::Displacement(first + q));
        }
        *to = value;
    }
    Ok(())
}

/// A slave row need not sum to one (hierarchical shape functions): Σ N_A x_A − o differs from
/// Σ N_A (x_A − o) by (Σ N_A − 1) o, which the node of the largest entry takes over. [eq:row-sum]
#[inline(always)]
pub(crate) fn shift_of_row<const D: usize>(
    slave_row: &[f64],
    origin: &[f64; D],
    x: &mut [[f64; D]],
) {
    let Some((_, row)) = slave_row.split_last() else {
        return;
    };
    let mut excess = -1.0;
    let mut largest: f64 = 0.0;
    for &entry in row {
        excess += entry;
        largest = largest.max(abs(entry));
    }
    let node = row.iter().zip(x).find(|(entry, _)| abs(**entry) >= largest);
    if let (Some((&entry, x)), true) = (node, largest > 1e-30) {
        for k in 0..D {
            x[k] += excess * origin[k] / entry;
        }
    }
}
