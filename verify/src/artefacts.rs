//! Generated sources and the C library: what the proof is about, laid out for use.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;

use contact_generator::expand::LIBRARY_ELEMENTS;
use contact_verify::pages::{Declarations, Equations, Quotes};

/// Bytes of emitted Rust source per element.
pub type Sizes = BTreeMap<String, usize>;

/// Writes the emitted source of every built-in element to `output/generated` and returns the sizes.
pub fn generated_sources(output: &Path) -> Result<Sizes, Box<dyn std::error::Error>> {
    let folder = output.join("generated");
    std::fs::create_dir_all(&folder)?;
    let mut sizes = Sizes::new();
    for (name, text) in contact_generator::expand::library_sources()? {
        std::fs::write(folder.join(format!("{name}.rs")), &text)?;
        sizes.insert(name, text.len());
    }
    Ok(sizes)
}

/// Declarations of the built-in elements, and the equations of the documentation, for the pages.
pub fn quotes() -> std::io::Result<Quotes> {
    let mut equations = Equations::default();
    let folder = root().join("docs/theory");
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let page = path.file_name().unwrap_or_default().to_string_lossy();
        if page.ends_with(".md") {
            equations.add(&page, &std::fs::read_to_string(&path)?);
        }
    }
    Ok(Quotes {
        declarations: Declarations::read(&LIBRARY_ELEMENTS.concat()),
        equations,
    })
}

/// Folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Where the files of the C library lie.
pub struct Artefacts {
    shared: PathBuf,
    archive: PathBuf,
    include: PathBuf,
    generated: PathBuf,
}

impl fmt::Display for Artefacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "shared library     {}", self.shared.display())?;
        writeln!(f, "static library     {}", self.archive.display())?;
        writeln!(f, "C and Fortran      {}", self.include.display())?;
        writeln!(f, "generated sources  {}", self.generated.display())
    }
}

/// Builds the C library and copies it with its headers to `output`.
pub fn c_library(output: &Path) -> Result<Artefacts, Box<dyn std::error::Error>> {
    let root = root();
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_string());
    let messages = Command::new(cargo)
        .args([
            "build",
            "--release",
            "-p",
            "contact-elements-capi",
            "--message-format=json-render-diagnostics",
        ])
        .current_dir(&root)
        .stderr(std::process::Stdio::inherit())
        .output()?;
    if !messages.status.success() {
        return Err("the C library could not be built, see the messages above".into());
    }
    let built = built_files(&String::from_utf8_lossy(&messages.stdout));
    let artefacts = Artefacts {
        shared: output.join("lib/libcontact_elements.so"),
        archive: output.join("lib/libcontact_elements.a"),
        include: output.join("include"),
        generated: output.join("generated"),
    };
    std::fs::create_dir_all(output.join("lib"))?;
    std::fs::create_dir_all(&artefacts.include)?;
    for (ending, target) in [(".so", &artefacts.shared), (".a", &artefacts.archive)] {
        if let Some(file) = built.iter().find(|file| file.ends_with(ending)) {
            std::fs::copy(file, target)?;
        }
    }
    std::fs::copy(
        &artefacts.shared,
        output.join("lib/libcontact_elements.so.1"),
    )?;
    for entry in std::fs::read_dir(root.join("contact-elements/include"))? {
        let path = entry?.path();
        if let Some(name) = path.file_name() {
            std::fs::copy(&path, artefacts.include.join(name))?;
        }
    }
    Ok(artefacts)
}

/// File names in cargo's messages about the C library.
fn built_files(messages: &str) -> Vec<String> {
    let is_library = |message: &serde_json::Value| {
        message["reason"] == "compiler-artifact" && message["target"]["kind"][0] == "cdylib"
    };
    messages
        .lines()
        .filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok())
        .filter(is_library)
        .flat_map(|message| message["filenames"].as_array().cloned().unwrap_or_default())
        .filter_map(|file| file.as_str().map(str::to_string))
        .collect()
}
