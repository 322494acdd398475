//! Geometries as types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::program::{function, optional_table, table};
use super::values::{domain, imports};
use crate::formulate::{FormulatedGeometry, second_derivatives, third_derivatives};
use crate::model::Body;

/// The type of a geometry, its trait implementation and its tables.
pub fn emit_geometry(formulated: &FormulatedGeometry) -> TokenStream {
    let geometry = &formulated.declared;
    let name = &geometry.name;
    let docs = &geometry.docs;
    let module = format_ident!("_geometry_{}", name.to_string().to_lowercase());
    let functions: TokenStream = formulated.routines().map(function).collect();
    let implementation = match &geometry.body {
        Body::Shape { .. } => shape(formulated),
        Body::Rigid { .. } => rigid(formulated),
        Body::Distance { .. } => {
            let d = geometry.coordinates.len();
            quote! { impl runtime::Distance<#d> for #name {} }
        }
    };
    let values_table = table(&formulated.values);
    let third_table = optional_table(formulated.third.as_ref());
    let projection_table = optional_table(formulated.projection.as_ref());
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

fn shape(formulated: &FormulatedGeometry) -> TokenStream {
    let geometry = &formulated.declared;
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
    let curved = &formulated.curved;
    let affine = formulated.is_affine();
    let flags = (0..n).map(|a| vectors.contains(&a));
    let (rows, third) = (
        rows_method([p, h, n], weights),
        third_method([p, n], weights),
    );
    quote! {
        impl runtime::Shape<#p, #h, #n> for #name {
            const DOMAIN: runtime::Domain = #domain;
            const AFFINE: bool = #affine;
            const WEIGHTS: usize = #weights;
            const VECTORS: [bool; #n] = [#(#flags),*];
            const CURVED: [bool; #h] = [#(#curved),*];
            #rows
            #third
        }
    }
}

/// `&[zeta[0], …, values[0], …]`
fn inputs(p: usize, values: &str, count: usize) -> TokenStream {
    let values = format_ident!("{values}");
    let zeta = (0..p).map(|i| quote! { zeta[#i] });
    let others = (0..count).map(|k| quote! { #values[#k] });
    quote! { &[#(#zeta,)* #(#others),*] }
}

/// Rows of shape functions with first and second derivatives.
fn rows_method([p, h, n]: [usize; 3], weights: usize) -> TokenStream {
    let inputs = inputs(p, "weights", weights);
    let values = (0..n).map(|a| quote! { o[#a] });
    let (first, second) = (block(n, p, n), block(n * (1 + p), h, n));
    quote! {
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
            let o = rows(#inputs);
            runtime::ShapeRows { n: [#(#values),*], d1: #first, d2: #second }
        }
    }
}

/// Third derivatives of the shape functions.
fn third_method([p, n]: [usize; 2], weights: usize) -> TokenStream {
    let inputs = inputs(p, "weights", weights);
    let third = third_rows(p, n);
    quote! {
        #[inline(always)]
        #[allow(unused_variables)]
        fn third(zeta: &[f64; #p], weights: &[f64]) -> [[f64; #n]; 4] {
            let Some(weights) = weights.first_chunk::<#weights>() else {
                return [[0.0; #n]; 4];
            };
            let o = rows_third(#inputs);
            #third
        }
    }
}

fn rigid(formulated: &FormulatedGeometry) -> TokenStream {
    let geometry = &formulated.declared;
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
    let affine = formulated.is_affine();
    let inputs = inputs(p, "parameters", count);
    let third = third_rows(p, d);
    let values = (0..d).map(|k| quote! { o[#k] });
    let (first, second) = (block(d, p, d), block(d * (1 + p), h, d));
    let closed = closed_projection(projection.is_some(), d, count);
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
                let o = position(#inputs);
                runtime::Vectors { r: [#(#values),*], b: #first, second: #second }
            }
            #[inline(always)]
            fn third(zeta: &[f64; #p], parameters: &[f64]) -> [[f64; #d]; 4] {
                let Some(parameters) = parameters.first_chunk::<#count>() else {
                    return [[0.0; #d]; 4];
                };
                let o = position_third(#inputs);
                #third
            }
            #[inline(always)]
            fn projection(x: &[f64; #d], parameters: &[f64]) -> Option<[f64; #p]> {
                #closed
            }
        }
    }
}

/// The closest point in closed form, where it is declared.
fn closed_projection(declared: bool, d: usize, count: usize) -> TokenStream {
    if !declared {
        return quote! { None };
    }
    let x = (0..d).map(|k| quote! { x[#k] });
    let parameters = (0..count).map(|k| quote! { parameters[#k] });
    quote! {
        let parameters = parameters.first_chunk::<#count>()?;
        Some(projection(&[#(#x,)* #(#parameters),*]))
    }
}
