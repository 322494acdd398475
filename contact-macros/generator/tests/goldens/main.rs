//! What the stages make of seven declarations, and what every built-in element costs.
//!
//! | file | shows |
//! |---|---|
//! | `golden/ITEM/model.txt` | the checked declaration with what follows from it |
//! | `golden/ITEM/programs.txt` | its programs, one operation per line, the equation beside each term |
//! | `golden/ITEM/emitted.rs` | the source that is emitted for it |
//! | `golden/operations.txt` | operations of every element and geometry: a jump shows here before it shows in a benchmark |
//!
//! `CONTACT_BLESS=1 cargo test -p contact-generator --test goldens` rewrites them. Look at the difference before you
//! commit it: it is a change of what users run.

mod model;
mod operations;
mod programs;

use std::path::Path;

use contact_generator::emit::{emit_element, emit_friction, emit_geometry, emit_law, readable};
use contact_generator::expand::library_elements;
use contact_generator::formulate::{Formulation, formulate};
use contact_generator::model::Model;
use proc_macro2::TokenStream;

/// The text of a golden file must be this; with `CONTACT_BLESS=1` it is written.
fn assert_golden(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name);
    if std::env::var("CONTACT_BLESS").is_ok_and(|value| value == "1") {
        let folder = path.parent().expect("a folder");
        std::fs::create_dir_all(folder)
            .and_then(|()| std::fs::write(&path, text))
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let found = std::fs::read_to_string(&path).unwrap_or_else(|error| {
        panic!("{}: {error}; CONTACT_BLESS=1 writes it", path.display());
    });
    let mut lines = found.lines().zip(text.lines()).enumerate();
    if let Some((number, (old, new))) = lines.find(|(_, (old, new))| old != new) {
        let (path, number) = (path.display(), number + 1);
        panic!("{path}:{number} differs; CONTACT_BLESS=1 writes it\nfound: {old}\nnow:   {new}");
    }
    assert!(found == text, "{}: another length", path.display());
}

/// The three files of one item.
fn assert_item(name: &str, model: &str, programs: &str, emitted: &TokenStream) {
    let emitted = readable(emitted).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_golden(&format!("{name}/model.txt"), model);
    assert_golden(&format!("{name}/programs.txt"), programs);
    assert_golden(&format!("{name}/emitted.rs"), &emitted);
}

/// Calls `check` with what is formulated for the built-in elements.
fn with_elements(check: impl FnOnce(&Formulation<'_>)) {
    let model = library_elements().expect("the library");
    check(&formulate(&model).expect("small programs"));
}

/// Calls `check` with what is formulated for the built-in geometries and laws.
fn with_library(check: impl FnOnce(&Formulation<'_>)) {
    let model = Model::library();
    check(&formulate(&model).expect("small programs"));
}

fn assert_element(name: &str) {
    with_elements(|formulation| {
        let mut elements = formulation.elements.iter();
        let element = elements.find(|element| element.declared.name == name);
        let element = element.expect("a built-in element");
        let friction = emit_friction(std::slice::from_ref(element));
        let own = emit_element(element);
        assert_item(
            name,
            &model::of_element(element),
            &programs::listing(element.routines().map(|routine| &routine.program)),
            &quote::quote! { #friction #own },
        );
    });
}

#[test]
fn point_on_a_facet() {
    assert_element("PointQuad4");
}

#[test]
fn point_on_a_facet_with_friction() {
    assert_element("PointQuad4Coulomb");
}

#[test]
fn two_beams() {
    assert_element("HermiteHermiteBeams");
}

#[test]
fn facet_on_facet() {
    assert_element("Quad4Quad4");
}

fn assert_geometry(name: &str) {
    with_library(|formulation| {
        let mut geometries = formulation.geometries.iter();
        let geometry = geometries.find(|geometry| geometry.declared.name == name);
        let geometry = geometry.expect("a built-in geometry");
        let routines = geometry.routines().map(|routine| &routine.program);
        assert_item(
            name,
            &model::of_geometry(geometry),
            &programs::listing(routines.chain(&geometry.tangent)),
            &emit_geometry(geometry),
        );
    });
}

#[test]
fn facet() {
    assert_geometry("Quad4");
}

#[test]
fn distance_function() {
    assert_geometry("SphereDistance");
}

#[test]
fn normal_law() {
    with_library(|formulation| {
        let mut laws = formulation.laws.iter();
        let law = laws.find(|law| law.declared.name == "LogBarrier");
        let law = law.expect("a built-in law");
        assert_item(
            "LogBarrier",
            &model::of_law(law),
            &programs::listing(law.routines().map(|routine| &routine.program)),
            &emit_law(law),
        );
    });
}

#[test]
fn operation_counts() {
    let mut table = String::new();
    with_elements(|formulation| table += &operations::of_elements(formulation));
    with_library(|formulation| table += &operations::of_geometries(formulation));
    assert_golden("operations.txt", &table);
}
