//! Which area belongs to a contact point, and how does it change?

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::expressions::shape_call;
use crate::formulate::FormulatedElement;
use crate::model::{Geometry, Measure, Rule, Slave};

pub(super) fn measure_method(e: &FormulatedElement<'_>) -> TokenStream {
    let d = e.declared.dimension;
    let body = match &e.declared.slave {
        Slave::Integrated {
            geometry,
            rule: Rule::Given,
        } => {
            let index = e.parameters.layout.point + geometry.coordinates.len();
            quote! {
                runtime::Measure {
                    weight: parameters.get(#index).copied().unwrap_or(1.0),
                    ..runtime::Measure::default()
                }
            }
        }
        Slave::Integrated { geometry, .. } => gauss_measure(e, geometry),
        _ => quote! { runtime::Measure::default() },
    };
    quote! {
        #[inline(always)]
        fn measure(
            point: usize,
            reference: &[[f64; #d]],
            x: &[[f64; #d]],
            parameters: &[f64],
            variation: &mut [f64],
        ) -> runtime::Measure<#d> {
            #body
        }
    }
}

/// Statements that define `weight` and the tangents `t` of the slave at integration point `point`, of
/// the configuration that the measure is taken in.
pub(super) fn gauss_tangents(
    e: &FormulatedElement<'_>,
    geometry: &Geometry,
    otherwise: &TokenStream,
) -> TokenStream {
    let d = e.declared.dimension;
    let (n, p) = (geometry.nodes(), geometry.coordinates.len());
    let shape = shape_call(geometry);
    let start = e.parameters.layout.slave_weights;
    let slopes = if geometry.is_rational() {
        quote! {
            let weights = parameters.get(#start..).unwrap_or(&[]);
            let slopes = POINTS.get(point).map(|eta| #shape(eta, weights).d1);
        }
    } else {
        quote! { let slopes = SLOPES.get(point).copied(); }
    };
    let positions = if e.declared.measure == Measure::Current {
        quote!(x)
    } else {
        quote!(reference)
    };
    quote! {
        #slopes
        let (Some(slopes), Some(&weight)) = (slopes, WEIGHTS.get(point)) else {
            #otherwise;
        };
        let t = runtime::slave_tangents::<#d, #p, #n>(&slopes, #positions);
    }
}

fn gauss_measure(e: &FormulatedElement<'_>, geometry: &Geometry) -> TokenStream {
    let d = e.declared.dimension;
    let (n, p) = (geometry.nodes(), geometry.coordinates.len());
    let current = e.declared.measure == Measure::Current;
    let tangents = gauss_tangents(e, geometry, &quote! { return runtime::Measure::default() });
    let function = Ident::new(
        if current {
            "measure_current"
        } else {
            "measure_reference"
        },
        e.declared.name.span(),
    );
    let inputs = tangent_inputs(geometry, d);
    let spread = current.then(|| {
        let slots = (0..p).map(|i| {
            let entries = (0..d).map(|k| {
                let index = 1 + i * d + k;
                quote! { weight * o[#index] }
            });
            quote! { measure.variation[#i] = [#(#entries),*]; }
        });
        quote! {
            #(#slots)*
            runtime::spread_variation::<#d, #p, #n>(&slopes, &measure, variation);
        }
    });
    quote! {
        #tangents
        let o = #function(&[#(#inputs),*]);
        let mut measure = runtime::Measure::default();
        measure.weight = weight * o[0];
        #spread
        measure
    }
}

/// `t[i][k]` for all tangents of the slave.
pub(super) fn tangent_inputs(geometry: &Geometry, d: usize) -> Vec<TokenStream> {
    (0..geometry.coordinates.len())
        .flat_map(|i| (0..d).map(move |k| quote! { t[#i][#k] }))
        .collect()
}
