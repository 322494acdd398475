//! The numbers of the C headers, read from their text: what the library may return.

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The manual.
pub const HEADER: &str = concat!(
    include_str!("../../../contact-elements/include/contact_elements_call.h"),
    include_str!("../../../contact-elements/include/contact_elements_batch.h"),
    include_str!("../../../contact-elements/include/contact_elements_pairs.h"),
    include_str!("../../../contact-elements/include/contact_elements_table.h"),
    include_str!("../../../contact-elements/include/contact_elements_f77.h"),
);

/// The documented numbers, each with its name.
pub static NUMBERS: LazyLock<Numbers> = LazyLock::new(|| Numbers::read(HEADER));

/// Names by number, one list per kind.
#[derive(Debug, Default)]
pub struct Numbers {
    /// `CTE_SUCCESS`, `CTE_CUT_BACK`, `CTE_ERROR_*`.
    pub codes: BTreeMap<i32, String>,
    /// `CTE_STATUS_*`.
    pub statuses: BTreeMap<i32, String>,
    /// `CTE_ARGUMENT_*`.
    pub arguments: BTreeMap<i32, String>,
    /// `CTE_VERDICT_*`.
    pub verdicts: BTreeMap<i32, String>,
    /// `CTE_UNKNOWN_*`; components count on from the first of three.
    pub kinds: BTreeMap<i32, String>,
}

impl Numbers {
    /// Reads every `#define NAME number`.
    pub fn read(header: &str) -> Self {
        let mut numbers = Self::default();
        for line in header.lines() {
            let Some((name, value)) = definition(line) else {
                continue;
            };
            let list = if let "CTE_SUCCESS" | "CTE_CUT_BACK" = name {
                &mut numbers.codes
            } else if name.starts_with("CTE_ERROR_") {
                &mut numbers.codes
            } else if name.starts_with("CTE_STATUS_") {
                &mut numbers.statuses
            } else if name.starts_with("CTE_ARGUMENT_") {
                &mut numbers.arguments
            } else if name.starts_with("CTE_VERDICT_") {
                &mut numbers.verdicts
            } else if name.starts_with("CTE_UNKNOWN_") {
                &mut numbers.kinds
            } else {
                continue;
            };
            list.insert(value, name.to_string());
        }
        numbers
    }

    /// The name of a return code.
    pub fn code(&self, code: i32) -> Result<&str, String> {
        known(&self.codes, code, "return code")
    }

    /// The name of a status.
    pub fn status(&self, status: i32) -> Result<&str, String> {
        known(&self.statuses, status, "status")
    }

    /// The name of an argument.
    pub fn argument(&self, argument: i32) -> Result<&str, String> {
        known(&self.arguments, argument, "error_argument")
    }
}

/// The name of a number, or a note that the header has no such number.
pub fn known<'a>(
    list: &'a BTreeMap<i32, String>,
    number: i32,
    what: &str,
) -> Result<&'a str, String> {
    let undocumented = || format!("undocumented {what} {number}");
    list.get(&number)
        .map(String::as_str)
        .ok_or_else(undocumented)
}

/// Name and value of a line `#define NAME 12 /* .. */` or `#define NAME (-1)`.
fn definition(line: &str) -> Option<(&str, i32)> {
    let mut words = line.strip_prefix("#define ")?.split_whitespace();
    let (name, value) = (words.next()?, words.next()?);
    let value = value.trim_matches(['(', ')']).parse().ok()?;
    Some((name, value))
}

/// Every function that the header declares.
pub fn functions() -> Vec<String> {
    let mut text = String::new();
    let mut rest = HEADER;
    while let Some((before, comment)) = rest.split_once("/*") {
        text.push_str(before);
        rest = comment.split_once("*/").map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    let declared = text.split("cte_").skip(1).filter_map(|part| {
        let (name, _) = part.split_once('(')?;
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        plain.then(|| format!("cte_{name}"))
    });
    declared.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::FUNCTIONS;

    #[test]
    fn the_header_is_read() {
        assert_eq!(NUMBERS.code(0), Ok("CTE_SUCCESS"));
        assert_eq!(NUMBERS.code(-13), Ok("CTE_ERROR_ELEMENT"));
        assert_eq!(NUMBERS.status(8), Ok("CTE_STATUS_LAW"));
        assert_eq!(NUMBERS.argument(38), Ok("CTE_ARGUMENT_VERTEX"));
        assert_eq!(NUMBERS.verdicts.len(), 5);
        assert_eq!(NUMBERS.kinds.len(), 7);
        assert!(NUMBERS.code(2).is_err() && NUMBERS.code(-14).is_err());
        assert!(NUMBERS.status(-1).is_err() && NUMBERS.status(9).is_err());
    }

    #[test]
    fn every_declared_function_is_called() {
        let declared = functions();
        assert!(declared.len() > 20, "{declared:?}");
        for name in &declared {
            assert!(FUNCTIONS.contains(&name.as_str()), "{name} is not fuzzed");
        }
        for name in FUNCTIONS.iter().filter(|name| **name != "element symbols") {
            assert!(
                declared.iter().any(|known| known == name),
                "{name} is not declared"
            );
        }
    }
}
