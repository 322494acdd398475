//! Numbers without the suffix of their type: the place where they stand tells it.

use proc_macro2::{Group, Literal, TokenStream, TokenTree};

/// The tokens with every number as a person would write it: `3`, `0.5`.
pub fn plain(tokens: TokenStream) -> TokenStream {
    tokens.into_iter().map(plain_token).collect()
}

fn plain_token(token: TokenTree) -> TokenTree {
    match token {
        TokenTree::Group(group) => {
            let mut inner = Group::new(group.delimiter(), plain(group.stream()));
            inner.set_span(group.span());
            inner.into()
        }
        TokenTree::Literal(literal) => without_suffix(literal).into(),
        other => other,
    }
}

fn without_suffix(literal: Literal) -> Literal {
    let text = literal.to_string();
    let number = |suffix: &str| {
        text.strip_suffix(suffix)
            .filter(|_| starts_with_digit(&text))
    };
    let integers = ["usize", "u16", "u32", "u64"].into_iter().find_map(number);
    let mut plain = if let Some(Ok(value)) = integers.map(str::parse::<u64>) {
        Literal::u64_unsuffixed(value)
    } else if let Some(Ok(value)) = number("f64").map(str::parse::<f64>) {
        Literal::f64_unsuffixed(value)
    } else {
        return literal;
    };
    plain.set_span(literal.span());
    plain
}

fn starts_with_digit(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn numbers_lose_the_suffix_and_texts_stay() {
        let tokens = quote::quote! { [3usize, 7u16, 1f64, 0.5f64, -2f64, "4usize", t8] };
        let expected = quote::quote! { [3, 7, 1.0, 0.5, -2.0, "4usize", t8] };
        assert_eq!(plain(tokens).to_string(), expected.to_string());
    }
}
