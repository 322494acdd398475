//! The C library as a host sees it: a directory with the shared object, its links and the archive.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use tempfile::TempDir;

use crate::process::{run, succeed};
use crate::workspace;

/// A built C library in a temporary directory.
pub struct Library {
    directory: TempDir,
    name: String,
}

impl Library {
    /// `cargo build --release -p contact-elements-capi`.
    pub fn contact_elements() -> Self {
        let mut command = cargo("build");
        command.args(["-p", "contact-elements-capi"]);
        Self::build(&mut command, "contact_elements")
    }

    /// The shared object with what `abidw` needs, full debug information of the exported functions: only the
    /// last crate is compiled once more.
    pub fn with_debug_information() -> Self {
        let built = built("contact-elements-capi");
        let elements = artefact(&built, "libcontact_elements-", ".rlib");
        let all = artefact(&built, "libcontact_library-", ".rlib");
        let macros = artefact(&built, "libcontact_macros-", ".so");
        let library = Self::empty("contact_elements");
        let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
        rustc
            .args([
                "--edition=2024",
                "--crate-type=cdylib",
                "--crate-name=contact_elements",
            ])
            .args([
                "-Cmetadata=abi",
                "-Cpanic=abort",
                "-Copt-level=1",
                "-Cdebuginfo=2",
            ])
            .arg("-L")
            .arg(elements.parent().expect("a folder"))
            .arg("--extern")
            .arg(format!("contact_elements={}", elements.display()))
            .arg("--extern")
            .arg(format!("contact_library={}", all.display()))
            .arg("--extern")
            .arg(format!("contact_macros={}", macros.display()))
            .arg("-Clink-arg=-Wl,-soname,libcontact_elements.so.1")
            // Relative, so that no folder of this machine stands in the baseline.
            .current_dir(workspace(""))
            .arg("contact-elements/capi/src/lib.rs")
            .arg("-o")
            .arg(library.shared());
        succeed(&mut rustc);
        library
    }

    /// The library of a crate outside the workspace.
    pub fn of_crate(manifest: &Path, target: &Path, name: &str) -> Self {
        let mut command = cargo("build");
        command
            .arg("--manifest-path")
            .arg(manifest)
            .env("CARGO_TARGET_DIR", target);
        Self::build(&mut command, name)
    }

    /// Runs the build and puts `lib{name}` where a linker and a loader find it.
    fn build(command: &mut Command, name: &str) -> Self {
        let (built, stderr) = build(command);
        let library = Self::empty(name);
        for wanted in [format!("lib{name}.so"), format!("lib{name}.a")] {
            let from = built
                .iter()
                .find(|path| path.ends_with(&wanted))
                .unwrap_or_else(|| panic!("{wanted} was not built:\n{stderr}"));
            std::fs::copy(from, library.path().join(&wanted)).expect("a copy of the library");
        }
        library.link_soname();
        library
    }

    fn empty(name: &str) -> Self {
        Library {
            directory: TempDir::new().expect("a temporary directory"),
            name: name.to_string(),
        }
    }

    /// The loader looks for the SONAME, the linker for the plain name.
    fn link_soname(&self) {
        let plain = format!("lib{}.so", self.name);
        let versioned = self.path().join(format!("{plain}.1"));
        std::os::unix::fs::symlink(plain, versioned).expect("a symbolic link");
    }

    /// The directory; other files of the test may be put there.
    pub fn path(&self) -> &Path {
        self.directory.path()
    }

    /// The shared object.
    pub fn shared(&self) -> PathBuf {
        self.path().join(format!("lib{}.so", self.name))
    }

    /// The archive.
    pub fn archive(&self) -> PathBuf {
        self.path().join(format!("lib{}.a", self.name))
    }

    /// What a linker is told to use the shared object where it stands.
    pub fn link(&self) -> Vec<String> {
        let directory = self.path().display();
        vec![
            format!("-L{directory}"),
            format!("-l{}", self.name),
            format!("-Wl,-rpath,{directory}"),
        ]
    }
}

/// The cargo that runs the tests, for the release profile in the workspace.
pub fn cargo(subcommand: &str) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command
        .args([subcommand, "--release"])
        .current_dir(workspace(""));
    command
}

/// Runs a build; its files, and what it wrote to stderr.
fn build(command: &mut Command) -> (Vec<PathBuf>, String) {
    let output = run(command.arg("--message-format=json-render-diagnostics"));
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{command:?}:\n{stderr}");
    let files = artefacts(&String::from_utf8_lossy(&output.stdout));
    (files, stderr)
}

/// Builds a package of the workspace; its files and those of its dependencies.
fn built(package: &str) -> Vec<PathBuf> {
    build(cargo("build").args(["-p", package])).0
}

/// The crate that users name as their dependency, compiled as in the C library.
pub fn elements_crate() -> PathBuf {
    artefact(&built("contact-elements"), "libcontact_elements", ".rlib")
}

/// The file whose name begins and ends so.
fn artefact(built: &[PathBuf], start: &str, end: &str) -> PathBuf {
    let named = |path: &Path| {
        let name = path.file_name().and_then(OsStr::to_str);
        name.is_some_and(|name| name.starts_with(start) && name.ends_with(end))
    };
    let found = built.iter().find(|path| named(path));
    found
        .unwrap_or_else(|| panic!("no {start}*{end} was built"))
        .clone()
}

/// Files of all artefacts in the messages of cargo.
fn artefacts(messages: &str) -> Vec<PathBuf> {
    let list = |message: Value| message["filenames"].as_array().cloned().unwrap_or_default();
    messages
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .flat_map(list)
        .filter_map(|name| name.as_str().map(PathBuf::from))
        .collect()
}
