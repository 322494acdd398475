//! Instructions of an evaluation, counted by callgrind: a second measure that load does not disturb.

use std::process::{Command, Stdio};

use crate::Failure;

/// Runs a pass; callgrind counts what happens in here.
#[inline(never)]
pub fn counted(pass: &mut dyn FnMut()) {
    std::hint::black_box(&mut *pass)();
}

/// Instructions within [`counted`] of this program, called with other arguments.
///
/// # Errors
/// Where valgrind is missing or says nothing.
pub fn count(arguments: &[&str]) -> Result<f64, Failure> {
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg("--toggle-collect=*instructions*counted*")
        .arg(std::env::current_exe()?)
        .args(arguments)
        .stdout(Stdio::null())
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    let said = String::from_utf8_lossy(&run.stderr);
    let line = said.lines().find_map(|line| line.split_once("Collected :"));
    let (_, number) = line.ok_or_else(|| format!("callgrind counted nothing: {said}"))?;
    Ok(number.trim().parse()?)
}
