//! Domains: their names, their bounds, and points inside them.

use super::types::Domain;
use crate::diagnostics::{Mistakes, geometry as messages, list, names, short, suggest::nearest};
use crate::syntax::{self, GeometryItem, GeometryKind};

/// Domains of curves and of surfaces, as messages list them.
const CURVES: [&str; 3] = ["line", "unit_line", "interval"];
const SURFACES: [&str; 4] = ["square", "unit_square", "triangle", "rectangle"];

/// The domain of a geometry; `None` after a mistake.
pub(super) fn domain(item: &GeometryItem, mistakes: &mut Mistakes) -> Option<Domain> {
    let Some(written) = &item.domain else {
        return missing(item, mistakes);
    };
    if item.kind == GeometryKind::Distance {
        mistakes.report(written.name.span(), messages::domain_of_distance());
        return None;
    }
    let is_curve = matches!(item.kind, GeometryKind::Curve | GeometryKind::RigidCurve);
    let domain = named(written, is_curve, item.kind.describe(), mistakes)?;
    let is_shape = matches!(item.kind, GeometryKind::Curve | GeometryKind::Surface);
    if is_shape
        && let Some(bound) = written
            .bounds
            .iter()
            .find(|bound| bound.value.is_infinite())
    {
        mistakes.report(bound.span, messages::infinite_domain());
        return None;
    }
    Some(domain)
}

fn missing(item: &GeometryItem, mistakes: &mut Mistakes) -> Option<Domain> {
    let example = match item.kind {
        GeometryKind::Curve => "`in line`, `in unit_line` or `in interval(a, b)`",
        GeometryKind::Surface => "`in square`, `in unit_square` or `in triangle`",
        _ => return Some(Domain::Unbounded),
    };
    mistakes.report(
        item.name.span(),
        messages::missing_domain(item.kind.describe(), example),
    );
    None
}

/// The domain of that name, if it is one of the right kind with the right number of bounds.
fn named(
    written: &syntax::Domain,
    is_curve: bool,
    kind: &str,
    mistakes: &mut Mistakes,
) -> Option<Domain> {
    let text = written.name.to_string();
    let (own, other) = if is_curve {
        (&CURVES[..], &SURFACES[..])
    } else {
        (&SURFACES[..], &CURVES[..])
    };
    if !own.contains(&text.as_str()) {
        let all = format!("a {kind} lies in {}", list(own, "or"));
        let message = match nearest(&text, own.iter().copied()) {
            _ if other.contains(&text.as_str()) => messages::wrong_domain(&text, kind, all),
            Some(near) => messages::unknown_domain(&text, format!("did you mean `{near}`?")),
            None => messages::unknown_domain(&text, all),
        };
        mistakes.report(written.name.span(), message);
        return None;
    }
    let values: Vec<f64> = written.bounds.iter().map(|bound| bound.value).collect();
    let (domain, signature) = match (text.as_str(), values.as_slice()) {
        ("line", []) => (Some(Domain::Interval(-1.0, 1.0)), "line"),
        ("unit_line", []) => (Some(Domain::Interval(0.0, 1.0)), "unit_line"),
        ("interval", [a, b]) => (Some(Domain::Interval(*a, *b)), "interval(a, b)"),
        ("square", []) => (Some(Domain::Rectangle([-1.0; 2], [1.0; 2])), "square"),
        ("unit_square", []) => (Some(Domain::Rectangle([0.0; 2], [1.0; 2])), "unit_square"),
        ("triangle", []) => (Some(Domain::Triangle), "triangle"),
        ("rectangle", [a, b, c, d]) => (Some(Domain::Rectangle([*a, *c], [*b, *d])), ""),
        ("interval", _) => (None, "interval(a, b)"),
        ("rectangle", _) => (None, "rectangle(a, b, c, d)"),
        (name, _) => (None, name),
    };
    if domain.is_none() {
        let message = messages::wrong_bound_count(&text, signature, values.len());
        mistakes.report(written.name.span(), message);
    }
    domain.filter(|_| ascending(written, mistakes))
}

/// Whether each pair of bounds encloses something.
fn ascending(written: &syntax::Domain, mistakes: &mut Mistakes) -> bool {
    let before = mistakes.count();
    for pair in written.bounds.chunks_exact(2) {
        if pair[0].value >= pair[1].value {
            let message = names::empty_range(&short(pair[0].value), &short(pair[1].value));
            mistakes.report(pair[0].span, message);
        }
    }
    mistakes.count() == before
}

impl Domain {
    /// Points all over the domain, corners included; near the origin where there are no bounds.
    pub(super) fn samples(&self, coordinates: usize) -> Vec<Vec<f64>> {
        const ALONG: [f64; 5] = [0.0, 0.21, 0.5, 0.83, 1.0];
        const ACROSS: [f64; 4] = [0.0, 0.13, 0.62, 1.0];
        let between = |(low, high): (f64, f64), t: f64| low + t * (high - low);
        match *self {
            Domain::Unbounded => vec![vec![0.3; coordinates], vec![0.7; coordinates]],
            Domain::Interval(a, b) => ALONG.map(|t| vec![between(finite(a, b), t)]).to_vec(),
            Domain::Rectangle(a, b) => {
                let (u, v) = (finite(a[0], b[0]), finite(a[1], b[1]));
                let row = |t: f64| ACROSS.map(|s| vec![between(u, t), between(v, s)]);
                ALONG.into_iter().flat_map(row).collect()
            }
            Domain::Triangle => [
                (1.0, 1.0),
                (0.3, 0.6),
                (1.8, 0.9),
                (0.0, 1.5),
                (0.75, 0.0),
                (0.0, 0.0),
            ]
            .map(|(xi, eta)| vec![xi / 3.0, eta / 3.0])
            .to_vec(),
        }
    }
}

/// The bounds with infinite ones brought near.
fn finite(low: f64, high: f64) -> (f64, f64) {
    match (low.is_finite(), high.is_finite()) {
        (true, true) => (low, high),
        (true, false) => (low, low + 1.0),
        (false, true) => (high - 1.0, high),
        (false, false) => (0.2, 0.8),
    }
}
