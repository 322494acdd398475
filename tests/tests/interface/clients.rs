//! Every program of `examples/` and `tests/clients` against the C library.
//!
//! A source with a `main` (C, C++) or a `program` (Fortran) is a client; it prints a line per check and exits with 0. The
//! other C sources and the Fortran modules of its folder are parts: they are compiled once and linked to each client.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use contact_tests::compiler::{self, REQUIRE_FORTRAN};
use contact_tests::documents::{Quoted, pages, quoted_programs};
use contact_tests::library::Library;
use contact_tests::process::{available, run, succeed, text};
use contact_tests::workspace;

/// Parts that every client of `tests/clients` may use.
const SUPPORT: &str = "tests/clients/support";
const INTERFACE: &str = "tests/clients/interface";

/// The sources of a folder with one of these extensions, by name; with the shared parts where it is one of `tests/clients`.
fn sources(folder: &str, extensions: &[&str]) -> Vec<PathBuf> {
    let shared = folder.starts_with("tests/clients").then_some(SUPPORT);
    let mut list: Vec<PathBuf> = [folder].into_iter().chain(shared).flat_map(files).collect();
    list.retain(|path| {
        let extension = path.extension().and_then(OsStr::to_str);
        extension.is_some_and(|e| extensions.contains(&e))
    });
    list.sort();
    list
}

