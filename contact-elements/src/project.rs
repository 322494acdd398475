//! Global projection of an element's contact points: no start is needed. [eq:global-projection]

use crate::arithmetic::is_usable;
use crate::codes::{argument, code};
use crate::descriptor::Descriptor;
use crate::element::gather::{Coordinates, Nodes};
use crate::error::Error;
use crate::evaluation::inputs::{check_parameters, check_reach, node_counts};
use crate::search::{Closest, Gathered, closest, declared};

/// Inputs of a global projection.
#[derive(Clone, Copy, Debug, Default)]
pub struct Query<'a> {
    /// Reference coordinates \[nodes · dimension\], length.
    pub x: &'a [f64],
    /// Displacements \[nodes · dimension\], length; empty for zero.
    pub u: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// Interpolated slaves: shape row and weight.
    pub slave_row: &'a [f64],
    /// Reach of the search, length; 0 means no limit.
    pub reach: f64,
}

/// Finds the closest point of every contact point over the whole domain of the master, without a start.
///
/// `results` has one entry per contact point. `history` is empty or has room for the element's history: it becomes an
/// initial history that begins at the closest points.
///
/// # Errors
/// The error names the argument: [`NULL`](crate::code::NULL) for a slice that is missing or too short,
/// [`PARAMETER`](crate::code::PARAMETER), [`NOT_FINITE`](crate::code::NOT_FINITE),
/// [`NODE_COUNT`](crate::code::NODE_COUNT) for an interpolated slave without a row,
/// [`ELEMENT`](crate::code::ELEMENT) for a geometry with too many nodes or operations.
///
/// # Examples
/// ```
/// use contact_elements::{Closest, Query, Verdict, project};
/// # mod pairs {
/// #     contact_elements::contact_elements! {
/// #         /// A point and a bilinear facet.
/// #         element PointQuad4 { slave: point; master: Quad4; normal: Penalty; }
/// #     }
/// # }
/// # use pairs::PointQuad4;
/// // the slave point, 0.05 below the facet, and the corners of the facet
/// let x = [
///     0.2, -0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0,
/// ];
/// let query = Query { x: &x, parameters: &[1000.0, 0.0, 1.0], ..Query::default() };
/// let (mut found, mut history) = ([Closest::default()], [0.0; 3]);
/// project(PointQuad4::DESCRIPTOR, &query, &mut found, &mut history)?;
/// assert_eq!(found[0].verdict, Verdict::Inside);
/// assert!((found[0].distance - 0.05).abs() < 1e-12);
/// assert!((found[0].zeta[0] - 0.2).abs() < 1e-12 && history[1] == found[0].zeta[0]);
/// # Ok::<(), contact_elements::Error>(())
/// ```
pub fn project(
    element: &Descriptor,
    query: &Query<'_>,
    results: &mut [Closest],
    history: &mut [f64],
) -> Result<(), Error> {
    let nslave = if element.interpolated {
        query.slave_row.len().saturating_sub(1)
    } else {
        element.slave_nodes
    };
    let n = element.nodes(nslave);
    let coordinates = n * element.dimension;
    let lengths = [
        (query.x.len(), coordinates, argument::X),
        (results.len(), element.points, argument::RESULT),
    ];
    let optional = [
        (query.u.len(), coordinates, argument::U),
        (history.len(), element.history(), argument::HISTORY_TRIAL),
    ];
    let given = optional.into_iter().filter(|(length, ..)| *length > 0);
    for (length, least, name) in lengths.into_iter().chain(given) {
        if length < least {
            return Err(Error::missing(name));
        }
    }
    check_reach(query.reach)?;
    node_counts(element, 0, i32::try_from(nslave).unwrap_or(i32::MAX))?;
    check_parameters(element, query.parameters)?;
    let nodes = Nodes {
        x: Coordinates::one_by_one(query.x, element.dimension),
        u: (!query.u.is_empty()).then(|| Coordinates::one_by_one(query.u, element.dimension)),
        connectivity: None,
        count: n,
    };
    let row = if element.interpolated {
        query.slave_row
    } else {
        &[]
    };
    let gathered = gather(element, &nodes, query.parameters, row)?;
    let size = element.point_history();
    for (number, result) in results.iter_mut().enumerate().take(element.points) {
        *result = closest_of(element, &gathered, number, query.reach)?;
        let own = history.get_mut(number * size..).unwrap_or_default();
        start(element, result, own.get_mut(..size).unwrap_or_default());
    }
    Ok(())
}

/// Both sides of all contact points; the weight of an interpolated slave is checked with its row.
pub(crate) fn gather<'a>(
    element: &'a Descriptor,
    nodes: &Nodes<'_>,
    parameters: &'a [f64],
    row: &[f64],
) -> Result<Gathered<'a>, Error> {
    if let Some((entry, weight)) = row.iter().enumerate().next_back()
        && !is_usable(*weight)
    {
        return Err(Error::new(code::NOT_FINITE, argument::SLAVE_ROW, entry));
    }
    Gathered::new(element, nodes, parameters, row)
}

/// The closest point of a contact point.
pub(crate) fn closest_of(
    element: &Descriptor,
    gathered: &Gathered<'_>,
    number: usize,
    reach: f64,
) -> Result<Closest, Error> {
    let refused = Error::new(code::ELEMENT, argument::ELEMENT, 0);
    let sides = gathered.sides(number).ok_or(refused)?;
    if element.projected == 0 {
        return Ok(Closest::NOTHING_PROJECTED);
    }
    let [domain, _] = &element.domains;
    let zeta = gathered.declared(&sides);
    let found = match zeta.filter(|&zeta| domain.feature(zeta, 0.0) == 0) {
        Some(zeta) => declared(&sides, zeta, reach),
        // beyond the domain the declared point has no meaning
        None => closest(&sides, &element.domains, &element.periods, reach),
    };
    found.ok_or(refused)
}

/// Makes `entries` the initial history of a point at its closest point.
pub(crate) fn start(element: &Descriptor, closest: &Closest, entries: &mut [f64]) {
    // a foot so far away that no evaluation accepts it is not used as start
    let zeta = core::array::from_fn(|i| {
        let (zeta, centre) = (closest.zeta.get(i), element.centre.get(i));
        let zeta = zeta.filter(|&&zeta| element.reach().can_be_projection(i, zeta));
        zeta.or(centre).copied().unwrap_or(0.0)
    });
    element.history_layout().begin(zeta, entries);
}
