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

/// What encloses the tag of a definition; in two pieces, as the tests of the documentation read this file.
const OPEN: &str = concat!("**[", "eq:");
const CLOSE: &str = "]**";

/// Equations by tag.
#[derive(Clone, Debug, Default)]
pub struct Equations(BTreeMap<String, Equation>);

impl Equations {
    /// Adds the equations that a page defines. A definition `**[eq:…]**` stands before its equation or in the first
    /// cell of a row. Further tags of a line name parts of its equation.
    pub fn add(&mut self, page: &str, text: &str) {
        for line in text.lines() {
            let mut parts = line.split(OPEN);
            let before = parts.next().unwrap_or_default();
            let Some((tag, after)) = parts.next().and_then(|part| part.split_once(CLOSE)) else {
                continue;
            };
            let rest = line.split_once(CLOSE).map_or(after, |(_, rest)| rest);
            let is_row = before.trim_start().starts_with('|');
            let whole = if is_row {
                cells(rest).into_iter().nth(1).unwrap_or_default()
            } else {
                rest.trim().to_string()
            };
            let whole = whole.replace(OPEN, "").replace(CLOSE, "");
            for (tag, after) in parts.filter_map(|part| part.split_once(CLOSE)) {
                self.insert(tag, own_equation(after).unwrap_or(&whole), page);
            }
            self.insert(tag, &whole, page);
        }
    }

    fn insert(&mut self, tag: &str, text: &str, page: &str) {
        let equation = Equation {
            text: text.to_string(),
            page: page.to_string(),
        };
        self.0.insert(tag.to_string(), equation);
    }

    /// The equation of a tag.
    pub fn get(&self, tag: &str) -> Option<&Equation> {
        self.0.get(tag)
    }
}

/// The formula that follows a tag at once, if one does.
fn own_equation(after: &str) -> Option<&str> {
    let formula = after.trim_start().strip_prefix("$`")?;
    let end = formula.find("`$")?;
    let start = after.len() - after.trim_start().len();
    after.get(start..start + 2 + end + 2)
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
        let page = "| **@a]** | `\\|x\\|` | source |\ntext\n**@b]** `y = 1`. More.\n\
                    **@d]** $`z = p + q`$ of **@e]** $`p`$ and **@f]**.\n";
        let page = page.replace('@', concat!("[", "eq:"));
        equations.add("page.md", &page);
        let text = |tag: &str| {
            equations
                .get(tag)
                .map(|Equation { text, .. }| text.as_str())
        };
        assert_eq!(text("a"), Some("`|x|`"));
        assert_eq!(text("b"), Some("`y = 1`. More."));
        assert_eq!(text("c"), None);
        assert_eq!(text("e"), Some("$`p`$"));
        assert_eq!(text("f"), Some("$`z = p + q`$ of e $`p`$ and f."));
    }
}
