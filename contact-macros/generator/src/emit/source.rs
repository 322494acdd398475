//! Emitted tokens as source for people.

use proc_macro2::TokenStream;

use super::plain::plain;
use super::program::TAG;

/// Emitted tokens as formatted source. Equations at statements become comments: a comment does not survive among
/// tokens, so the tokens carry it as documentation.
///
/// # Errors
/// Where the tokens are no Rust file.
pub fn readable(tokens: &TokenStream) -> syn::Result<String> {
    let file = syn::parse2(plain(tokens.clone()))?;
    let text = prettyplease::unparse(&file);
    let lines = text.lines().map(|line| match line.trim_start() {
        comment if comment.starts_with(&format!("/// {TAG}")) => line.replacen("///", "//", 1),
        _ => line.to_string(),
    });
    Ok(lines.map(|line| line + "\n").collect())
}
