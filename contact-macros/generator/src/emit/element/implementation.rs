//! How is the element evaluated? The constants of its trait implementation and the frame of the methods.

use proc_macro2::TokenStream;
use quote::quote;

use super::angle::angle_methods;
use super::expressions::{law_path, tangential_law_path};
use super::friction::friction_methods;
use super::gap::divisors_method;
use super::gap::gap_method;
use super::kinematics::kinematics_method;
use super::kinematics::projection_method;
use super::measure::measure_method;
use super::slave::slave_method;
use super::tangent::tangent_method;
use crate::emit::parameters;
use crate::emit::values::domain;
use crate::formulate::{FormulatedElement, ProjectionMethod};
use crate::model::{Axis, Enforcement, Gap, Measure};

pub(super) fn implementation(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let (d, p, h) = e.sizes();
    let law = law_path(&e.declared.law);
    let tangential = match &e.declared.tangential {
        Some(tangential) => tangential_law_path(&tangential.law),
        None => quote! { runtime::Frictionless },
    };
    let constants = constants(e);
    let methods = [
        slave_method(e),
        kinematics_method(e),
        projection_method(e),
        divisors_method(e),
        gap_method(e),
        tangent_method(e),
        measure_method(e),
        friction_methods(e),
        angle_methods(e),
    ];
    quote! {
        impl runtime::Element<#d, #p, #h> for #name {
            type Law = #law;
            type Tangential = #tangential;
            #constants
            #(#methods)*
        }
    }
}

fn constants(e: &FormulatedElement<'_>) -> TokenStream {
    let axis = e.declared.tangential.as_ref().and_then(|own| own.axis);
    let slave_axis = axis == Some(Axis::Slave);
    let periods = e.periods();
    let layout = parameters::layout(&e.parameters);
    let search = search(e);
    let moving = e.kinematics.moving.contains(&true);
    let signed = e.declared.gap == Gap::Signed;
    let current = e.declared.measure == Measure::Current;
    let enforcement = enforcement(e);
    let (slave_nodes, master_nodes) = (e.slave_nodes, e.master_nodes);
    let domains = e.domains();
    let domains = domains.iter().map(domain);
    let two_curves = e.projected_slave();
    let curved = (0..3).map(|h| e.kinematics.curved.get(h).copied().unwrap_or(false));
    let parallel = if two_curves {
        quote! { runtime::Status::NotUnique }
    } else {
        quote! { runtime::Status::Degenerate }
    };
    quote! {
        const LAYOUT: runtime::Layout = #layout;
        const SEARCH: runtime::Search = #search;
        const MOVING: bool = #moving;
        const CURVED: [bool; 3] = [#(#curved),*];
        const SIGNED: bool = #signed;
        const CURRENT: bool = #current;
        const ENFORCEMENT: runtime::Enforcement = #enforcement;
        const SLAVE_NODES: usize = #slave_nodes;
        const MASTER_NODES: usize = #master_nodes;
        const SLAVE_AXIS: bool = #slave_axis;
        const PERIODS: [f64; 2] = [#(#periods),*];
        const DOMAINS: [runtime::Domain; 2] = [#(#domains),*];
        const TWO_CURVES: bool = #two_curves;
        const PARALLEL: runtime::Status = #parallel;
    }
}

pub(super) fn enforcement(e: &FormulatedElement<'_>) -> TokenStream {
    match e.declared.enforcement {
        Enforcement::Penalty => quote! { runtime::Enforcement::Penalty },
        Enforcement::Augmented => quote! { runtime::Enforcement::Augmented },
        Enforcement::Multiplier => quote! { runtime::Enforcement::Multiplier },
    }
}

fn search(e: &FormulatedElement<'_>) -> TokenStream {
    match e.projection_method() {
        ProjectionMethod::Closed => quote! { runtime::Search::Closed },
        ProjectionMethod::Affine => quote! { runtime::Search::Affine },
        ProjectionMethod::Newton => quote! { runtime::Search::Newton },
    }
}
