//! The committed symbols of the built-in elements: `contact_elements_symbols.h` and
//! `contact_elements.inc` say what the generator says, and the library agrees with both.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use contact_generator::emit::symbol_name;
use contact_generator::expand::library_elements;
use contact_generator::header::{fortran_include, numbers, short_name, symbols_header};
use contact_tests::committed::assert_committed;
use contact_tests::compiler::{self, REQUIRE_FORTRAN};
use contact_tests::library::Library;
use contact_tests::process::{available, succeed};
use contact_tests::workspace;

/// Names of the built-in elements, in the order of their indices.
fn names() -> Vec<String> {
    let model = library_elements().expect("the library");
    model.elements.iter().map(|e| e.name.to_string()).collect()
}

#[test]
fn committed_files_are_what_the_generator_writes() {
    let elements = library_elements().expect("the library").elements;
    let include = workspace("contact-elements/include");
    assert_committed(
        &include.join("contact_elements_symbols.h"),
        &symbols_header("cte", &elements),
    );
    assert_committed(
        &include.join("contact_elements.inc"),
        &fortran_include("cte", &elements),
    );
}

/// The numbers of the C headers by name, sorted.
fn numbers_of_the_headers() -> Vec<(String, i32)> {
    let sections = numbers().into_iter().flat_map(|(_, list)| list);
    let mut all: Vec<_> = sections
        .map(|(name, value)| (name.to_string(), value))
        .collect();
    all.sort();
    all
}

/// Codes, arguments and request bits of the library are those that the headers define.
#[test]
fn numbers_of_the_library_are_those_of_the_headers() {
    let text = std::fs::read_to_string(workspace("contact-elements/src/codes.rs")).expect("codes");
    let (mut module, mut found) = ("", Vec::new());
    for line in text.lines().map(str::trim) {
        if let Some(name) = line.strip_prefix("pub mod ") {
            module = name.trim_end_matches(" {");
        }
        let constant = line
            .strip_prefix("pub const ")
            .and_then(|rest| rest.split_once(':'));
        let Some((name, rest)) = constant else {
            continue;
        };
        let (_, value) = rest
            .trim_end_matches(';')
            .split_once("= ")
            .expect("a value");
        let name = match (module, name) {
            ("code", "SUCCESS" | "CUT_BACK") | ("request", _) => name.to_string(),
            ("code", _) => format!("ERROR_{name}"),
            ("argument", _) => format!("ARGUMENT_{name}"),
            _ => continue,
        };
        found.push((name, value.parse::<i32>().expect("a number")));
    }
    let headers = numbers_of_the_headers();
    assert!(found.len() > 60, "{found:?}");
    for number in &found {
        assert!(headers.contains(number), "{number:?} is not in the headers");
    }
    let is_known = |(name, _): &&(String, i32)| {
        name.starts_with("ERROR_") || name.starts_with("ARGUMENT_") || *name == "CSR_BY_BLOCKS"
    };
    for number in headers.iter().filter(is_known) {
        assert!(found.contains(number), "{number:?} is not in the library");
    }
}

/// The Fortran module has the numbers of the headers, without those that only Fortran 77 needs.
#[test]
fn numbers_of_the_module_are_those_of_the_headers() {
    let module = workspace("contact-elements/include/contact_elements.f90");
    let text = std::fs::read_to_string(module).expect("the module");
    let lists = text.lines().filter_map(|line| {
        let (_, list) = line.split_once("integer(i4), parameter :: ")?;
        Some(list)
    });
    let constants = lists.flat_map(|list| list.split(", ")).filter_map(|one| {
        let (name, value) = one.split_once(" = ")?;
        Some((name.strip_prefix("CTE_")?.to_string(), value.parse().ok()?))
    });
    let mut found: Vec<(String, i32)> = constants.collect();
    found.sort();
    let mut expected = numbers_of_the_headers();
    expected.retain(|(name, _)| !name.starts_with("F77_"));
    assert_eq!(found, expected);
}

