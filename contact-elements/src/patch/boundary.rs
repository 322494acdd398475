//! Edges and vertices of a facet: corners of its domain, and which of its nodes an edge is made of.

use crate::arithmetic::abs;
use crate::descriptor::Descriptor;
use crate::point::domain::Domain;
use crate::table::{GeometryPrograms, MasterDescription};

/// Most nodes of a facet, an edge or a vertex.
pub(crate) const MOST_NODES: usize = 16;
/// Most corners of a domain.
pub(crate) const MOST_CORNERS: usize = 4;
/// Most outputs of a geometry: values, first and second derivatives.
const MOST_OUTPUTS: usize = 6 * MOST_NODES;
/// Shape functions that differ by less than this are the same.
const SAME: f64 = 1e-9;
/// Parts of an edge at which shape functions are compared; they lie unsymmetrically.
const SAMPLES: [f64; 3] = [0.25, 0.5, 0.8];

/// Where a projection lies on a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Feature {
    Inside,
    Edge(usize),
    Vertex(usize),
}

impl Feature {
    /// From the numbers of the interface: 0, 1 + edge, 5 + vertex.
    pub(crate) fn new(number: u8) -> Self {
        match number {
            0 => Self::Inside,
            1..=4 => Self::Edge(usize::from(number - 1)),
            _ => Self::Vertex(usize::from(number - 5)),
        }
    }
}

/// Corners of a bounded domain; edge k runs from corner k to corner k + 1, the last back to the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corners {
    list: [[f64; 2]; MOST_CORNERS],
    pub(crate) count: usize,
}

impl Corners {
    /// Corners of a domain; `None` where it has no end.
    pub(crate) fn new(domain: &Domain) -> Option<Self> {
        let (list, count) = match *domain {
            Domain::Interval(lower, upper) => ([[lower, 0.0], [upper, 0.0], [0.0; 2], [0.0; 2]], 2),
            Domain::Rectangle([a, b], [c, d]) => ([[a, b], [c, b], [c, d], [a, d]], 4),
            Domain::Triangle => ([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0; 2]], 3),
            Domain::Unbounded => return None,
        };
        let is_bounded = list.iter().flatten().all(|value| abs(*value) <= 1e30);
        is_bounded.then_some(Self { list, count })
    }

    /// Corner `k`, counted round.
    pub(crate) fn at(&self, k: usize) -> [f64; 2] {
        let k = if k >= self.count { k - self.count } else { k };
        self.list.get(k).copied().unwrap_or_default()
    }

    /// Parameters at a part of edge `k`.
    pub(crate) fn on_edge(&self, k: usize, part: f64) -> [f64; 2] {
        let (from, to) = (self.at(k), self.at(k + 1));
        core::array::from_fn(|i| from[i] + part * (to[i] - from[i]))
    }

    /// The part of edge `k` at which ζ lies.
    pub(crate) fn part(&self, k: usize, zeta: [f64; 2]) -> f64 {
        let (from, to) = (self.at(k), self.at(k + 1));
        let along: [f64; 2] = core::array::from_fn(|i| to[i] - from[i]);
        let length = along[0] * along[0] + along[1] * along[1];
        let reached = (zeta[0] - from[0]) * along[0] + (zeta[1] - from[1]) * along[1];
        (reached / length.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
    }
}

/// The shape of an element's master.
pub(crate) fn shape(element: &Descriptor) -> Option<&'static GeometryPrograms> {
    match element.master {
        MasterDescription::Shape(geometry) => Some(geometry),
        _ => None,
    }
}

/// Shape functions at ζ with all weights 1.
fn functions(geometry: &GeometryPrograms, zeta: [f64; 2], p: usize) -> [f64; MOST_OUTPUTS] {
    let program = &geometry.values;
    let (mut inputs, mut outputs) = ([1.0; 2 + MOST_NODES], [0.0; MOST_OUTPUTS]);
    for (input, value) in inputs.iter_mut().zip(zeta).take(p) {
        *input = value;
    }
    if let (Some(inputs), Some(outputs)) = (
        inputs.get(..program.inputs.len()),
        outputs.get_mut(..program.outputs.len()),
    ) {
        (program.compiled)(inputs, outputs);
    }
    outputs
}

/// True where the geometry of a facet, edge or vertex fits these tables.
pub(crate) fn fits(element: &Descriptor) -> bool {
    shape(element).is_none_or(|geometry| {
        let program = &geometry.values;
        program.inputs.len() <= 2 + MOST_NODES && program.outputs.len() <= MOST_OUTPUTS
    }) && element.master_nodes <= MOST_NODES
}

/// The node at every corner of a facet; `None` if a corner has no node.
pub(crate) fn nodes_of_corners(
    facet: &Descriptor,
    corners: &Corners,
) -> Option<[usize; MOST_CORNERS]> {
    let geometry = shape(facet)?;
    let mut nodes = [0; MOST_CORNERS];
    for (k, node) in nodes.iter_mut().enumerate().take(corners.count) {
        let values = functions(geometry, corners.at(k), facet.projected);
        let mut values = values.iter().take(facet.master_nodes);
        *node = values.position(|value| abs(value - 1.0) <= SAME)?;
    }
    Some(nodes)
}

/// For every node of the curve the number of the facet's node, if the curve, taken along edge `k`, is that edge.
pub(crate) fn nodes_of_edge(
    facet: &Descriptor,
    corners: &Corners,
    k: usize,
    curve: &Descriptor,
) -> Option<[usize; MOST_NODES]> {
    let (surface, line) = (shape(facet)?, shape(curve)?);
    let [domain, _] = &curve.domains;
    let ends = Corners::new(domain)?;
    let on_facet = SAMPLES.map(|part| functions(surface, corners.on_edge(k, part), 2));
    let on_curve = SAMPLES.map(|part| functions(line, ends.on_edge(0, part), 1));
    let column = |values: &[[f64; MOST_OUTPUTS]; 3], node: usize| {
        [0_usize, 1, 2].map(|sample| {
            let row = values.get(sample);
            row.and_then(|row| row.get(node)).copied().unwrap_or(0.0)
        })
    };
    let same = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| abs(a - b) <= SAME);
    let mut nodes = [0; MOST_NODES];
    let mut taken = [false; MOST_NODES];
    for (j, node) in nodes.iter_mut().enumerate().take(curve.master_nodes) {
        let wanted = column(&on_curve, j);
        *node = (0..facet.master_nodes).find(|&a| same(column(&on_facet, a), wanted))?;
        *taken.get_mut(*node)? = true;
    }
    // what is left of the facet has no part in the edge
    let rest = taken.iter().enumerate().take(facet.master_nodes);
    let mut rest = rest.filter(|(_, taken)| !**taken);
    let vanishes = rest.all(|(a, _)| same(column(&on_facet, a), [0.0; 3]));
    vanishes.then_some(nodes)
}
