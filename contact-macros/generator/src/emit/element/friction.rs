//! What are frame, residual and tangent of tangential contact?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{components, geometry_path, matrix, shape_call};
use super::friction_tangent::{contact_inputs, tangent_call, tangent_items};
use super::rolling::rolling_methods;
use crate::emit::program::{name, shared_items};
use crate::emit::values::imports;
use crate::formulate::{FormulatedElement, FrictionPrograms};
use crate::model::{Axis, Geometry, Master, Rule, Slave};

/// The module of the programs of tangential contact. Elements with the same number of parameters and the same
/// vanishing terms share them: the tangent is compiled once, as a call from values to values.
pub fn emit_friction(elements: &[FormulatedElement<'_>]) -> TokenStream {
    let mut seen = std::collections::BTreeSet::new();
    let mut items = TokenStream::new();
    for element in elements {
        let friction = element.friction.iter();
        for routine in friction.flat_map(FrictionPrograms::routines) {
            if seen.insert(routine.function.clone()) {
                items.extend(shared_items(routine));
            }
        }
        if let Some(call) = element.friction.as_ref().and_then(tangent_call)
            && seen.insert(call.to_string())
        {
            items.extend(tangent_items(element));
        }
    }
    if seen.is_empty() {
        return items;
    }
    let imports = imports();
    quote! {
        #[allow(non_snake_case, non_upper_case_globals, unused_variables, clippy::all)]
        mod friction {
            #imports
            #items
        }
    }
}

/// The methods of the trait that only tangential contact has.
pub(super) fn friction_methods(e: &FormulatedElement<'_>) -> TokenStream {
    let Some(friction) = &e.friction else {
        return quote! {};
    };
    let frame = frame_method(e, friction);
    let force = force_method(e, friction);
    let (higher, tangent) = match &friction.tangent {
        Some(_) => (higher_method(e), tangential_method(e, friction)),
        None if friction.rolling.is_some() => (higher_method(e), quote! {}),
        None => (quote! {}, quote! {}),
    };
    let rolling = rolling_methods(e);
    let direction = (friction.axis == Some(Axis::Slave)).then(|| direction_method(e));
    quote! { #frame #force #higher #tangent #direction #rolling }
}

/// Factor of δζ̂^q: t_q, with rolling also the share of the moments.
fn effective_force(e: &FormulatedElement<'_>, friction: &FrictionPrograms) -> Vec<TokenStream> {
    let (_, p, _) = e.sizes();
    let field = match friction.rolling {
        Some(_) => quote! { force },
        None => quote! { t },
    };
    (0..p).map(|q| quote! { tangential.#field[#q] }).collect()
}

/// `slave_tangent`: the slave curve's own tangent, where it is an axis.
fn slave_tangent(e: &FormulatedElement<'_>, friction: &FrictionPrograms) -> Option<TokenStream> {
    let needed = friction.axis == Some(Axis::Slave);
    needed.then(|| fixed_tangent(e)).flatten()
}

/// `slave_tangent`: the tangent of a slave curve at an integration point.
pub(super) fn fixed_tangent(e: &FormulatedElement<'_>) -> Option<TokenStream> {
    let Slave::Integrated { geometry, rule } = &e.declared.slave else {
        return None;
    };
    let (d, n) = (e.declared.dimension, geometry.nodes());
    let slopes = slave_slopes(e, geometry, rule);
    Some(quote! {
        let slopes: Option<[[f64; #n]; 1]> = #slopes;
        let slave_tangent =
            runtime::slave_tangents::<#d, 1, #n>(&slopes.unwrap_or([[0.0; #n]; 1]), x)[0];
    })
}

/// N_A,1 of the slave curve at an integration point.
fn slave_slopes(e: &FormulatedElement<'_>, geometry: &Geometry, rule: &Rule) -> TokenStream {
    let shape = shape_call(geometry);
    let weights = e.parameters.layout.slave_weights;
    let start = e.parameters.layout.point;
    let weights = quote! { parameters.get(#weights..).unwrap_or(&[]) };
    match rule {
        Rule::Given => quote! {
            parameters
                .get(#start..)
                .and_then(|eta| eta.first_chunk::<1>())
                .map(|eta| #shape(eta, #weights).d1)
        },
        Rule::Gauss(_) if geometry.is_rational() => {
            quote! { POINTS.get(point).map(|eta| #shape(eta, #weights).d1) }
        }
        Rule::Gauss(_) => quote! { SLOPES.get(point).copied() },
    }
}

pub(super) fn direction_method(e: &FormulatedElement<'_>) -> TokenStream {
    let Slave::Integrated { geometry, rule } = &e.declared.slave else {
        return quote! {};
    };
    let n = geometry.nodes();
    let slopes = slave_slopes(e, geometry, rule);
    quote! {
        #[inline(always)]
        fn slave_direction(point: usize, parameters: &[f64], row: &mut [f64]) {
            let slopes: Option<[[f64; #n]; 1]> = #slopes;
            if let (Some([slopes]), Some(row)) = (slopes, row.first_chunk_mut::<#n>()) {
                *row = slopes;
            }
        }
    }
}

fn frame_method(e: &FormulatedElement<'_>, friction: &FrictionPrograms) -> TokenStream {
    let (d, p, h) = e.sizes();
    let tangent = slave_tangent(e, friction);
    let mut inputs: Vec<TokenStream> = (0..d).map(|k| quote! { gap.n[#k] }).collect();
    for i in 0..p {
        inputs.extend(components("b", Some(i), d));
    }
    inputs.extend((0..p).map(|i| quote! { moved[#i] }));
    match friction.axis {
        Some(Axis::Convected) => {
            let at = e
                .parameters
                .layout
                .axis
                .unwrap_or(e.parameters.entries.len());
            inputs.extend(
                (at..at + 2).map(|at| quote! { parameters.get(#at).copied().unwrap_or(0.0) }),
            );
        }
        Some(Axis::Slave) => inputs.extend((0..d).map(|k| quote! { slave_tangent[#k] })),
        None => {}
    }
    let slip = (0..p).map(|q| quote! { o[#q] });
    let frame = matrix(p, p, p);
    let share = p + p * p;
    let function = name(&friction.frame);
    quote! {
        #[inline(always)]
        fn frame(
            point: usize,
            x: &[[f64; #d]],
            vectors: &runtime::Vectors<#d, #p, #h>,
            gap: &runtime::Gap<#d>,
            moved: &[f64; #p],
            parameters: &[f64],
        ) -> runtime::Frame<#p> {
            #tangent
            let o = friction::#function(&[#(#inputs),*]);
            runtime::Frame { s: [#(#slip),*], e: #frame, share: o[#share] }
        }
    }
}

fn force_method(e: &FormulatedElement<'_>, friction: &FrictionPrograms) -> TokenStream {
    let function = name(&friction.residual);
    let (d, p, h) = e.sizes();
    let mut inputs = contact_inputs((d, p, h));
    inputs.extend(effective_force(e, friction));
    let force = (0..d).map(|k| quote! { o[#k] });
    let turn = (d..d + p).map(|k| quote! { o[#k] });
    quote! {
        #[inline(always)]
        fn tangential_force(
            vectors: &runtime::Vectors<#d, #p, #h>,
            gap: &runtime::Gap<#d>,
            frame: &runtime::Frame<#p>,
            tangential: &runtime::Tangential,
        ) -> runtime::TangentialForce<#d, #p> {
            let o = friction::#function(&[#(#inputs),*]);
            runtime::TangentialForce { force: [#(#force),*], turn: [#(#turn),*] }
        }
    }
}

fn tangential_method(e: &FormulatedElement<'_>, friction: &FrictionPrograms) -> TokenStream {
    let (d, p, h) = e.sizes();
    let slave_tangent = slave_tangent(e, friction);
    let along = slave_tangent.is_some().then(|| quote! { , &slave_tangent });
    let call = tangent_call(friction);
    let (method, result) = if friction.merges_with_normal {
        (quote! { joined_tangent }, quote! { [[f64; #d]; #d] })
    } else {
        let result = quote! { runtime::TangentialCoefficients<#d, #p, #h> };
        (quote! { tangential_tangent }, result)
    };
    quote! {
        #[inline(always)]
        fn #method(
            (point, x): (usize, &[[f64; #d]]),
            vectors: &runtime::Vectors<#d, #p, #h>,
            gap: &runtime::Gap<#d>,
            frame: &runtime::Frame<#p>,
            third: &[[f64; #d]; 4],
            (tangential, slope): (&runtime::Tangential, f64),
            parameters: &[f64],
        ) -> #result {
            #slave_tangent
            friction::#call(vectors, gap, frame, third, (tangential, slope) #along)
        }
    }
}

pub(super) fn higher_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let master_weights = e.parameters.layout.master_weights;
    let slave_weights = e.parameters.layout.slave_weights;
    let at = e.parameters.layout.geometry;
    let weights = |at: usize| quote! { parameters.get(#at..).unwrap_or(&[]) };
    let (own, of_master, of_slave) = (weights(at), weights(master_weights), weights(slave_weights));
    let body = match (&e.declared.slave, &e.declared.master) {
        (Slave::Projected(slave), Master::Shape(master)) => {
            let (s, m) = (geometry_path(slave), geometry_path(master));
            let (ns, nm) = (slave.nodes(), master.nodes());
            quote! {
                runtime::curve_to_curve_higher::<#s, #m, #d, #ns, #nm>(
                    x, zeta, (#of_slave, #of_master), second,
                )
            }
        }
        (Slave::Projected(slave), Master::Rigid { geometry, .. }) => {
            let (s, m, ns) = (geometry_path(slave), geometry_path(geometry), slave.nodes());
            quote! {
                runtime::curve_to_rigid_higher::<#s, #m, #d, #ns>(
                    x, zeta, (#of_slave, #own), second,
                )
            }
        }
        (_, Master::Shape(master)) => {
            let (m, nm) = (geometry_path(master), master.nodes());
            quote! {
                runtime::onto_shape_higher::<#m, #d, #p, #h, #nm>(x, zeta, #of_master, second)
            }
        }
        (_, Master::Rigid { geometry, .. }) => {
            let m = geometry_path(geometry);
            quote! { runtime::onto_rigid_higher::<#m, #d, #p, #h>(zeta, #own) }
        }
        (_, Master::Point | Master::Distance { .. }) => quote! { [[0.0; #d]; 4] },
    };
    quote! {
        #[inline(always)]
        fn higher(
            x: &[[f64; #d]],
            zeta: &[f64; #p],
            parameters: &[f64],
            second: &mut [&mut [f64]; #h],
        ) -> [[f64; #d]; 4] {
            #body
        }
    }
}
