//! Tangential laws as types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::imports;
use super::program::{function, optional_table, table};
use crate::formulate::FormulatedTangentialLaw;
use crate::model::TangentialLaw;

/// The type of a tangential law, its trait implementation and its tables.
pub fn emit_tangential_law(formulated: &FormulatedTangentialLaw) -> TokenStream {
    let law = &formulated.declared;
    let name = &law.name;
    let docs = &law.docs;
    let module = format_ident!("_tangential_law_{}", name.to_string().to_lowercase());
    let functions: TokenStream = formulated.routines().map(function).collect();
    let friction_table = table(&formulated.friction);
    let sliding_table = optional_table(formulated.sliding.as_ref());
    let methods = methods(law);
    let text = name.to_string();
    let orthotropic = law.stiffness.len() == 2;
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
                pub const PROGRAMS: TangentialLawPrograms = TangentialLawPrograms {
                    name: #text,
                    orthotropic: #orthotropic,
                    friction: #friction_table,
                    sliding: #sliding_table,
                };
            }
        }
    }
}

fn methods(law: &TangentialLaw) -> TokenStream {
    let name = &law.name;
    let count = law.parameters.len();
    let axes = law.stiffness.len();
    let (orthotropic, bounded) = (axes == 2, !law.bound.is_empty());
    let inputs = (0..count).map(|k| quote! { parameters[#k] });
    // an isotropic law has one value for both axes
    let pair = |start: usize| {
        let last = start + axes - 1;
        quote! { [o[#start], o[#last]] }
    };
    let fields = if bounded {
        let (stiffness, bound) = (pair(0), pair(axes));
        let (by_pressure, by_slip) = (pair(2 * axes), pair(3 * axes));
        quote! {
            stiffness: #stiffness, bound: #bound, by_pressure: #by_pressure, by_slip: #by_slip,
        }
    } else {
        let stiffness = pair(0);
        quote! { stiffness: #stiffness, ..runtime::Friction::default() }
    };
    let slide = if bounded {
        let of = |field: &str| {
            let field = format_ident!("{field}");
            (0..axes)
                .map(move |q| quote! { friction.#field[#q] })
                .collect::<Vec<_>>()
        };
        let (stiffness, bound) = (of("stiffness"), of("bound"));
        let (by_pressure, by_slip) = (of("by_pressure"), of("by_slip"));
        let gamma = orthotropic.then(|| quote! { gamma });
        quote! {
            let o = sliding(&[
                s[0], s[1], #(#stiffness,)* #(#bound,)* #(#by_pressure,)* #(#by_slip,)* #gamma
            ]);
            runtime::Tangential {
                t: [o[0], o[1]],
                c: [[o[2], o[3]], [o[4], o[5]]],
                h: [o[6], o[7]],
                ..runtime::Tangential::default()
            }
        }
    } else {
        quote! { runtime::Tangential::default() }
    };
    quote! {
        #[allow(unused_variables)]
        impl runtime::TangentialLaw for #name {
            const ACTIVE: bool = true;
            const ORTHOTROPIC: bool = #orthotropic;
            const BOUNDED: bool = #bounded;
            const PARAMETERS: usize = #count;
            #[inline(always)]
            fn evaluate(pressure: f64, slip: f64, parameters: &[f64]) -> runtime::Friction {
                let Some(parameters) = parameters.first_chunk::<#count>() else {
                    return runtime::Friction::default();
                };
                let o = friction(&[pressure, slip, #(#inputs),*]);
                runtime::Friction { #fields }
            }
            #[inline(always)]
            fn slide(
                s: [f64; 2],
                friction: &runtime::Friction,
                gamma: f64,
            ) -> runtime::Tangential {
                #slide
            }
        }
    }
}
