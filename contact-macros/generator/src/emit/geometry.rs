//! Geometries as types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{domain, imports, program::Emitted};
use crate::linearise::geometry::{
    curved, projection_program, rigid_program, rigid_third_program, shape_program,
    shape_third_program,
};
use crate::linearise::{distance, second_derivatives, third_derivatives};
use crate::model::{Body, Geometry};

/// The type of a geometry, its trait implementation and its tables.
pub fn emit_geometry(geometry: &Geometry) -> TokenStream {
    let name = &geometry.name;
    let docs = &geometry.docs;
    let module = format_ident!("_geometry_{}", name.to_string().to_lowercase());
    let (values, third) = match &geometry.body {
        Body::Shape { .. } => (shape_program(geometry), Some(shape_third_program(geometry))),
        Body::Rigid { .. } => (rigid_program(geometry), Some(rigid_third_program(geometry))),
        Body::Distance { .. } => (distance::gap_program(geometry), None),
    };
    let values = Emitted::new(&values, "");
    let third = third.map(|program| Emitted::new(&program, ""));
    let projection = projection_program(geometry).map(|program| Emitted::new(&program, ""));
    let functions: TokenStream = [Some(&values), third.as_ref(), projection.as_ref()]
        .into_iter()
        .flatten()
        .map(Emitted::whole_function)
        .collect();
    let implementation = match &geometry.body {
        Body::Shape { .. } => shape(geometry),
        Body::Rigid { .. } => rigid(geometry),
        Body::Distance { .. } => {
            let d = geometry.coordinates.len();
            quote! { impl runtime::Distance<#d> for #name {} }
        }
    };
    let values_table = values.table();
    let third_table = optional_table(third.as_ref());
    let projection_table = optional_table(projection.as_ref());
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
            #implementation
            impl #name {
                /// The programs of this geometry, for verification and for the search over its domain.
                pub const PROGRAMS: &'static GeometryPrograms = {
                    // a static: a constant would stand in every crate with an element of this geometry
                    static PROGRAMS: GeometryPrograms = GeometryPrograms {
                        name: #text,
                        values: #values_table,
                        third: #third_table,
                        projection: #projection_table,
                    };
                    &PROGRAMS
                };
            }
        }
    }
}

