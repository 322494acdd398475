//! The texts of the project, and where its documentation and its code disagree.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::workspace;

/// Beginning of a tag; written in parts so that this file cites no tag.
pub const TAG: &str = concat!("[", "eq:");
/// Folders that hold no text of the project.
const SKIPPED: [&str; 4] = ["target", ".git", ".library", "node_modules"];
/// Around the table of terms.
pub const TERMS: [&str; 2] = ["<!-- terms:begin -->", "<!-- terms:end -->"];

/// A text with its path in the repository.
#[derive(Clone)]
pub struct Text {
    /// From the root of the repository.
    pub path: String,
    /// All of it.
    pub content: String,
}

/// All texts with one of the endings.
pub fn texts(endings: &[&str]) -> Vec<Text> {
    let mut found = Vec::new();
    collect(&workspace(""), "", endings, &mut found);
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

/// A file of the repository.
pub fn read(path: &str) -> String {
    fs::read_to_string(workspace(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// All pages of the documentation.
pub fn pages() -> Vec<Text> {
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

/// Arguments of `.term(`, `.terms(` and `.left_out(` in the linearisations; where the argument is a variable, the
/// literals of that file that look like tags.
pub fn term_tags(sources: &[Text]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for source in sources {
        let mut by_variable = false;
        for call in [".term(", ".terms(", ".left_out("] {
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
pub fn term_table(page: &str) -> BTreeSet<String> {
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

/// Tags that are defined twice, cited without a definition or defined without a citation.
pub fn problems_of_tags(pages: &[Text], code: &[Text], terms: &BTreeSet<String>) -> Vec<String> {
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

/// Links that lead to no file.
pub fn problems_of_links(pages: &[Text]) -> Vec<String> {
    let mut problems = Vec::new();
    for page in pages {
        let folder = workspace(&page.path).with_file_name("");
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

/// Files named by our own pages that do not exist.
pub fn problems_of_paths(pages: &[Text]) -> Vec<String> {
    let mut problems = Vec::new();
    for page in pages.iter().filter(|page| is_ours(&page.path)) {
        for path in named_files(&without_code(&page.content)) {
            let beside = workspace(&page.path).with_file_name(path);
            if !workspace(path).exists() && !beside.exists() {
                problems.push(format!("{}: names {path}, which does not exist", page.path));
            }
        }
    }
    problems
}

/// Pages whose paths start at the root of the repository.
pub fn is_ours(path: &str) -> bool {
    path.starts_with("docs/") || !path.contains('/')
}

/// Names of the items of a library file.
pub fn library_names(text: &str) -> Vec<String> {
    let kinds = [
        "surface ",
        "curve ",
        "rigid surface ",
        "rigid curve ",
        "rigid distance ",
        "normal law ",
        "tangential law ",
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

/// Names without a row in the tables of docs/declare.md.
pub fn problems_of_library(page: &str, names: &[String]) -> Vec<String> {
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

/// A whole program of a page, and what the page says it prints.
pub struct Quoted {
    /// The page.
    pub path: String,
    /// The source.
    pub program: String,
    /// The block of text that follows it.
    pub printed: String,
}

/// Fenced blocks of a page: language, content.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let fenced = page.split("\n```").skip(1).step_by(2);
    fenced.filter_map(|block| block.split_once('\n')).collect()
}

/// The programs in one language, told by how a line of theirs starts; the next block of their page is
/// the text that they print.
pub fn quoted_programs(pages: &[Text], language: &str, start: &str) -> Vec<Quoted> {
    let mut found = Vec::new();
    for page in pages.iter().filter(|page| is_ours(&page.path)) {
        let blocks = blocks(&page.content);
        for (at, (kind, program)) in blocks.iter().enumerate() {
            if *kind != language || !program.lines().any(|line| line.starts_with(start)) {
                continue;
            }
            let Some(("text", printed)) = blocks.get(at + 1) else {
                panic!(
                    "{}: a program without a block of text that it prints",
                    page.path
                );
            };
            found.push(Quoted {
                path: page.path.clone(),
                program: format!("{program}\n"),
                printed: format!("{printed}\n"),
            });
        }
    }
    found
}

/// Blocks of Rust in a page, one line per line of code without indentation.
pub fn rust_blocks(page: &str) -> Vec<String> {
    let blocks = page.split("\n```rust\n").skip(1);
    blocks
        .filter_map(|rest| rest.split("\n```").next())
        .map(dedent)
        .collect()
}

/// Lines without indentation.
pub fn dedent(text: &str) -> String {
    text.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}