#[test]
fn symbol_names_differ() {
    let mut symbols: Vec<String> = names().iter().map(|name| symbol_name(name)).collect();
    let count = symbols.len();
    symbols.sort();
    symbols.dedup();
    assert_eq!(symbols.len(), count);
}

#[test]
fn every_symbol_is_the_element_of_its_index() {
    let library = Library::contact_elements();
    let source = library.path().join("symbols.c");
    std::fs::write(&source, program(&names())).expect("a file");
    let executable = library.path().join("symbols");
    succeed(
        compiler::c()
            .arg(&source)
            .args(library.link())
            .arg("-o")
            .arg(&executable),
    );
    print!("{}", succeed(&mut Command::new(executable)));
}

/// Asks for every element by name, and calls its symbol with a null pointer.
fn program(names: &[String]) -> String {
    let mut checks = String::new();
    for name in names {
        let symbol = symbol_name(name);
        let index = format!("CTE_{}", symbol.to_uppercase());
        let length = name.len();
        let _ = writeln!(
            checks,
            "  failures += check(\"{name}\", {length}, {index}, cte_{symbol});"
        );
    }
    let count = names.len();
    format!(
        "#include \"contact_elements_symbols.h\"\n#include <stdio.h>\n\
         static int check(const char *name, int32_t length, int32_t index, int32_t (*f)(cte_arguments *))\n{{\n\
         \x20 int32_t found = -1;\n\
         \x20 const int pass = cte_element_find(name, length, &found) == CTE_SUCCESS && found == index &&\n\
         \x20   f(NULL) == CTE_ERROR_NULL;\n\
         \x20 if (!pass) printf(\"%s: index %d, found %d\\n\", name, (int)index, (int)found);\n\
         \x20 return !pass;\n}}\n\
         int main(void)\n{{\n  int failures = cte_element_count() != {count};\n{checks}\
         \x20 return failures != 0;\n}}\n"
    )
}

/// Fortran 95 knows no longer names; equal ones would be declared twice.
#[test]
fn names_of_the_fortran_include_differ_and_fit() {
    let text = std::fs::read_to_string(workspace("contact-elements/include/contact_elements.inc"))
        .expect("the include file");
    let mut names: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("      INTEGER "))
        .collect();
    let count = names.len();
    assert!(names.iter().all(|name| name.len() <= 31), "{names:?}");
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
}

#[test]
fn the_fortran_include_is_fortran_95() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    for name in ["fixed.f", "free.f90"] {
        let source = directory.path().join(name);
        let program = "      PROGRAM P\n      INCLUDE 'contact_elements.inc'\n      END\n";
        std::fs::write(&source, program).expect("a file");
        succeed(
            compiler::fortran(&source, directory.path())
                .args(["-std=f95", "-pedantic", "-Werror", "-fsyntax-only"])
                .arg(&source),
        );
    }
}

#[test]
fn the_fortran_include_reads_alike_in_both_forms() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let expected: String = (0..names().len()).map(|i| format!("{i}\n")).collect();
    for source in ["fixed.f", "free.f90"] {
        let source = directory.path().join(source);
        assert_eq!(printed(&source, directory.path()), expected);
    }
}

/// What a program prints that includes the file and writes every index.
fn printed(source: &Path, directory: &Path) -> String {
    let mut text = String::from("      PROGRAM INDICES\n      INCLUDE 'contact_elements.inc'\n");
    for name in names() {
        let name = short_name(&format!("CTE_{}", symbol_name(&name).to_uppercase()));
        let _ = writeln!(text, "      WRITE (*, '(I0)') {name}");
    }
    text.push_str("      END\n");
    std::fs::write(source, text).expect("a file");
    let executable = source.with_extension("out");
    succeed(
        compiler::fortran(source, directory)
            .arg(source)
            .arg("-o")
            .arg(&executable),
    );
    succeed(&mut Command::new(executable))
}
