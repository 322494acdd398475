//! C header section and Fortran include file of a library of elements.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::emit::{Parameters, symbol_name};
use crate::expand::parse;
use crate::model::{Element, Model};

/// The C header of the interface: types, units, rules and functions.
pub const C_HEADER: &str = include_str!("../../../contact-elements/include/contact_elements.h");

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

/// [`symbols`] as a header of its own, beside `contact_elements.h`.
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

/// Request bits as they stand in the header, without their prefix.
const REQUESTS: [(&str, u32); 10] = [
    ("RESIDUAL", 1),
    ("TANGENT", 2),
    ("HISTORY", 4),
    ("OUTPUT", 8),
    ("ENERGY", 16),
    ("FREEZE_STATE", 32),
    ("SYMMETRISE", 64),
    ("PROJECTION_GIVEN", 128),
    ("SCREEN", 256),
    ("CSR_BY_BLOCKS", 512),
];

/// Fortran include file, fixed and free form alike: the request bits and the index of every element as a
/// PARAMETER, each element with the names of its parameters in order.
pub fn fortran_include(prefix: &str, elements: &[Element]) -> String {
    let upper = prefix.to_uppercase();
    let mut text = String::from("! Request bits: what an evaluation is to write; their sum.\n");
    let constant = |text: &mut String, name: &str, value: usize| {
        fortran_statement(text, "INTEGER ", &format!("{upper}_{name}"));
        fortran_statement(text, "PARAMETER (", &format!("{upper}_{name} = {value})"));
    };
    for (name, bit) in REQUESTS {
        constant(&mut text, name, bit as usize);
    }
    text.push_str("! Indices of the elements; below each its parameters, in order.\n");
    for (index, element) in elements.iter().enumerate() {
        let name = symbol_name(&element.name.to_string()).to_uppercase();
        constant(&mut text, &name, index);
        let mut line = String::from("!");
        for entry in Parameters::new(element).entries {
            if line.len() + 1 + entry.name.len() > 72 {
                let _ = writeln!(text, "{line}");
                line = String::from("!");
            }
            line.push(' ');
            line.push_str(&entry.name);
        }
        let _ = writeln!(text, "{line}");
    }
    text
}

/// Last column of a statement in fixed form.
const LAST_COLUMN: usize = 72;

/// A statement for both forms: where it does not fit, `&` in column 73 and in column 6 of the next line.
/// Fixed form ignores the one and free form joins the two, even within a name.
fn fortran_statement(text: &mut String, keyword: &str, rest: &str) {
    let mut line = format!("      {keyword}");
    for letter in rest.chars() {
        if line.len() == LAST_COLUMN {
            let _ = writeln!(text, "{line}&");
            line = String::from("     &");
        }
        line.push(letter);
    }
    let _ = writeln!(text, "{line}");
}

/// A whole header for a library with its own prefix.
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

/// The function section of [`C_HEADER`] under another prefix; the types stay `cte_`.
fn functions(prefix: &str) -> String {
    let section = between(C_HEADER, "functions */\n", "/* Element symbols:");
    let (before, rest) = section
        .split_once("/* For hosts that dlopen")
        .unwrap_or((section, ""));
    let (_, after) = rest.split_once("} cte_api_table;\n").unwrap_or(("", rest));
    let fortran = format!("{}_F77_", prefix.to_uppercase());
    let text = format!("{before}{after}").replace("CTE_F77_", &fortran);
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

fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let after = text.split_once(start).map_or("", |(_, after)| after);
    after.split_once(end).map_or(after, |(inside, _)| inside)
}

/// What went wrong while a build script wrote a header.
#[derive(Debug)]
pub enum HeaderError {
    /// A file could not be read or written.
    File(PathBuf, std::io::Error),
    /// The source is not Rust, or a declaration has mistakes (the compiler shows them in place).
    Declaration(syn::Error),
    /// No `contact_elements!` with an `export PREFIX;` line in the source.
    NothingExported,
}

impl std::fmt::Display for HeaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::File(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Declaration(error) => write!(f, "{error}"),
            Self::NothingExported => {
                write!(
                    f,
                    "no contact_elements! with `export PREFIX;` as its first line"
                )
            }
        }
    }
}

impl std::error::Error for HeaderError {}

/// For a build script: finds the exported `contact_elements!` in the Rust file `source` and writes
/// `PREFIX.h` and `PREFIX.inc`, beside a copy of `contact_elements.h`, into `directory`.
/// Returns the path of `PREFIX.h`.
///
/// # Errors
/// [`HeaderError`]: unreadable files, mistakes in the declaration, nothing exported.
pub fn write(source: &Path, directory: &Path) -> Result<PathBuf, HeaderError> {
    let file = |path: &Path| {
        let path = path.to_path_buf();
        move |error| HeaderError::File(path, error)
    };
    let text = std::fs::read_to_string(source).map_err(file(source))?;
    let rust = syn::parse_file(&text).map_err(HeaderError::Declaration)?;
    let library = Model::library();
    for item in rust.items {
        let syn::Item::Macro(item) = item else {
            continue;
        };
        if item
            .mac
            .path
            .segments
            .last()
            .is_none_or(|s| s.ident != "contact_elements")
        {
            continue;
        }
        let declaration = parse(item.mac.tokens).map_err(HeaderError::Declaration)?;
        let Some(prefix) = declaration.export else {
            continue;
        };
        let model =
            Model::build(&declaration.file, Some(&library)).map_err(HeaderError::Declaration)?;
        let prefix = prefix.to_string();
        std::fs::create_dir_all(directory).map_err(file(directory))?;
        let path = directory.join(format!("{prefix}.h"));
        let write = |path: &Path, text: &str| std::fs::write(path, text).map_err(file(path));
        write(&path, &header(&prefix, &model.elements))?;
        write(&directory.join("contact_elements.h"), C_HEADER)?;
        write(
            &directory.join(format!("{prefix}.inc")),
            &fortran_include(&prefix, &model.elements),
        )?;
        return Ok(path);
    }
    Err(HeaderError::NothingExported)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statement(keyword: &str, rest: &str) -> String {
        let mut text = String::new();
        fortran_statement(&mut text, keyword, rest);
        text
    }

    #[test]
    fn short_statements_stay_on_one_line() {
        assert_eq!(statement("INTEGER ", "CTE_A"), "      INTEGER CTE_A\n");
        let full = "X".repeat(LAST_COLUMN - 14);
        assert_eq!(statement("INTEGER ", &full).lines().count(), 1);
    }

    #[test]
    fn long_statements_continue_in_both_forms() {
        let name = format!("{} = 12)", "N".repeat(63));
        let text = statement("PARAMETER (", &name);
        let lines: Vec<&str> = text.lines().collect();
        let [first, second] = lines[..] else {
            panic!("{text}");
        };
        assert_eq!(first.find('&'), Some(LAST_COLUMN), "column 73");
        assert_eq!(second.find('&'), Some(5), "column 6");
        let fixed = format!("{}{}", &first[6..LAST_COLUMN], &second[6..]);
        assert_eq!(fixed, format!("PARAMETER ({name}"));
    }

    #[test]
    fn comments_of_elements_stay_comments() {
        assert_eq!(comment("a */ int x; /* b */"), "a * / int x; / * b * /");
        assert!(!comment("/*/*/**/").contains("*/"));
    }
}
