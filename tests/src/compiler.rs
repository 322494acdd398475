//! C, C++ and Fortran compilers with the flags that hold for all client sources.

use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

use crate::workspace;

/// Environment variable that makes a missing Fortran compiler a failure.
pub const REQUIRE_FORTRAN: &str = "CONTACT_REQUIRE_FORTRAN";

/// Strict C99, the headers of the workspace in reach.
pub fn c() -> Command {
    with_headers(bare_c())
}

/// Strict C99.
pub fn bare_c() -> Command {
    strict("gcc", "-std=c99")
}

/// Strict C++, the headers of the workspace in reach.
pub fn cpp() -> Command {
    with_headers(strict("g++", "-std=c++11"))
}

fn strict(program: &str, standard: &str) -> Command {
    let mut command = Command::new(program);
    command.args([standard, "-pedantic", "-Wall", "-Wextra", "-Werror"]);
    command.args(["-O1", "-g"]);
    command
}

fn with_headers(mut command: Command) -> Command {
    command.arg("-I").arg(workspace("contact-elements/include"));
    command
}

/// The compiler for a Fortran source: free form is Fortran 2008, fixed form (`.f`) is Fortran 77.
/// Modules are written to and read from `modules`.
pub fn fortran(source: &Path, modules: &Path) -> Command {
    let mut command = Command::new("gfortran");
    match source.extension().and_then(OsStr::to_str) {
        Some("f") => command.args(["-std=legacy", "-ffixed-form"]),
        _ => command.args(["-std=f2008", "-ffree-form"]),
    };
    command
        .args(["-Wall", "-O1", "-g", "-ffpe-trap=invalid,zero,overflow"])
        .arg("-I")
        .arg(workspace("contact-elements/include"))
        .arg("-J")
        .arg(modules);
    command
}
