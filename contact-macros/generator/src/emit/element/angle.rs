//! How do the weight by the angle of two curves and its share of residual and tangent get into the element?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::components;
use super::friction::direction_method;
use super::friction::fixed_tangent;
use super::friction::higher_method;
use crate::emit::program::{optional_table, table};
use crate::formulate::{FormulatedElement, MOST_PAIRS};
use crate::model::Angle;

/// Where the window of angles stands in the parameters.
pub(super) fn angle_offset(e: &FormulatedElement<'_>) -> TokenStream {
    match e.parameters.layout.angle {
        Some(at) => quote! { Some(#at) },
        None => quote! { None },
    }
}

/// The methods of the trait that concern the angle.
pub(super) fn angle_methods(e: &FormulatedElement<'_>) -> TokenStream {
    let Some(angle) = &e.angle else {
        return quote! {};
    };
    let tangents = tangents_method(e);
    let weight = weight_methods(e);
    let force = angle_force_method(e);
    let tangent = angle.tangent.as_ref().map(|_| {
        let higher = higher_method(e);
        let tangent = angle_tangent_method(e, angle.pairs);
        quote! { #higher #tangent }
    });
    let direction = (!e.projected_slave()).then(|| direction_method(e));
    quote! {
        const ANGLE: bool = true;
        #tangents
        #weight
        #force
        #tangent
        #direction
    }
}

fn tangents_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (_, p, h) = e.sizes();
    let (body, first) = match fixed_tangent(e) {
        Some(tangent) => (tangent, quote! { slave_tangent }),
        None => (quote! {}, quote! { vectors.b[0] }),
    };
    let last = p - 1;
    quote! {
        #[inline(always)]
        fn curve_tangents(
            point: usize,
            x: &[[f64; 3]],
            vectors: &runtime::Vectors<3, #p, #h>,
            parameters: &[f64],
        ) -> [[f64; 3]; 2] {
            #body
            [#first, vectors.b[#last]]
        }
    }
}

fn weight_methods(e: &FormulatedElement<'_>) -> TokenStream {
    let at = e.parameters.layout.angle.unwrap_or(usize::MAX - 2);
    let next = at + 1;
    quote! {
        #[inline(always)]
        fn angle_position(tangents: &[[f64; 3]; 2], parameters: &[f64]) -> [f64; 2] {
            let [u, v] = tangents;
            let low = parameters.get(#at).copied().unwrap_or(0.0);
            let high = parameters.get(#next).copied().unwrap_or(0.0);
            angle_position(&[u[0], u[1], u[2], v[0], v[1], v[2], low, high])
        }
        #[inline(always)]
        fn angle_weight(position: [f64; 2]) -> [f64; 3] {
            angle_weight(&position)
        }
    }
}

/// n, L, u, v, r_,cc of the projected curves.
fn angle_inputs(e: &FormulatedElement<'_>) -> Vec<TokenStream> {
    let (_, _, h) = e.sizes();
    let mut inputs: Vec<TokenStream> = (0..3usize).map(|k| quote! { gap.n[#k] }).collect();
    inputs.push(quote! { gap.distance });
    inputs.extend((0..2usize).flat_map(|c| (0..3usize).map(move |k| quote! { tangents[#c][#k] })));
    // 11 and 22 of two curves, the only one of the master else
    let second = if h == 3 { vec![0, 2] } else { vec![0] };
    inputs.extend(
        second
            .into_iter()
            .flat_map(|h| components("second", Some(h), 3)),
    );
    inputs
}

fn angle_force_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (_, p, h) = e.sizes();
    let mut inputs = angle_inputs(e);
    inputs.extend([quote! { blend.slope }, quote! { blend.energy }]);
    let form = form(0);
    quote! {
        #[inline(always)]
        fn angle_force(
            tangents: &[[f64; 3]; 2],
            vectors: &runtime::Vectors<3, #p, #h>,
            gap: &runtime::Gap<3>,
            blend: &runtime::Blend,
        ) -> runtime::AngleForm<3> {
            let o = angle_residual(&[#(#inputs),*]);
            #form
        }
    }
}

fn angle_tangent_method(e: &FormulatedElement<'_>, pairs: usize) -> TokenStream {
    let (_, p, h) = e.sizes();
    let mut inputs = angle_inputs(e);
    let third = if p == 2 { vec![0usize, 3] } else { vec![0] };
    inputs.extend(
        third
            .into_iter()
            .flat_map(|h| (0..3usize).map(move |k| quote! { third[#h][#k] })),
    );
    let fields = ["slope", "energy", "curvature", "traction"];
    inputs.extend(fields.map(|field| {
        let field = quote::format_ident!("{field}");
        quote! { blend.#field }
    }));
    let forms = (0..pairs).map(|pair| {
        let (left, right) = (form(30 * pair), form(30 * pair + 15));
        quote! { [#left, #right] }
    });
    let padding = (pairs..MOST_PAIRS).map(|_| quote! { [runtime::AngleForm::default(); 2] });
    quote! {
        #[inline(never)]
        fn angle_tangent(
            tangents: &[[f64; 3]; 2],
            vectors: &runtime::Vectors<3, #p, #h>,
            gap: &runtime::Gap<3>,
            third: &[[f64; 3]; 4],
            blend: &runtime::Blend,
        ) -> runtime::AngleCoefficients<3> {
            let o = angle_tangent(&[#(#inputs),*]);
            runtime::AngleCoefficients([#(#forms,)* #(#padding),*])
        }
    }
}

pub(super) fn angle_description(e: &FormulatedElement<'_>) -> TokenStream {
    let (Some(angle), Some(at)) = (&e.angle, e.parameters.layout.angle) else {
        return quote! { None };
    };
    let small = angle.acts_at == Angle::Small;
    let [position, weight, residual] = [&angle.position, &angle.weight, &angle.residual].map(table);
    let tangent = optional_table(angle.tangent.as_ref());
    quote! {
        Some(&AngleDescription {
            small: #small,
            window: #at,
            position: #position,
            weight: #weight,
            residual: #residual,
            tangent: #tangent,
        })
    }
}

/// A form of the output array `o` from `start` on.
fn form(start: usize) -> TokenStream {
    let vector = |number: usize| {
        let entries = (0..3usize).map(|k| {
            let index = start + 3 * number + k;
            quote! { o[#index] }
        });
        quote! { [#(#entries),*] }
    };
    let (position, slave, master) = (vector(0), vector(1), vector(2));
    let (slave_bend, master_bend) = (vector(3), vector(4));
    quote! {
        runtime::AngleForm {
            position: #position,
            turning: [#slave, #master],
            bending: [#slave_bend, #master_bend],
        }
    }
}
