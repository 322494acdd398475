//! Where a slave point is closest to the patch.

use super::super::sides::Gathered;
use super::super::sizes::Fault;
use super::super::{Descriptor, argument, code};
use super::boundary::{Feature, MOST_NODES};
use super::checked::{Checked, List};
use crate::arithmetic::sqrt;
use crate::runtime::{Nodes, Status, dot};
use crate::search::{Verdict, closest};

/// Distances that differ by less than this part are the same.
const SAME: f64 = 1e-10;
/// How far beyond the best another facet is still looked at.
const MARGIN: f64 = 1.0 + 1e-9;
/// A reach of zero would be none.
const LEAST_REACH: f64 = 1e-150;

/// The closest point of the patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) facet: usize,
    /// 0, 1 + edge, 5 + vertex.
    pub(super) feature: u8,
    pub(super) zeta: [f64; 2],
}

/// What can go wrong.
pub(super) enum Error {
    Fault(Fault),
    Status(Status),
}

/// Parameters of a facet: the patch's, with the weights of its own nodes.
pub(super) struct Values {
    list: [f64; Self::MOST],
    count: usize,
}

impl Values {
    const MOST: usize = 64;

    /// Of a facet's nodes.
    pub(super) fn of_facet(checked: &Checked<'_>, facet: usize) -> Self {
        let layout = &checked.facet.layout;
        let mut values = Self {
            list: [0.0; Self::MOST],
            count: checked.facet.parameters.len().min(Self::MOST),
        };
        let own = checked.values.iter().take(layout.master_weights);
        for (to, &value) in values.list.iter_mut().zip(own) {
            *to = value;
        }
        let weights = values.list.iter_mut().skip(layout.master_weights);
        for (to, &node) in weights.zip(checked.of_facet(facet)) {
            *to = checked.weight(node);
        }
        values
    }

    /// Turns the facet's parameters into those of an edge or vertex: its side, and the weights of its own nodes.
    pub(super) fn make_lower(
        &mut self,
        checked: &Checked<'_>,
        lower: &Descriptor,
        side: f64,
        nodes: impl Iterator<Item = i32>,
    ) {
        let layout = &lower.layout;
        let r0 = checked.values.get(checked.facet.layout.r0);
        if let (Some(to), Some(&r0)) = (self.list.get_mut(layout.r0), r0) {
            *to = r0;
        }
        if let Some(to) = layout.orientation.and_then(|at| self.list.get_mut(at)) {
            *to = side;
        }
        let weights = self.list.iter_mut().skip(layout.master_weights);
        for (to, node) in weights.zip(nodes) {
            *to = checked.weight(node);
        }
        self.count = lower.parameters.len().min(Self::MOST);
    }

    pub(super) fn slice(&self) -> &[f64] {
        self.list.get(..self.count).unwrap_or(&[])
    }
}

impl Checked<'_> {
    /// Weight of a master node; 1 where facets are not rational.
    pub(super) fn weight(&self, node: i32) -> f64 {
        let at = self.facet.layout.master_weights + usize::try_from(node).unwrap_or(0);
        self.values.get(at).copied().unwrap_or(1.0)
    }

    /// A slave point and master nodes as node numbers of the patch.
    pub(super) fn list(&self, slave: usize, masters: impl Iterator<Item = i32>) -> List {
        let mut list = [0; 1 + MOST_NODES];
        list[0] = slave as i32;
        for (to, node) in list.iter_mut().skip(1).zip(masters) {
            *to = self.slaves as i32 + node;
        }
        list
    }

    /// A slave point and a facet, for the search.
    pub(super) fn gather<'g>(
        &'g self,
        slave: usize,
        facet: usize,
        values: &'g Values,
    ) -> Result<Gathered<'g>, Fault> {
        let missing = (code::NULL, argument::X, 0);
        let list = self.list(slave, self.of_facet(facet).iter().copied());
        let count = 1 + self.facet.master_nodes;
        let nodes = Nodes {
            connectivity: list.get(..count),
            count,
            ..self.nodes.ok_or(missing)?
        };
        Gathered::new(self.facet, &nodes, values.slice(), &[])
    }
}

