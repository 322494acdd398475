//! C headers: those of the interface, and the one of a library under its own prefix.

use std::fmt::Write as _;

use crate::emit::symbol_name;
use crate::model::Element;

macro_rules! headers {
    ($($name:literal),*) => {
        [$(($name, include_str!(concat!("../../../../contact-elements/include/", $name)))),*]
    };
}

/// The headers of the interface by name, the one that includes all others first.
pub const C_HEADERS: [(&str, &str); 6] = headers![
    "contact_elements.h",
    "contact_elements_call.h",
    "contact_elements_batch.h",
    "contact_elements_pairs.h",
    "contact_elements_table.h",
    "contact_elements_f77.h"
];

/// Symbols of `elements` under `prefix`: one evaluation function and one index per element.
pub fn symbols(prefix: &str, elements: &[Element]) -> String {
    let upper = prefix.to_uppercase();
    let mut text = String::new();
    for (index, element) in elements.iter().enumerate() {
        let symbol = symbol_name(&element.name.to_string());
        for line in element.docs.trim().lines() {
            let _ = writeln!(text, "/* {} */", comment(line.trim()));
        }
        let _ = writeln!(text, "#define {upper}_{} {index}", symbol.to_uppercase());
        let _ = writeln!(
            text,
            "int32_t {prefix}_{symbol}(cte_arguments *arguments);\n"
        );
    }
    text
}

/// Text that neither ends nor opens a C comment.
fn comment(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *")
}

/// The declarations of the element symbols as a separate header, beside `contact_elements.h`.
pub fn symbols_header(prefix: &str, elements: &[Element]) -> String {
    let guard = format!("{}_SYMBOLS_H", prefix.to_uppercase());
    let symbols = symbols(prefix, elements);
    format!(
        "/* Index and function of every element of the library `{prefix}`; rules: contact_elements.h. */\n\
         #ifndef {guard}\n#define {guard}\n\n#include \"contact_elements.h\"\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{symbols}\
         #ifdef __cplusplus\n}}\n#endif\n#endif\n"
    )
}

/// A complete header for a library with its own prefix.
pub fn header(prefix: &str, elements: &[Element]) -> String {
    let guard = format!("{}_H", prefix.to_uppercase());
    let functions = functions(prefix);
    let functions = functions.trim();
    let symbols = symbols(prefix, elements);
    format!(
        "/* Elements of the library `{prefix}`; types, units and rules: contact_elements.h. */\n\
         #ifndef {guard}\n#define {guard}\n\n#include \"contact_elements.h\"\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{functions}\n\n{symbols}\
         #ifdef __cplusplus\n}}\n#endif\n#endif\n"
    )
}

/// The declared functions of all headers, with their comments.
fn sections() -> String {
    let mut text = String::new();
    for (_, header) in C_HEADERS {
        let Some((_, section)) = header.split_once("- functions */\n") else {
            continue;
        };
        let ends = ["/* ------", "#ifdef __cplusplus"];
        let end = ends.iter().filter_map(|end| section.find(end)).min();
        text.push_str(
            section
                .get(..end.unwrap_or(section.len()))
                .unwrap_or(section),
        );
    }
    text
}

/// The functions of the interface under another prefix; the types stay `cte_`.
fn functions(prefix: &str) -> String {
    let fortran = format!("{}_F77_", prefix.to_uppercase());
    let text = sections().replace("CTE_F77_", &fortran);
    let mut renamed = String::new();
    let mut rest = text.as_str();
    while let Some(at) = rest.find("cte_") {
        let (head, tail) = rest.split_at(at);
        let end = tail
            .find(|c: char| !c.is_ascii_alphanumeric() && c != '_')
            .unwrap_or(tail.len());
        let (name, after) = tail.split_at(end);
        renamed.push_str(head);
        match (after.starts_with('('), name.strip_prefix("cte_")) {
            (true, Some(name)) => {
                let _ = write!(renamed, "{prefix}_{name}");
            }
            _ => renamed.push_str(name),
        }
        rest = after;
    }
    renamed.push_str(rest);
    renamed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_of_elements_stay_comments() {
        assert_eq!(comment("a */ int x; /* b */"), "a * / int x; / * b * /");
        assert!(!comment("/*/*/**/").contains("*/"));
    }
}
