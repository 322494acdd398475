//! The words of the project: sentences that a reader understands without having read the rest.
//!
//! The rules stand in `CONTRIBUTING.md`. Only what a machine can tell is checked here.

use crate::documents::Text;

/// What a text must not say, and what to write instead.
const PHRASES: [(&str, &str); 7] = [
    ("is no number", "`is NaN`"),
    ("are no numbers", "`are NaN`"),
    ("Wanted: ", "the target and its reason"),
    ("was wanted", "the target and its reason"),
    ("of one's own", "`your own`"),
    (" anew", "`again`, `rewrite`, `restart`"),
    ("; none: ", "`None` if ..."),
];

/// How a doc comment must not begin: its first word is what the item is.
const BEGINNINGS: [&str; 2] = ["Of ", "None of "];

/// The rules themselves quote what they forbid.
const QUOTES: [&str; 2] = ["<!-- words:begin -->", "<!-- words:end -->"];

/// Phrases of pages, of comments in code, and doc comments without a subject.
pub fn problems_of_words(pages: &[Text], code: &[Text]) -> Vec<String> {
    let said = pages.iter().flat_map(|page| {
        let mut quotes = false;
        numbered(page).filter(move |(.., line)| {
            quotes = (quotes || line.contains(QUOTES[0])) && !line.contains(QUOTES[1]);
            !quotes
        })
    });
    let commented = code
        .iter()
        .flat_map(numbered)
        .filter_map(|(path, number, line)| comment(line).map(|text| (path, number, text)));
    let phrases = said.chain(commented).flat_map(|(path, number, line)| {
        let found = PHRASES.iter().filter(|(phrase, _)| line.contains(phrase));
        found.map(move |(phrase, better)| {
            format!("{path}:{number}: `{}`: write {better}", phrase.trim())
        })
    });
    phrases.chain(code.iter().flat_map(headless)).collect()
}

fn numbered(text: &Text) -> impl Iterator<Item = (&str, usize, &str)> {
    let lines = text.content.lines().enumerate();
    lines.map(|(number, line)| (text.path.as_str(), number + 1, line))
}

/// The text of a line that is a comment in Rust, C or Fortran.
fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let marks = ["///", "//!", "//", "/*", "* ", "!"];
    marks.iter().find_map(|mark| line.strip_prefix(mark))
}

/// Doc comments whose first line begins with a preposition instead of a noun.
fn headless(text: &Text) -> Vec<String> {
    let mut before = "";
    let mut found = Vec::new();
    for (path, number, line) in numbered(text) {
        let line = line.trim_start();
        let first = line
            .strip_prefix("/// ")
            .filter(|_| !before.starts_with("///"));
        if let Some(doc) = first.filter(|doc| BEGINNINGS.iter().any(|start| doc.starts_with(start)))
        {
            found.push(format!("{path}:{number}: `{doc}`: begin with the noun"));
        }
        before = line;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problems(page: &str, code: &str) -> Vec<String> {
        let text = |path: &str, content: &str| Text {
            path: path.to_string(),
            content: content.to_string(),
        };
        problems_of_words(&[text("docs/a.md", page)], &[text("a.rs", code)])
    }

    #[test]
    fn phrases_are_found_in_pages_and_comments() {
        assert_eq!(problems("A gap that is no number.", "").len(), 1);
        assert_eq!(problems("", "    // Wanted: 1.3\n").len(), 1);
        assert!(problems("", "let name = \"is no number\";").is_empty());
        assert!(problems("A gap that is NaN.", "/// The gap.").is_empty());
    }

    #[test]
    fn rules_may_quote_what_they_forbid() {
        let page = format!("{}\nis no number\n{}\n", QUOTES[0], QUOTES[1]);
        assert!(problems(&page, "").is_empty());
        assert_eq!(problems(&format!("{page}is no number"), "").len(), 1);
    }

    #[test]
    fn doc_comments_begin_with_the_noun() {
        assert_eq!(problems("", "/// Of the tangent.\n").len(), 1);
        assert!(problems("", "/// Error\n/// Of the tangent.\n").is_empty());
        assert!(problems("", "/// Worst error of the tangent.\n").is_empty());
    }
}
