//! A patch and its arguments, checked before anything is computed with them.

use super::boundary::{self, Corners, MOST_CORNERS, MOST_NODES};
use crate::arithmetic::is_usable;
use crate::codes::{argument, code, request};
use crate::descriptor::Descriptor;
use crate::element::gather::Nodes;
use crate::error::Error;
use crate::evaluation::inputs::check_reach;
use crate::evaluation::sizes::MOST_UNKNOWNS;
use crate::point::history::{History, is_status};
use crate::point::values::Enforcement;
use crate::registered::Registered;
use crate::search::spread;
use crate::table::{MasterDescription, SlaveDescription};

/// Doubles of history per slave point: status, number of the facet from 1, feature, two parameters.
pub(crate) const HISTORY: usize = 5;

/// Facets that share edges and vertices, and the elements that stand for them.
#[derive(Clone, Copy, Debug)]
pub struct Patch<'a> {
    /// A slave point against a facet.
    pub facet: &'a Registered,
    /// A slave point against the curve that bounds the facet; if `None`, a point beyond an edge is outside.
    pub edge: Option<&'a Registered>,
    /// A slave point against a vertex; if `None`, a point beyond it is outside.
    pub vertex: Option<&'a Registered>,
    /// Slave points.
    pub slave_points: usize,
    /// Master nodes.
    pub master_nodes: usize,
    /// Master nodes of every facet, from 0.
    pub connectivity: &'a [i32],
    /// Reach of the search, length; 0 means no limit.
    pub reach: f64,
}

/// Request bits of a patch.
const REQUESTS: u32 = request::RESIDUAL
    | request::TANGENT
    | request::HISTORY
    | request::OUTPUT
    | request::ENERGY
    | request::FREEZE_STATE;

/// What was checked.
pub(crate) struct Checked<'a> {
    pub(crate) facet: &'a Registered,
    pub(crate) edge: Option<&'a Registered>,
    pub(crate) vertex: Option<&'a Registered>,
    pub(crate) slaves: usize,
    pub(crate) masters: usize,
    pub(crate) connectivity: &'a [i32],
    pub(crate) corners: Corners,
    /// The facet's node at each corner.
    pub(crate) at_corners: [usize; MOST_CORNERS],
    pub(crate) reach: f64,
    /// How far facets reach beyond their nodes. [eq:spread]
    pub(crate) spread: f64,
    /// Nodes of the whole patch, slave points first.
    pub(crate) nodes: Option<Nodes<'a>>,
    /// Laws, r0, orientation, and a weight per master node where the facet is rational.
    pub(crate) values: &'a [f64],
    /// Accepted history.
    pub(crate) history: Option<History<'a>>,
}

impl<'a> Checked<'a> {
    /// Checks elements and connectivity.
    pub(crate) fn new(patch: &Patch<'a>) -> Result<Self, Error> {
        let (slaves, masters) = (patch.slave_points, patch.master_nodes);
        for (count, name) in [(slaves, argument::NSLAVE), (masters, argument::NNODE)] {
            if count == 0 {
                return Err(Error::new(code::NODE_COUNT, name, 0));
            }
        }
        check_reach(patch.reach)?;
        let facet = patch.facet;
        let refused = Error::new(code::ELEMENT, argument::FACET, 0);
        let corners = facet_corners(facet).ok_or(refused)?;
        let at_corners = boundary::nodes_of_corners(facet, &corners).ok_or(refused)?;
        check_lower(facet, &corners, patch.edge, patch.vertex)?;
        let nodes = slaves.saturating_add(masters);
        if nodes.saturating_mul(facet.dimension) > MOST_UNKNOWNS {
            return Err(Error::new(code::NODE_COUNT, argument::NNODE, 0));
        }
        if i32::try_from(slaves.saturating_mul(HISTORY)).is_err() {
            return Err(Error::new(code::NODE_COUNT, argument::NSLAVE, 0));
        }
        if patch.connectivity.is_empty() {
            return Err(Error::missing(argument::CONNECTIVITY));
        }
        let exists = |&node: &i32| usize::try_from(node).is_ok_and(|node| node < masters);
        if let Some(entry) = patch.connectivity.iter().position(|node| !exists(node)) {
            return Err(Error::new(code::INDEX, argument::CONNECTIVITY, entry));
        }
        Ok(Self {
            facet,
            edge: patch.edge,
            vertex: patch.vertex,
            slaves,
            masters,
            connectivity: patch.connectivity,
            corners,
            at_corners,
            reach: patch.reach,
            spread: f64::INFINITY,
            nodes: None,
            values: &[],
            history: None,
        })
    }

