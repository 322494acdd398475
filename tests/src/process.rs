//! Running other programs; their output is shown when they fail.

use std::process::{Command, Output};

/// Runs a command that must start and end by itself, whatever its exit code.
pub fn run(command: &mut Command) -> Output {
    command
        .output()
        .unwrap_or_else(|error| panic!("{command:?}: {error}"))
}

/// Runs a command that must succeed; its standard output.
pub fn succeed(command: &mut Command) -> String {
    let output = run(command);
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}",
        output.status,
        text(&output)
    );
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Both outputs of a command.
pub fn text(output: &Output) -> String {
    let stdout = String::from_utf8_lossy(&output.stdout);
    let stderr = String::from_utf8_lossy(&output.stderr);
    format!("{stdout}{stderr}")
}

/// Whether a program of this name answers to `--version`.
pub fn exists(program: &str) -> bool {
    Command::new(program)
        .arg("--version")
        .output()
        .is_ok_and(|output| output.status.success())
}

/// Whether the tool can be used. A missing one skips a part of a test, visibly, unless the
/// environment variable `required` is `1`: then it is a failure.
pub fn available(tool: &str, required: &str) -> bool {
    if exists(tool) {
        return true;
    }
    let demanded = std::env::var(required).is_ok_and(|value| value == "1");
    assert!(!demanded, "{required}=1, but there is no {tool}");
    // Not captured by the test harness, unlike `eprintln!`.
    use std::io::Write;
    let _ = writeln!(
        std::io::stderr(),
        "SKIPPED: {tool} is not installed ({required}=1 makes this a failure)"
    );
    false
}
