//! Integration rules of slaves.

use syn::Ident;

use super::types::{Domain, Geometry, Rule};
use crate::diagnostics::{Mistakes, element as messages};
use crate::syntax;

/// The largest rule of an interval.
const LINE_POINTS: usize = 10;
/// The rules of a triangle.
const TRIANGLE_POINTS: [usize; 3] = [1, 3, 6];

/// The rule for a slave geometry; `None` after a mistake.
pub(super) fn rule(
    written: &syntax::Rule,
    geometry: &Geometry,
    mistakes: &mut Mistakes,
) -> Option<Rule> {
    let text = written.name.to_string();
    match (text.as_str(), &written.points) {
        ("given", None) => Some(Rule::Given),
        ("gauss", Some(points)) if !points.is_empty() => {
            gauss(&written.name, points, geometry, mistakes)
        }
        ("given" | "gauss", _) => {
            mistakes.report(written.name.span(), messages::wrong_rule_form(&text));
            None
        }
        _ => {
            mistakes.report(written.name.span(), messages::unknown_rule(&text));
            None
        }
    }
}

fn gauss(
    rule: &Ident,
    points: &[(usize, proc_macro2::Span)],
    geometry: &Geometry,
    mistakes: &mut Mistakes,
) -> Option<Rule> {
    let (domain, directions) = match geometry.domain {
        Domain::Triangle => ("a triangle", 1),
        Domain::Rectangle(..) => ("a quadrilateral", 2),
        _ => ("a curve", 1),
    };
    if points.len() != directions {
        let name = geometry.name.to_string();
        let example = default_rule(geometry);
        let message = messages::rule_does_not_fit(&name, domain, directions, example);
        mistakes.report(rule.span(), message);
        return None;
    }
    let before = mistakes.count();
    for (count, span) in points {
        let (fits, supported) = match geometry.domain {
            Domain::Triangle => (
                TRIANGLE_POINTS.contains(count),
                "1, 3 and 6 points on a triangle",
            ),
            Domain::Rectangle(..) => (
                (1..=LINE_POINTS).contains(count),
                "1 to 10 points in each direction",
            ),
            _ => ((1..=LINE_POINTS).contains(count), "1 to 10 points"),
        };
        if !fits {
            mistakes.report(
                *span,
                messages::unsupported_points(&count.to_string(), supported),
            );
        }
    }
    (mistakes.count() == before).then(|| Rule::Gauss(points.iter().map(|(n, _)| *n).collect()))
}

/// A rule that fits a slave geometry, as hints propose it.
pub(super) fn default_rule(geometry: &Geometry) -> &'static str {
    match geometry.domain {
        Domain::Triangle => "gauss(3)",
        Domain::Rectangle(..) => "gauss(2, 2)",
        _ => "gauss(2)",
    }
}