    /// Checks the inputs of an evaluation.
    pub(crate) fn with(
        mut self,
        nodes: Nodes<'a>,
        values: &'a [f64],
        history: Option<History<'a>>,
    ) -> Result<Self, Error> {
        (self.nodes, self.values, self.history) = (Some(nodes), values, history);
        self.check_values()?;
        self.check_positions()?;
        self.check_history()?;
        self.spread = self.spread_of_facets();
        Ok(self)
    }

    /// [`Checked::spread`]: unlimited for one facet, which is searched anyway, and for facets with tangent vectors, about
    /// which nothing is known.
    fn spread_of_facets(&self) -> f64 {
        let has_vectors = self.facet.vectors.iter().any(|&is_vector| is_vector);
        match self.facet.master {
            MasterDescription::Shape(geometry) if self.facets() > 1 && !has_vectors => {
                let [domain, _] = &self.facet.domains;
                spread(&geometry.values, self.facet.master_nodes, domain)
            }
            _ => f64::INFINITY,
        }
    }

    /// Nodes of the patch.
    pub(crate) fn nodes(&self) -> usize {
        self.slaves + self.masters
    }

    pub(crate) fn unknowns(&self) -> usize {
        self.nodes() * self.facet.dimension
    }

    /// Laws, r0, orientation; then a weight per master node of rational facets.
    pub(crate) fn parameters(&self) -> usize {
        let layout = &self.facet.layout;
        let is_rational = layout.slave_weights > layout.master_weights;
        layout.master_weights + if is_rational { self.masters } else { 0 }
    }

    pub(crate) fn requests(&self) -> u32 {
        let all = [Some(self.facet), self.edge, self.vertex];
        let offered = all.into_iter().flatten().map(Registered::requests);
        offered.fold(REQUESTS, |bits, own| bits & own)
    }

    /// Hash over all formulations.
    pub(crate) fn formulation(&self) -> u64 {
        let all = [Some(self.facet), self.edge, self.vertex];
        let own = all.map(|element| element.map_or(0, |element| element.formulation));
        own.iter()
            .fold(0, |hash: u64, own| hash.rotate_left(21) ^ own)
    }

    /// Number of facets.
    pub(crate) fn facets(&self) -> usize {
        let nodes = self.facet.master_nodes.max(1);
        self.connectivity.len().checked_div(nodes).unwrap_or(0)
    }

    /// Master nodes of a facet.
    pub(crate) fn of_facet(&self, facet: usize) -> &[i32] {
        let nodes = self.facet.master_nodes;
        let list = self.connectivity.get(facet * nodes..).unwrap_or(&[]);
        list.get(..nodes).unwrap_or(&[])
    }

    fn check_values(&self) -> Result<(), Error> {
        let weights = self.facet.layout.master_weights;
        let bounds = |entry: usize| self.facet.parameters.get(entry.min(weights));
        for entry in 0..self.parameters() {
            let (Some(&value), Some(bounds)) = (self.values.get(entry), bounds(entry)) else {
                return Err(Error::new(code::PARAMETER, argument::PARAMETERS, entry));
            };
            if !is_usable(value) {
                return Err(Error::new(code::NOT_FINITE, argument::PARAMETERS, entry));
            }
            if !bounds.allows(value) {
                return Err(Error::new(code::PARAMETER, argument::PARAMETERS, entry));
            }
        }
        Ok(())
    }

