//! Size of a C library: one element against all of them.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Failure;
use crate::report::Section;
use crate::timing::Effort;

/// Package and file of a library.
struct Library {
    name: &'static str,
    package: &'static str,
    file: &'static str,
}

/// Root of the workspace to which both belong.
const MANIFEST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml");
const LIBRARIES: [Library; 2] = [
    Library {
        name: "all built-in elements",
        package: "contact-all-elements",
        file: "libcontact_all_elements.so",
    },
    Library {
        name: "one element, a point on a bilinear facet",
        package: "contact-one-element",
        file: "libcontact_one_element.so",
    },
];

/// One section, if libraries are to be built.
///
/// # Errors
/// Where one cannot be built or stripped.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    if !effort.build {
        return Ok(vec![]);
    }
    let sizes: Vec<[u64; 2]> = LIBRARIES.iter().map(sizes).collect::<Result<_, _>>()?;
    let mut section = Section::new(
        "library-size",
        "Size of a C library",
        &["library", "built [kB]", "stripped [kB]", "stripped, ratio"],
    );
    for (library, size) in LIBRARIES.iter().zip(&sizes) {
        let mut row = vec![library.name.to_string()];
        row.extend(size.map(|bytes| format!("{:.0}", bytes as f64 / 1e3)));
        row.push(format!("{:.3}", size[1] as f64 / sizes[0][1] as f64));
        section.row(row);
    }
    section.note(
        "Shared libraries, release profile; stripped by `strip`. Both export the whole interface.",
    );
    Ok(vec![section])
}

/// Bytes as built and stripped.
fn sizes(library: &Library) -> Result<[u64; 2], Failure> {
    run(Command::new("cargo")
        .args(["build", "--release", "--manifest-path", MANIFEST])
        .args(["--package", library.package]))?;
    let built = folder().join(library.file);
    let stripped = std::env::temp_dir().join(format!("{}-{}", std::process::id(), library.file));
    run(Command::new("strip").arg("-o").arg(&stripped).arg(&built))?;
    let sizes = [built.metadata()?.len(), stripped.metadata()?.len()];
    std::fs::remove_file(stripped)?;
    Ok(sizes)
}

/// Where release builds lie.
fn folder() -> PathBuf {
    let root = Path::new(MANIFEST).with_file_name("target");
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or(root, PathBuf::from);
    target.join("release")
}

fn run(command: &mut Command) -> Result<(), Failure> {
    if command.status()?.success() {
        Ok(())
    } else {
        Err(format!("{command:?} failed").into())
    }
}
