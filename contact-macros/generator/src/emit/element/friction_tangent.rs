//! What is the tangent of tangential contact as a call from values to values?

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::expressions::{components, matrix};
use crate::emit::program::name;
use crate::formulate::{FormulatedElement, FrictionPrograms, third_derivatives};
use crate::model::Axis;

/// Name of the call that gives the tangent, where there is one.
pub(super) fn tangent_call(friction: &FrictionPrograms) -> Option<Ident> {
    let kind = if friction.merges_with_normal {
        "joined"
    } else {
        "forms"
    };
    let tangent = friction.tangent.as_ref()?;
    Some(format_ident!("{}_{kind}", tangent.function))
}

/// The tangential tangent as a call from values to values: no arrays of inputs and outputs in between.
pub(super) fn tangent_items(e: &FormulatedElement<'_>) -> TokenStream {
    let Some((friction, tangent)) =
        (e.friction.as_ref()).and_then(|own| Some((own, own.tangent.as_ref()?)))
    else {
        return quote! {};
    };
    let (d, p, h) = e.sizes();
    let (call, function) = (tangent_call(friction), name(tangent));
    let mut inputs = contact_inputs((d, p, h));
    for k in 0..third_derivatives(p) {
        // a curve's only third derivative stands first
        inputs.extend((0..d).map(|c| quote! { third[#k][#c] }));
    }
    inputs.extend((0..p).map(|q| quote! { frame.s[#q] }));
    inputs.extend((0..p).map(|q| quote! { tangential.t[#q] }));
    for q in 0..p {
        inputs.extend((0..p).map(|r| quote! { tangential.c[#q][#r] }));
    }
    inputs.extend((0..p).map(|q| quote! { tangential.h[#q] }));
    inputs.push(quote! { slope });
    if friction.rolling.is_some() {
        inputs.extend((0..p).map(|q| quote! { tangential.force[#q] }));
    }
    let along = (friction.axis == Some(Axis::Slave)).then(|| {
        inputs.extend((0..d).map(|k| quote! { slave_tangent[#k] }));
        quote! { , slave_tangent: &[f64; #d] }
    });
    let forms = coefficients((d, p, h));
    let (result, value) = if friction.merges_with_normal {
        (quote! { [[f64; #d]; #d] }, quote! { #forms.joined() })
    } else {
        let result = quote! { runtime::TangentialCoefficients<#d, #p, #h> };
        (result, forms)
    };
    quote! {
        #[inline(never)]
        pub(super) fn #call(
            vectors: &runtime::Vectors<#d, #p, #h>,
            gap: &runtime::Gap<#d>,
            frame: &runtime::Frame<#p>,
            third: &[[f64; #d]; 4],
            (tangential, slope): (&runtime::Tangential, f64)
            #along
        ) -> #result {
            let o = #function(&[#(#inputs),*]);
            #value
        }
    }
}

/// n, L, b_i, r_,ij, E
pub(super) fn contact_inputs((d, p, h): (usize, usize, usize)) -> Vec<TokenStream> {
    let mut inputs: Vec<TokenStream> = (0..d).map(|k| quote! { gap.n[#k] }).collect();
    inputs.push(quote! { gap.distance });
    for i in 0..p {
        inputs.extend(components("b", Some(i), d));
    }
    for i in 0..h {
        inputs.extend(components("second", Some(i), d));
    }
    for i in 0..p {
        inputs.extend((0..p).map(|q| quote! { frame.e[#i][#q] }));
    }
    inputs
}

/// The coefficients of the tangential tangent from the output array `o`.
fn coefficients((d, p, h): (usize, usize, usize)) -> TokenStream {
    let run = |start: usize, count: usize| {
        let entries = (start..start + count).map(|index| quote! { o[#index] });
        quote! { [#(#entries),*] }
    };
    let mut start = 0;
    let mut forms = |width: usize, form: &dyn Fn(usize) -> TokenStream| {
        let forms: Vec<TokenStream> = (0..p).map(|q| form(start + q * width)).collect();
        start += p * width;
        quote! { [#(#forms),*] }
    };
    let z = forms(d + p, &|at| {
        let (position, turning) = (run(at, d), run(at + d, p));
        quote! { runtime::Variation { position: #position, turning: #turning } }
    });
    let second = forms(d + p * d + h, &|at| {
        let (position, turning) = (run(at, d), matrix(at + d, p, d));
        let bending = run(at + d + p * d, h);
        quote! {
            runtime::SecondVariation { position: #position, turning: #turning, bending: #bending }
        }
    });
    let g = forms(2 * d + p * d, &|at| {
        let (position, turning) = (run(at, d), matrix(at + d, p, d));
        let slave = run(at + d + p * d, d);
        quote! { runtime::ForceChange { position: #position, turning: #turning, slave: #slave } }
    });
    let cross = run(start, p);
    quote! { runtime::TangentialCoefficients { z: #z, p: #second, g: #g, cross: #cross } }
}
