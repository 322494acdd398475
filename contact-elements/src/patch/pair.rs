//! The pair that a slave point takes part in: with a facet, an edge or a vertex.

use super::boundary::{Corners, Feature, MOST_NODES, nodes_of_edge};
use super::checked::{Checked, List};
use super::closest_place::ClosestPlace;
use super::pseudonormal::{relative, side};
use super::values::Values;
use crate::arithmetic::abs;
use crate::codes::{argument, code, request};
use crate::element::gather::{Coordinates, Nodes};
use crate::element::receiver::{Call, OUTPUT_SIZE, Summary};
use crate::error::Error;
use crate::evaluation::inputs::{check_parameters, wanted};
use crate::evaluation::single::{cells, run};
use crate::evaluation::target::{Matrix, Target};
use crate::point::history::History;
use crate::point::values::Status;
use crate::registered::Registered;

/// Most unknowns of a pair.
const MOST_UNKNOWNS: usize = 3 * (1 + MOST_NODES);
/// A point nearer to an edge or vertex than this part of its coordinates lies on it.
const ON_IT: f64 = 1e-14;

/// Contribution of a pair.
pub(crate) struct Answer {
    pub(crate) residual: [f64; MOST_UNKNOWNS],
    pub(crate) tangent: [f64; MOST_UNKNOWNS * MOST_UNKNOWNS],
    pub(crate) output: [f64; OUTPUT_SIZE],
    pub(crate) energy: f64,
}

impl Answer {
    pub(crate) fn new() -> Self {
        Self {
            residual: [0.0; MOST_UNKNOWNS],
            tangent: [0.0; MOST_UNKNOWNS * MOST_UNKNOWNS],
            output: [0.0; OUTPUT_SIZE],
            energy: 0.0,
        }
    }
}

/// How the projection of a pair is found.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Foot {
    /// By Newton's method from the place found.
    Free,
    /// Taken as found: Newton's method leaves the master by rounding.
    Given,
    /// Taken as found, on the facet: a point on an edge or vertex has no direction from it, but the facet has a normal.
    OnFacet,
}

/// One pair.
pub(crate) struct Pair<'a> {
    element: &'a Registered,
    slave: usize,
    /// Nodes of the patch.
    list: List,
    values: Values,
    pub(crate) place: ClosestPlace,
    /// Parameters on the master of the pair.
    zeta: [f64; 2],
    side: f64,
    foot: Foot,
}

impl<'a> Pair<'a> {
    /// The pair of a place that was just found; `None` where no lower pair was declared for it.
    pub(crate) fn new(
        checked: &Checked<'a>,
        slave: usize,
        place: &ClosestPlace,
    ) -> Result<Option<Self>, Error> {
        let (r, tangents) = relative(checked, slave, place.facet, place.zeta)?;
        let largest = |top: f64, value: &f64| top.max(abs(*value));
        let size = tangents.iter().flatten().fold(0.0, largest);
        if place.feature != 0 && r.iter().fold(0.0, largest) <= ON_IT * size {
            return Self::with(checked, slave, place, 1.0, Foot::OnFacet);
        }
        let side = side(checked, slave, place)?;
        Self::with(checked, slave, place, side, Foot::Free)
    }

    fn with(
        checked: &Checked<'a>,
        slave: usize,
        place: &ClosestPlace,
        side: f64,
        foot: Foot,
    ) -> Result<Option<Self>, Error> {
        let nodes = checked.of_facet(place.facet);
        let at = |node: usize| nodes.get(node).copied().unwrap_or(0);
        let mut pair = Self {
            element: checked.facet,
            slave,
            list: [0; 1 + MOST_NODES],
            values: Values::of_facet(checked, place.facet),
            place: *place,
            zeta: place.zeta,
            side,
            foot,
        };
        match Feature::new(place.feature) {
            _ if foot == Foot::OnFacet => {
                pair.list = checked.list(slave, nodes.iter().copied());
            }
            Feature::Inside => pair.list = checked.list(slave, nodes.iter().copied()),
            Feature::Edge(k) => {
                let Some(edge) = checked.edge else {
                    return Ok(None);
                };
                let refused = Error::new(code::ELEMENT, argument::EDGE, 0);
                let own = nodes_of_edge(checked.facet, &checked.corners, k, edge);
                let own = own.ok_or(refused)?;
                let [domain, _] = &edge.domains;
                let ends = Corners::new(domain).ok_or(refused)?;
                pair.zeta = ends.on_edge(0, checked.corners.part(k, place.zeta));
                pair.element = edge;
                let own = own.iter().take(edge.master_nodes);
                pair.list = checked.list(slave, own.clone().map(|&node| at(node)));
                pair.values
                    .make_lower(checked, edge, side, own.map(|&node| at(node)));
            }
            Feature::Vertex(k) => {
                let Some(vertex) = checked.vertex else {
                    return Ok(None);
                };
                let node = checked.at_corners.get(k).copied().unwrap_or(0);
                pair.element = vertex;
                pair.list = checked.list(slave, core::iter::once(at(node)));
                pair.values
                    .make_lower(checked, vertex, side, core::iter::empty());
            }
        }
        Ok(Some(pair))
    }

