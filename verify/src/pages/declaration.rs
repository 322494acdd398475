//! The text of declarations, cut out of a file of the language.

use std::collections::BTreeMap;

/// Texts of declarations by name of the element.
#[derive(Clone, Debug, Default)]
pub struct Declarations(BTreeMap<String, String>);

impl Declarations {
    /// Every `element NAME { … }` of a file with the comments above it.
    pub fn read(text: &str) -> Self {
        let mut found = BTreeMap::new();
        let mut above = String::new();
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            if line.starts_with("///") {
                above.push_str(line);
                above.push('\n');
                continue;
            }
            let mut item = std::mem::take(&mut above);
            let Some(rest) = line.trim_start().strip_prefix("element ") else {
                continue;
            };
            item.push_str(line);
            let depth =
                |text: &str| text.matches('{').count() as i32 - text.matches('}').count() as i32;
            let mut open = depth(line);
            while open > 0 {
                let Some(line) = lines.next() else { break };
                open += depth(line);
                item.push('\n');
                item.push_str(line);
            }
            let name = rest
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .next();
            found.insert(name.unwrap_or_default().to_string(), item);
        }
        Self(found)
    }

    /// The text of one declaration.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::Declarations;

    #[test]
    fn an_element_comes_with_its_comment() {
        let text = "/// A law.\nnormal law L(g;) { N = g; }\n/// First.\nelement A { slave: point; }\n\
                    element B {\n    master: point;\n}\n";
        let found = Declarations::read(text);
        assert_eq!(
            found.get("A"),
            Some("/// First.\nelement A { slave: point; }")
        );
        assert_eq!(found.get("B"), Some("element B {\n    master: point;\n}"));
        assert_eq!(found.get("L"), None);
    }
}
