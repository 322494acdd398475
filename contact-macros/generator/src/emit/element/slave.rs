//! Which row of shape functions does the slave have at a contact point?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::shape_call;
use crate::formulate::FormulatedElement;
use crate::model::{Geometry, Rule, Slave};

/// Shape rows at the integration points, and their derivatives where a measure needs them.
pub(super) fn statics(e: &FormulatedElement<'_>) -> TokenStream {
    let Slave::Integrated {
        geometry,
        rule: Rule::Gauss(_),
    } = &e.declared.slave
    else {
        return quote! {};
    };
    let p = geometry.coordinates.len();
    let q = e.points.len();
    let coordinates = e.points.iter().map(|(point, _)| {
        let point = &point[..p];
        quote! { [#(#point),*] }
    });
    let weights = e.points.iter().map(|(_, weight)| weight);
    let rows = (!geometry.is_rational()).then(|| shape_rows(e, geometry));
    quote! {
        #rows
        static POINTS: [[f64; #p]; #q] = [#(#coordinates),*];
        static WEIGHTS: [f64; #q] = [#(#weights),*];
    }
}

/// Rows and slopes as constants: without weights they depend on nothing that comes at run time.
fn shape_rows(e: &FormulatedElement<'_>, geometry: &Geometry) -> TokenStream {
    let (n, p, q) = (geometry.nodes(), geometry.coordinates.len(), e.points.len());
    let values = e.shape_values();
    let row = |row: &[f64]| quote! { [#(#row),*] };
    let rows = values.iter().map(|values| row(&values[..n]));
    let slopes = values.iter().map(|values| {
        let rows = (0..p).map(|i| row(&values[n * (1 + i)..n * (2 + i)]));
        quote! { [#(#rows),*] }
    });
    quote! {
        static ROWS: [[f64; #n]; #q] = [#(#rows),*];
        static SLOPES: [[[f64; #n]; #p]; #q] = [#(#slopes),*];
    }
}

pub(super) fn slave_method(e: &FormulatedElement<'_>) -> TokenStream {
    let body = match &e.declared.slave {
        Slave::Point => quote! {
            if let Some(s) = s.first_mut() {
                *s = T::constant(1.0);
            }
        },
        Slave::Interpolated | Slave::Projected(_) => quote! {},
        Slave::Integrated { geometry, rule } => {
            let n = geometry.nodes();
            let row = slave_rows(e, geometry, rule);
            quote! {
                #row
                if let (Some(row), Some(s)) = (row, s.first_chunk_mut::<#n>()) {
                    *s = row;
                }
            }
        }
    };
    quote! {
        #[inline(always)]
        fn slave<T: runtime::Real>(point: usize, parameters: &[T], s: &mut [T]) {
            #body
        }
    }
}

/// `let row: Option<[f64; n]> = …;`
fn slave_rows(e: &FormulatedElement<'_>, geometry: &Geometry, rule: &Rule) -> TokenStream {
    let shape = shape_call(geometry);
    let weights = e.parameters.layout.slave_weights;
    let start = e.parameters.layout.point;
    let p = geometry.coordinates.len();
    match rule {
        Rule::Given => quote! {
            let weights = parameters.get(#weights..).unwrap_or(&[]);
            let row = parameters
                .get(#start..)
                .and_then(|eta| eta.first_chunk::<#p>())
                .map(|eta| #shape(eta, weights).n);
        },
        Rule::Gauss(_) if geometry.is_rational() => quote! {
            let weights = parameters.get(#weights..).unwrap_or(&[]);
            let row = POINTS.get(point).map(|eta| #shape(&eta.map(T::constant), weights).n);
        },
        Rule::Gauss(_) => quote! { let row = ROWS.get(point).map(|row| row.map(T::constant)); },
    }
}
