//! The closest point over a whole domain, and the one that a geometry declares.

use super::boxes::Search;
use super::closest::{Closest, Verdict};
use super::descent::{REGULAR, definiteness, square};
use super::pair::Sides;
use super::region::Region;
use crate::arithmetic::sqrt;
use crate::point::domain::Domain;

/// The closest points of two sides over their domains. Nothing beyond `reach` is searched; 0 means no limit.
/// `None` if a geometry has too many nodes or operations.
pub(crate) fn closest(
    sides: &Sides<'_>,
    domains: &[Domain; 2],
    periods: &[f64; 2],
    reach: f64,
) -> Option<Closest> {
    if !sides.fit() {
        return None;
    }
    let region = Region::new(sides, domains, periods);
    Some(Search::new(sides, region, reach).run())
}

/// The closest point that a geometry declares.
pub(crate) fn declared(sides: &Sides<'_>, zeta: [f64; 2], reach: f64) -> Option<Closest> {
    let local = sides.fit().then(|| sides.at(&zeta))?;
    let distance = sqrt(square(&local.r));
    let definiteness = definiteness(&local, sides.parameters());
    let verdict = if reach > 0.0 && distance > reach {
        Verdict::Beyond
    } else if definiteness > REGULAR {
        Verdict::Inside
    } else {
        Verdict::NotUnique
    };
    Some(Closest {
        verdict,
        zeta,
        distance,
        feature: 0,
        definiteness,
        boxes: 0,
        steps: 0,
    })
}
