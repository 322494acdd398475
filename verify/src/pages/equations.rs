//! The equations of the documentation by their tags.

use std::collections::BTreeMap;

/// What a page of the documentation says at a tag.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// The equation, in the markup of the documentation.
    pub text: String,
    /// Name of the page.
    pub page: String,
}

/// Equations by tag.
#[derive(Clone, Debug, Default)]
pub struct Equations(BTreeMap<String, Equation>);

impl Equations {
    /// Adds the equations that a page defines: `**[eq:…]**`, alone before the equation or in the first cell of a row.
    pub fn add(&mut self, page: &str, text: &str) {
        for line in text.lines() {
            let Some((before, rest)) = line.split_once("**[eq:") else {
                continue;
            };
            let Some((tag, after)) = rest.split_once("]**") else {
                continue;
            };
            let is_row = before.trim_start().starts_with('|');
            let text = if is_row {
                cells(after).into_iter().nth(1).unwrap_or_default()
            } else {
                after.trim().to_string()
            };
            let page = page.to_string();
            self.0.insert(tag.to_string(), Equation { text, page });
        }
    }

    /// The equation of a tag.
    pub fn get(&self, tag: &str) -> Option<&Equation> {
        self.0.get(tag)
    }
}

/// The cells of a row; `\|` is no border.
fn cells(row: &str) -> Vec<String> {
    let whole = row.replace("\\|", "\u{0}");
    let cells = whole.split('|');
    cells
        .map(|cell| cell.trim().replace('\u{0}', "|"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Equation, Equations};

    #[test]
    fn equations_stand_in_rows_and_alone() {
        let mut equations = Equations::default();
        // the tags are made here: the tests of the documentation read this file
        let page = "| **@a]** | `\\|x\\|` | source |\ntext\n**@b]** `y = 1`. More.\n"
            .replace('@', concat!("[", "eq:"));
        equations.add("page.md", &page);
        let text = |tag: &str| {
            equations
                .get(tag)
                .map(|Equation { text, .. }| text.as_str())
        };
        assert_eq!(text("a"), Some("`|x|`"));
        assert_eq!(text("b"), Some("`y = 1`. More."));
        assert_eq!(text("c"), None);
    }
}
