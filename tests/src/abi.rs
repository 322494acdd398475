//! The binary interface as text: what a library promises, and whether another one keeps it.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use contact_generator::header::C_HEADERS;

use crate::compiler;
use crate::header::structs;
use crate::library::Library;
use crate::process::{run, succeed, text};
use crate::workspace;

/// Sections of the baseline; each grows at its end only.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Interface {
    /// Exported functions.
    symbols: Vec<String>,
    /// `struct.field offset size`, struct by struct.
    fields: Vec<String>,
    /// `index name: parameter parameter ..`.
    elements: Vec<String>,
}

const HEAD: &str = "# The frozen interface of libcontact_elements.so.1; see tests/README.md.\n\
# symbol NAME | field STRUCT.FIELD OFFSET SIZE | element INDEX NAME: PARAMETERS\n";

impl Interface {
    /// The interface of a built library and of the header.
    pub fn of(library: &Library) -> Self {
        let nm = succeed(
            Command::new("nm")
                .args(["-D", "--defined-only"])
                .arg(library.shared()),
        );
        let symbol = |line: &str| line.split_whitespace().last().map(str::to_string);
        let described = described(library);
        let section = |word: &str| -> Vec<String> {
            let lines = described.lines();
            lines
                .filter_map(|line| line.strip_prefix(word))
                .map(|line| line.trim().to_string())
                .collect()
        };
        Interface {
            symbols: nm.lines().filter_map(symbol).collect(),
            fields: section("field "),
            elements: section("element "),
        }
    }

    /// The interface in a baseline file.
    pub fn parse(text: &str) -> Self {
        let mut interface = Interface::default();
        for line in text.lines() {
            match line.split_once(' ') {
                Some(("symbol", rest)) => interface.symbols.push(rest.to_string()),
                Some(("field", rest)) => interface.fields.push(rest.to_string()),
                Some(("element", rest)) => interface.elements.push(rest.to_string()),
                _ => {}
            }
        }
        interface
    }

    /// The baseline file.
    pub fn text(&self) -> String {
        let mut text = HEAD.to_string();
        for (word, lines) in [
            ("symbol", &self.symbols),
            ("field", &self.fields),
            ("element", &self.elements),
        ] {
            for line in lines {
                let _ = writeln!(text, "{word} {line}");
            }
        }
        text
    }

    /// Promises of `self` that `found` does not keep: symbols and fields stay, elements keep their
    /// index and the order of their parameters.
    pub fn broken_by(&self, found: &Interface) -> Vec<String> {
        let mut broken = Vec::new();
        let mut missing = |promised: &[String], found: &[String]| {
            let gone = promised.iter().filter(|line| !found.contains(line));
            broken.extend(gone.cloned());
        };
        missing(&self.symbols, &found.symbols);
        missing(&self.fields, &found.fields);
        for (index, promised) in self.elements.iter().enumerate() {
            let kept = |line: &String| {
                let (mut old, mut new) = (promised.split(' '), line.split(' '));
                old.all(|word| new.next() == Some(word))
            };
            if !found.elements.get(index).is_some_and(kept) {
                broken.push(promised.clone());
            }
        }
        broken
    }

    /// `self` with everything new in `found` at the end of its section.
    pub fn extended_by(&self, found: &Interface) -> Interface {
        let extended = |old: &[String], new: &[String]| -> Vec<String> {
            let added = new.iter().filter(|line| !old.contains(line));
            old.iter().chain(added).cloned().collect()
        };
        Interface {
            symbols: extended(&self.symbols, &found.symbols),
            fields: extended(&self.fields, &found.fields),
            elements: found.elements.clone(),
        }
    }
}

/// Runs a C program that prints offset and size of every field, and every element.
fn described(library: &Library) -> String {
    let mut fields = String::new();
    for item in C_HEADERS.iter().flat_map(|(_, text)| structs(text)) {
        let name = &item.name;
        for field in &item.fields {
            let _ = writeln!(
                fields,
                "  printf(\"field {name}.{field} %d %d\\n\", (int)offsetof({name}, {field}), \
                 (int)sizeof(((({name} *)0)->{field})));"
            );
        }
    }
    let source = library.path().join("describe.c");
    let program = include_str!("../abi/describe.c").replace("/* fields */", fields.trim());
    std::fs::write(&source, program).expect("a file");
    let executable = source.with_extension("out");
    let mut compiler = compiler::c();
    succeed(
        compiler
            .arg(&source)
            .args(library.link())
            .arg("-o")
            .arg(&executable),
    );
    succeed(&mut Command::new(executable))
}

/// Writes the types of a shared object with debug information as text.
pub fn abidw(object: &Path, to: &Path) {
    succeed(
        with_opaque_types("abidw")
            .args(["--no-corpus-path", "--no-comp-dir-path", "--no-show-locs"])
            .arg("--out-file")
            .arg(to)
            .arg(object),
    );
}

/// Whether a shared object keeps everything in a baseline of [`abidw`], and the report.
/// Functions may be added.
pub fn abidiff(baseline: &Path, object: &Path) -> (bool, String) {
    let output = run(with_opaque_types("abidiff")
        .arg("--no-added-syms")
        .arg(baseline)
        .arg(object));
    (output.status.success(), text(&output))
}

/// A tool that leaves out what stands behind `const cte_element *`.
fn with_opaque_types(tool: &str) -> Command {
    let mut command = Command::new(tool);
    command
        .arg("--suppressions")
        .arg(workspace("tests/abi/opaque.suppr"));
    command
}

/// A baseline of [`abidw`] in which the field of a struct stands 8 bytes further on.
pub fn with_moved_field(baseline: &str, item: &str, field: &str) -> Option<String> {
    const OFFSET: &str = "layout-offset-in-bits='";
    let item = baseline.find(&format!("<class-decl name='{item}'"))?;
    let field = item + baseline[item..].find(&format!("name='{field}'"))?;
    let start = item + baseline[item..field].rfind(OFFSET)? + OFFSET.len();
    let (before, rest) = baseline.split_at(start);
    let (bits, after) = rest.split_once('\'')?;
    let bits: u64 = bits.parse().ok()?;
    Some(format!("{before}{}'{after}", bits + 64))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = "symbol b\nsymbol a\nfield s.x 0 8\nelement 0 One: p q\n";

    #[test]
    fn growth_is_allowed_at_the_end() {
        let old = Interface::parse(OLD);
        let new = Interface::parse(
            "symbol a\nsymbol aa\nsymbol b\nfield s.x 0 8\nfield s.y 8 8\n\
             element 0 One: p q r\nelement 1 Two: p\n",
        );
        assert!(old.broken_by(&new).is_empty());
        let text = old.extended_by(&new).text();
        assert!(
            text.contains("symbol b\nsymbol a\nsymbol aa\nfield s.x"),
            "{text}"
        );
        assert!(
            text.ends_with("element 0 One: p q r\nelement 1 Two: p\n"),
            "{text}"
        );
    }

    #[test]
    fn every_broken_promise_is_found() {
        let old = Interface::parse(OLD);
        let new = Interface::parse("symbol b\nfield s.x 4 8\nelement 0 One: q p\n");
        assert_eq!(old.broken_by(&new), ["a", "s.x 0 8", "0 One: p q"]);
        let moved = Interface::parse(&OLD.replace("0 One: p q", "0 Two: p\nelement 1 One: p q"));
        assert_eq!(old.broken_by(&moved), ["0 One: p q"]);
    }
}
