//! What the compiler says of a declaration. `ui/fail` holds a file per class of mistake with the messages beside it;
//! `ui/pass` holds every line of the grammar page, and the compiler says nothing.
//!
//! `CONTACT_BLESS=1` rewrites the messages; read the difference.

use std::path::{Path, PathBuf};
use std::process::Command;

use contact_tests::committed::assert_committed;
use contact_tests::library::elements_crate;
use contact_tests::process::run;
use contact_tests::workspace;

/// Compiles a program up to its metadata; whether that succeeds, and what the compiler says.
fn compiled(source: &Path, elements: &Path) -> (bool, String) {
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    let external = format!("contact_elements={}", elements.display());
    rustc
        .args([
            "--edition=2024",
            "--crate-name=declared",
            "--crate-type=bin",
        ])
        .args(["--emit=metadata", "-Cpanic=abort", "--out-dir"])
        .arg(directory.path())
        .arg("--extern")
        .arg(external)
        .arg("-L")
        .arg(elements.with_file_name("deps"))
        .arg(source)
        // The messages name the file as it is given here.
        .current_dir(workspace("tests"));
    let output = run(&mut rustc);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.success(), said)
}

/// The programs in a folder of `ui`, by name, from the folder of the tests.
fn programs(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(workspace("tests").join(folder)).expect("a folder");
    let mut list: Vec<PathBuf> = entries
        .map(|entry| Path::new(folder).join(entry.expect("a file").file_name()))
        .filter(|path| path.extension().is_some_and(|ending| ending == "rs"))
        .collect();
    list.sort();
    list
}

/// The messages without the line that counts them.
fn messages(said: &str) -> String {
    let (before, _) = said
        .split_once("error: aborting due to")
        .unwrap_or((said, ""));
    format!("{}\n", before.trim_end())
}

#[test]
fn mistakes_have_their_messages() {
    let elements = elements_crate();
    let programs = programs("ui/fail");
    assert!(programs.len() >= 28, "only {} programs", programs.len());
    for program in programs {
        let (success, said) = compiled(&program, &elements);
        assert!(!success, "{} compiles", program.display());
        let expected = workspace("tests").join(program.with_extension("stderr"));
        assert_committed(&expected, &messages(&said));
    }
}

#[test]
fn every_line_of_the_grammar_compiles() {
    let elements = elements_crate();
    let programs = programs("ui/pass");
    assert!(programs.len() >= 3, "only {} programs", programs.len());
    for program in programs {
        let (success, said) = compiled(&program, &elements);
        assert!(success && said.is_empty(), "{}:\n{said}", program.display());
    }
}

/// Values in the table of the keys of an element, with their key: `gap: signed`.
fn choices(page: &str) -> Vec<String> {
    let (_, elements) = page.split_once("\n## Elements\n").expect("a chapter");
    let rows = elements.lines().skip_while(|line| !line.starts_with('|'));
    let table = rows.take_while(|line| line.starts_with('|')).skip(2);
    table
        .flat_map(|row| {
            let mut cells = row.split('|').skip(1);
            let mut quoted = [cells.next(), cells.next()].map(|cell| {
                let parts = cell.unwrap_or_default().split('`').skip(1).step_by(2);
                parts.map(str::to_string).collect::<Vec<String>>()
            });
            let key = quoted[0].pop().unwrap_or_default();
            let word = |value: &String| {
                value
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || "_23".contains(c))
            };
            let values = std::mem::take(&mut quoted[1]).into_iter().filter(word);
            values.map(move |value| format!("{key}: {value}"))
        })
        .collect()
}

#[test]
fn every_value_of_an_element_is_declared() {
    let declared = std::fs::read_to_string(workspace("tests/ui/pass/elements.rs")).expect("a file");
    let page = std::fs::read_to_string(workspace("docs/declare.md")).expect("a page");
    let choices = choices(&page);
    assert!(choices.len() >= 25, "found only {choices:?}");
    for choice in choices.iter().filter(|choice| !choice.ends_with(" placed")) {
        assert!(
            declared.contains(choice),
            "`{choice}` is not in ui/pass/elements.rs"
        );
    }
}

#[test]
fn the_count_of_messages_is_left_out() {
    let said = "error: a\n\nerror: aborting due to 1 previous error\n\n";
    assert_eq!(messages(said), "error: a\n");
    assert_eq!(messages("warning: b\n"), "warning: b\n");
}
