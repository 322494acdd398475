//! How does the emitted source of an element introduce itself?

use crate::formulate::{FormulatedElement, ProjectionMethod, Routine};
use crate::model::{Angle, Axis, Enforcement, Gap, Linearisation, Measure, Reference};

/// The lines of the header: declaration, formulation in words, operations, terms left out with their reasons.
pub(super) fn header(e: &FormulatedElement<'_>) -> Vec<String> {
    let mut lines = vec!["```text".to_string(), e.declared.declaration.clone()];
    lines.push(String::new());
    for (topic, text) in formulation(e) {
        lines.push(format!("{topic:<14}{text}"));
    }
    lines.push(format!("{:<14}{}", "operations", operations(e)));
    for (term, reason) in left_out(e) {
        lines.push(format!("{:<14}{term}: {reason}", "left out"));
    }
    lines.push("```".to_string());
    lines.into_iter().map(|line| format!(" {line}")).collect()
}

/// Topics of the formulation and what holds for this element.
fn formulation(e: &FormulatedElement<'_>) -> Vec<(&'static str, String)> {
    let declared = e.declared;
    let mut topics = vec![
        ("pair", pair(e)),
        ("projection", projection(e)),
        ("gap", gap(declared.gap).to_string()),
        ("tangent", tangent(e).to_string()),
        (
            "normal law",
            format!(
                "{}, {}",
                declared.law.name,
                enforcement(declared.enforcement)
            ),
        ),
    ];
    if let Some(tangential) = &declared.tangential {
        let axis = match tangential.axis {
            None => "",
            Some(Axis::Convected) => ", first axis convected by the master",
            Some(Axis::Slave) => ", first axis along the slave",
        };
        topics.push(("friction", format!("{}{axis}", tangential.law.name)));
    }
    if let Some(rolling) = &declared.rolling {
        let from = match rolling.reference {
            Reference::PrincipalNormal => "the principal normals",
            Reference::Director => "directors",
        };
        let text = format!("{}, angles from {from}", rolling.law.name);
        topics.push(("rolling", text));
    }
    match declared.angle {
        Some(Angle::Large) => topics.push(("angle", "acts at large angles".to_string())),
        Some(Angle::Small) => topics.push(("angle", "acts at small angles".to_string())),
        None => {}
    }
    topics
}

fn pair(e: &FormulatedElement<'_>) -> String {
    let points = match e.points.len() {
        1 => String::new(),
        count => format!(", {count} integration points"),
    };
    let measure = match (e.measure.is_some(), e.declared.measure) {
        (false, _) => "",
        (true, Measure::Reference) => ", area of the reference configuration",
        (true, Measure::Current) => ", area of the current configuration",
    };
    let nodes = |count: usize| match count {
        1 => "1 node".to_string(),
        count => format!("{count} nodes"),
    };
    let (slave, master) = (nodes(e.slave_nodes), nodes(e.master_nodes));
    let dimension = e.declared.dimension;
    format!("{dimension} dimensions, slave of {slave}, master of {master}{points}{measure}")
}

fn projection(e: &FormulatedElement<'_>) -> String {
    let method = match e.projection_method() {
        ProjectionMethod::Closed => "in closed form",
        ProjectionMethod::Affine => "by one linear solve",
        ProjectionMethod::Newton => "by Newton's method",
    };
    match e.kinematics.projected() {
        0 => "no projected parameter".to_string(),
        1 => format!("1 parameter, {method}"),
        count => format!("{count} parameters, {method}"),
    }
}

fn gap(gap: Gap) -> &'static str {
    match gap {
        Gap::Distance => "distance",
        Gap::Oriented => "distance with a given sign",
        Gap::Signed => "signed, along the normal",
    }
}

fn tangent(e: &FormulatedElement<'_>) -> &'static str {
    match (&e.tangent, e.declared.linearisation) {
        (None, _) => "none: the element has a residual only",
        (Some(_), Linearisation::Exact) => "exact at any gap",
        (Some(_), Linearisation::TangentPlane) => "on the tangent plane, exact at zero gap",
    }
}

fn enforcement(enforcement: Enforcement) -> &'static str {
    match enforcement {
        Enforcement::Penalty => "by itself",
        Enforcement::Augmented => "beside a multiplier of the history",
        Enforcement::Multiplier => "beside a multiplier that is an unknown",
    }
}

/// Operations of every program of a point and of the laws, and their sum.
fn operations(e: &FormulatedElement<'_>) -> String {
    let one = |routine: &Routine| format!("{} {}", routine.program.name, routine.operations());
    let laws = e.tangential_laws.iter().flat_map(|law| law.routines());
    let routines = e.routines().chain([&e.law.law]).chain(laws);
    let all: Vec<String> = routines.map(one).collect();
    format!("{}; in all {}", all.join(", "), e.operations())
}

/// The terms that vanish identically, with the program that would have them, and why.
fn left_out<'a>(e: &'a FormulatedElement<'_>) -> Vec<(String, &'a str)> {
    let terms = e.routines().flat_map(|routine| {
        let name = &routine.program.name;
        let terms = routine.program.terms.iter().filter(|term| !term.present);
        terms.map(move |term| (format!("{} of {name}", term.tag), term.reason.as_str()))
    });
    terms.collect()
}
