//! Paths in a stream of tokens, those within macros too.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Collects every path of at least two names, and all names that occur. The body of `quote!` is another crate's code.
pub fn paths_in(tokens: TokenStream, paths: &mut Vec<Vec<String>>, names: &mut BTreeSet<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < trees.len() {
        match &trees[at] {
            TokenTree::Ident(ident)
                if ident.to_string().starts_with("quote")
                    && is_punctuation(&trees, at + 1, '!') =>
            {
                at += 3;
            }
            TokenTree::Ident(_) => at = path_at(&trees, at, &[], paths, names),
            TokenTree::Group(group) => {
                paths_in(group.stream(), paths, names);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Reads the path that begins at a name, after what stands before it; returns the place behind.
fn path_at(
    trees: &[TokenTree],
    start: usize,
    before: &[String],
    paths: &mut Vec<Vec<String>>,
    names: &mut BTreeSet<String>,
) -> usize {
    // `::name` is another crate's
    let is_foreign = start >= 2 && before.is_empty() && is_separator(trees, start - 2);
    let (mut path, mut at) = (before.to_vec(), start);
    while let Some(TokenTree::Ident(ident)) = trees.get(at) {
        path.push(ident.to_string());
        names.insert(ident.to_string());
        at += 1;
        if !is_separator(trees, at) {
            break;
        }
        match trees.get(at + 2) {
            Some(TokenTree::Ident(_)) => at += 2,
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                branches(group.stream(), &path, paths, names);
                return at + 3;
            }
            _ => break,
        }
    }
    if path.len() > 1 && !is_foreign {
        paths.push(path);
    }
    at
}

/// The paths of `before::{…}`.
fn branches(
    tokens: TokenStream,
    before: &[String],
    paths: &mut Vec<Vec<String>>,
    names: &mut BTreeSet<String>,
) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < trees.len() {
        at = match &trees[at] {
            TokenTree::Ident(ident) if ident == "self" => {
                paths.push(before.to_vec());
                at + 1
            }
            TokenTree::Ident(_) => path_at(&trees, at, before, paths, names),
            _ => at + 1,
        };
    }
}

fn is_punctuation(trees: &[TokenTree], at: usize, sign: char) -> bool {
    matches!(trees.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

fn is_separator(trees: &[TokenTree], at: usize) -> bool {
    is_punctuation(trees, at, ':') && is_punctuation(trees, at + 1, ':')
}
