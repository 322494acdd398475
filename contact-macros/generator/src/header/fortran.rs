//! The include file for Fortran: numbers of the interface and indices of the elements.

use std::fmt::Write as _;

use super::c::C_HEADERS;
use crate::emit::symbol_name;
use crate::formulate::Parameters;
use crate::model::Element;

/// Longest name that a Fortran 95 compiler takes.
const LONGEST_NAME: usize = 31;

/// Last column of a line in fixed form.
const LAST_COLUMN: usize = 72;

/// What stands for a part of a name that is too long.
const ABBREVIATIONS: [(&str, &str); 25] = [
    ("ADHESIVE", "ADH"),
    ("AT_POINT", "AP"),
    ("AUGMENTED", "AUG"),
    ("BEZIER", "BEZ"),
    ("COULOMB", "COUL"),
    ("CURRENT", "CUR"),
    ("CURVE", "C"),
    ("CYLINDER", "CYL"),
    ("DIRECTOR", "DIR"),
    ("DISTANCE", "DIST"),
    ("HERMITE", "HERM"),
    ("INTERPOLATED", "INTERP"),
    ("LARGE_ANGLE", "LA"),
    ("LINE_CONTACT", "LC"),
    ("MULTIPLIER", "MULT"),
    ("ORIENTED", "ORI"),
    ("ORTHOTROPIC", "ORTHO"),
    ("POWER_LAW", "PL"),
    ("RATIONAL", "RAT"),
    ("RESIDUAL", "RES"),
    ("ROLLING", "ROLL"),
    ("SMALL_ANGLE", "SA"),
    ("STATIC_KINETIC", "SK"),
    ("SURFACE", "S"),
    ("TANGENT_PLANE", "TP"),
];

/// Says what the file is, and stops compilers whose default integers are too long.
const HEAD: &str = "\
! Numbers of the library `{library}` as PARAMETERs: the same in fixed
! and free form, for Fortran 77 and later. Shapes and rules:
! contact_elements_f77.h. Entries of outputs, histories and sizes count
! from 0. Names have 31 characters at most; parts of longer ones are
! abbreviated.
!
! The calls take default integers of 4 bytes. Where these have 8
! (-fdefault-integer-8, -i8) the next PARAMETER divides by zero and does
! not compile: use the module of contact_elements.f90 there.
";

/// The include file: numbers of the headers, then the index of every element below the names of its parameters.
pub fn fortran_include(prefix: &str, elements: &[Element]) -> String {
    let upper = prefix.to_uppercase();
    let mut text = HEAD.replace("{library}", prefix);
    let check = format!("{upper}_INTEGERS_HAVE_4_BYTES");
    constant(&mut text, &check, "1/(64/BIT_SIZE(0) - 1)");
    for (section, numbers) in numbers() {
        let _ = writeln!(text, "!\n! {section}");
        for (name, value) in numbers {
            constant(&mut text, &format!("{upper}_{name}"), &value.to_string());
        }
    }
    text.push_str("!\n! Indices of the elements, each below its parameters in their order\n");
    for (index, element) in elements.iter().enumerate() {
        let name = element.name.to_string();
        let parameters = Parameters::new(element).entries;
        let words = parameters.iter().map(|entry| entry.name.as_str());
        comment(&mut text, &format!("{name}:"), words);
        let symbol = format!("{upper}_{}", symbol_name(&name).to_uppercase());
        constant(&mut text, &symbol, &index.to_string());
    }
    text
}

/// A PARAMETER of default type.
fn constant(text: &mut String, name: &str, value: &str) {
    let name = short_name(name);
    let _ = writeln!(text, "      INTEGER {name}");
    let _ = writeln!(text, "      PARAMETER ({name} = {value})");
}

/// Words behind a title in as many comment lines as they need.
fn comment<'a>(text: &mut String, title: &str, words: impl Iterator<Item = &'a str>) {
    let mut line = format!("! {title}");
    for word in words {
        if line.len() + 1 + word.len() > LAST_COLUMN {
            let _ = writeln!(text, "{line}");
            line = String::from("!  ");
        }
        line.push(' ');
        line.push_str(word);
    }
    let _ = writeln!(text, "{line}");
}

