//! Normal laws as types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::program::{function, optional_table, table};
use super::values::imports;
use crate::formulate::FormulatedLaw;
use crate::model::{Bound, Law};

/// The type of a law, its trait implementation and its tables.
pub fn emit_law(formulated: &FormulatedLaw) -> TokenStream {
    let law = &formulated.declared;
    let name = &law.name;
    let docs = &law.docs;
    let module = format_ident!("_law_{}", name.to_string().to_lowercase());
    let functions: TokenStream = formulated.routines().map(function).collect();
    let (evaluate_table, active_table) = (table(&formulated.law), table(&formulated.active));
    let valid_table = optional_table(formulated.valid.as_ref());
    let methods = methods(law);
    let text = name.to_string();
    let imports = imports();
    quote! {
        #[doc = #docs]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #[allow(non_snake_case, clippy::all)]
        mod #module {
            use super::#name;
            #imports
            #functions
            #methods
            impl #name {
                /// The programs of this law, for verification.
                pub const PROGRAMS: LawPrograms = LawPrograms {
                    name: #text,
                    law: #evaluate_table,
                    active: #active_table,
                    valid: #valid_table,
                };
            }
        }
    }
}

fn methods(law: &Law) -> TokenStream {
    let name = &law.name;
    let count = law.parameters.len();
    let inputs: Vec<TokenStream> = (0..count).map(|k| quote! { parameters[#k] }).collect();
    let has_energy = law.energy.is_some();
    let closes_below = matches!(law.active, Bound::Below(_));
    let (pattern, energy) = if has_energy {
        (quote! { [traction, slope, energy] }, quote! { energy })
    } else {
        (quote! { [traction, slope] }, quote! { T::constant(0.0) })
    };
    let valid = if law.valid.is_some() {
        quote! {
            let Some(parameters) = parameters.first_chunk::<#count>() else { return T::constant(-1.0) };
            valid(&[gap, #(#inputs),*])[0]
        }
    } else {
        quote! { let _ = (gap, parameters); T::constant(1.0) }
    };
    quote! {
        #[allow(unused_variables)]
        impl runtime::NormalLaw for #name {
            const PARAMETERS: usize = #count;
            const ENERGY: bool = #has_energy;
            const CLOSES_BELOW: bool = #closes_below;
            #[inline(always)]
            fn active<T: runtime::Real>(gap: T, parameters: &[T]) -> T {
                let Some(parameters) = parameters.first_chunk::<#count>() else { return T::constant(-1.0) };
                active(&[gap, #(#inputs),*])[0]
            }
            #[inline(always)]
            fn valid<T: runtime::Real>(gap: T, parameters: &[T]) -> T {
                #valid
            }
            #[inline(always)]
            fn evaluate<T: runtime::Real>(gap: T, parameters: &[T]) -> runtime::Traction<T> {
                let Some(parameters) = parameters.first_chunk::<#count>() else {
                    let zero = T::constant(0.0);
                    return runtime::Traction { traction: zero, slope: zero, energy: zero };
                };
                let #pattern = law(&[gap, #(#inputs),*]);
                runtime::Traction { traction, slope, energy: #energy }
            }
        }
    }
}
