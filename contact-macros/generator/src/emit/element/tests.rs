//! The emitted source of the built-in elements is always the same, readable, of known cost, and has every term.
//!
//! The files in `tests/golden` are compared; `CONTACT_BLESS=1 cargo test -p contact-generator golden`
//! rewrites them. Look at the difference before you commit it: it is a change of what users run.

use std::fmt::Write as _;
use std::path::Path;

use crate::emit::{emit_element, readable};
use crate::expand::{expand_library, library_elements};
use crate::formulate::{FormulatedElement, Routine, formulate};
use crate::model::{Body, Linearisation, Master, Model};

/// Most bytes of the formatted source of one element.
const MOST_BYTES: usize = 200_000;

/// Terms of the closed form.
const CLOSED_FORM: [&str; 7] = [
    "12-main",
    "13-curvature",
    "13-rotational-left",
    "13-rotational-right",
    "F-curvature",
    "complement",
    "quadratic-rotation",
];

/// Calls `visit` with every built-in element.
fn for_each_element(mut visit: impl FnMut(&FormulatedElement<'_>)) {
    let model = library_elements().expect("the library");
    let formulation = formulate(&model).expect("small programs");
    formulation.elements.iter().for_each(&mut visit);
}

fn source(element: &FormulatedElement<'_>) -> String {
    let name = &element.declared.name;
    readable(&emit_element(element)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Asserts that a golden file has this text; with `CONTACT_BLESS=1` it is written.
fn assert_golden(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name);
    if std::env::var("CONTACT_BLESS").is_ok_and(|value| value == "1") {
        std::fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let found = std::fs::read_to_string(&path).unwrap_or_else(|error| {
        panic!("{}: {error}; CONTACT_BLESS=1 writes it", path.display());
    });
    let mut lines = found.lines().zip(text.lines()).enumerate();
    if let Some((number, (old, new))) = lines.find(|(_, (old, new))| old != new) {
        let (path, number) = (path.display(), number + 1);
        panic!("{path}:{number} differs; CONTACT_BLESS=1 writes it\nfound: {old}\nemitted: {new}");
    }
    assert!(found == text, "{}: another length", path.display());
}

#[test]
fn emission_is_deterministic() {
    for part in ["geometries", "laws", "elements", "elements_extended"] {
        let text = || expand_library(part).expect("the library").to_string();
        assert!(text() == text(), "{part}");
    }
}

#[test]
fn sources_parse_and_are_small() {
    for_each_element(|element| {
        let bytes = source(element).len();
        assert!(
            bytes <= MOST_BYTES,
            "{}: {bytes} bytes",
            element.declared.name
        );
    });
}

#[test]
fn golden_source_of_a_small_element() {
    for_each_element(|element| {
        if element.declared.name == "PointPoint2d" {
            assert_golden("point_point2d.rs", &source(element));
        }
    });
}

/// A jump in cost shows here before it shows in a benchmark.
#[test]
fn golden_operation_counts() {
    let mut table = format!(
        "{:<40}{:>6}{:>9}{:>9}\n",
        "element", "gap", "tangent", "measure"
    );
    let count = |routine: Option<&Routine>| match routine {
        Some(routine) => routine.operations().to_string(),
        None => "-".to_string(),
    };
    for_each_element(|element| {
        let name = element.declared.name.to_string();
        let gap = count(Some(&element.gap));
        let tangent = count(element.tangent.as_ref());
        let measure = count(element.measure.as_ref());
        let _ = writeln!(table, "{name:<40}{gap:>6}{tangent:>9}{measure:>9}");
    });
    let _ = writeln!(table, "\n{:<40}{:>6}", "geometry", "rows");
    let library = Model::library();
    let formulation = formulate(&library).expect("small programs");
    for geometry in &formulation.geometries {
        if !matches!(geometry.declared.body, Body::Distance { .. }) {
            let (name, rows) = (&geometry.declared.name, geometry.values.operations());
            let _ = writeln!(table, "{:<40}{rows:>6}", name.to_string());
        }
    }
    assert_golden("operations.txt", &table);
}

#[test]
fn every_term_is_there_or_left_out_for_a_reason() {
    for_each_element(|element| {
        let name = &element.declared.name;
        let Some(tangent) = &element.tangent else {
            return;
        };
        let terms = &tangent.program.terms;
        assert!(!terms.is_empty(), "{name}");
        for term in terms {
            let tag = term.tag;
            assert_eq!(term.present, term.reason.is_empty(), "{name}: {tag}");
        }
        if matches!(element.declared.master, Master::Distance { .. }) {
            return;
        }
        let mut tags: Vec<&str> = terms.iter().map(|term| term.tag).collect();
        tags.sort_unstable();
        assert_eq!(tags, CLOSED_FORM, "{name}");
        if element.declared.linearisation == Linearisation::TangentPlane {
            let left_out = |tag| terms.iter().any(|term| term.tag == tag && !term.present);
            assert!(
                left_out("quadratic-rotation") && left_out("F-curvature"),
                "{name}"
            );
        }
    });
}
