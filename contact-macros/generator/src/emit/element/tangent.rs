//! What are the coefficients of the tangent?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{components, matrix};
use super::gap::distance_inputs;
use crate::formulate::FormulatedElement;

pub(super) fn tangent_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let body = if e.tangent.is_none() {
        quote! { runtime::Coefficients::default() }
    } else {
        let mut inputs;
        if e.is_distance() {
            inputs = distance_inputs(e);
            inputs.push(quote! { orientation });
        } else {
            inputs = (0..d).map(|k| quote! { gap.n[#k] }).collect();
            inputs.push(quote! { gap.distance });
            for i in 0..p {
                inputs.extend(components("b", Some(i), d));
            }
            for i in 0..h {
                inputs.extend(components("second", Some(i), d));
            }
        }
        inputs.push(quote! { traction.traction });
        inputs.push(quote! { traction.slope });
        let position = matrix(0, d, d);
        let right = matrix(d * d, p, d);
        let left = matrix(d * d + p * d, p, d);
        let rotation = matrix(d * d + 2 * p * d, p, p);
        quote! {
            let o = tangent(&[#(#inputs),*]);
            runtime::Coefficients { p: #position, right: #right, left: #left, s: #rotation }
        }
    };
    quote! {
        #[inline(always)]
        fn tangent<T: runtime::Real>(
            vectors: &runtime::Vectors<#d, #p, #h, T>,
            gap: &runtime::Gap<#d, T>,
            traction: &runtime::Traction<T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Coefficients<#d, #p, T> {
            #body
        }
    }
}