fn optional_table(emitted: Option<&Emitted>) -> TokenStream {
    match emitted {
        Some(emitted) => {
            let table = emitted.table();
            quote! { Some(#table) }
        }
        None => quote! { None },
    }
}

/// `[[value; width]; rows]` from consecutive entries of the output array `o`.
fn block(start: usize, rows: usize, width: usize) -> TokenStream {
    let rows = (0..rows).map(|row| {
        let entries = (0..width).map(|k| {
            let index = start + row * width + k;
            quote! { o[#index] }
        });
        quote! { [#(#entries),*] }
    });
    quote! { [#(#rows),*] }
}

/// The rows 111, 112, 122, 222 of `width` entries from the output array `o`; a curve has the first only.
fn third_rows(p: usize, width: usize) -> TokenStream {
    let given = third_derivatives(p);
    let rows = (0..4).map(|row| {
        let entries = (0..width).map(|k| {
            let index = row * width + k;
            if row < given {
                quote! { o[#index] }
            } else {
                quote! { 0.0 }
            }
        });
        quote! { [#(#entries),*] }
    });
    quote! { [#(#rows),*] }
}

fn shape(geometry: &Geometry) -> TokenStream {
    let Body::Shape {
        functions,
        vectors,
        rational,
    } = &geometry.body
    else {
        unreachable!("called for shape functions only")
    };
    let name = &geometry.name;
    let (p, n) = (geometry.coordinates.len(), functions.len());
    let h = second_derivatives(p);
    let weights = if *rational { n } else { 0 };
    let domain = domain(&geometry.domain);
    let curved = curved(geometry);
    let affine = curved.iter().all(|&curved| !curved);
    let flags = (0..n).map(|a| vectors.contains(&a));
    let zeta = (0..p).map(|i| quote! { zeta[#i] });
    let zeta_third = zeta.clone();
    let weight = (0..weights).map(|a| quote! { weights[#a] });
    let weight_third = weight.clone();
    let values = (0..n).map(|a| quote! { o[#a] });
    let first = block(n, p, n);
    let second = block(n * (1 + p), h, n);
    let third_inputs = quote! { &[#(#zeta_third,)* #(#weight_third),*] };
    let third = third_rows(p, n);
    quote! {
        impl runtime::Shape<#p, #h, #n> for #name {
            const DOMAIN: runtime::Domain = #domain;
            const AFFINE: bool = #affine;
            const WEIGHTS: usize = #weights;
            const VECTORS: [bool; #n] = [#(#flags),*];
            const CURVED: [bool; #h] = [#(#curved),*];
            #[inline(always)]
            #[allow(unused_variables)]
            fn rows<T: runtime::Real>(
                zeta: &[T; #p],
                weights: &[T],
            ) -> runtime::ShapeRows<#p, #h, #n, T> {
                let zero = T::constant(0.0);
                let Some(weights) = weights.first_chunk::<#weights>() else {
                    return runtime::ShapeRows {
                        n: [zero; #n],
                        d1: [[zero; #n]; #p],
                        d2: [[zero; #n]; #h],
                    };
                };
                let o = rows(&[#(#zeta,)* #(#weight),*]);
                runtime::ShapeRows { n: [#(#values),*], d1: #first, d2: #second }
            }
            #[inline(always)]
            #[allow(unused_variables)]
            fn third(zeta: &[f64; #p], weights: &[f64]) -> [[f64; #n]; 4] {
                let Some(weights) = weights.first_chunk::<#weights>() else {
                    return [[0.0; #n]; 4];
                };
                let o = rows_third(#third_inputs);
                #third
            }
        }
    }
}

fn rigid(geometry: &Geometry) -> TokenStream {
    let Body::Rigid {
        position,
        projection,
    } = &geometry.body
    else {
        unreachable!("called for rigid geometries only")
    };
    let name = &geometry.name;
    let (p, d) = (geometry.coordinates.len(), position.len());
    let h = second_derivatives(p);
    let count = geometry.parameters.len();
    let domain = domain(&geometry.domain);
    let affine = curved(geometry).iter().all(|&curved| !curved);
    let zeta = (0..p).map(|i| quote! { zeta[#i] });
    let zeta_third = zeta.clone();
    let third = third_rows(p, d);
    let parameters: Vec<TokenStream> = (0..count).map(|k| quote! { parameters[#k] }).collect();
    let values = (0..d).map(|k| quote! { o[#k] });
    let first = block(d, p, d);
    let second = block(d * (1 + p), h, d);
    let closed = if projection.is_some() {
        let x = (0..d).map(|k| quote! { x[#k] });
        quote! {
            let parameters = parameters.first_chunk::<#count>()?;
            Some(projection(&[#(#x,)* #(#parameters),*]))
        }
    } else {
        quote! { None }
    };
    quote! {
        #[allow(unused_variables)]
        impl runtime::Rigid<#d, #p, #h> for #name {
            const DOMAIN: runtime::Domain = #domain;
            const AFFINE: bool = #affine;
            #[inline(always)]
            fn position<T: runtime::Real>(
                zeta: &[T; #p],
                parameters: &[T],
            ) -> runtime::Vectors<#d, #p, #h, T> {
                let Some(parameters) = parameters.first_chunk::<#count>() else {
                    return runtime::Vectors::default();
                };
                let o = position(&[#(#zeta,)* #(#parameters),*]);
                runtime::Vectors { r: [#(#values),*], b: #first, second: #second }
            }
            #[inline(always)]
            fn third(zeta: &[f64; #p], parameters: &[f64]) -> [[f64; #d]; 4] {
                let Some(parameters) = parameters.first_chunk::<#count>() else {
                    return [[0.0; #d]; 4];
                };
                let o = position_third(&[#(#zeta_third,)* #(#parameters),*]);
                #third
            }
            #[inline(always)]
            fn projection(x: &[f64; #d], parameters: &[f64]) -> Option<[f64; #p]> {
                #closed
            }
        }
    }
}
