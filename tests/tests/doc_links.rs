//! The documentation and the code agree: equation tags, names of terms, links, paths, library names
//! and examples. Each check has a counterpart below that sees it fail.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// How a tag begins; written apart so that this file cites none.
const TAG: &str = concat!("[", "eq:");
/// Folders that hold no text of the project.
const SKIPPED: [&str; 4] = ["target", ".git", ".library", "node_modules"];
const TERMS: [&str; 2] = ["<!-- terms:begin -->", "<!-- terms:end -->"];
const LINEARISE: &str = "contact-macros/generator/src/linearise";
const LIBRARY: [(&str, &str); 3] = [
    (
        "geometries",
        "contact-macros/generator/library/geometries.contact",
    ),
    ("laws", "contact-macros/generator/library/laws.contact"),
    (
        "elements",
        "contact-macros/generator/library/elements.contact",
    ),
];

/// A text with its path in the repository.
#[derive(Clone)]
struct Text {
    path: String,
    content: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All texts with one of the endings.
fn texts(endings: &[&str]) -> Vec<Text> {
    let mut found = Vec::new();
    collect(&root(), "", endings, &mut found);
    found.sort_by(|a, b| a.path.cmp(&b.path));
    assert!(!found.is_empty(), "no files: {endings:?}");
    found
}

fn collect(folder: &Path, prefix: &str, endings: &[&str], found: &mut Vec<Text>) {
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = entry.path();
        let inside = format!("{prefix}{name}");
        if path.is_dir() {
            if !SKIPPED.contains(&name.as_str()) {
                collect(&path, &format!("{inside}/"), endings, found);
            }
        } else if endings.iter().any(|ending| name.ends_with(ending))
            && let Ok(content) = fs::read_to_string(&path)
        {
            found.push(Text {
                path: inside,
                content,
            });
        }
    }
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn pages() -> Vec<Text> {
    texts(&[".md"])
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')
}

/// Tags in a text, with whether each stands in bold, as definitions do.
fn tags(content: &str) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    for (at, _) in content.match_indices(TAG) {
        let rest = &content[at + TAG.len()..];
        let Some((name, after)) = rest.split_once(']') else {
            continue;
        };
        if is_name(name) {
            let defined = content[..at].ends_with("**") && after.starts_with("**");
            found.push((name.to_string(), defined));
        }
    }
    found
}

/// Places where each tag is defined.
fn definitions(pages: &[Text]) -> BTreeMap<String, Vec<String>> {
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for page in pages {
        for (tag, defined) in tags(&page.content) {
            if defined {
                found.entry(tag).or_default().push(page.path.clone());
            }
        }
    }
    found
}

/// Arguments of `.term(` and `.left_out(` in the linearisations; where the argument is a variable, the
/// literals of that file that look like tags.
fn term_tags(sources: &[Text]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for source in sources {
        let mut by_variable = false;
        for call in [".term(", ".left_out("] {
            for (at, _) in source.content.match_indices(call) {
                let argument = source.content[at + call.len()..].trim_start();
                match argument.strip_prefix('"') {
                    Some(rest) => {
                        found.extend(rest.split('"').next().map(str::to_string));
                    }
                    None => by_variable = true,
                }
            }
        }
        if by_variable {
            let literals = source.content.split('"').skip(1).step_by(2);
            found.extend(
                literals
                    .filter(|text| is_name(text) && text.contains('-'))
                    .map(str::to_string),
            );
        }
    }
    found
}

/// First cells in backticks of the table of terms.
fn term_table(page: &str) -> BTreeSet<String> {
    let inside = between(page, TERMS[0], TERMS[1]).expect("the table of terms");
    let cells = inside.lines().filter_map(|line| line.strip_prefix("| `"));
    cells
        .filter_map(|rest| rest.split('`').next())
        .map(str::to_string)
        .collect()
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(start)?;
    rest.split_once(end).map(|(inside, _)| inside)
}

fn problems_of_tags(pages: &[Text], code: &[Text], terms: &BTreeSet<String>) -> Vec<String> {
    let defined = definitions(pages);
    let mut problems = Vec::new();
    for (tag, places) in &defined {
        if places.len() > 1 {
            problems.push(format!("{tag}: defined {} times: {places:?}", places.len()));
        }
    }
    let mut cited = terms.clone();
    for text in pages.iter().chain(code) {
        for (tag, definition) in tags(&text.content) {
            if !defined.contains_key(&tag) {
                problems.push(format!("{}: cites {tag}, which no page defines", text.path));
            }
            if !definition && !text.path.ends_with(".md") {
                cited.insert(tag);
            }
        }
    }
    for tag in defined.keys().filter(|tag| !cited.contains(*tag)) {
        problems.push(format!("{tag}: defined, but no code cites it"));
    }
    for tag in terms.iter().filter(|tag| !defined.contains_key(*tag)) {
        problems.push(format!("term {tag}: no page defines it"));
    }
    problems
}