/// The closest point of all facets: of equally near ones inside before edge before vertex,
/// then that of the history's facet, then the first. Nothing within the reach: none.
pub(super) fn find(checked: &Checked<'_>, slave: usize) -> Result<Option<Place>, Error> {
    let remembered = checked.remembered(slave, 1).unwrap_or(0.0) as usize;
    let remembered = remembered.checked_sub(1);
    let begin = match remembered {
        Some(facet) => Some(facet),
        None => nearest(checked, slave)?,
    };
    let others = (0..checked.facets()).filter(|&facet| Some(facet) != begin);
    let mut best: Option<(Place, f64)> = None;
    for facet in begin.into_iter().chain(others) {
        let reach = match &best {
            Some((_, distance)) => (distance * MARGIN).max(LEAST_REACH),
            None => checked.reach,
        };
        let Some((place, distance)) = on_facet(checked, slave, facet, reach)? else {
            continue;
        };
        let is_better = best.is_none_or(|(old, least)| {
            // the foot on an edge differs from its vertex by the root of what the distances do
            let (free, before) = (freedom(place.feature), freedom(old.feature));
            let is_earlier = remembered.is_none() && facet < old.facet && free == before;
            let is_preferred = free > before || is_earlier;
            distance < least * (1.0 - SAME) || (is_preferred && distance <= least * (1.0 + SAME))
        });
        if is_better {
            best = Some((place, distance));
        }
    }
    Ok(best.map(|(place, _)| place))
}

/// The facet with the nearest middle, where the search begins without a history.
fn nearest(checked: &Checked<'_>, slave: usize) -> Result<Option<usize>, Error> {
    let mut best = None;
    if checked.spread == f64::INFINITY {
        return Ok(best.map(|(facet, _)| facet));
    }
    for facet in 0..checked.facets() {
        let values = Values::of_facet(checked, facet);
        let gathered = checked
            .gather(slave, facet, &values)
            .map_err(Error::Fault)?;
        let (middle, _) = gathered.surroundings();
        let square = dot(&middle, &middle);
        if best.is_none_or(|(_, least)| square < least) {
            best = Some((facet, square));
        }
    }
    Ok(best.map(|(facet, _)| facet))
}

/// Parameters in which a closest point is free: 2 inside a facet, 1 on an edge, 0 in a vertex.
fn freedom(feature: u8) -> u8 {
    match Feature::new(feature) {
        Feature::Inside => 2,
        Feature::Edge(_) => 1,
        Feature::Vertex(_) => 0,
    }
}

/// The closest point of one facet and its distance; none beyond the reach.
fn on_facet(
    checked: &Checked<'_>,
    slave: usize,
    facet: usize,
    reach: f64,
) -> Result<Option<(Place, f64)>, Error> {
    let values = Values::of_facet(checked, facet);
    let gathered = checked
        .gather(slave, facet, &values)
        .map_err(Error::Fault)?;
    let element = checked.facet;
    if reach > 0.0 && checked.spread < f64::INFINITY {
        let (middle, away) = gathered.surroundings();
        if sqrt(dot(&middle, &middle)) - checked.spread * away > reach * MARGIN {
            return Ok(None);
        }
    }
    let found = gathered
        .sides(0)
        .and_then(|sides| closest(&sides, &element.domains, &element.periods, reach))
        .ok_or(Error::Fault((code::ELEMENT, argument::FACET, 0)))?;
    match found.verdict {
        Verdict::Beyond => Ok(None),
        Verdict::Undecided => Err(Error::Status(Status::NotConverged)),
        Verdict::Inside | Verdict::Boundary | Verdict::NotUnique => {
            let place = Place {
                facet,
                feature: found.feature,
                zeta: found.zeta,
            };
            Ok(Some((place, found.distance)))
        }
    }
}
