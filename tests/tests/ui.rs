//! What the compiler says: `tests/ui/fail` holds a file per class of mistake with the messages beside it.
//!
//! `TRYBUILD=overwrite` rewrites the messages; read the difference.

#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("ui/fail/*.rs");
}
