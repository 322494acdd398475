//! The emitted source of the built-in elements is always the same, readable, of known cost, and has every term.

use crate::emit::{emit_element, readable};
use crate::expand::{expand_library, library_elements};
use crate::formulate::{FormulatedElement, formulate};
use crate::model::{Linearisation, Master};

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