/// Targets of the links of a page, without those to other sites and to headings.
fn links(page: &str) -> Vec<&str> {
    let prose = without_code(page);
    let mut found = Vec::new();
    for (at, _) in page.match_indices("](") {
        let target = page[at + 2..].split(')').next().unwrap_or("");
        let file = target.split('#').next().unwrap_or("");
        if !file.is_empty() && !file.contains("://") && prose.contains(&format!("]({target}")) {
            found.push(file);
        }
    }
    found
}

/// The page without its blocks of code.
fn without_code(page: &str) -> String {
    page.split("\n```").step_by(2).collect()
}

fn problems_of_links(pages: &[Text]) -> Vec<String> {
    let mut problems = Vec::new();
    for page in pages {
        let folder = root().join(&page.path).with_file_name("");
        for link in links(&page.content) {
            if !folder.join(link).exists() {
                problems.push(format!("{}: no file {link}", page.path));
            }
        }
    }
    problems
}

/// Files named in backticks: with a folder and an ending that the project has.
fn named_files(page: &str) -> Vec<&str> {
    let endings = [".rs", ".h", ".md", ".contact", ".c", ".f90", ".f", ".toml"];
    let quoted = page.split('`').skip(1).step_by(2);
    quoted
        .filter(|text| text.contains('/') && endings.iter().any(|ending| text.ends_with(ending)))
        .filter(|text| !text.contains([' ', '*', '<', '(']))
        .collect()
}

fn problems_of_paths(pages: &[Text]) -> Vec<String> {
    let mut problems = Vec::new();
    for page in pages.iter().filter(|page| is_ours(&page.path)) {
        for path in named_files(&without_code(&page.content)) {
            let beside = root().join(&page.path).with_file_name(path);
            if !root().join(path).exists() && !beside.exists() {
                problems.push(format!("{}: names {path}, which does not exist", page.path));
            }
        }
    }
    problems
}

/// Pages whose paths start at the root of the repository.
fn is_ours(path: &str) -> bool {
    path.starts_with("docs/") || !path.contains('/')
}

/// Names of the items of a library file.
fn library_names(text: &str) -> Vec<String> {
    let kinds = [
        "surface ",
        "curve ",
        "rigid surface ",
        "rigid curve ",
        "rigid distance ",
        "normal law ",
        "element ",
    ];
    let heads = text
        .lines()
        .filter_map(|line| kinds.iter().find_map(|kind| line.strip_prefix(kind)));
    heads
        .filter_map(|rest| rest.split(|c: char| !c.is_alphanumeric()).next())
        .map(str::to_string)
        .collect()
}

fn problems_of_library(page: &str, names: &[String]) -> Vec<String> {
    names
        .iter()
        .filter(|name| {
            !page
                .lines()
                .any(|line| line.starts_with(&format!("| `{name}` |")))
        })
        .map(|name| format!("{name}: no row in docs/declare.md"))
        .collect()
}

/// Blocks of Rust in a page, one line per line of code without indentation.
fn rust_blocks(page: &str) -> Vec<String> {
    let blocks = page.split("\n```rust\n").skip(1);
    blocks
        .filter_map(|rest| rest.split("\n```").next())
        .map(dedent)
        .collect()
}

