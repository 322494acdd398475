//! The binary interface, frozen: `tests/abi/baseline.txt` (symbols, layouts, elements and their
//! parameters) and `tests/abi/baseline.abi` (types, as `abidw` reads them from debug information).
//!
//! Both are written by `CONTACT_BLESS=1`, which refuses to change what they already promise.

use std::process::Command;
use std::sync::OnceLock;

use contact_tests::abi::{Interface, abidiff, abidw, with_moved_field};
use contact_tests::committed::blessing;
use contact_tests::compiler;
use contact_tests::library::Library;
use contact_tests::process::{available, succeed};
use contact_tests::workspace;

/// Environment variable that makes a missing `abidiff` a failure.
const REQUIRE_ABIDIFF: &str = "CONTACT_REQUIRE_ABIDIFF";

/// What the shared object may ask its host for.
const ALLOWED: [&str; 5] = ["memcpy", "memset", "memmove", "bcmp", "memcmp"];

fn library() -> &'static Library {
    static LIBRARY: OnceLock<Library> = OnceLock::new();
    LIBRARY.get_or_init(Library::contact_elements)
}

/// Columns of `nm` on the shared object, line by line.
fn nm(arguments: &[&str]) -> Vec<Vec<String>> {
    let text = succeed(Command::new("nm").args(arguments).arg(library().shared()));
    let words = |line: &str| line.split_whitespace().map(str::to_string).collect();
    text.lines().map(words).collect()
}

#[test]
fn nothing_promised_has_changed() {
    let baseline = workspace("tests/abi/baseline.txt");
    let found = Interface::of(library());
    let frozen = std::fs::read_to_string(&baseline).unwrap_or_default();
    let frozen = Interface::parse(&frozen);
    let broken = frozen.broken_by(&found);
    assert!(
        broken.is_empty(),
        "promised and gone:\n{}",
        broken.join("\n")
    );
    let extended = frozen.extended_by(&found);
    if blessing() {
        std::fs::write(&baseline, extended.text()).expect("the baseline");
    } else {
        assert_eq!(
            frozen.text(),
            extended.text(),
            "the interface has grown: CONTACT_BLESS=1 adds it to {}",
            baseline.display()
        );
    }
}

#[test]
fn the_host_needs_next_to_nothing() {
    for line in nm(&["-D", "--undefined-only"]) {
        let [kind, symbol] = line.as_slice() else {
            panic!("{line:?}")
        };
        let (name, version) = symbol.split_once('@').unwrap_or((symbol, ""));
        assert!(kind == "w" || ALLOWED.contains(&name), "undefined: {name}");
        assert!(old_enough(version), "{symbol} needs a newer C library");
    }
}

/// Whether a symbol has no version or GLIBC_2.17 (2012) at most.
fn old_enough(version: &str) -> bool {
    let Some(number) = version.trim_start_matches('@').strip_prefix("GLIBC_") else {
        return version.is_empty();
    };
    let numbers: Vec<u32> = number.split('.').filter_map(|n| n.parse().ok()).collect();
    numbers.as_slice() <= [2, 17, u32::MAX].as_slice()
}

#[test]
fn versions_are_compared_as_numbers() {
    for version in ["", "@GLIBC_2.2.5", "GLIBC_2.14", "GLIBC_2.17"] {
        assert!(old_enough(version), "{version}");
    }
    for version in ["GLIBC_2.18", "GLIBC_2.34", "GLIBC_3.0", "GCC_3.0"] {
        assert!(!old_enough(version), "{version}");
    }
}

#[test]
fn nothing_panics_or_unwinds() {
    let symbols = nm(&[]);
    assert!(symbols.len() > 100, "no symbol table to look at");
    for line in symbols {
        let name = line.last().expect("a name");
        assert!(
            !name.contains("panic") && !name.contains("unwind"),
            "{name}"
        );
        // The stub of the capi crate: local, and the pointer to it that unwind tables hold.
        if name.contains("personality") {
            let kind = &line[line.len() - 2];
            let stub = [
                ("t", "rust_eh_personality"),
                ("d", "DW.ref.rust_eh_personality"),
            ];
            assert!(
                stub.contains(&(kind.as_str(), name.as_str())),
                "{kind} {name}"
            );
        }
    }
}

