//! Time of generation and size of the emitted source, element by element of the library:
//! `cargo run --release -p contact-generator --example cost`.
//!
//! The time is that of everything the macro does: the library of geometries and laws, parsing, checks, linearisation,
//! optimisation, emission. The source is counted as the compiler's pretty printer would show it.

use std::time::Instant;

use contact_generator::emit::readable;
use contact_generator::expand::{LIBRARY_ELEMENTS, expand};
use proc_macro2::TokenStream;

fn main() -> syn::Result<()> {
    println!("{:<44} {:>8} {:>8}", "element", "ms", "kB");
    let (mut longest, mut largest) = (0.0_f64, 0);
    for declaration in declarations(&LIBRARY_ELEMENTS.concat()) {
        let name = declaration.split_whitespace().nth(1).unwrap_or_default();
        let tokens: TokenStream = declaration.parse()?;
        let start = Instant::now();
        let emitted = expand(tokens);
        let milliseconds = 1e3 * start.elapsed().as_secs_f64();
        let size = readable(&emitted)?.len();
        println!("{name:<44} {milliseconds:8.1} {:8.1}", size as f64 / 1e3);
        longest = longest.max(milliseconds);
        largest = largest.max(size);
    }
    println!(
        "longest: {longest:.1} ms, largest: {:.1} kB",
        largest as f64 / 1e3
    );
    Ok(())
}

/// One text per element, without its comments.
fn declarations(library: &str) -> Vec<String> {
    let mut list: Vec<String> = vec![];
    for line in library.lines().filter(|line| !line.starts_with("//")) {
        if line.starts_with("element ") {
            list.push(String::new());
        }
        if let Some(text) = list.last_mut() {
            text.push_str(line);
            text.push('\n');
        }
    }
    list
}
