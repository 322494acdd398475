//! Writes `include/rail.h`, `include/rail.inc` and the `contact_elements.h` they belong to.

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=src/lib.rs");
    println!("cargo::rerun-if-changed=build.rs");
    if let Err(error) =
        contact_generator::header::write(Path::new("src/lib.rs"), Path::new("include"))
    {
        // A mistake in the declaration: the compiler shows it in its place.
        println!("cargo::warning=no header: {error}");
    }
}
