//! What is the gap, and does anything vanish that gap or tangent divide by?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::components;
use super::measure::gauss_tangents;
use crate::emit::program::name;
use crate::formulate::FormulatedElement;

/// Least length that a distance function may divide by [length].
const LEAST_LENGTH: f64 = 1e-30;
/// Least area that a moving measure may divide by [length^2].
const LEAST_AREA: f64 = 1e-60;
use super::measure::tangent_inputs;

pub(super) fn gap_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let r0 = e.parameters.layout.r0;
    let mut inputs = if e.is_distance() {
        distance_inputs(e)
    } else {
        components("r", None, d)
    };
    for i in 0..p {
        inputs.extend(components("b", Some(i), d));
    }
    inputs.push(quote! { orientation });
    inputs.push(quote! { r0 });
    let normal = (0..d).map(|k| quote! { o[#k] });
    let (distance, gap) = (d, d + 1);
    quote! {
        #[inline(always)]
        fn gap<T: runtime::Real>(
            vectors: &runtime::Vectors<#d, #p, #h, T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Gap<#d, T> {
            let r0 = parameters.get(#r0).copied().unwrap_or(T::constant(0.0));
            let o = gap(&[#(#inputs),*]);
            runtime::Gap { n: [#(#normal),*], distance: o[#distance], gap: o[#gap] }
        }
    }
}

/// The question before an evaluation; the default serves where nothing can vanish.
pub(super) fn divisors_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let questions = [distance_divisors(e), measure_divisors(e)];
    if questions.iter().all(Option::is_none) {
        return quote! {};
    }
    let questions = questions.iter().flatten();
    quote! {
        #[inline(always)]
        fn is_regular(
            point: usize,
            x: &[[f64; #d]],
            vectors: &runtime::Vectors<#d, #p, #h>,
            parameters: &[f64],
        ) -> bool {
            let mut regular = true;
            #(#questions)*
            regular
        }
    }
}

/// Can gap and tangent of a distance function be divided by?
fn distance_divisors(e: &FormulatedElement<'_>) -> Option<TokenStream> {
    let function = name(e.divisors.distance.as_ref()?);
    let mut inputs = distance_inputs(e);
    // orientation, N and N' are factors only
    inputs.extend([quote!(1.0), quote!(1.0), quote!(1.0)]);
    Some(quote! {
        regular &= runtime::can_divide(&#function(&[#(#inputs),*]), #LEAST_LENGTH);
    })
}

/// Can a moving measure be divided by?
fn measure_divisors(e: &FormulatedElement<'_>) -> Option<TokenStream> {
    let function = name(e.divisors.measure.as_ref()?);
    let geometry = e.declared.slave.geometry()?;
    let tangents = gauss_tangents(e, geometry, &quote! { return true });
    let inputs = tangent_inputs(geometry, e.declared.dimension);
    Some(quote! {
        #tangents
        regular &= runtime::can_divide(&#function(&[#(#inputs),*]), #LEAST_AREA);
    })
}

/// The coordinates and parameters of a distance function as expressions.
pub(super) fn distance_inputs(e: &FormulatedElement<'_>) -> Vec<TokenStream> {
    let mut inputs = components("r", None, e.declared.dimension);
    inputs.extend(own_parameters(e));
    inputs
}

/// The parameters of a distance function as expressions.
fn own_parameters(e: &FormulatedElement<'_>) -> Vec<TokenStream> {
    let rigid = e.declared.master.rigid();
    let count = rigid.map_or(0, |geometry| geometry.parameters.len());
    let at = e.parameters.layout.geometry;
    (at..at + count)
        .map(|index| quote! { parameters.get(#index).copied().unwrap_or(runtime::Real::constant(0.0)) })
        .collect()
}
