//! How is the element evaluated? The constants of its trait implementation and the frame of the methods.

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{law_path, tangential_law_path};
use super::facts::Facts;
use crate::emit::domain;
use crate::linearise::geometry::periods;
use crate::model::{Axis, Body, Enforcement, Gap, Master, Measure, Slave};

impl Facts<'_> {
    pub(super) fn implementation(&self) -> TokenStream {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let law = law_path(&self.element.law);
        let tangential = match &self.element.tangential {
            Some(tangential) => tangential_law_path(&tangential.law),
            None => quote! { runtime::Frictionless },
        };
        let slave_axis = matches!(
            &self.element.tangential,
            Some(tangential) if tangential.axis == Some(Axis::Slave)
        );
        let mut periods = match &self.element.master {
            Master::Rigid { geometry, .. } => periods(geometry),
            _ => vec![],
        };
        periods.resize(2, 0.0);
        let layout = self.parameters.layout();
        let search = self.search();
        let moving = self.kinematics.moving.iter().any(|&moving| moving);
        let signed = self.element.gap == Gap::Signed;
        let current = self.element.measure == Measure::Current;
        let enforcement = self.enforcement();
        let (slave_nodes, master_nodes) = (self.slave_nodes, self.master_nodes);
        let domains = self.domains();
        let two_curves = self.projected_slave();
        let curved = (0..3).map(|h| self.kinematics.curved.get(h).copied().unwrap_or(false));
        let parallel = if two_curves {
            quote! { runtime::Status::NotUnique }
        } else {
            quote! { runtime::Status::Degenerate }
        };
        let methods = [
            self.slave_method(),
            self.kinematics_method(),
            self.projection_method(),
            self.divisors_method(),
            self.gap_method(),
            self.tangent_method(),
            self.measure_method(),
            self.friction_methods(),
            self.angle_methods(),
        ];
        quote! {
            impl runtime::Element<#d, #p, #h> for #name {
                type Law = #law;
                type Tangential = #tangential;
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
                #(#methods)*
            }
        }
    }

    pub(super) fn enforcement(&self) -> TokenStream {
        match self.element.enforcement {
            Enforcement::Penalty => quote! { runtime::Enforcement::Penalty },
            Enforcement::Augmented => quote! { runtime::Enforcement::Augmented },
            Enforcement::Multiplier => quote! { runtime::Enforcement::Multiplier },
        }
    }

    fn search(&self) -> TokenStream {
        let closed = match &self.element.master {
            Master::Point | Master::Distance { .. } => true,
            Master::Rigid { geometry, .. } => {
                !self.projected_slave()
                    && matches!(
                        &geometry.body,
                        Body::Rigid {
                            projection: Some(_),
                            ..
                        }
                    )
            }
            Master::Shape(_) => false,
        };
        if closed {
            quote! { runtime::Search::Closed }
        } else if self.kinematics.curved.iter().all(|&curved| !curved) {
            quote! { runtime::Search::Affine }
        } else {
            quote! { runtime::Search::Newton }
        }
    }

    pub(super) fn domains(&self) -> Vec<TokenStream> {
        let master = match &self.element.master {
            Master::Shape(geometry) | Master::Rigid { geometry, .. } => domain(&geometry.domain),
            _ => quote! { runtime::Domain::Unbounded },
        };
        match &self.element.slave {
            Slave::Projected(geometry) => vec![domain(&geometry.domain), master],
            _ => vec![master, quote! { runtime::Domain::Unbounded }],
        }
    }
}
