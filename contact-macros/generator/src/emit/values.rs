//! Values as expressions, and what every emitted item refers to.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::Domain;

/// What every emitted item refers to.
pub fn imports() -> TokenStream {
    quote! {
        #[allow(unused_imports)]
        use ::contact_elements::ElementDescription;
        #[allow(unused_imports)]
        use ::contact_elements::table::{
            AngleDescription, AxisDescription, ElementPrograms, GeometryPrograms, LawPrograms, MasterDescription,
            Operation, RollingDescription, SlaveDescription, Table, TangentialLawPrograms, Term,
        };
        #[allow(unused_imports)]
        use ::contact_elements::runtime;
    }
}

/// A parameter domain as an expression.
pub fn domain(domain: &Domain) -> TokenStream {
    match domain {
        Domain::Unbounded => quote! { runtime::Domain::Unbounded },
        Domain::Interval(lower, upper) => {
            let (lower, upper) = (number(*lower), number(*upper));
            quote! { runtime::Domain::Interval(#lower, #upper) }
        }
        Domain::Rectangle(lower, upper) => {
            let lower = lower.iter().map(|&v| number(v));
            let upper = upper.iter().map(|&v| number(v));
            quote! { runtime::Domain::Rectangle([#(#lower),*], [#(#upper),*]) }
        }
        Domain::Triangle => quote! { runtime::Domain::Triangle },
    }
}

/// An optional offset as an expression.
pub fn option(value: Option<usize>) -> TokenStream {
    match value {
        Some(value) => quote! { Some(#value) },
        None => quote! { None },
    }
}

/// A number as an expression, infinities included.
pub fn number(value: f64) -> TokenStream {
    if value == f64::INFINITY {
        quote! { f64::INFINITY }
    } else if value == f64::NEG_INFINITY {
        quote! { f64::NEG_INFINITY }
    } else {
        quote! { #value }
    }
}
