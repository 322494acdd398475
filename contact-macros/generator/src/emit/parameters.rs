//! The parameter list of an element as constants.

use proc_macro2::TokenStream;
use quote::quote;

use super::values::{number, option};
use crate::formulate::Parameters;

/// The `Layout` constant.
pub fn layout(parameters: &Parameters) -> TokenStream {
    let layout = &parameters.layout;
    let (r0, geometry) = (layout.r0, layout.geometry);
    let (master, slave, point) = (layout.master_weights, layout.slave_weights, layout.point);
    let (orientation, placement) = (option(layout.orientation), option(layout.placement));
    let (tangential, axis) = (layout.tangential, option(layout.axis));
    let count = parameters.entries.len();
    quote! {
        runtime::Layout {
            tangential: #tangential,
            r0: #r0,
            orientation: #orientation,
            geometry: #geometry,
            master_weights: #master,
            slave_weights: #slave,
            point: #point,
            axis: #axis,
            placement: #placement,
            count: #count,
        }
    }
}

/// The descriptor's list.
pub fn list(parameters: &Parameters) -> TokenStream {
    let entries = parameters.entries.iter().map(|entry| {
        let name = format!("{}\0", entry.name);
        let unit = format!("{}\0", entry.unit);
        let (lower, upper) = (number(entry.lower), number(entry.upper));
        let closed = entry.closed;
        quote! {
            ::contact_elements::Parameter {
                name: #name, unit: #unit, lower: #lower, upper: #upper, closed: #closed,
            }
        }
    });
    quote! { &[#(#entries),*] }
}
