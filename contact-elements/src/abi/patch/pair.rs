//! The pair that a slave point takes part in: with a facet, an edge or a vertex.

use super::super::safe::{Evaluation, Outcome, evaluate};
use super::super::sizes::Fault;
use super::super::{Descriptor, OUTPUT_SIZE, argument, code, request};
use super::boundary::{Corners, Feature, MOST_NODES, nodes_of_edge};
use super::checked::{Checked, List};
use super::place::{Place, Values};
use super::side::{relative, side};
use crate::arithmetic::abs;
use crate::runtime::Status;

/// Most unknowns of a pair.
const MOST_UNKNOWNS: usize = 3 * (1 + MOST_NODES);
/// A point nearer to an edge or vertex than this part of its coordinates lies on it.
const ON_IT: f64 = 1e-14;

/// What a pair gives.
pub(super) struct Answer {
    pub(super) residual: [f64; MOST_UNKNOWNS],
    pub(super) tangent: [f64; MOST_UNKNOWNS * MOST_UNKNOWNS],
    pub(super) output: [f64; OUTPUT_SIZE],
    pub(super) energy: f64,
}

impl Answer {
    pub(super) fn new() -> Self {
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
    /// It is the place found: Newton's method leaves the master by rounding.
    Given,
    /// The same, on the facet: a point on an edge or vertex has no direction from it, but the facet has a normal.
    OnFacet,
}

/// One pair.
pub(super) struct Pair {
    element: &'static Descriptor,
    slave: usize,
    /// Nodes of the patch.
    list: List,
    values: Values,
    pub(super) place: Place,
    /// Parameters on the master of the pair.
    zeta: [f64; 2],
    side: f64,
    foot: Foot,
}

impl Pair {
    /// Of a place that was just found; none where no lower pair was declared for it.
    pub(super) fn new(
        checked: &Checked<'_>,
        slave: usize,
        place: &Place,
    ) -> Result<Option<Self>, Fault> {
        let (r, tangents) = relative(checked, slave, place.facet, place.zeta)?;
        let largest = |top: f64, value: &f64| top.max(abs(*value));
        let size = tangents.iter().flatten().fold(0.0, largest);
        if place.feature != 0 && r.iter().fold(0.0, largest) <= ON_IT * size {
            return Self::with(checked, slave, place, (1.0, Foot::OnFacet));
        }
        let side = side(checked, slave, place)?;
        Self::with(checked, slave, place, (side, Foot::Free))
    }

    fn with(
        checked: &Checked<'_>,
        slave: usize,
        place: &Place,
        (side, foot): (f64, Foot),
    ) -> Result<Option<Self>, Fault> {
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
                let refused = (code::ELEMENT, argument::EDGE, 0);
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
    pub(super) fn keep(&self, memory: &mut [f64]) {
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

    /// The pair that was stored; none where there was none.
    pub(super) fn kept(
        checked: &Checked<'_>,
        slave: usize,
        memory: &[f64],
    ) -> Result<Option<Self>, Fault> {
        let &[facet, feature, first, second, side, foot] = memory else {
            return Ok(None);
        };
        let Some(facet) = (facet as usize).checked_sub(1) else {
            return Ok(None);
        };
        let place = Place {
            facet,
            feature: feature as u8,
            zeta: [first, second],
        };
        let feet = [Foot::Free, Foot::Given, Foot::OnFacet];
        let foot = feet.into_iter().find(|own| f64::from(*own as u8) == foot);
        Self::with(checked, slave, &place, (side, foot.unwrap_or(Foot::Free)))
    }

    /// Evaluates the pair. `bits`: what is wanted, and FREEZE_STATE.
    pub(super) fn evaluate(
        &mut self,
        checked: &Checked<'_>,
        answer: &mut Answer,
        bits: u32,
    ) -> Outcome {
        let outcome = self.once(checked, answer, bits);
        if outcome.status() != Some(Status::Outside) || self.foot != Foot::Free {
            return outcome;
        }
        self.foot = Foot::Given;
        self.once(checked, answer, bits)
    }

    /// Positions and displacements of the pair's nodes.
    fn coordinates(&self, checked: &Checked<'_>) -> [[f64; MOST_UNKNOWNS]; 2] {
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
    pub(super) fn unknowns(&self) -> usize {
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
    pub(super) fn unknown(&self, own: usize) -> usize {
        let d = self.element.dimension;
        let (node, k) = self.place_of(own, d);
        node.unwrap_or(0) * d + k
    }

    fn once(&self, checked: &Checked<'_>, answer: &mut Answer, bits: u32) -> Outcome {
        let n = self.unknowns();
        let [x, u] = self.coordinates(checked);
        let status = checked.remembered(self.slave, 0).unwrap_or(0.0);
        let history = [status, self.zeta[0], self.zeta[1]];
        let given = match self.foot {
            Foot::Free => 0,
            Foot::Given | Foot::OnFacet => request::PROJECTION_GIVEN,
        };
        let wanted = |bit: u32, length: usize| if bits & bit == 0 { 0 } else { length };
        let mut energy = [0.0];
        let outcome = evaluate(
            self.element,
            &mut Evaluation {
                x: x.get(..n).unwrap_or(&[]),
                u: u.get(..n).unwrap_or(&[]),
                parameters: self.values.slice(),
                history: history.get(..1 + self.element.projected).unwrap_or(&[]),
                residual: first(&mut answer.residual, wanted(request::RESIDUAL, n)),
                tangent: first(&mut answer.tangent, wanted(request::TANGENT, n * n)),
                output: &mut answer.output,
                energy: first(&mut energy, wanted(request::ENERGY, 1)),
                bits: given | bits & request::FREEZE_STATE,
                ..Evaluation::default()
            },
        );
        answer.energy = energy[0];
        outcome
    }
}

/// The first entries of an array.
fn first(values: &mut [f64], count: usize) -> &mut [f64] {
    values.get_mut(..count).unwrap_or(&mut [])
}
