//! Where are slave and master, and how do they move with the projected parameters?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::geometry_path;
use crate::formulate::FormulatedElement;
use crate::model::{Geometry, Master, Slave};

pub(super) fn kinematics_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let master_weights = e.parameters.layout.master_weights;
    let at = e.parameters.layout.geometry;
    let body = match (&e.declared.slave, &e.declared.master) {
        (Slave::Projected(slave), Master::Shape(master)) => curve_to_curve(e, slave, master),
        (Slave::Projected(slave), Master::Rigid { geometry, .. }) => {
            curve_to_rigid(e, slave, geometry)
        }
        (_, Master::Shape(master)) => {
            let (m, nm) = (geometry_path(master), master.nodes());
            quote! {
                let weights = parameters.get(#master_weights..).unwrap_or(&[]);
                runtime::onto_shape::<#m, #d, #p, #h, #nm, T>(x, zeta, weights, rows)
            }
        }
        (_, Master::Rigid { geometry, .. }) => {
            let m = geometry_path(geometry);
            quote! {
                let own = parameters.get(#at..).unwrap_or(&[]);
                runtime::onto_rigid::<#m, #d, #p, #h, T>(x, zeta, own, rows)
            }
        }
        (_, Master::Point) => quote! { runtime::onto_point(x, rows) },
        (_, Master::Distance { .. }) => quote! {
            runtime::Vectors {
                r: runtime::slave_point(x, rows.s, 0),
                ..runtime::Vectors::default()
            }
        },
    };
    quote! {
        #[inline(always)]
        fn kinematics<T: runtime::Real>(
            x: &[[T; #d]],
            zeta: &[T; #p],
            parameters: &[T],
            rows: &mut runtime::Rows<'_, #p, T>,
        ) -> runtime::Vectors<#d, #p, #h, T> {
            #body
        }
    }
}

fn curve_to_curve(e: &FormulatedElement<'_>, slave: &Geometry, master: &Geometry) -> TokenStream {
    let d = e.declared.dimension;
    let master_weights = e.parameters.layout.master_weights;
    let slave_weights = e.parameters.layout.slave_weights;
    let (s, m) = (geometry_path(slave), geometry_path(master));
    let (ns, nm) = (slave.nodes(), master.nodes());
    quote! {
        let weights = (
            parameters.get(#slave_weights..).unwrap_or(&[]),
            parameters.get(#master_weights..).unwrap_or(&[]),
        );
        runtime::curve_to_curve::<#s, #m, #d, #ns, #nm, T>(x, zeta, weights, rows)
    }
}

fn curve_to_rigid(e: &FormulatedElement<'_>, slave: &Geometry, geometry: &Geometry) -> TokenStream {
    let d = e.declared.dimension;
    let slave_weights = e.parameters.layout.slave_weights;
    let at = e.parameters.layout.geometry;
    let (s, m) = (geometry_path(slave), geometry_path(geometry));
    let ns = slave.nodes();
    quote! {
        let data = (
            parameters.get(#slave_weights..).unwrap_or(&[]),
            parameters.get(#at..).unwrap_or(&[]),
        );
        runtime::curve_to_rigid::<#s, #m, #d, #ns, T>(x, zeta, data, rows)
    }
}

pub(super) fn projection_method(e: &FormulatedElement<'_>) -> TokenStream {
    let (d, p, h) = e.sizes();
    let at = e.parameters.layout.geometry;
    let body = match &e.declared.master {
        Master::Rigid { geometry, .. } if !e.projected_slave() => {
            let path = geometry_path(geometry);
            quote! {
                let own = parameters.get(#at..).unwrap_or(&[]);
                <#path as runtime::Rigid<#d, #p, #h>>::projection(x, own).unwrap_or([0.0; #p])
            }
        }
        _ => quote! { [0.0; #p] },
    };
    quote! {
        #[inline(always)]
        fn closed_projection(x: &[f64; #d], parameters: &[f64]) -> [f64; #p] {
            #body
        }
    }
}
