//! Helpers of the tests of all modules: text in, messages with their places out.

use crate::model::Model;
use crate::syntax::File;

/// The result of checking `text` against the library.
pub fn check(text: &str) -> syn::Result<Model> {
    let file: File = syn::parse_str(text)?;
    Model::build(&file, Some(&Model::library()))
}

/// The checked model; panics with all messages if there are any.
pub fn accept(text: &str) -> Model {
    check(text).unwrap_or_else(|error| panic!("{}", describe(error).join("\n")))
}

/// All messages of `text` as `line:column message\nhint: ..`, where the column starts at 1.
pub fn mistakes(text: &str) -> Vec<String> {
    match check(text) {
        Ok(_) => Vec::new(),
        Err(error) => describe(error),
    }
}

fn describe(error: syn::Error) -> Vec<String> {
    error
        .into_iter()
        .map(|error| {
            let start = error.span().start();
            format!("{}:{} {error}", start.line, start.column + 1)
        })
        .collect()
}

/// Asserts that `text` has exactly one mistake, at the place where `«` marks it in the text.
#[track_caller]
pub fn assert_mistake(text: &str, message: &str, hint: &str) {
    let before = text.split('«').next().unwrap();
    assert!(before.len() < text.len(), "no place is marked");
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
    let expected = format!("{line}:{column} {message}\nhint: {hint}");
    assert_eq!(mistakes(&text.replace('«', "")), [expected]);
}
