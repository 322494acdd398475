//! No file of the crates imports another that leads back to it.

use std::fs;
use std::path::{Path, PathBuf};

use contact_tests::circles::Crate;
use contact_tests::workspace;

/// Crates and the files they begin with.
const CRATES: [(&str, &str); 3] = [
    ("contact_elements", "contact-elements/src/lib.rs"),
    ("contact_generator", "contact-macros/generator/src/lib.rs"),
    ("contact_verify", "verify/src/lib.rs"),
];

fn told(circles: &[Vec<PathBuf>]) -> String {
    let circle = |files: &Vec<PathBuf>| {
        let files = files.iter().map(|file| format!("\n    {}", file.display()));
        format!("  {} files:{}\n", files.len(), files.collect::<String>())
    };
    circles.iter().map(circle).collect()
}

#[test]
fn no_file_leads_back_to_itself() {
    let mut found = String::new();
    for (name, root) in CRATES {
        let all = Crate::read(name, &workspace(root)).expect("source of a crate");
        assert!(all.files() > 10, "{name}: only {} files", all.files());
        let circles = all.circles();
        if !circles.is_empty() {
            found += &format!("{name}\n{}", told(&circles));
        }
    }
    assert!(found.is_empty(), "files that import each other:\n{found}");
}

/// The circles of a crate made of these files, as names of files.
fn circles_of(files: &[(&str, &str)]) -> Vec<Vec<String>> {
    let folder = tempfile::tempdir().expect("a folder");
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    let all = Crate::read("planted", &folder.path().join("lib.rs")).expect("a crate");
    let name = |path: PathBuf| {
        let own: &Path = path
            .strip_prefix(folder.path())
            .expect("a file of the crate");
        own.display().to_string()
    };
    let circles = all.circles().into_iter();
    circles
        .map(|circle| circle.into_iter().map(name).collect())
        .collect()
}

#[test]
fn planted_circle_is_found() {
    let circles = circles_of(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "use crate::b::B; pub struct A(B);"),
        ("b.rs", "pub struct B; fn c() { super::c::c(); }"),
        (
            "c.rs",
            "pub fn c() { assert!(matches!(0, crate::a::A(_))); }",
        ),
    ]);
    assert_eq!(circles, [["a.rs", "b.rs", "c.rs"]]);
}

#[test]
fn planted_circle_behind_reexports_is_found() {
    let circles = circles_of(&[
        (
            "lib.rs",
            "mod room; mod other; pub use room::Thing as Renamed;",
        ),
        ("room/mod.rs", "mod thing; pub use thing::*;"),
        (
            "room/thing.rs",
            "use crate::other; pub struct Thing; fn f() { other::f(); }",
        ),
        (
            "other.rs",
            "use crate::Renamed; pub fn f() -> Option<Renamed> { None }",
        ),
    ]);
    assert_eq!(circles, [["room/thing.rs", "other.rs"]]);
}

#[test]
fn parent_that_uses_its_child_is_tied_to_it() {
    let circles = circles_of(&[
        ("lib.rs", "mod parent;"),
        (
            "parent/mod.rs",
            "mod child; pub struct Data; fn f() { child::f(); }",
        ),
        (
            "parent/child.rs",
            "use super::Data; pub fn f() -> Option<Data> { None }",
        ),
    ]);
    assert_eq!(circles, [["parent/mod.rs", "parent/child.rs"]]);
}

#[test]
fn declarations_and_reexports_tie_nobody() {
    let circles = circles_of(&[
        (
            "lib.rs",
            "mod room; pub mod door { pub use crate::room::{One, Two}; }",
        ),
        (
            "room/mod.rs",
            "mod one; mod two; pub use one::One; pub use two::Two;",
        ),
        ("room/one.rs", "pub struct One;"),
        (
            "room/two.rs",
            "use super::One; pub struct Two(One); #[cfg(test)] mod tests { use crate::door::Two; }",
        ),
    ]);
    assert_eq!(circles, Vec::<Vec<String>>::new());
}