fn files(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(workspace(folder)).expect("a folder of clients");
    entries.map(|entry| entry.expect("a file").path()).collect()
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

/// The C compiler with the headers of the shared parts in reach.
fn c() -> Command {
    let mut compiler = compiler::c();
    compiler.arg("-I").arg(workspace(SUPPORT));
    compiler
}

/// Compiles a part; its object file.
fn object(mut compiler: Command, source: &Path, directory: &Path) -> PathBuf {
    let object = directory.join(format!("{}.o", name(source)));
    succeed(compiler.arg("-c").arg(source).arg("-o").arg(&object));
    object
}

/// A client that ran: its source and what it printed, or why it failed.
struct Ran {
    source: PathBuf,
    printed: Result<String, String>,
}

/// Compiles and runs a client.
fn ran(mut compiler: Command, source: &Path, parts: &[PathBuf], link: &[String]) -> Ran {
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
    let shown = format!("{}: {}", source.display(), output.status);
    println!("{shown}, {checks} checks passed");
    Ran {
        source: source.to_path_buf(),
        printed: match output.status.success() {
            true => Ok(printed),
            false => Err(format!("{shown}\n{printed}")),
        },
    }
}

/// All clients passed; their number is at least this.
fn assert_passed(clients: &[Ran], least: usize) {
    assert!(clients.len() >= least, "only {} clients", clients.len());
    let failures: Vec<&str> = clients
        .iter()
        .filter_map(|client| client.printed.as_ref().err().map(String::as_str))
        .collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// Runs the C clients of a folder.
fn c_clients(folder: &str, link: &[String]) -> Vec<Ran> {
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let (clients, parts): (Vec<PathBuf>, Vec<PathBuf>) = sources(folder, &["c"])
        .into_iter()
        .partition(|source| read(source).contains("\nint main("));
    let objects: Vec<PathBuf> = parts
        .iter()
        .map(|part| object(c(), part, directory.path()))
        .collect();
    clients
        .iter()
        .map(|client| ran(c(), client, &objects, link))
        .collect()
}

/// Runs the Fortran clients of a folder.
fn fortran_clients(folder: &str, link: &[String]) -> Vec<Ran> {
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let compiler = |source: &Path| compiler::fortran(source, directory.path());
    let (clients, mut modules): (Vec<PathBuf>, Vec<PathBuf>) = sources(folder, &["f", "f90"])
        .into_iter()
        .partition(|source| is_program(&read(source)));
    modules.push(workspace("contact-elements/include/contact_elements.f90"));
    let objects: Vec<PathBuf> = in_order(modules)
        .iter()
        .map(|source| object(compiler(source), source, directory.path()))
        .collect();
    clients
        .iter()
        .map(|client| ran(compiler(client), client, &objects, link))
        .collect()
}

#[test]
fn examples_in_c() {
    let library = Library::contact_elements();
    assert_passed(&c_clients("examples/c", &library.link()), 2);
    // The archive needs no library beside the C compiler's own.
    let archive = library.archive().display().to_string();
    assert_passed(&c_clients("examples/c", &[archive]), 2);
}

#[test]
fn examples_in_fortran() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let library = Library::contact_elements();
    assert_passed(&fortran_clients("examples/fortran", &library.link()), 2);
    assert_passed(&fortran_clients("examples/fortran77", &library.link()), 1);
}

#[test]
fn bad_input_in_c_and_fortran() {
    assert_twins_pass("tests/clients/bad_input");
}

#[test]
fn interface_in_c_and_fortran() {
    assert_twins_pass(INTERFACE);
}

#[test]
fn header_in_cpp() {
    let library = Library::contact_elements();
    let clients: Vec<Ran> = sources(INTERFACE, &["cpp"])
        .iter()
        .map(|client| ran(compiler::cpp(), client, &[], &library.link()))
        .collect();
    assert_passed(&clients, 1);
}

/// The clients of a folder pass, and each in C has a twin in Fortran that prints the same.
fn assert_twins_pass(folder: &str) {
    let library = Library::contact_elements();
    let c = c_clients(folder, &library.link());
    assert_passed(&c, 1);
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let fortran = fortran_clients(folder, &library.link());
    assert_passed(&fortran, 1);
    for client in &c {
        let name = stem(&client.source);
        let twin = fortran.iter().find(|twin| stem(&twin.source) == name);
        let twin = twin.unwrap_or_else(|| panic!("no {name} in Fortran"));
        assert_same_lines(name, &client.printed, &twin.printed);
    }
}

fn assert_same_lines(name: &str, c: &Result<String, String>, fortran: &Result<String, String>) {
    let (Ok(c), Ok(fortran)) = (c, fortran) else {
        panic!("{name} failed: {c:?}{fortran:?}");
    };
    let differ = c.lines().zip(fortran.lines()).find(|(a, b)| a != b);
    assert_eq!(differ, None, "{name}: left in C, right in Fortran");
    let [c, fortran] = [c, fortran].map(|text| text.lines().count());
    assert_eq!(c, fortran, "{name}: lines in C and in Fortran");
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
    let explicit = workspace(INTERFACE).join("integers.f90");
    let client = ran(compiler(&explicit), &explicit, &[module], &library.link());
    assert_passed(&[client], 1);
    let fixed = workspace("examples/fortran77/bricks.f");
    assert_refused(compiler(&fixed).arg(&fixed), "Division by zero");
    let loose = directory.join("loose.f90");
    let text = read(&explicit).replace("integer(i4) ::", "integer ::");
    std::fs::write(&loose, text).expect("a file");
    assert_refused(compiler(&loose).arg(&loose), "Type mismatch in argument");
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

/// Compiles and runs a program of the documentation; it prints what its page says.
fn prints_what_the_page_says(
    quoted: &Quoted,
    compiler: impl Fn(&Path) -> Command,
    name: &str,
    link: &[String],
) {
    let directory = tempfile::TempDir::new().expect("a temporary directory");
    let source = directory.path().join(name);
    std::fs::write(&source, &quoted.program).expect("the source");
    let executable = directory.path().join("program");
    let mut command = compiler(&source);
    command.arg(&source).args(link).args(["-lm", "-o"]);
    succeed(command.arg(&executable));
    let printed = succeed(&mut Command::new(&executable));
    assert_eq!(printed, quoted.printed, "{}", quoted.path);
}

#[test]
fn programs_of_the_documentation_in_c() {
    let library = Library::contact_elements();
    let programs = quoted_programs(&pages(), "c", "int main(");
    assert!(programs.iter().any(|quoted| quoted.path == "README.md"));
    for quoted in &programs {
        prints_what_the_page_says(quoted, |_| compiler::c(), "program.c", &library.link());
    }
}

#[test]
fn programs_of_the_documentation_in_fortran() {
    if !available("gfortran", REQUIRE_FORTRAN) {
        return;
    }
    let library = Library::contact_elements();
    let directory = library.path();
    let module = workspace("contact-elements/include/contact_elements.f90");
    let module = object(compiler::fortran(&module, directory), &module, directory);
    let link = [vec![module.display().to_string()], library.link()].concat();
    let programs = quoted_programs(&pages(), "fortran", "program ");
    assert!(programs.iter().any(|quoted| quoted.path == "README.md"));
    for quoted in &programs {
        let compiler = |source: &Path| compiler::fortran(source, directory);
        prints_what_the_page_says(quoted, compiler, "program.f90", &link);
    }
}

fn is_program(text: &str) -> bool {
    let begins = |line: &str| {
        line.to_ascii_lowercase()
            .trim_start()
            .starts_with("program ")
    };
    text.lines().any(begins)
}

/// The modules, each after those it uses.
fn in_order(mut waiting: Vec<PathBuf>) -> Vec<PathBuf> {
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
