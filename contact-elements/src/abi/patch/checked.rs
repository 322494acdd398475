//! A patch and its arguments, checked before anything is computed with them.

use core::cell::Cell;

use super::super::evaluate::nodes;
use super::super::sizes::{Fault, MOST_UNKNOWNS};
use super::super::types::Arguments;
use super::super::{Descriptor, argument, code, request};
use super::boundary::{self, Corners, MOST_CORNERS, MOST_NODES};
use super::{HISTORY, Patch};
use crate::program::{MasterDescription, SlaveDescription};
use crate::runtime::{Enforcement, Nodes, is_status, is_usable};
use crate::search::spread;

/// Request bits of a patch.
const REQUESTS: u32 = request::RESIDUAL
    | request::TANGENT
    | request::HISTORY
    | request::OUTPUT
    | request::ENERGY
    | request::FREEZE_STATE;

/// What was checked.
pub(super) struct Checked<'a> {
    pub(super) facet: &'static Descriptor,
    pub(super) edge: Option<&'static Descriptor>,
    pub(super) vertex: Option<&'static Descriptor>,
    pub(super) slaves: usize,
    pub(super) masters: usize,
    pub(super) connectivity: &'a [i32],
    pub(super) corners: Corners,
    /// The facet's node at each corner.
    pub(super) at_corners: [usize; MOST_CORNERS],
    pub(super) reach: f64,
    /// How far facets reach beyond their nodes. [eq:spread]
    pub(super) spread: f64,
    /// Nodes of the whole patch, slave points first.
    pub(super) nodes: Option<Nodes<'a>>,
    /// Laws, r0, orientation, and a weight per master node where the facet is rational.
    pub(super) values: &'a [f64],
    /// Accepted history.
    pub(super) history: Option<&'a [Cell<f64>]>,
}

impl<'a> Checked<'a> {
    /// Checks elements and connectivity.
    ///
    /// # Safety
    /// The pointers of `patch` are valid for the shapes that the header gives, or null.
    pub(super) unsafe fn new(patch: &Patch) -> Result<Self, Fault> {
        let count = |value: i32, name: i32| match usize::try_from(value) {
            Ok(value) if value > 0 => Ok(value),
            _ => Err((code::NODE_COUNT, name, 0)),
        };
        let slaves = count(patch.slave_points, argument::NSLAVE)?;
        let masters = count(patch.master_nodes, argument::NNODE)?;
        let facets = count(patch.facets, argument::FACETS)?;
        // by its bits: a comparison with a signalling NaN would raise an exception
        if !is_usable(patch.reach) || patch.reach.to_bits() > (1 << 63) {
            return Err((code::NOT_FINITE, argument::REACH, 0));
        }
        // SAFETY: promised by the caller; elements are static.
        let (facet, edge, vertex) = unsafe {
            (
                patch.facet.as_ref(),
                patch.edge.as_ref(),
                patch.vertex.as_ref(),
            )
        };
        let facet = facet.ok_or((code::NULL, argument::FACET, 0))?;
        let refused = (code::ELEMENT, argument::FACET, 0);
        let corners = facet_corners(facet).ok_or(refused)?;
        let at_corners = boundary::nodes_of_corners(facet, &corners).ok_or(refused)?;
        check_lower(facet, &corners, (edge, vertex))?;
        if (slaves + masters).saturating_mul(facet.dimension) > MOST_UNKNOWNS {
            return Err((code::NODE_COUNT, argument::NNODE, 0));
        }
        if i32::try_from(slaves.saturating_mul(HISTORY)).is_err() {
            return Err((code::NODE_COUNT, argument::NSLAVE, 0));
        }
        if patch.connectivity.is_null() {
            return Err((code::NULL, argument::CONNECTIVITY, 0));
        }
        let entries = facets * facet.master_nodes;
        // SAFETY: promised by the caller: one entry for every node of every facet.
        let connectivity = unsafe { core::slice::from_raw_parts(patch.connectivity, entries) };
        let exists = |&node: &i32| usize::try_from(node).is_ok_and(|node| node < masters);
        if let Some(entry) = connectivity.iter().position(|node| !exists(node)) {
            return Err((code::INDEX, argument::CONNECTIVITY, entry));
        }
        Ok(Self {
            facet,
            edge,
            vertex,
            slaves,
            masters,
            connectivity,
            corners,
            at_corners,
            reach: patch.reach,
            spread: f64::INFINITY,
            nodes: None,
            values: &[],
            history: None,
        })
    }

    /// Checks the arguments of an evaluation.
    ///
    /// # Safety
    /// The pointers of `arguments` are valid for the shapes that the header gives, or null.
    pub(super) unsafe fn with(mut self, arguments: &Arguments) -> Result<Self, Fault> {
        let refused = arguments.request & !self.requests();
        if refused != 0 {
            let bit = refused.trailing_zeros() as usize;
            return Err((code::REQUEST, argument::REQUEST, bit));
        }
        if arguments.request & request::FREEZE_STATE != 0 && arguments.history_accepted.is_null() {
            return Err((code::NULL, argument::HISTORY_ACCEPTED, 0));
        }
        if arguments.x.is_null() {
            return Err((code::NULL, argument::X, 0));
        }
        if arguments.parameters.is_null() {
            return Err((code::NULL, argument::PARAMETERS, 0));
        }
        let n = self.nodes();
        match usize::try_from(arguments.nnode) {
            Ok(given) if given == 0 || given == n => {}
            _ => return Err((code::NODE_COUNT, argument::NNODE, 0)),
        }
        let given = usize::try_from(arguments.parameter_count).unwrap_or(0);
        // SAFETY: promised by the caller.
        unsafe {
            self.nodes = Some(nodes(self.facet, arguments, n)?);
            let count = given.min(self.parameters());
            self.values = core::slice::from_raw_parts(arguments.parameters, count);
            self.history = (!arguments.history_accepted.is_null()).then(|| {
                // Cell<f64> has the layout of f64
                core::slice::from_raw_parts(
                    arguments.history_accepted.cast(),
                    self.slaves * HISTORY,
                )
            });
        }
        self.check_values()?;
        self.check_positions()?;
        self.check_history()?;
        self.spread = self.spread_of_facets();
        Ok(self)
    }