fn dedent(text: &str) -> String {
    text.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

fn report(problems: &[String]) {
    assert!(problems.is_empty(), "\n  {}\n", problems.join("\n  "));
}

#[test]
fn equation_tags_lead_both_ways() {
    let code = texts(&[".rs", ".contact", ".h", ".f90", ".c"]);
    let sources = linearisations(&code);
    report(&problems_of_tags(&pages(), &code, &term_tags(&sources)));
}

fn linearisations(code: &[Text]) -> Vec<Text> {
    code.iter()
        .filter(|text| text.path.starts_with(LINEARISE))
        .cloned()
        .collect()
}

#[test]
fn terms_of_the_generator_are_the_terms_of_the_table() {
    let code = term_tags(&linearisations(&texts(&[".rs"])));
    let table = term_table(&read("docs/theory/README.md"));
    assert!(code.len() >= 10, "found only {code:?}");
    assert_eq!(
        code, table,
        "left: program.term(..); right: docs/theory/README.md"
    );
}

#[test]
fn links_lead_to_files() {
    report(&problems_of_links(&pages()));
}

#[test]
fn named_paths_exist() {
    report(&problems_of_paths(&pages()));
}

#[test]
fn every_library_item_has_a_row() {
    let page = read("docs/declare.md");
    let start = read("README.md");
    for (kind, path) in LIBRARY {
        let names = library_names(&read(path));
        assert!(names.len() >= 3, "{path}: found only {names:?}");
        report(&problems_of_library(&page, &names));
        let count = format!("{} {kind}", names.len());
        assert!(start.contains(&count), "README.md does not say `{count}`");
    }
}

/// What `docs/` shows is what `cargo build --examples` compiles.
#[test]
fn rust_in_the_docs_is_compiled() {
    let compiled = dedent(&read("contact-elements/examples/documented.rs"));
    let mut count = 0;
    for page in pages().iter().filter(|page| is_ours(&page.path)) {
        for block in rust_blocks(&page.content) {
            count += 1;
            assert!(
                compiled.contains(&block),
                "{}: not in contact-elements/examples/documented.rs:\n{block}",
                page.path
            );
        }
    }
    assert!(count >= 5, "found only {count} blocks of Rust");
}

/// The checks see what is wrong.
mod failures {
    use super::*;

    fn text(path: &str, content: &str) -> Text {
        Text {
            path: path.to_string(),
            content: content.replace("@", TAG),
        }
    }

    fn problems(page: &str, code: &str, terms: &[&str]) -> Vec<String> {
        let terms = terms.iter().map(ToString::to_string).collect();
        problems_of_tags(&[text("docs/a.md", page)], &[text("a.rs", code)], &terms)
    }

    #[test]
    fn tags() {
        assert!(problems("**@gap]** g = L", "// @gap]", &[]).is_empty());
        assert!(problems("**@energy]** W", "", &["energy"]).is_empty());
        assert_eq!(
            problems("**@gap]** **@gap]**", "// @gap]", &[]).len(),
            1,
            "twice"
        );
        assert_eq!(problems("", "// @gap]", &[]).len(), 1, "not defined");
        assert_eq!(
            problems("**@gap]** and @gap]", "", &[]).len(),
            1,
            "not cited by code"
        );
        assert_eq!(
            problems("", "", &["12-main"]).len(),
            1,
            "term without a page"
        );
    }

    #[test]
    fn terms() {
        let source = text(
            "a.rs",
            "p.term(\n  \"x-1\", c, \"\"); p.left_out(\"y\", \"why\"); p.term(tag, c, \"\"); [\"z-2\", \"q\"]",
        );
        let found: Vec<String> = term_tags(&[source]).into_iter().collect();
        assert_eq!(found, ["x-1", "y", "z-2"]);
        let table = format!("{}\n| term |\n| `x-1` | a |\n{}", TERMS[0], TERMS[1]);
        assert_eq!(term_table(&table).into_iter().collect::<Vec<_>>(), ["x-1"]);
    }

    #[test]
    fn files() {
        let good = "[a](../README.md#top) [b](https://example.org) [c](#here)";
        assert!(problems_of_links(&[text("docs/a.md", good)]).is_empty());
        assert_eq!(
            problems_of_links(&[text("docs/a.md", "[a](absent.md)")]).len(),
            1
        );
        let code = "\n```rust\nf[0](x)\n```\n";
        assert!(problems_of_links(&[text("docs/a.md", code)]).is_empty());
        assert!(problems_of_paths(&[text("docs/a.md", "`tests/tests/doc_links.rs`")]).is_empty());
        assert_eq!(
            problems_of_paths(&[text("docs/a.md", "`tests/absent.rs`")]).len(),
            1
        );
    }

    #[test]
    fn names() {
        let names =
            library_names("/// A line.\ncurve Line2(xi) in line {\nelement A { slave: point; }");
        assert_eq!(names, ["Line2", "A"]);
        assert_eq!(problems_of_library("| `Line2` | curve |", &names).len(), 1);
    }

    #[test]
    fn blocks() {
        let page = "text\n```rust\nlet a = 1;\n    let b = 2;\n```\n";
        assert_eq!(rust_blocks(page), ["let a = 1;\nlet b = 2;"]);
    }
}
