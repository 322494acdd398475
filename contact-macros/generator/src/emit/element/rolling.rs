//! What are the angles about two curves, and residual and tangent of their moments?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{components, geometry_path, tangential_law_path};
use super::friction_tangent::contact_inputs;
use crate::emit::program::name;
use crate::formulate::FormulatedElement;
use crate::formulate::{RollingPrograms, Routine};
use crate::model::{Master, Reference, Slave};

/// Where the parameters of rolling begin.
pub(super) fn rolling_layout(e: &FormulatedElement<'_>) -> TokenStream {
    let law = e.parameters.layout.rolling;
    let directors = match e.parameters.layout.directors {
        Some(at) => quote! { Some(#at) },
        None => quote! { None },
    };
    quote! { runtime::RollingLayout { law: #law, directors: #directors } }
}

/// The methods of the trait that concern rolling.
pub(super) fn rolling_methods(e: &FormulatedElement<'_>) -> TokenStream {
    let (Some(rolling), Some(declared)) = (e.rolling(), &e.declared.rolling) else {
        return quote! {};
    };
    let layout = rolling_layout(e);
    let law = tangential_law_path(&declared.law);
    let angles = angles_method(e, rolling);
    let force = rolling_force_method(e, rolling);
    let tangent = rolling
        .tangent
        .as_ref()
        .map(|tangent| rolling_tangent_method(e, rolling, tangent));
    let rows = (rolling.tangent.is_some() && rolling.reference == Reference::PrincipalNormal)
        .then(|| third_rows_method(e));
    quote! {
        const ROLLING: Option<runtime::RollingLayout> = Some(#layout);
        #[inline(always)]
        fn rolling_law(
            angle: f64,
            pressure: f64,
            path: f64,
            parameters: &[f64],
            forced: Option<runtime::Status>,
        ) -> Result<(runtime::Status, runtime::Tangential), runtime::Status> {
            let mut moment = runtime::Tangential::default();
            let loading = (pressure, path);
            runtime::return_map::<#law>([angle, 0.0], loading, parameters, forced, &mut moment)
                .map(|status| (status, moment))
        }
        #angles
        #force
        #tangent
        #rows
    }
}

/// Directors of both curves.
fn directors(e: &FormulatedElement<'_>) -> Vec<TokenStream> {
    let at = e.parameters.layout.directors.unwrap_or(usize::MAX - 6);
    (at..at + 6)
        .map(|at| quote! { parameters.get(#at).copied().unwrap_or(0.0) })
        .collect()
}

fn angles_method(e: &FormulatedElement<'_>, rolling: &RollingPrograms) -> TokenStream {
    let mut inputs: Vec<TokenStream> = (0..3usize).map(|k| quote! { gap.n[#k] }).collect();
    inputs.extend((0..2).flat_map(|c| components("b", Some(c), 3)));
    match rolling.reference {
        Reference::PrincipalNormal => {
            inputs.extend(
                [0, 2]
                    .into_iter()
                    .flat_map(|h| components("second", Some(h), 3)),
            );
        }
        Reference::Director => inputs.extend(directors(e)),
    }
    let function = name(&rolling.angle);
    quote! {
        #[inline(always)]
        fn rolling_angles(
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            parameters: &[f64],
        ) -> runtime::RollingAngles {
            let o = friction::#function(&[#(#inputs),*]);
            runtime::RollingAngles {
                angle: [o[0], o[1]], share: [o[2], o[3]], bend: [o[4], o[5]],
            }
        }
    }
}

/// The contact point with third derivatives and directors.
fn rolling_inputs(e: &FormulatedElement<'_>, rolling: &RollingPrograms) -> Vec<TokenStream> {
    let mut inputs = contact_inputs((3, 2, 3));
    for k in 0..4usize {
        inputs.extend((0..3usize).map(|c| quote! { third[#k][#c] }));
    }
    if rolling.reference == Reference::Director {
        inputs.extend(directors(e));
    }
    inputs.extend((0..2usize).map(|c| quote! { rolling.moment[#c] }));
    inputs
}

fn rolling_force_method(e: &FormulatedElement<'_>, rolling: &RollingPrograms) -> TokenStream {
    let function = name(&rolling.residual);
    let inputs = rolling_inputs(e, rolling);
    let explicit = motion(2);
    quote! {
        #[inline(always)]
        fn rolling_force(
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            frame: &runtime::Frame<2>,
            third: &[[f64; 3]; 4],
            rolling: &runtime::Rolling,
            parameters: &[f64],
        ) -> runtime::RollingForce<3, 2> {
            let o = friction::#function(&[#(#inputs),*]);
            runtime::RollingForce { share: [o[0], o[1]], explicit: #explicit }
        }
    }
}

fn rolling_tangent_method(
    e: &FormulatedElement<'_>,
    rolling: &RollingPrograms,
    tangent: &Routine,
) -> TokenStream {
    let function = name(tangent);
    let mut inputs = rolling_inputs(e, rolling);
    for field in [quote! { stiffness }, quote! { by_pressure }] {
        inputs.extend((0..2usize).map(|c| quote! { rolling.#field[#c] }));
    }
    inputs.push(quote! { slope });
    let pairs = |first: usize, count: usize| {
        let pairs = (first..first + count).map(|pair| {
            let (left, right) = (motion(42 * pair), motion(42 * pair + 21));
            quote! { [#left, #right] }
        });
        quote! { [#(#pairs),*] }
    };
    let (symmetric, moment) = (pairs(0, 9), pairs(9, 2));
    quote! {
        #[inline(always)]
        fn rolling_tangent(
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            frame: &runtime::Frame<2>,
            third: &[[f64; 3]; 4],
            (rolling, slope): (&runtime::Rolling, f64),
            parameters: &[f64],
        ) -> runtime::RollingCoefficients<3, 2> {
            let o = friction::#function(&[#(#inputs),*]);
            runtime::RollingCoefficients { symmetric: #symmetric, moment: #moment }
        }
    }
}

fn third_rows_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (Slave::Projected(slave), Master::Shape(master)) = (&e.declared.slave, &e.declared.master)
    else {
        return quote! {};
    };
    let (s, m) = (geometry_path(slave), geometry_path(master));
    let (ns, nm) = (slave.nodes(), master.nodes());
    quote! {
        #[inline(always)]
        fn third_rows(zeta: &[f64; 2], rows: &mut [&mut [f64]; 2]) {
            runtime::curve_to_curve_third::<#s, #m, #ns, #nm>(zeta, rows);
        }
    }
}

/// A form of two curves from consecutive outputs.
fn motion(start: usize) -> TokenStream {
    let vector = |number: usize| {
        let entries = (0..3).map(|k| {
            let index = start + 3 * number + k;
            quote! { o[#index] }
        });
        quote! { [#(#entries),*] }
    };
    let pair = |number: usize| {
        let (first, last) = (vector(number), vector(number + 1));
        quote! { [#first, #last] }
    };
    let (position, turning, bending, third) = (vector(0), pair(1), pair(3), pair(5));
    quote! {
        runtime::Motion {
            position: #position, turning: #turning, bending: #bending, third: #third,
        }
    }
}
