//! Elements as types: the programs of their closed forms, the trait implementation, the descriptor.
//!
//! | file | question |
//! |---|---|
//! | `header` | how the emitted source introduces itself |
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
mod friction;
mod friction_tangent;
mod gap;
mod header;
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

use super::program::{function, guarded_function};
use super::values::imports;
use crate::formulate::{AnglePrograms, FormulatedElement};
use description::tables;
use descriptor::descriptor;
pub use friction::emit_friction;
use header::header;
use implementation::implementation;
use slave::statics;

/// The type of an element with all that belongs to it.
pub fn emit_element(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let docs = &e.declared.docs;
    let module = format_ident!("_element_{}", name.to_string().to_lowercase());
    let header = header(e);
    let functions = functions(e);
    let statics = statics(e);
    let implementation = implementation(e);
    let descriptor = descriptor(e);
    let tables = tables(e);
    let imports = imports();
    quote! {
        #[doc = #docs]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #(#[doc = #header])*
        #[allow(non_snake_case, unused_variables, clippy::all)]
        mod #module {
            use super::*;
            #imports
            #functions
            #statics
            #implementation
            #descriptor
            #tables
        }
    }
}

/// The functions of the element's own programs; those of friction are shared.
fn functions(e: &FormulatedElement<'_>) -> TokenStream {
    let angle = e.angle.iter().flat_map(AnglePrograms::routines);
    let guarded = angle.chain(e.divisors.routines()).map(guarded_function);
    e.own_routines().map(function).chain(guarded).collect()
}