    /// Of one facet, which is searched anyway, and of facets with tangent vectors nothing is known.
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
    pub(super) fn nodes(&self) -> usize {
        self.slaves + self.masters
    }

    pub(super) fn unknowns(&self) -> usize {
        self.nodes() * self.facet.dimension
    }

    /// Laws, r0, orientation; then a weight per master node of rational facets.
    pub(super) fn parameters(&self) -> usize {
        let layout = &self.facet.layout;
        let is_rational = layout.slave_weights > layout.master_weights;
        layout.master_weights + if is_rational { self.masters } else { 0 }
    }

    pub(super) fn requests(&self) -> u32 {
        let all = [Some(self.facet), self.edge, self.vertex];
        let offered = all.into_iter().flatten().map(Descriptor::requests);
        offered.fold(REQUESTS, |bits, own| bits & own)
    }

    /// Hash over all formulations.
    pub(super) fn formulation(&self) -> u64 {
        let all = [Some(self.facet), self.edge, self.vertex];
        let own = all.map(|element| element.map_or(0, |element| element.formulation));
        own.iter()
            .fold(0, |hash: u64, own| hash.rotate_left(21) ^ own)
    }

    /// Number of facets.
    pub(super) fn facets(&self) -> usize {
        let nodes = self.facet.master_nodes.max(1);
        self.connectivity.len().checked_div(nodes).unwrap_or(0)
    }

    /// Master nodes of a facet.
    pub(super) fn of_facet(&self, facet: usize) -> &[i32] {
        let nodes = self.facet.master_nodes;
        let list = self.connectivity.get(facet * nodes..).unwrap_or(&[]);
        list.get(..nodes).unwrap_or(&[])
    }

    fn check_values(&self) -> Result<(), Fault> {
        let weights = self.facet.layout.master_weights;
        let bounds = |entry: usize| self.facet.parameters.get(entry.min(weights));
        for entry in 0..self.parameters() {
            let (Some(&value), Some(bounds)) = (self.values.get(entry), bounds(entry)) else {
                return Err((code::PARAMETER, argument::PARAMETERS, entry));
            };
            if !is_usable(value) {
                return Err((code::NOT_FINITE, argument::PARAMETERS, entry));
            }
            if !bounds.allows(value) {
                return Err((code::PARAMETER, argument::PARAMETERS, entry));
            }
        }
        Ok(())
    }

    fn check_positions(&self) -> Result<(), Fault> {
        let Some(nodes) = &self.nodes else {
            return Ok(());
        };
        for node in 0..self.nodes() {
            for k in 0..self.facet.dimension {
                if !is_usable(nodes.x.entry(Some(node), k)) {
                    return Err((code::NOT_FINITE, argument::X, node));
                }
                if nodes.u.is_some_and(|u| !is_usable(u.entry(Some(node), k))) {
                    return Err((code::NOT_FINITE, argument::U, node));
                }
            }
        }
        Ok(())
    }

    fn check_history(&self) -> Result<(), Fault> {
        let entries = self.history.unwrap_or(&[]);
        for (at, entry) in entries.iter().enumerate() {
            let value = entry.get();
            if !is_usable(value) {
                return Err((code::NOT_FINITE, argument::HISTORY_ACCEPTED, at));
            }
            let is_possible = match at.checked_rem(HISTORY) {
                Some(0) => is_status(value),
                Some(1) => value >= 0.0 && value <= self.facets() as f64,
                _ => true,
            };
            if !is_possible {
                return Err((code::HISTORY, argument::HISTORY_ACCEPTED, at));
            }
        }
        Ok(())
    }

    /// An entry of the accepted history of a slave point.
    pub(super) fn remembered(&self, slave: usize, entry: usize) -> Option<f64> {
        let history = self.history?;
        history.get(slave * HISTORY + entry).map(Cell::get)
    }
}

/// One slave point, penalty, no friction.
fn is_plain(element: &Descriptor) -> bool {
    matches!(element.slave, SlaveDescription::Point)
        && element.enforcement == Enforcement::Penalty
        && !element.friction
        && boundary::fits(element)
}

/// Corners of a facet that can be one.
fn facet_corners(facet: &Descriptor) -> Option<Corners> {
    let [domain, _] = &facet.domains;
    (is_plain(facet) && boundary::shape(facet).is_some())
        .then(|| Corners::new(domain))
        .flatten()
}

/// The lower pairs: of the same law, with a side where the facet has two, of the facet's own edges.
fn check_lower(
    facet: &Descriptor,
    corners: &Corners,
    (edge, vertex): (Option<&Descriptor>, Option<&Descriptor>),
) -> Result<(), Fault> {
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
        let refused = Err((code::ELEMENT, argument::EDGE, 0));
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
            return Err((code::ELEMENT, argument::VERTEX, 0));
        }
    }
    Ok(())
}

/// Node numbers of a pair: one slave point and master nodes.
pub(super) type List = [i32; 1 + MOST_NODES];
