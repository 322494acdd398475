//! Messages: how they look, how they are collected, and the catalogue of all of them.
//!
//! A message says what is wrong in the words of the language; its hint says what to write instead.
//! Mistakes are collected so that one build shows all of them.

pub mod angle;
pub mod element;
pub mod geometry;
pub mod law;
pub mod names;
pub mod suggest;
pub mod syntax;
#[cfg(test)]
pub(crate) mod testing;

use proc_macro2::Span;

/// A message with its hint; the span is added where it is reported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub hint: String,
}

impl Diagnostic {
    /// A message with its hint.
    pub fn new(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Diagnostic {
            message: message.into(),
            hint: hint.into(),
        }
    }

    /// The compiler error at `span`.
    pub fn at(self, span: Span) -> syn::Error {
        syn::Error::new(span, format!("{}\nhint: {}", self.message, self.hint))
    }
}

/// Collects mistakes; panics if it is dropped before they were taken out.
#[derive(Debug, Default)]
#[must_use = "the mistakes must be taken out with `finish` or `into_errors`"]
pub struct Mistakes {
    errors: Vec<syn::Error>,
    taken: bool,
}

impl Mistakes {
    /// No mistakes yet.
    pub fn new() -> Self {
        Mistakes::default()
    }

    /// Records a mistake of the catalogue.
    pub fn report(&mut self, span: Span, diagnostic: Diagnostic) {
        self.push(diagnostic.at(span));
    }

    /// Records an error.
    pub fn push(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    /// How many mistakes were recorded so far: compare two counts to learn whether a check passed.
    pub fn count(&self) -> usize {
        self.errors.len()
    }

    /// The mistakes in the order of their recording.
    pub fn into_errors(mut self) -> Vec<syn::Error> {
        self.taken = true;
        std::mem::take(&mut self.errors)
    }

    /// All mistakes as one error in the order of the text, if there are any.
    pub fn finish(self) -> syn::Result<()> {
        let mut errors = self.into_errors();
        errors.sort_by_key(|error| {
            let start = error.span().start();
            (start.line, start.column)
        });
        let mut errors = errors.into_iter();
        let Some(mut all) = errors.next() else {
            return Ok(());
        };
        errors.for_each(|error| all.combine(error));
        Err(all)
    }
}

impl Drop for Mistakes {
    fn drop(&mut self) {
        if !self.taken && !std::thread::panicking() {
            panic!("mistakes were collected but never taken out");
        }
    }
}

/// `a`, `b` and `c`.
pub fn list<T: AsRef<str>>(names: &[T], conjunction: &str) -> String {
    let quoted: Vec<String> = names
        .iter()
        .map(|name| format!("`{}`", name.as_ref()))
        .collect();
    match quoted.split_last() {
        None => "none".to_string(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} {conjunction} {last}", rest.join(", ")),
    }
}

/// A number with at most six decimals.
pub fn short(value: f64) -> String {
    let magnitude = value.abs();
    if value.is_finite() && magnitude != 0.0 && !(1e-4..1e9).contains(&magnitude) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.6}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_come_out_in_the_order_of_the_text() {
        let tokens: Vec<_> = "first second"
            .parse::<proc_macro2::TokenStream>()
            .unwrap()
            .into_iter()
            .collect();
        let mut mistakes = Mistakes::new();
        mistakes.report(tokens[1].span(), Diagnostic::new("two", "b"));
        mistakes.report(tokens[0].span(), Diagnostic::new("one", "a"));
        assert_eq!(mistakes.count(), 2);
        let texts: Vec<String> = mistakes
            .finish()
            .unwrap_err()
            .into_iter()
            .map(|error| error.to_string())
            .collect();
        assert_eq!(texts, ["one\nhint: a", "two\nhint: b"]);
    }

    #[test]
    #[should_panic(expected = "never taken out")]
    fn dropping_mistakes_unread_is_a_bug() {
        drop(Mistakes::new());
    }

    #[test]
    fn lists_and_numbers_read_well() {
        assert_eq!(list::<&str>(&[], "or"), "none");
        assert_eq!(list(&["a"], "or"), "`a`");
        assert_eq!(list(&["a", "b", "c"], "or"), "`a`, `b` or `c`");
        assert_eq!(short(0.75), "0.75");
        assert_eq!(short(2.0), "2");
        assert_eq!(short(1e-7), "1.000e-7");
        assert_eq!(short(f64::NAN), "NaN");
    }
}