/// The numbers that the headers define, section by section: `#define CTE_NAME 12`, without `CTE_`.
pub fn numbers() -> Vec<(&'static str, Vec<(&'static str, i32)>)> {
    let mut sections = Vec::new();
    for (_, header) in C_HEADERS {
        for section in
            header.split("/* ------------------------------------------------------------------ ")
        {
            let title = section
                .lines()
                .next()
                .unwrap_or("")
                .trim_end_matches("*/")
                .trim();
            let found: Vec<_> = section.lines().filter_map(number).collect();
            if !found.is_empty() {
                sections.push((title, found));
            }
        }
    }
    sections
}

/// Name and value of a line that defines a number.
fn number(line: &'static str) -> Option<(&'static str, i32)> {
    let mut words = line.strip_prefix("#define CTE_")?.split_whitespace();
    let (name, value) = (words.next()?, words.next()?);
    let value = value.trim_end_matches('u').trim_matches(['(', ')']);
    Some((name, value.parse().ok()?))
}

/// The name itself where a Fortran 95 compiler takes it; else with its parts abbreviated, and where that does not
/// suffice cut, with four digits that tell it from others.
pub fn short_name(name: &str) -> String {
    if name.len() <= LONGEST_NAME {
        return name.to_string();
    }
    let abbreviated = ABBREVIATIONS
        .iter()
        .fold(name.to_string(), |name, (long, short)| {
            name.replace(long, short)
        });
    if abbreviated.len() <= LONGEST_NAME {
        return abbreviated;
    }
    let hash = name.bytes().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    let kept: String = abbreviated.chars().take(LONGEST_NAME - 5).collect();
    format!("{kept}_{:04X}", hash >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_fit_stay() {
        let longest = "CTE_POINT_QUAD4_COULOMB_ADHESI";
        assert_eq!(short_name("CTE_POINT_QUAD4"), "CTE_POINT_QUAD4");
        assert_eq!(short_name(&format!("{longest}V")), format!("{longest}V"));
    }

    #[test]
    fn long_names_are_abbreviated() {
        let long = "CTE_HERMITE_QUAD4_ORTHOTROPIC_AT_POINT_TANGENT_PLANE";
        assert_eq!(short_name(long), "CTE_HERM_QUAD4_ORTHO_AP_TP");
    }

    #[test]
    fn what_stays_too_long_is_cut_and_told_apart() {
        let names = ["A", "B"].map(|end| short_name(&format!("RAIL_{}{end}", "X".repeat(60))));
        let [first, second] = &names;
        assert_ne!(first, second);
        for name in &names {
            assert_eq!(name.len(), LONGEST_NAME);
            assert!(name.starts_with("RAIL_XXXXX"));
        }
    }

    #[test]
    fn lines_fit_fixed_form() {
        let mut text = String::new();
        constant(&mut text, &"N".repeat(80), "-13");
        comment(
            &mut text,
            "Element:",
            ["parameter_with_a_name"; 9].into_iter(),
        );
        assert!(text.lines().all(|line| line.len() <= LAST_COLUMN), "{text}");
    }

    #[test]
    fn numbers_are_those_of_the_headers() {
        let all: Vec<_> = numbers().into_iter().flat_map(|(_, list)| list).collect();
        for wanted in [
            ("CUT_BACK", 1),
            ("ERROR_HISTORY", -12),
            ("CSR_BY_BLOCKS", 512),
            ("STATUS_LAW", 8),
            ("OUTPUT_SIZE", 23),
            ("VERDICT_BEYOND", 3),
            ("ARGUMENT_THREADS", 39),
        ] {
            assert!(all.contains(&wanted), "{wanted:?}");
        }
        assert!(all.len() > 90, "{}", all.len());
    }
}
