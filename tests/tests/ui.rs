//! What the compiler says: `tests/ui/fail` holds a file per class of mistake with the messages beside
//! it, `tests/ui/pass` declarations of every feature of the language, built and run.
//!
//! `TRYBUILD=overwrite` writes the messages anew; read the difference.

#[test]
fn messages_and_features() {
    let tests = trybuild::TestCases::new();
    tests.compile_fail("ui/fail/*.rs");
    tests.pass("ui/pass/*.rs");
}
