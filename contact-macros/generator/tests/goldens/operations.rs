//! Operations of the programs of every built-in element and geometry.

use std::fmt::Write as _;

use contact_generator::formulate::{Formulation, Routine};
use contact_generator::model::Body;

pub fn of_elements(formulation: &Formulation<'_>) -> String {
    let count = |routine: Option<&Routine>| match routine {
        Some(routine) => routine.operations().to_string(),
        None => "-".to_string(),
    };
    let mut table = format!(
        "{:<40}{:>6}{:>9}{:>9}\n",
        "element", "gap", "tangent", "measure"
    );
    for element in &formulation.elements {
        let name = element.declared.name.to_string();
        let gap = count(Some(&element.gap));
        let tangent = count(element.tangent.as_ref());
        let measure = count(element.measure.as_ref());
        let _ = writeln!(table, "{name:<40}{gap:>6}{tangent:>9}{measure:>9}");
    }
    table
}

pub fn of_geometries(formulation: &Formulation<'_>) -> String {
    let mut table = format!("\n{:<40}{:>6}\n", "geometry", "rows");
    for geometry in &formulation.geometries {
        if !matches!(geometry.declared.body, Body::Distance { .. }) {
            let (name, rows) = (&geometry.declared.name, geometry.values.operations());
            let _ = writeln!(table, "{:<40}{rows:>6}", name.to_string());
        }
    }
    table
}
