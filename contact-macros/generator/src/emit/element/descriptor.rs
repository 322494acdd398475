//! What does the C interface know of the element?

use proc_macro2::TokenStream;
use quote::quote;

use super::angle::angle_offset;
use super::description::master_description;
use super::description::slave_description;
use super::implementation::enforcement;
use crate::emit::parameters;
use crate::formulate::FormulatedElement;
use crate::model::Slave;

pub(super) fn descriptor(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let what = what(e);
    let kernel = kernel(e);
    let (lanes, lanes_kernel) = lanes(e);
    let (screen, screen_kernel) = screen(e);
    quote! {
        #lanes_kernel
        #screen_kernel
        // a function, not a closure: a closure behind a pointer is compiled twice
        fn kernel(
            call: &runtime::Call<'_>,
            nodes: &runtime::Nodes<'_>,
            memory: &mut [f64],
            target: &mut ::contact_elements::Target<'_>,
        ) -> Result<runtime::Summary, runtime::InputError> {
            #kernel
        }
        impl #name {
            /// This element with its kernels.
            pub const DESCRIPTOR: &'static ::contact_elements::Registered = {
                static DESCRIPTOR: ::contact_elements::Registered =
                    ::contact_elements::Registered {
                        descriptor: #what,
                        kernel,
                        lanes: #lanes,
                        screen: #screen,
                    };
                &DESCRIPTOR
            };
        }
    }
}

/// What the element is.
fn what(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let (d, p, h) = e.sizes();
    let q = e.points.len();
    let (slave_nodes, master_nodes) = (e.slave_nodes, e.master_nodes);
    let text = format!("{name}\0");
    let documentation = format!("{}\0", e.declared.docs.trim());
    let parameters = parameters::list(&e.parameters);
    let (friction, rolling) = (e.friction.is_some(), e.rolling().is_some());
    let (symmetric, has_tangent) = (e.is_symmetric(), e.tangent.is_some());
    let (slave, master) = (slave_description(e), master_description(e));
    let layout = parameters::layout(&e.parameters);
    let angle = angle_offset(e);
    let enforcement = enforcement(e);
    let has_multiplier = e.has_multiplier();
    let (operations, formulation) = (e.operations(), e.formulation());
    let interpolated = matches!(e.declared.slave, Slave::Interpolated);
    let flags = e.vector_flags();
    quote! {
        ::contact_elements::Descriptor {
            name: #text,
            documentation: #documentation,
            dimension: #d,
            slave_nodes: #slave_nodes,
            master_nodes: #master_nodes,
            interpolated: #interpolated,
            points: #q,
            projected: #p,
            parameters: #parameters,
            friction: #friction,
            enforcement: #enforcement,
            rolling: #rolling,
            angle: #angle,
            keeps_side: <#name as runtime::Element<#d, #p, #h>>::KEEPS_SIDE,
            symmetric: #symmetric,
            tangent: #has_tangent,
            energy: #has_multiplier
                || <<#name as runtime::Element<#d, #p, #h>>::Law
                    as runtime::NormalLaw>::ENERGY,
            operations: #operations,
            formulation: #formulation,
            vectors: &[#(#flags),*],
            centre: <#name as runtime::Element<#d, #p, #h>>::START,
            slave: #slave,
            master: #master,
            layout: #layout,
            domains: <#name as runtime::Element<#d, #p, #h>>::DOMAINS,
            periods: <#name as runtime::Element<#d, #p, #h>>::PERIODS,
            extents: <#name as runtime::Element<#d, #p, #h>>::EXTENTS,
        }
    }
}

/// The call of the kernel with all sizes of this element filled in.
fn kernel(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let (d, p, h) = e.sizes();
    let q = e.points.len();
    let n = e.slave_nodes + e.master_nodes;
    let padded = (n * d).next_multiple_of(4);
    let vectors = e.vector_flags();
    let interpolated = matches!(e.declared.slave, Slave::Interpolated);
    if interpolated {
        quote! {
            runtime::interpolated::<#name, _, #d, #p, #h>(
                call, nodes, &[#(#vectors),*], memory, target,
            )
        }
    } else {
        quote! {
            runtime::fixed::<#name, _, #d, #p, #h, #n, #q, #padded>(
                call, nodes, &[#(#vectors),*], target,
            )
        }
    }
}

/// The kernel of a batch in lanes, and the function itself.
fn lanes(e: &FormulatedElement<'_>) -> (TokenStream, TokenStream) {
    let name = &e.declared.name;
    let (d, p, h) = e.sizes();
    let n = e.slave_nodes + e.master_nodes;
    if !e.in_lanes() {
        return (quote! { None }, quote! {});
    }
    let vectors = e.vector_flags();
    let function = quote! {
        fn lanes(run: &mut ::contact_elements::Run<'_>, width: runtime::Width) {
            runtime::evaluate_batch::<#name, _, #d, #p, #h, #n>(
                run, width, &[#(#vectors),*],
            )
        }
    };
    (quote! { Some(lanes) }, function)
}

/// What tells open contacts without their projection, where it can, and the function itself.
fn screen(e: &FormulatedElement<'_>) -> (TokenStream, TokenStream) {
    let name = &e.declared.name;
    let (d, p, h) = e.sizes();
    let n = e.slave_nodes + e.master_nodes;
    if !e.can_screen() {
        return (quote! { None }, quote! {});
    }
    let vectors = e.vector_flags();
    let function = quote! {
        fn screen(
            run: &::contact_elements::Run<'_>,
            place: (usize, usize),
            bounds: &mut [f64; runtime::SCREENED],
        ) -> u32 {
            runtime::screen::<#name, _, #d, #p, #h, #n>(
                run, place, &[#(#vectors),*], bounds,
            )
        }
    };
    let value = quote! {
        if runtime::is_screened::<#name, #d, #p, #h, #n>() {
            Some(screen)
        } else {
            None
        }
    };
    (value, function)
}
