//! The size of a declaration: code past some thousand operations outgrows the instruction cache and slows
//! the compiler down, so it is refused where it is declared.

use syn::Ident;

/// Operations of one program above which a declaration is refused.
pub const MOST_OPERATIONS: usize = 10_000;

/// Refuses geometries and laws whose programs are too large; all of them at once. The closed forms of an
/// element have a fixed size, so only declared expressions can exceed it.
///
/// # Errors
/// One message per geometry or law, at its name.
pub fn check<'a>(sizes: impl IntoIterator<Item = (&'a Ident, usize)>) -> syn::Result<()> {
    let sizes = sizes.into_iter();
    let too_large = sizes
        .filter(|(_, operations)| *operations > MOST_OPERATIONS)
        .map(|(name, operations)| message(name, operations));
    match too_large.reduce(|mut all, one| {
        all.combine(one);
        all
    }) {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

fn message(name: &Ident, operations: usize) -> syn::Error {
    let text = format!(
        "`{name}` needs {operations} operations, more than {MOST_OPERATIONS}\n\
         hint: share common factors with `let`, or split the geometry into facets"
    );
    syn::Error::new(name.span(), text)
}

#[cfg(test)]
mod tests {
    use crate::formulate::formulate;
    use crate::model::Model;

    fn surface(terms: usize) -> syn::Result<()> {
        let sum: Vec<String> = (1..=terms)
            .map(|k| format!("sin({k}*u)*cos({k}*v)"))
            .collect();
        let text = format!(
            "rigid surface Wavy(u, v) {{ rho = [u, v, {}]; }}",
            sum.join(" + ")
        );
        let file = syn::parse_str(&text)?;
        formulate(&Model::build(&file, None)?).map(drop)
    }

    #[test]
    fn a_large_declaration_is_refused_at_its_name() {
        assert!(surface(20).is_ok());
        let error = surface(600).expect_err("too large");
        assert!(error.to_string().starts_with("`Wavy` needs"), "{error}");
        assert!(error.to_string().contains("hint:"));
    }
}