    /// Stores what [`Pair::kept`] needs.
    pub(crate) fn keep(&self, memory: &mut [f64]) {
        let [first, second] = self.place.zeta;
        let kept = [
            (self.place.facet + 1) as f64,
            f64::from(self.place.feature),
            first,
            second,
            self.side,
            f64::from(self.foot as u8),
        ];
        for (to, value) in memory.iter_mut().zip(kept) {
            *to = value;
        }
    }

    /// The pair that was stored; `None` if there was no pair.
    pub(crate) fn kept(
        checked: &Checked<'a>,
        slave: usize,
        memory: &[f64],
    ) -> Result<Option<Self>, Error> {
        let &[facet, feature, first, second, side, foot] = memory else {
            return Ok(None);
        };
        let Some(facet) = (facet as usize).checked_sub(1) else {
            return Ok(None);
        };
        let place = ClosestPlace {
            facet,
            feature: feature as u8,
            zeta: [first, second],
        };
        let feet = [Foot::Free, Foot::Given, Foot::OnFacet];
        let foot = feet.into_iter().find(|own| f64::from(*own as u8) == foot);
        Self::with(checked, slave, &place, side, foot.unwrap_or(Foot::Free))
    }

    /// Evaluates the pair. `bits` holds the requested outputs and FREEZE_STATE.
    pub(crate) fn evaluate(
        &mut self,
        checked: &Checked<'a>,
        answer: &mut Answer,
        bits: u32,
    ) -> Result<Summary, Error> {
        let result = self.once(checked, answer, bits);
        let is_outside = result.is_ok_and(|summary| summary.status == Status::Outside);
        if !is_outside || self.foot != Foot::Free {
            return result;
        }
        self.foot = Foot::Given;
        self.once(checked, answer, bits)
    }

    /// Positions and displacements of the pair's nodes.
    fn coordinates(&self, checked: &Checked<'a>) -> [[f64; MOST_UNKNOWNS]; 2] {
        let d = self.element.dimension;
        let (mut x, mut u) = ([0.0; MOST_UNKNOWNS], [0.0; MOST_UNKNOWNS]);
        let Some(nodes) = &checked.nodes else {
            return [x, u];
        };
        let pairs = x.iter_mut().zip(&mut u).take(self.unknowns());
        for (unknown, (x, u)) in pairs.enumerate() {
            let (node, k) = self.place_of(unknown, d);
            *x = nodes.x.entry(node, k);
            *u = nodes.u.map_or(0.0, |u| u.entry(node, k));
        }
        [x, u]
    }

    /// Unknowns of the pair.
    pub(crate) fn unknowns(&self) -> usize {
        self.element.dimension * (1 + self.element.master_nodes)
    }

    /// Node of the patch and component of an unknown of the pair.
    fn place_of(&self, unknown: usize, d: usize) -> (Option<usize>, usize) {
        let (a, k) = if d == 2 {
            (unknown / 2, unknown % 2)
        } else {
            (unknown / 3, unknown % 3)
        };
        let node = self
            .list
            .get(a)
            .and_then(|&node| usize::try_from(node).ok());
        (node, k)
    }

    /// Unknown of the patch.
    pub(crate) fn unknown(&self, own: usize) -> usize {
        let d = self.element.dimension;
        let (node, k) = self.place_of(own, d);
        node.unwrap_or(0) * d + k
    }

    fn once(
        &self,
        checked: &Checked<'a>,
        answer: &mut Answer,
        bits: u32,
    ) -> Result<Summary, Error> {
        let (element, n) = (self.element, self.unknowns());
        let [x, u] = self.coordinates(checked);
        let status = checked.remembered(self.slave, 0).unwrap_or(0.0);
        let history = [status, self.zeta[0], self.zeta[1]];
        let given = match self.foot {
            Foot::Free => 0,
            Foot::Given | Foot::OnFacet => request::PROJECTION_GIVEN,
        };
        check_parameters(element, self.values.slice())?;
        let coordinates = |values| Coordinates::one_by_one(values, element.dimension);
        let nodes = Nodes {
            x: coordinates(&x),
            u: Some(coordinates(&u)),
            connectivity: None,
            count: 1 + element.master_nodes,
        };
        let call = Call {
            parameters: self.values.slice(),
            history: history.get(..1 + element.projected).map(History::Own),
            slave_row: &[],
            wanted: wanted(given | bits),
        };
        let length = |bit: u32, length: usize| if bits & bit == 0 { 0 } else { length };
        let mut energy = [0.0];
        let mut target = Target {
            unknowns: n,
            dimension: element.dimension,
            history_layout: element.history_layout(),
            f: cells(first(&mut answer.residual, length(request::RESIDUAL, n))),
            k: match first(&mut answer.tangent, length(request::TANGENT, n * n)) {
                [] => Matrix::None,
                matrix => Matrix::Dense(matrix),
            },
            map: None,
            f_scale: 1.0,
            k_scale: 1.0,
            global_f: None,
            sparse: None,
            output: &mut answer.output,
            history: &[],
            energy: first(&mut energy, length(request::ENERGY, 1)),
        };
        let result = run(element, &call, &nodes, &mut [], &mut target, false);
        answer.energy = energy[0];
        result
    }
}

/// The first entries of an array.
fn first(values: &mut [f64], count: usize) -> &mut [f64] {
    values.get_mut(..count).unwrap_or(&mut [])
}