/// The stub returns and does nothing else.
#[test]
fn the_personality_is_a_stub() {
    let disassembly = succeed(
        Command::new("objdump")
            .args([
                "-d",
                "--no-show-raw-insn",
                "--disassemble=rust_eh_personality",
            ])
            .arg(library().shared()),
    );
    let (_, body) = disassembly
        .split_once("<rust_eh_personality>:\n")
        .unwrap_or_default();
    let first = body.lines().next().unwrap_or("\tret");
    assert!(first.trim_end().ends_with("\tret"), "{first}");
}

#[test]
fn the_soname_carries_the_major_version() {
    let dynamic = succeed(Command::new("readelf").arg("-d").arg(library().shared()));
    assert!(
        dynamic.contains("soname: [libcontact_elements.so.1]"),
        "{dynamic}"
    );
    assert!(!dynamic.contains("(NEEDED)"), "{dynamic}");
}

#[test]
fn sizes() {
    let stripped = library().path().join("stripped.so");
    succeed(
        Command::new("strip")
            .arg("-o")
            .arg(&stripped)
            .arg(library().shared()),
    );
    for (what, path) in [
        ("shared", library().shared()),
        ("shared, stripped", stripped.clone()),
        ("static", library().archive()),
    ] {
        let size = std::fs::metadata(path).expect("a file").len();
        println!("{what}: {} kB", size / 1000);
    }
    let size = std::fs::metadata(stripped).expect("a file").len();
    let elements = contact_library::ELEMENTS;
    let lanes = elements.iter().filter(|own| own.lanes.is_some()).count() as u64;
    // Kernels in lanes are there for each width, rows of K for several numbers of nodes; what both crates of elements need
    // is there twice. A kernel writes its outputs through checked slices, inlined for fewer instructions per call.
    let most = 31_200 * elements.len() as u64 + 90_000 * lanes;
    assert!(
        size < most,
        "{size} bytes without symbols for {} elements, {lanes} of them in lanes",
        elements.len()
    );
}

#[test]
fn types_are_those_of_the_baseline() {
    if !available("abidiff", REQUIRE_ABIDIFF) {
        return;
    }
    let library = Library::with_debug_information();
    let baseline = workspace("tests/abi/baseline.abi");
    if blessing() && !baseline.exists() {
        abidw(&library.shared(), &baseline);
    }
    let (same, report) = abidiff(&baseline, &library.shared());
    assert!(same, "{report}");
    let spoiled = library.path().join("spoiled.abi");
    let text = std::fs::read_to_string(&baseline).expect("the baseline");
    let moved = with_moved_field(&text, "Arguments", "k_scale").expect("cte_arguments.k_scale");
    std::fs::write(&spoiled, moved).expect("a file");
    let (same, report) = abidiff(&spoiled, &library.shared());
    assert!(!same, "a moved field went unnoticed:\n{report}");
    if blessing() {
        abidw(&library.shared(), &baseline);
    }
}

#[test]
fn a_changed_struct_is_noticed() {
    if !available("abidiff", REQUIRE_ABIDIFF) {
        return;
    }
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let build = |name: &str, fields: &str| {
        let source = directory.path().join(format!("{name}.c"));
        let object = source.with_extension("so");
        let text = format!(
            "struct s {{ {fields} }};\nint f(struct s *s);\nint f(struct s *s) {{ return s->n; }}\n"
        );
        std::fs::write(&source, text).expect("a file");
        let mut compiler = compiler::bare_c();
        succeed(
            compiler
                .args(["-shared", "-fPIC", "-o"])
                .arg(&object)
                .arg(&source),
        );
        object
    };
    let old = build("old", "int n; double x;");
    let baseline = directory.path().join("old.abi");
    abidw(&old, &baseline);
    assert!(abidiff(&baseline, &old).0);
    for (name, fields) in [
        ("moved", "double x; int n;"),
        ("inserted", "int n; int m; double x; double y;"),
        ("retyped", "int n; float x;"),
    ] {
        let (same, report) = abidiff(&baseline, &build(name, fields));
        assert!(!same, "{name} went unnoticed:\n{report}");
    }
}
