//! Elements as types: the programs of their closed forms, the trait implementation, the descriptor.
//!
//! | file | question |
//! |---|---|
//! | `facts` | what is known before anything is emitted |
//! | `implementation` | how the element is evaluated: constants, search, domains |
//! | `slave` | which shape row the slave has |
//! | `kinematics` | where slave and master are |
//! | `gap`, `tangent`, `measure` | gap, coefficients of the tangent, area of a point |
//! | `friction` | frame, residual and tangent of tangential contact |
//! | `rolling` | angles about two curves and their moments |
//! | `angle` | weight by the angle of two curves, its share of residual and tangent |
//! | `friction_tangent` | that tangent as a call that elements share |
//! | `descriptor` | what the C interface knows |
//! | `description` | what the verification knows |

mod angle;
mod description;
mod descriptor;
mod expressions;
mod facts;
mod friction;
mod friction_tangent;
mod gap;
mod implementation;
mod kinematics;
mod measure;
mod rolling;
mod slave;
mod tangent;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::imports;
use crate::model::Element;
use facts::Facts;
pub use friction::emit_friction;

/// The type of an element with all that belongs to it.
pub fn emit_element(element: &Element) -> TokenStream {
    let facts = Facts::new(element);
    let name = &element.name;
    let docs = &element.docs;
    let module = format_ident!("_element_{}", name.to_string().to_lowercase());
    let functions: TokenStream = facts.functions().collect();
    let divisors = facts.divisors.functions();
    let statics = facts.statics();
    let implementation = facts.implementation();
    let descriptor = facts.descriptor();
    let tables = facts.tables();
    let imports = imports();
    quote! {
        #[doc = #docs]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #[allow(non_snake_case, unused_variables, clippy::all)]
        mod #module {
            use super::*;
            #imports
            #functions
            #divisors
            #statics
            #implementation
            #descriptor
            #tables
        }
    }
}
