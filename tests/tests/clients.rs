//! Every program of `tests/clients` against the C library.
//!
//! A source with a `main` (C, C++) or a `program` (Fortran) is a client. The other C sources and the
//! Fortran modules are parts of clients; they are compiled once and linked to every client of their
//! language. A client prints a line per check and exits with 0.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use contact_tests::compiler::{self, REQUIRE_FORTRAN};
use contact_tests::library::Library;
use contact_tests::process::{available, run, succeed, text};
use contact_tests::workspace;

/// The sources of `tests/clients` with one of these extensions, by name.
fn sources(extensions: &[&str]) -> Vec<PathBuf> {
    let directory = workspace("tests/clients");
    let entries = std::fs::read_dir(&directory).expect("the clients");
    let mut list: Vec<PathBuf> = entries
        .map(|entry| entry.expect("a file").path())
        .filter(|path| {
            let extension = path.extension().and_then(OsStr::to_str);
            extension.is_some_and(|e| extensions.contains(&e))
        })
        .collect();
    list.sort();
    list
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn stem(path: &Path) -> &str {
    path.file_stem().and_then(OsStr::to_str).expect("a name")
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(OsStr::to_str).expect("a name")
}

/// Compiles a part; its object file.
fn object(mut compiler: Command, source: &Path, directory: &Path) -> PathBuf {
    let object = directory.join(format!("{}.o", name(source)));
    succeed(compiler.arg("-c").arg(source).arg("-o").arg(&object));
    object
}

/// Compiles and runs a client; what it printed, where it failed.
fn failure(
    mut compiler: Command,
    source: &Path,
    parts: &[PathBuf],
    link: &[String],
) -> Option<String> {
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let executable = directory.path().join("client");
    succeed(
        compiler
            .arg(source)
            .args(parts)
            .args(link)
            .args(["-lm", "-o"])
            .arg(&executable),
    );
    let output = run(&mut Command::new(&executable));
    let printed = text(&output);
    let checks = printed
        .lines()
        .filter(|l| l.trim_start().starts_with("PASS"))
        .count();
    println!(
        "{}: {}, {checks} checks passed",
        name(source),
        output.status
    );
    (!output.status.success()).then(|| format!("{}: {}\n{printed}", name(source), output.status))
}

fn assert_none(failures: Vec<String>) {
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// The clients among the C sources, and the objects of the parts.
fn c_clients(directory: &Path) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let (clients, parts): (Vec<PathBuf>, Vec<PathBuf>) = sources(&["c"])
        .into_iter()
        .partition(|source| read(source).contains("\nint main("));
    let objects = parts
        .iter()
        .map(|part| object(compiler::c(), part, directory))
        .collect();
    (clients, objects)
}

#[test]
fn c_and_cpp_against_the_shared_library() {
    let library = Library::contact_elements();
    let (clients, parts) = c_clients(library.path());
    assert!(clients.len() >= 3, "{clients:?}");
    let c = clients
        .iter()
        .filter_map(|client| failure(compiler::c(), client, &parts, &library.link()));
    let cpp = sources(&["cpp"]);
    assert!(!cpp.is_empty());
    let cpp = cpp
        .iter()
        .filter_map(|client| failure(compiler::cpp(), client, &[], &library.link()));
    assert_none(c.chain(cpp).collect());
}

#[test]
fn c_against_the_static_library() {
    let library = Library::contact_elements();
    let (clients, parts) = c_clients(library.path());
    let bricks = clients.iter().find(|client| stem(client) == "bricks");
    let bricks = bricks.expect("bricks.c");
    // The archive needs no library beside the C compiler's own.
    let archive = library.archive().display().to_string();
    assert_none(Vec::from_iter(failure(
        compiler::c(),
        bricks,
        &parts,
        &[archive],
    )));
}

#[test]
fn fortran_against_the_shared_library() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let library = Library::contact_elements();
    let directory = library.path();
    let mut free = sources(&["f90"]);
    free.push(workspace("contact-elements/include/contact_elements.f90"));
    let modules = in_order(&free);
    let objects: Vec<PathBuf> = modules
        .iter()
        .map(|source| object(compiler::fortran(source, directory), source, directory))
        .collect();
    let programs = free.iter().filter(|source| is_program(&read(source)));
    let clients: Vec<PathBuf> = programs.cloned().chain(sources(&["f"])).collect();
    assert!(clients.len() >= 3, "{clients:?}");
    let failures = clients.iter().filter_map(|client| {
        let compiler = compiler::fortran(client, directory);
        failure(compiler, client, &objects, &library.link())
    });
    assert_none(failures.collect());
}

/// With default integers of 8 bytes the include file does not compile, a program with explicit kinds runs, and one that
/// passes default integers to the module does not compile.
#[test]
fn no_fortran_client_takes_integers_of_another_size() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let library = Library::contact_elements();
    let directory = library.path();
    let module = workspace("contact-elements/include/contact_elements.f90");
    let compiler = |source: &Path| {
        let mut compiler = compiler::fortran(source, directory);
        compiler.arg("-fdefault-integer-8");
        compiler
    };
    let module = object(compiler(&module), &module, directory);
    let explicit = client("integers.f90");
    assert_none(Vec::from_iter(failure(
        compiler(&explicit),
        &explicit,
        &[module],
        &library.link(),
    )));
    let fixed = client("bricks77.f");
    assert_refused(compiler(&fixed).arg(&fixed), "Division by zero");
    let loose = directory.join("loose.f90");
    let text = read(&explicit).replace("integer(i4) ::", "integer ::");
    std::fs::write(&loose, text).expect("a file");
    assert_refused(compiler(&loose).arg(&loose), "Type mismatch in argument");
}

/// The client of this name.
fn client(name: &str) -> PathBuf {
    let found = sources(&["f", "f90"])
        .into_iter()
        .find(|path| self::name(path) == name);
    found.unwrap_or_else(|| panic!("no client {name}"))
}

/// The compiler says this and makes no object.
fn assert_refused(compiler: &mut Command, message: &str) {
    let output = run(compiler.args(["-fsyntax-only"]));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        !output.status.success() && said.contains(message),
        "{compiler:?}:\n{said}"
    );
}

fn is_program(text: &str) -> bool {
    text.lines().any(|line| line.starts_with("program "))
}

/// The sources that hold modules only, each after those it uses.
fn in_order(sources: &[PathBuf]) -> Vec<PathBuf> {
    let mut waiting: Vec<PathBuf> = sources
        .iter()
        .filter(|source| !is_program(&read(source)))
        .cloned()
        .collect();
    let mut ordered: Vec<PathBuf> = Vec::new();
    while !waiting.is_empty() {
        let names: Vec<String> = waiting.iter().map(|s| stem(s).to_string()).collect();
        let (ready, later): (Vec<PathBuf>, Vec<PathBuf>) =
            waiting.into_iter().partition(|source| {
                let used = used_modules(&read(source));
                !names.iter().any(|name| used.contains(name))
            });
        assert!(!ready.is_empty(), "modules use each other: {later:?}");
        ordered.extend(ready);
        waiting = later;
    }
    ordered
}

/// The modules of a source's `use` statements; a module stands in the file of its name.
fn used_modules(text: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| line.trim_start().strip_prefix("use "))
        .filter_map(|rest| rest.split([',', ' ']).next())
        .map(str::to_string)
        .collect()
}
