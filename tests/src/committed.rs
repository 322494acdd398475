//! Files that are generated, committed and compared.

use std::path::Path;

/// Whether committed files are to be written instead of compared: `CONTACT_BLESS=1`.
pub fn blessing() -> bool {
    std::env::var("CONTACT_BLESS").is_ok_and(|value| value == "1")
}

/// Asserts that the file has this text; with `CONTACT_BLESS=1` it is written.
pub fn assert_committed(path: &Path, text: &str) {
    if blessing() {
        std::fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let found = std::fs::read_to_string(path)
        .unwrap_or_else(|error| panic!("{}: {error}; CONTACT_BLESS=1 writes it", path.display()));
    if let Some((number, found, expected)) = first_difference(&found, text) {
        panic!(
            "{}:{number} is out of date; CONTACT_BLESS=1 rewrites it\n\
             found:    {found}\nexpected: {expected}",
            path.display()
        );
    }
}

/// Line number and lines of the first difference.
fn first_difference<'a>(found: &'a str, expected: &'a str) -> Option<(usize, &'a str, &'a str)> {
    if found == expected {
        return None;
    }
    let (mut left, mut right) = (found.lines(), expected.lines());
    for number in 1.. {
        match (left.next(), right.next()) {
            (Some(a), Some(b)) if a == b => {}
            (None, None) => return Some((number, "end of file", "another line ending")),
            (a, b) => {
                let end = "end of file";
                return Some((number, a.unwrap_or(end), b.unwrap_or(end)));
            }
        }
    }
    None
}
