//! A user's own crate (`tests/user-crate`): built as its user would, used from C, proven.

use std::path::Path;
use std::process::Command;

use contact_generator::header::C_HEADERS;
use contact_tests::compiler;
use contact_tests::library::{Library, cargo};
use contact_tests::process::succeed;
use contact_tests::workspace;

/// Libraries that the archive of a crate with the standard library asks for.
const STANDARD: [&str; 6] = ["-lgcc_s", "-lutil", "-lrt", "-lpthread", "-lm", "-ldl"];

#[test]
fn declared_once_used_from_c() {
    let directory = workspace("tests/user-crate");
    let library = Library::of_crate(&directory.join("Cargo.toml"), target(), "rail");
    let include = directory.join("include");
    for (name, text) in C_HEADERS {
        assert_eq!(read(&include.join(name)), text);
    }
    assert!(read(&include.join("rail.inc")).contains("PARAMETER (RAIL_POINT_QUAD8 = 0)"));

    let archive = library.archive().display().to_string();
    let links = [
        library.link(),
        [archive.as_str()]
            .iter()
            .chain(&STANDARD)
            .map(ToString::to_string)
            .collect(),
    ];
    for link in links {
        let executable = library.path().join("client");
        succeed(
            strict_c(&include)
                .arg(directory.join("client.c"))
                .args(link)
                .args(["-lm", "-o"])
                .arg(&executable),
        );
        let printed = succeed(&mut Command::new(&executable));
        assert!(printed.contains("all passed"), "{printed}");
        println!("{printed}");
    }
}

/// The crate's own test: its elements against the oracle.
#[test]
fn proven_like_the_built_in_elements() {
    let printed = succeed(
        cargo("test")
            .arg("--manifest-path")
            .arg(workspace("tests/user-crate/Cargo.toml"))
            .env("CARGO_TARGET_DIR", target()),
    );
    assert!(
        printed.contains("test every_element_is_exact ... ok"),
        "{printed}"
    );
}

/// The target directory of the workspace: what both builds need is compiled once.
fn target() -> &'static Path {
    let parent = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    parent.expect("the target directory")
}

/// Only the headers of the crate are in reach.
fn strict_c(include: &Path) -> Command {
    let mut command = compiler::bare_c();
    command.arg("-I").arg(include);
    command
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