    fn check_positions(&self) -> Result<(), Error> {
        let Some(nodes) = &self.nodes else {
            return Ok(());
        };
        for node in 0..self.nodes() {
            for k in 0..self.facet.dimension {
                if !is_usable(nodes.x.entry(Some(node), k)) {
                    return Err(Error::new(code::NOT_FINITE, argument::X, node));
                }
                if nodes.u.is_some_and(|u| !is_usable(u.entry(Some(node), k))) {
                    return Err(Error::new(code::NOT_FINITE, argument::U, node));
                }
            }
        }
        Ok(())
    }

    fn check_history(&self) -> Result<(), Error> {
        let Some(history) = self.history else {
            return Ok(());
        };
        for at in 0..history.len() {
            let value = history.at(at);
            if !is_usable(value) {
                return Err(Error::new(code::NOT_FINITE, argument::HISTORY_ACCEPTED, at));
            }
            let is_possible = match at.checked_rem(HISTORY) {
                Some(0) => is_status(value),
                Some(1) => value >= 0.0 && value <= self.facets() as f64,
                _ => true,
            };
            if !is_possible {
                return Err(Error::new(code::HISTORY, argument::HISTORY_ACCEPTED, at));
            }
        }
        Ok(())
    }

    /// Weight of a master node; 1 where facets are not rational.
    pub(crate) fn weight(&self, node: i32) -> f64 {
        let at = self.facet.layout.master_weights + usize::try_from(node).unwrap_or(0);
        self.values.get(at).copied().unwrap_or(1.0)
    }

    /// A slave point and master nodes as node numbers of the patch.
    pub(crate) fn list(&self, slave: usize, masters: impl Iterator<Item = i32>) -> List {
        let mut list = [0; 1 + MOST_NODES];
        list[0] = slave as i32;
        for (to, node) in list.iter_mut().skip(1).zip(masters) {
            *to = self.slaves as i32 + node;
        }
        list
    }

    /// An entry of the accepted history of a slave point.
    pub(crate) fn remembered(&self, slave: usize, entry: usize) -> Option<f64> {
        self.history?.get(slave * HISTORY + entry)
    }
}

/// Checks the element: one slave point, penalty, no friction.
fn is_plain(element: &Descriptor) -> bool {
    matches!(element.slave, SlaveDescription::Point)
        && element.enforcement == Enforcement::Penalty
        && !element.friction
        && boundary::fits(element)
}

/// Corners of a facet, if the element can be one.
fn facet_corners(facet: &Descriptor) -> Option<Corners> {
    let [domain, _] = &facet.domains;
    (is_plain(facet) && boundary::shape(facet).is_some())
        .then(|| Corners::new(domain))
        .flatten()
}

/// Checks the lower pairs: the same law, a side where the facet has two, the facet's own edges.
fn check_lower(
    facet: &Descriptor,
    corners: &Corners,
    edge: Option<&Registered>,
    vertex: Option<&Registered>,
) -> Result<(), Error> {
    let law = |element: &Descriptor, at: usize| {
        let own = element.parameters.get(..element.layout.tangential);
        own.and_then(|own| own.get(at)).map(|own| own.name)
    };
    let agrees = |own: &Descriptor| {
        let same_law = facet.layout.tangential == own.layout.tangential
            && (0..facet.layout.tangential).all(|at| law(facet, at) == law(own, at));
        let has_side = facet.layout.orientation.is_none() || own.layout.orientation.is_some();
        is_plain(own) && own.dimension == facet.dimension && same_law && has_side
    };
    if let Some(edge) = edge {
        let refused = Err(Error::new(code::ELEMENT, argument::EDGE, 0));
        if facet.projected != 2 || edge.projected != 1 || !agrees(edge) {
            return refused;
        }
        let mut edges = 0..corners.count;
        if !edges.all(|k| boundary::nodes_of_edge(facet, corners, k, edge).is_some()) {
            return refused;
        }
    }
    if let Some(vertex) = vertex {
        let is_point = matches!(vertex.master, MasterDescription::Point);
        if !is_point || !agrees(vertex) {
            return Err(Error::new(code::ELEMENT, argument::VERTEX, 0));
        }
    }
    Ok(())
}

/// Node numbers of a pair: one slave point and master nodes.
pub(crate) type List = [i32; 1 + MOST_NODES];
