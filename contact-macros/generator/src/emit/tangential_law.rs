//! Tangential laws as types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::program::{function, optional_table, table};
use super::values::imports;
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

/// `[o[start], o[last]]`: an isotropic law has one value for both axes.
fn both_axes(start: usize, axes: usize) -> TokenStream {
    let last = start + axes - 1;
    quote! { [o[#start], o[#last]] }
}

/// Stiffness and, with a bound, the bound and its slopes.
fn fields(law: &TangentialLaw) -> TokenStream {
    let axes = law.stiffness.len();
    let of = |group: usize| both_axes(group * axes, axes);
    let stiffness = of(0);
    if law.bound.is_empty() {
        return quote! { stiffness: #stiffness, ..runtime::Friction::default() };
    }
    let (bound, by_pressure, by_slip) = (of(1), of(2), of(3));
    quote! { stiffness: #stiffness, bound: #bound, by_pressure: #by_pressure, by_slip: #by_slip, }
}

/// The force beyond the bound.
fn slide(law: &TangentialLaw) -> TokenStream {
    if law.bound.is_empty() {
        return quote! { runtime::Tangential::default() };
    }
    let axes = law.stiffness.len();
    let values = ["stiffness", "bound", "by_pressure", "by_slip"].into_iter();
    let values = values.flat_map(|field| {
        let field = format_ident!("{field}");
        (0..axes).map(move |q| quote! { friction.#field[#q] })
    });
    let gamma = (axes == 2).then(|| quote! { gamma });
    quote! {
        let o = sliding(&[s[0], s[1], #(#values,)* #gamma]);
        runtime::Tangential {
            t: [o[0], o[1]],
            c: [[o[2], o[3]], [o[4], o[5]]],
            h: [o[6], o[7]],
            ..runtime::Tangential::default()
        }
    }
}

fn methods(law: &TangentialLaw) -> TokenStream {
    let name = &law.name;
    let count = law.parameters.len();
    let (orthotropic, bounded) = (law.stiffness.len() == 2, !law.bound.is_empty());
    let inputs = (0..count).map(|k| quote! { parameters[#k] });
    let (fields, slide) = (fields(law), slide(law));
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
