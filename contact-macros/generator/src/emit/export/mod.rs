//! The C symbols of a library of elements: the interface under a prefix, one symbol per element.

mod fortran;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// `PointQuad4` → `point_quad4`: the C name of an element behind its prefix.
pub fn symbol_name(element: &str) -> String {
    let mut name = String::new();
    for (position, letter) in element.chars().enumerate() {
        if letter.is_uppercase() && position > 0 {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

/// The exported functions of the elements in the static `ELEMENTS` of the same module.
pub fn emit_export(prefix: &Ident, elements: &[Ident]) -> TokenStream {
    let functions = interface(prefix);
    let fortran = fortran::symbols(prefix);
    let symbols = elements.iter().map(|element| {
        let name = format_ident!("{}_{}", prefix, symbol_name(&element.to_string()));
        let docs = format!(" Evaluates one `{element}`.");
        quote! {
            #[doc = #docs]
            ///
            /// # Safety
            /// As `cte_element_evaluate` in the C header.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn #name(arguments: *mut abi::Arguments) -> i32 {
                // SAFETY: the caller keeps the promises of the C header.
                unsafe { abi::element_evaluate(#element::DESCRIPTOR, arguments) }
            }
        }
    });
    quote! {
        #[allow(clippy::missing_safety_doc)]
        mod _exported {
            use super::*;
            #[allow(unused_imports)]
            use ::contact_elements::abi;
            #functions
            #fortran
            #(#symbols)*
        }
    }
}

/// One exported function: name behind the prefix, arguments, result, call.
fn exported(
    prefix: &Ident,
    name: &str,
    arguments: TokenStream,
    result: TokenStream,
    call: TokenStream,
) -> TokenStream {
    let symbol = format_ident!("{}_{}", prefix, name);
    let docs = format!(" `cte_{name}` of the C header for this library.");
    quote! {
        #[doc = #docs]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn #symbol(#arguments) -> #result {
            // SAFETY: the caller keeps the promises of the C header.
            #[allow(unused_unsafe)]
            unsafe { #call }
        }
    }
}

/// All functions of the C interface but those of Fortran 77.
fn interface(prefix: &Ident) -> TokenStream {
    let list = [
        questions(prefix),
        pairs(prefix),
        evaluations(prefix),
        messages(prefix),
    ];
    list.into_iter().collect()
}

/// What the elements are.
fn questions(prefix: &Ident) -> TokenStream {
    let f = |name: &str, arguments: TokenStream, result: TokenStream, call: TokenStream| {
        exported(prefix, name, arguments, result, call)
    };
    let list = [
        f("abi_version", quote!(), quote!(u32), quote!(abi::VERSION)),
        f(
            "element_count",
            quote!(),
            quote!(i32),
            quote!(abi::element_count(&ELEMENTS)),
        ),
        f(
            "element_get",
            quote!(index: i32),
            quote!(*const abi::Registered),
            quote!(abi::element_get(&ELEMENTS, index)),
        ),
        f(
            "element_find",
            quote!(name: *const u8, length: i32, index: *mut i32),
            quote!(i32),
            quote!(abi::element_find(&ELEMENTS, name, length, index)),
        ),
        f(
            "element_info",
            quote!(element: *const abi::Registered, nnode: i32, info: *mut abi::Info),
            quote!(i32),
            quote!(abi::element_info(element, nnode, info)),
        ),
        f(
            "element_unknown",
            quote!(element: *const abi::Registered, nnode: i32, index: i32, node: *mut i32, kind: *mut i32),
            quote!(i32),
            quote!(abi::element_unknown(element, nnode, index, node, kind)),
        ),
        f(
            "element_parameter",
            quote!(element: *const abi::Registered, index: i32, name: *mut *const u8,
                unit: *mut *const u8, lower: *mut f64, upper: *mut f64, closed: *mut i32),
            quote!(i32),
            quote!(abi::element_parameter(
                element, index, name, unit, lower, upper, closed
            )),
        ),
        f(
            "element_check_parameters",
            quote!(element: *const abi::Registered, parameters: *const f64, count: i32, index: *mut i32),
            quote!(i32),
            quote!(abi::element_check_parameters(
                element, parameters, count, index
            )),
        ),
    ];
    list.into_iter().collect()
}

/// Histories, projections and patches.
fn pairs(prefix: &Ident) -> TokenStream {
    let f = |name: &str, arguments: TokenStream, result: TokenStream, call: TokenStream| {
        exported(prefix, name, arguments, result, call)
    };
    let list = [
        f(
            "element_history_init",
            quote!(element: *const abi::Registered, history: *mut f64),
            quote!(i32),
            quote!(abi::element_history_init(element, history)),
        ),
        f(
            "history_transfer",
            quote!(from: *const abi::Registered, from_output: *const f64, from_history: *const f64,
                to: *const abi::Registered, to_output: *const f64, to_history: *mut f64,
                argument: *mut i32),
            quote!(i32),
            quote!(abi::history_transfer(
                from,
                from_output,
                from_history,
                to,
                to_output,
                to_history,
                argument
            )),
        ),
        f(
            "history_augment",
            quote!(element: *const abi::Registered, trial: *const f64, accepted: *mut f64,
                argument: *mut i32),
            quote!(i32),
            quote!(abi::history_augment(element, trial, accepted, argument)),
        ),
        f(
            "element_project",
            quote!(element: *const abi::Registered, arguments: *mut abi::Arguments, reach: f64,
                result: *mut abi::Projection, history: *mut f64),
            quote!(i32),
            quote!(abi::element_project(
                element, arguments, reach, result, history
            )),
        ),
        f(
            "patch_info",
            quote!(patch: *const abi::Patch, info: *mut abi::Info, argument: *mut i32),
            quote!(i32),
            quote!(abi::patch_info(patch, info, argument)),
        ),
        f(
            "patch_evaluate",
            quote!(patch: *const abi::Patch, arguments: *mut abi::Arguments),
            quote!(i32),
            quote!(abi::patch_evaluate(patch, arguments)),
        ),
    ];
    list.into_iter().collect()
}

/// One element, many.
fn evaluations(prefix: &Ident) -> TokenStream {
    let f = |name: &str, arguments: TokenStream, result: TokenStream, call: TokenStream| {
        exported(prefix, name, arguments, result, call)
    };
    let list = [
        f(
            "element_evaluate",
            quote!(element: *const abi::Registered, arguments: *mut abi::Arguments),
            quote!(i32),
            quote!(abi::element_evaluate(element, arguments)),
        ),
        f(
            "element_batch_workspace",
            quote!(element: *const abi::Registered, nslave: i32),
            quote!(i64),
            quote!(abi::element_batch_workspace(element, nslave)),
        ),
        f(
            "element_evaluate_batch",
            quote!(element: *const abi::Registered, n: i64, batch: *mut abi::Batch),
            quote!(i32),
            quote!(abi::element_evaluate_batch(element, n, batch)),
        ),
        f(
            "element_evaluate_batch_threads",
            quote!(element: *const abi::Registered, n: i64, batch: *mut abi::Batch, threads: i32),
            quote!(i32),
            quote!(abi::element_evaluate_batch_threads(
                element, n, batch, threads
            )),
        ),
        scatter_map(prefix, "csr_map"),
        scatter_map(prefix, "csr_blocks"),
    ];
    list.into_iter().collect()
}

/// One of the two scatter maps into a sparse matrix.
fn scatter_map(prefix: &Ident, name: &str) -> TokenStream {
    let function = format_ident!("{}", name);
    exported(
        prefix,
        name,
        quote!(element: *const abi::Registered, n: i64, nslave: i32, connectivity: *const i32,
            rows: i64, row_start: *const i64, column: *const i32, map: *mut i64),
        quote!(i32),
        quote!(abi::#function(
            abi::Sparse { element, n, nslave, connectivity, rows, row_start, column },
            map
        )),
    )
}

/// Texts for codes, and the table of all functions.
fn messages(prefix: &Ident) -> TokenStream {
    let f = |name: &str, arguments: TokenStream, result: TokenStream, call: TokenStream| {
        exported(prefix, name, arguments, result, call)
    };
    let table = table(prefix);
    let list = [
        f(
            "code_message",
            quote!(code: i32),
            quote!(*const u8),
            quote!(abi::code_message(code)),
        ),
        f(
            "status_message",
            quote!(status: i32),
            quote!(*const u8),
            quote!(abi::status_message(status)),
        ),
        f(
            "argument_name",
            quote!(argument: i32),
            quote!(*const u8),
            quote!(abi::argument_name(argument)),
        ),
        f(
            "element_message",
            quote!(element: *const abi::Registered, arguments: *const abi::Arguments, code: i32,
                text: *mut u8, size: i32),
            quote!(i32),
            quote!(abi::element_message(element, arguments, code, text, size)),
        ),
        f(
            "api",
            quote!(major: u32, table: *mut abi::ApiTable),
            quote!(i32),
            quote!(abi::api(major, table, #table)),
        ),
    ];
    list.into_iter().collect()
}

/// The function table of this library.
fn table(prefix: &Ident) -> TokenStream {
    let entry = |name: &str| format_ident!("{}_{}", prefix, name);
    let fields = [
        "element_count",
        "element_get",
        "element_find",
        "element_info",
        "element_unknown",
        "element_parameter",
        "element_check_parameters",
        "element_history_init",
        "element_evaluate",
        "element_batch_workspace",
        "element_evaluate_batch",
        "csr_map",
        "code_message",
        "status_message",
        "argument_name",
        "element_message",
        "history_transfer",
        "history_augment",
        "element_project",
        "patch_info",
        "patch_evaluate",
        "element_evaluate_batch_threads",
        "csr_blocks",
    ];
    let names = fields.iter().map(|name| format_ident!("{name}"));
    let values = fields.iter().map(|name| entry(name));
    quote! {
        abi::ApiTable {
            struct_size: ::core::mem::size_of::<abi::ApiTable>() as u32,
            version: abi::VERSION,
            #(#names: #values),*
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn symbols_are_snake_case() {
        assert_eq!(super::symbol_name("PointQuad4"), "point_quad4");
        assert_eq!(super::symbol_name("Line2Line2Beams"), "line2_line2_beams");
    }
}
