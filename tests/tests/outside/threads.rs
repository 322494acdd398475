//! Batches by several threads: a crate outside the workspace (`tests/threads`), where `contact-elements` has the feature
//! `threads` and the C library has not.

use std::path::Path;

use contact_tests::library::cargo;
use contact_tests::process::succeed;
use contact_tests::workspace;

#[test]
fn threads_have_the_bits_of_one() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    let printed = succeed(
        cargo("test")
            .arg("--manifest-path")
            .arg(workspace("tests/threads/Cargo.toml"))
            .env("CARGO_TARGET_DIR", target.expect("the target directory")),
    );
    for name in [
        "in_lanes",
        "alone_with_friction",
        "several_points",
        "multipliers",
        "with_a_workspace",
        "faults_of_the_batch",
    ] {
        let passed = format!("test {name} ... ok");
        assert!(printed.contains(&passed), "{printed}");
    }
}
