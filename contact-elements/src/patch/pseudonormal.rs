//! On which side of the patch a point near an edge or vertex lies. [eq:pseudonormal]

use super::boundary::Feature;
use super::checked::Checked;
use super::closest_place::ClosestPlace;
use super::values::{Values, gather};
use crate::arithmetic::{atan2, divisor, sqrt};
use crate::error::Error;
use crate::point::values::dot;

type Vector = [f64; 3];

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// +1 outside, −1 inside, by the sum of the normals of the facets that meet in the feature, each times its angle.
/// +1 at the rim, and where facets have no sides.
pub(crate) fn side(
    checked: &Checked<'_>,
    slave: usize,
    place: &ClosestPlace,
) -> Result<f64, Error> {
    if checked.facet.layout.orientation.is_none() {
        return Ok(1.0);
    }
    let around = match Feature::new(place.feature) {
        Feature::Inside => None,
        Feature::Edge(k) => Around::edge(checked, slave, place, k)?,
        Feature::Vertex(k) => Around::vertex(checked, slave, place, k)?,
    };
    let Some(normal) = around else {
        return Ok(1.0);
    };
    let (r, _) = relative(checked, slave, place.facet, place.zeta)?;
    let at = checked.facet.layout.orientation.unwrap_or(0);
    let flips = checked.values.get(at).is_some_and(|&value| value < 0.0);
    let is_outside = (dot(&r, &normal) >= 0.0) != flips;
    Ok(if is_outside { 1.0 } else { -1.0 })
}

/// r and r_,i of a slave point and a place on a facet.
pub(crate) fn relative(
    checked: &Checked<'_>,
    slave: usize,
    facet: usize,
    zeta: [f64; 2],
) -> Result<(Vector, [Vector; 2]), Error> {
    let values = Values::of_facet(checked, facet);
    let gathered = gather(checked, slave, facet, &values)?;
    let sides = gathered.sides(0);
    Ok(sides.map_or_else(Default::default, |sides| sides.relative_at(&zeta)))
}

/// The facets that meet in an edge or vertex.
struct Around;

impl Around {
    /// The sum of both normals; `None` at the rim.
    fn edge(
        checked: &Checked<'_>,
        slave: usize,
        place: &ClosestPlace,
        k: usize,
    ) -> Result<Option<Vector>, Error> {
        let [from, to] = ends(checked, place.facet, k);
        let part = checked.corners.part(k, place.zeta);
        let mut sum = normal(checked, slave, place.facet, place.zeta)?.0;
        let mut is_rim = true;
        for facet in 0..checked.facets() {
            for k in 0..checked.corners.count {
                if ends(checked, facet, k) == [to, from] {
                    let zeta = checked.corners.on_edge(k, 1.0 - part);
                    sum = plus(sum, normal(checked, slave, facet, zeta)?.0, 1.0);
                    is_rim = false;
                }
            }
        }
        Ok((!is_rim).then_some(sum))
    }

    /// The sum of all normals times the angles of the facets; `None` at the rim.
    fn vertex(
        checked: &Checked<'_>,
        slave: usize,
        place: &ClosestPlace,
        k: usize,
    ) -> Result<Option<Vector>, Error> {
        let vertex = corner(checked, place.facet, k);
        let mut sum = [0.0; 3];
        for facet in 0..checked.facets() {
            for k in 0..checked.corners.count {
                if corner(checked, facet, k) != vertex {
                    continue;
                }
                if !goes_on(checked, facet, k) {
                    return Ok(None);
                }
                let zeta = checked.corners.at(k);
                let (normal, tangents) = normal(checked, slave, facet, zeta)?;
                sum = plus(sum, normal, angle(checked, k, tangents));
            }
        }
        Ok(Some(sum))
    }
}

/// Master nodes at the ends of edge `k` of a facet.
fn ends(checked: &Checked<'_>, facet: usize, k: usize) -> [i32; 2] {
    [corner(checked, facet, k), corner(checked, facet, k + 1)]
}

/// Master node at corner `k`, counted round.
fn corner(checked: &Checked<'_>, facet: usize, k: usize) -> i32 {
    let count = checked.corners.count;
    let k = if k >= count { k - count } else { k };
    let node = checked.at_corners.get(k).copied().unwrap_or(0);
    let nodes = checked.of_facet(facet);
    nodes.get(node).copied().unwrap_or(-1)
}

/// True where the patch continues beyond both edges of a facet at its corner `k`; for curves beyond that end.
fn goes_on(checked: &Checked<'_>, facet: usize, k: usize) -> bool {
    let count = checked.corners.count;
    if checked.facet.projected == 1 {
        let (own, other) = (corner(checked, facet, k), 1 - k.min(1));
        return (0..checked.facets()).any(|facet| corner(checked, facet, other) == own);
    }
    let before = if k == 0 { count - 1 } else { k - 1 };
    [k, before].into_iter().all(|edge| {
        let [from, to] = ends(checked, facet, edge);
        (0..checked.facets())
            .any(|facet| (0..count).any(|edge| ends(checked, facet, edge) == [to, from]))
    })
}

/// Unit normal of a facet and its tangents.
fn normal(
    checked: &Checked<'_>,
    slave: usize,
    facet: usize,
    zeta: [f64; 2],
) -> Result<(Vector, [Vector; 2]), Error> {
    let (_, [first, second]) = relative(checked, slave, facet, zeta)?;
    let normal = if checked.facet.dimension == 2 {
        [first[1], -first[0], 0.0]
    } else {
        cross(first, second)
    };
    let length = divisor(sqrt(dot(&normal, &normal)));
    Ok((normal.map(|value| value / length), [first, second]))
}

/// Angle of a facet at its corner `k`; 1 for curves.
fn angle(checked: &Checked<'_>, k: usize, [first, second]: [Vector; 2]) -> f64 {
    if checked.facet.projected == 1 {
        return 1.0;
    }
    let corners = &checked.corners;
    let here = corners.at(k);
    let towards = |other: [f64; 2]| -> Vector {
        core::array::from_fn(|i| (other[0] - here[0]) * first[i] + (other[1] - here[1]) * second[i])
    };
    let before = if k == 0 { corners.count - 1 } else { k - 1 };
    let (a, b) = (towards(corners.at(k + 1)), towards(corners.at(before)));
    let across = cross(a, b);
    atan2(sqrt(dot(&across, &across)), dot(&a, &b))
}

fn plus(a: Vector, b: Vector, factor: f64) -> Vector {
    core::array::from_fn(|k| a[k] + factor * b[k])
}
