//! Checked declarations as text, with what follows from them.

use std::fmt::Write as _;

use contact_generator::formulate::{FormulatedElement, FormulatedGeometry, FormulatedLaw};
use contact_generator::model::{Body, Parameter};

pub fn of_element(e: &FormulatedElement<'_>) -> String {
    let declared = e.declared;
    let (d, p, h) = e.sizes();
    let mut text = format!("{}\n\n", declared.declaration);
    let _ = writeln!(text, "documentation    {}", declared.docs);
    let _ = writeln!(text, "dimension        {d}");
    let _ = writeln!(
        text,
        "nodes            {} + {}",
        e.slave_nodes, e.master_nodes
    );
    let _ = writeln!(text, "projected        {p}, second derivatives {h}");
    let _ = writeln!(text, "projection       {:?}", e.projection_method());
    let _ = writeln!(text, "domains          {:?}", e.domains());
    let _ = writeln!(text, "moving           {:?}", e.kinematics.moving);
    let _ = writeln!(text, "curved           {:?}", e.kinematics.curved);
    let _ = writeln!(text, "third            {:?}", e.kinematics.third);
    let _ = writeln!(text, "gap              {:?}", declared.gap);
    let _ = writeln!(text, "linearisation    {:?}", declared.linearisation);
    let _ = writeln!(text, "measure          {:?}", declared.measure);
    let _ = writeln!(text, "enforcement      {:?}", declared.enforcement);
    let _ = writeln!(text, "symmetric        {}", e.is_symmetric());
    let _ = writeln!(text, "lanes            {}", e.in_lanes());
    let _ = writeln!(text, "screened         {}", e.can_screen());
    let _ = writeln!(text, "operations       {}", e.operations());
    for (point, weight) in &e.points {
        let _ = writeln!(text, "point            {point:?} weight {weight:?}");
    }
    for (offset, entry) in e.parameters.entries.iter().enumerate() {
        let (name, unit) = (&entry.name, &entry.unit);
        let range = range(entry.lower, entry.upper, entry.closed);
        let _ = writeln!(text, "parameter {offset}      {name} [{unit}] in {range}");
    }
    let _ = writeln!(text, "\n{:#?}", e.parameters.layout);
    text
}

pub fn of_geometry(formulated: &FormulatedGeometry) -> String {
    let declared = &formulated.declared;
    let kind = match &declared.body {
        Body::Shape { rational: true, .. } => "rational shape functions",
        Body::Shape { .. } => "shape functions",
        Body::Rigid { .. } => "rigid position",
        Body::Distance { .. } => "distance function",
    };
    let coordinates: Vec<String> = declared
        .coordinates
        .iter()
        .map(ToString::to_string)
        .collect();
    let mut text = format!("{} ({kind})\n\n", declared.name);
    let _ = writeln!(text, "documentation    {}", declared.docs);
    let _ = writeln!(text, "coordinates      {}", coordinates.join(" "));
    let _ = writeln!(text, "domain           {:?}", declared.domain);
    let _ = writeln!(text, "nodes            {}", declared.nodes());
    let _ = writeln!(text, "curved           {:?}", formulated.curved);
    let _ = writeln!(text, "third            {:?}", formulated.third_remaining);
    let _ = writeln!(text, "periods          {:?}", formulated.periods);
    parameters(&mut text, &declared.parameters);
    text
}

pub fn of_law(formulated: &FormulatedLaw) -> String {
    let declared = &formulated.declared;
    let mut text = format!("{} (normal law)\n\n", declared.name);
    let _ = writeln!(text, "documentation    {}", declared.docs);
    let _ = writeln!(text, "gap              {}", declared.gap);
    let _ = writeln!(text, "energy           {}", declared.energy.is_some());
    let _ = writeln!(text, "everywhere       {}", declared.valid.is_none());
    parameters(&mut text, &declared.parameters);
    text
}

fn parameters(text: &mut String, parameters: &[Parameter]) {
    for parameter in parameters {
        let (name, unit) = (&parameter.name, &parameter.unit);
        let range = range(parameter.lower, parameter.upper, parameter.closed);
        let _ = writeln!(text, "parameter        {name} [{unit}] in {range}");
    }
}

fn range(lower: f64, upper: f64, closed: bool) -> String {
    match closed {
        true => format!("[{lower}, {upper}]"),
        false => format!("({lower}, {upper})"),
    }
}
