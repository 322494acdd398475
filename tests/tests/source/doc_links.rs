//! The documentation and the code agree: equation tags, names of terms, links, paths, library names
//! and examples. Each check has a counterpart below that sees it fail.

use contact_tests::documents::{
    TAG, TERMS, Text, dedent, is_ours, library_names, pages, problems_of_library,
    problems_of_links, problems_of_paths, problems_of_tags, read, rust_blocks, term_table,
    term_tags, texts,
};
use contact_tests::words::problems_of_words;

const LINEARISE: &str = "contact-macros/generator/src/linearise";
const LIBRARY: [(&str, &[&str]); 3] = [
    (
        "geometries",
        &["contact-macros/generator/library/geometries.contact"],
    ),
    ("laws", &["contact-macros/generator/library/laws.contact"]),
    (
        "elements",
        &[
            "contact-macros/generator/library/elements.contact",
            "contact-macros/generator/library/elements_extended.contact",
        ],
    ),
];

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
    for (kind, paths) in LIBRARY {
        let text: String = paths.iter().map(|path| read(path)).collect();
        let names = library_names(&text);
        assert!(names.len() >= 3, "{paths:?}: found only {names:?}");
        report(&problems_of_library(&page, &names));
        let count = format!("{} {kind}", names.len());
        assert!(start.contains(&count), "README.md does not say `{count}`");
    }
}

/// What `docs/` shows is what `cargo build --examples` compiles.
#[test]
fn rust_in_the_docs_is_compiled() {
    let compiled = dedent(&read("contact-elements/library/examples/documented.rs"));
    let mut count = 0;
    for page in pages().iter().filter(|page| is_ours(&page.path)) {
        for block in rust_blocks(&page.content) {
            count += 1;
            assert!(
                compiled.contains(&block),
                "{}: not in contact-elements/library/examples/documented.rs:\n{block}",
                page.path
            );
        }
    }
    assert!(count >= 5, "found only {count} blocks of Rust");
}

#[test]
fn words_are_plain() {
    let of_the_checks = ["tests/src/words.rs", "CHANGELOG.md"];
    let [pages, code] = [pages(), texts(&[".rs", ".contact", ".h", ".f90", ".c"])].map(|texts| {
        let of_others = texts
            .into_iter()
            .filter(|text| !of_the_checks.contains(&&*text.path));
        of_others.collect::<Vec<_>>()
    });
    report(&problems_of_words(&pages, &code));
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
        assert!(
            problems_of_paths(&[text("docs/a.md", "`tests/tests/source/doc_links.rs`")]).is_empty()
        );
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
