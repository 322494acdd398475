//! Global closest point: the least of ½ r·r over the whole domain, found without a start and certified.
//! [eq:global-projection]
//!
//! Boxes of parameters are dropped where the distance, bounded by interval arithmetic over the tables of the
//! geometries, is larger than one already found, or where it falls towards another box. Where F is positive definite over a
//! box it has one minimum, which Newton's method finds. What is left at the end is the closest point, with proof.

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

mod boxes;
mod descent;
mod enclosure;
mod interval;
mod region;
mod sides;
mod spread;

pub(crate) use sides::{Side, Sides};
pub(crate) use spread::spread;

use crate::runtime::Domain;
use boxes::Search;
use region::Region;

/// What the search found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// One closest point, inside the domain or free on its boundary.
    Inside,
    /// One closest point, held by the boundary.
    Boundary,
    /// Two closest points at least, or a foot where F is not positive definite.
    NotUnique,
    /// Nothing within the reach.
    Beyond,
    /// The most boxes did not suffice.
    Undecided,
}

/// The closest point.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    /// What is known of it.
    pub verdict: Verdict,
    /// Parameters.
    pub zeta: [f64; 2],
    /// |r| [length]
    pub distance: f64,
    /// 0, or the feature that holds it.
    pub feature: u8,
    /// Least eigenvalue of a⁻¹F at the foot: positive inside the domain where the projection exists and is
    /// unique nearby. [eq:admissible]
    pub definiteness: f64,
    /// Boxes looked at.
    pub boxes: u32,
    /// Newton steps, all together.
    pub steps: u32,
}

impl Closest {
    /// Of a point or a distance function as master.
    pub(crate) const NOTHING_PROJECTED: Self = Self {
        verdict: Verdict::Inside,
        zeta: [0.0; 2],
        distance: 0.0,
        feature: 0,
        definiteness: 1.0,
        boxes: 0,
        steps: 0,
    };

    /// The closest point that a geometry declares.
    pub(crate) fn at(sides: &Sides<'_>, zeta: [f64; 2], reach: f64) -> Option<Self> {
        let local = sides.fit().then(|| sides.at(&zeta))?;
        let distance = crate::arithmetic::sqrt(descent::square(&local.r));
        let definiteness = descent::definiteness(&local, sides.parameters());
        let verdict = if reach > 0.0 && distance > reach {
            Verdict::Beyond
        } else if definiteness > boxes::REGULAR {
            Verdict::Inside
        } else {
            Verdict::NotUnique
        };
        Some(Self {
            verdict,
            zeta,
            distance,
            feature: 0,
            definiteness,
            boxes: 0,
            steps: 0,
        })
    }
}

/// Most boxes looked at.
pub const MOST_BOXES: u32 = 20_000;

/// The closest points of two sides over their domains. `reach`: nothing farther is looked for; 0: no limit.
/// None where a geometry has too many nodes or operations.
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
