//! Where a slave point is closest to the patch.

use super::boundary::Feature;
use super::checked::Checked;
use super::values::{Values, gather};
use crate::arithmetic::sqrt;
use crate::codes::{argument, code};
use crate::error::Error;
use crate::point::values::{Status, dot};
use crate::search::{Verdict, closest};

/// Distances that differ by less than this part are the same.
const SAME: f64 = 1e-10;
/// How far beyond the best distance another facet is still searched.
const MARGIN: f64 = 1.0 + 1e-9;
/// Smallest reach: zero would mean "no limit".
const LEAST_REACH: f64 = 1e-150;

/// The closest point of the patch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClosestPlace {
    pub(crate) facet: usize,
    /// 0, 1 + edge, 5 + vertex.
    pub(crate) feature: u8,
    pub(crate) zeta: [f64; 2],
}

/// The closest point of all facets: of equally near ones inside before edge before vertex,
/// then that of the history's facet, then the first. `None` where nothing is within the reach.
pub(crate) fn find(checked: &Checked<'_>, slave: usize) -> Result<Option<ClosestPlace>, Error> {
    let remembered = checked.remembered(slave, 1).unwrap_or(0.0) as usize;
    let remembered = remembered.checked_sub(1);
    let begin = match remembered {
        Some(facet) => Some(facet),
        None => nearest(checked, slave)?,
    };
    let others = (0..checked.facets()).filter(|&facet| Some(facet) != begin);
    let mut best: Option<(ClosestPlace, f64)> = None;
    for facet in begin.into_iter().chain(others) {
        let reach = match &best {
            Some((_, distance)) => (distance * MARGIN).max(LEAST_REACH),
            None => checked.reach,
        };
        let Some((place, distance)) = on_facet(checked, slave, facet, reach)? else {
            continue;
        };
        let is_better = best.is_none_or(|(old, least)| {
            // close to a vertex a foot is only as accurate as the square root of the accuracy of its distance
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
        let gathered = gather(checked, slave, facet, &values)?;
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

/// The closest point of one facet and its distance; `None` beyond the reach.
fn on_facet(
    checked: &Checked<'_>,
    slave: usize,
    facet: usize,
    reach: f64,
) -> Result<Option<(ClosestPlace, f64)>, Error> {
    let values = Values::of_facet(checked, facet);
    let gathered = gather(checked, slave, facet, &values)?;
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
        .ok_or(Error::new(code::ELEMENT, argument::FACET, 0))?;
    match found.verdict {
        Verdict::Beyond => Ok(None),
        Verdict::Undecided => Err(Error::cut_back(Status::NotConverged, argument::X, slave)),
        Verdict::Inside | Verdict::Boundary | Verdict::NotUnique => {
            let place = ClosestPlace {
                facet,
                feature: found.feature,
                zeta: found.zeta,
            };
            Ok(Some((place, found.distance)))
        }
    }
}
