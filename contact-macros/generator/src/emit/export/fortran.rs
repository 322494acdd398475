//! The Fortran 77 symbols of a library: one trailing underscore, everything by address.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// All symbols.
pub fn symbols(prefix: &Ident) -> TokenStream {
    let list = [
        find(prefix),
        info(prefix),
        message(prefix),
        evaluate(prefix),
        project(prefix),
        patch_info(prefix),
        patch_evaluate(prefix),
        batch(prefix),
        scatter_map(prefix, "csr_map", false),
        scatter_map(prefix, "csr_blocks", true),
        history_init(prefix),
        history_transfer(prefix),
        history_augment(prefix),
    ];
    list.into_iter().collect()
}

/// One symbol: name behind the prefix, arguments, call.
fn symbol(prefix: &Ident, name: &str, arguments: TokenStream, call: TokenStream) -> TokenStream {
    let symbol = format_ident!("{}_f77_{}_", prefix, name);
    let docs = format!(
        " `CTE_F77_{}` of the C header for this library.",
        name.to_uppercase()
    );
    quote! {
        #[doc = #docs]
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments)]
        pub unsafe extern "C" fn #symbol(#arguments) {
            // SAFETY: the caller keeps the promises of the C header.
            unsafe { abi::fortran::#call }
        }
    }
}

fn find(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "find",
        quote!(name: *const i32, length: *const i32, element: *mut i32, code: *mut i32),
        quote!(find(&ELEMENTS, name, length, element, code)),
    )
}

fn info(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "info",
        quote!(element: *const i32, nnode: *const i32, sizes: *mut i32, code: *mut i32),
        quote!(info(&ELEMENTS, element, nnode, sizes, code)),
    )
}

fn message(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "message",
        quote!(element: *const i32, code: *const i32, state: *const i32, text: *mut i32,
            size: *const i32, length: *mut i32),
        quote!(message(&ELEMENTS, element, code, state, text, size, length)),
    )
}

/// The fields that an evaluation of an element and of a patch have in common.
fn addresses() -> TokenStream {
    quote! {
        abi::fortran::Addresses {
            request, nnode, x, ldx, u, ldu, parameters, parameter_count, history_accepted, history_trial,
            mapped, map, f_scale, k_scale, f, k, ldk, output, energy, workspace, workspace_size,
        }
    }
}

/// Maps, scales, results, workspace and outcome: the end of the lists of an evaluation and of a patch.
fn results() -> TokenStream {
    quote! {
        mapped: *const i32, map: *const i32, f_scale: *const f64, k_scale: *const f64, f: *mut f64,
        k: *mut f64, ldk: *const i32, output: *mut f64, energy: *mut f64, workspace: *mut f64,
        workspace_size: *const i32, state: *mut i32, code: *mut i32
    }
}

/// Coordinates and parameters.
fn inputs() -> TokenStream {
    quote! {
        x: *const f64, ldx: *const i32, u: *const f64, ldu: *const i32, parameters: *const f64,
        parameter_count: *const i32
    }
}

fn evaluate(prefix: &Ident) -> TokenStream {
    let (inputs, results, addresses) = (inputs(), results(), addresses());
    symbol(
        prefix,
        "evaluate",
        quote!(element: *const i32, request: *const i32, nnode: *const i32, nslave: *const i32, #inputs,
            history_accepted: *const f64, history_trial: *mut f64, slave_row: *const f64, #results),
        quote!(evaluate(&ELEMENTS, element, nslave, slave_row, #addresses, state, code)),
    )
}

fn project(prefix: &Ident) -> TokenStream {
    let inputs = inputs();
    symbol(
        prefix,
        "project",
        quote!(element: *const i32, nnode: *const i32, nslave: *const i32, #inputs,
            slave_row: *const f64, reach: *const f64, result: *mut f64, history: *mut f64,
            state: *mut i32, code: *mut i32),
        quote! {
            project(
                &ELEMENTS,
                element,
                abi::fortran::ProjectAddresses {
                    nnode, nslave, x, ldx, u, ldu, parameters, parameter_count, slave_row, reach, result,
                    history,
                },
                state,
                code,
            )
        },
    )
}

/// The description of a patch.
fn patch() -> (TokenStream, TokenStream) {
    (
        quote!(numbers: *const i32, connectivity: *const i32, reach: *const f64),
        quote!(abi::fortran::PatchAddresses {
            numbers,
            connectivity,
            reach
        }),
    )
}

fn patch_info(prefix: &Ident) -> TokenStream {
    let (arguments, patch) = patch();
    symbol(
        prefix,
        "patch_info",
        quote!(#arguments, sizes: *mut i32, argument: *mut i32, code: *mut i32),
        quote!(patch_info(&ELEMENTS, #patch, sizes, argument, code)),
    )
}

fn patch_evaluate(prefix: &Ident) -> TokenStream {
    let (arguments, patch) = patch();
    let (inputs, results, addresses) = (inputs(), results(), addresses());
    symbol(
        prefix,
        "patch_evaluate",
        quote!(#arguments, request: *const i32, nnode: *const i32, #inputs,
            history_accepted: *const f64, history_trial: *mut f64, #results),
        quote!(patch_evaluate(&ELEMENTS, #patch, #addresses, state, code)),
    )
}

fn batch(prefix: &Ident) -> TokenStream {
    let inputs = inputs();
    symbol(
        prefix,
        "batch",
        quote!(element: *const i32, n: *const i32, request: *const i32, nslave: *const i32,
            global_nodes: *const i32, connectivity: *const i32, #inputs, ldp: *const i32,
            history_accepted: *const f64, history_trial: *mut f64, slave_row: *const f64,
            into: *const i32, f_scale: *const f64, k_scale: *const f64, f: *mut f64, k: *mut f64,
            global_f: *mut f64, csr_values: *mut f64, csr_map: *const i64, output: *mut f64,
            energy: *mut f64, statuses: *mut i32, codes: *mut i32, workspace: *mut f64,
            workspace_size: *const i32, state: *mut i32, code: *mut i32),
        quote! {
            batch(
                &ELEMENTS,
                element,
                abi::fortran::BatchAddresses {
                    n, request, nslave, global_nodes, connectivity, x, ldx, u, ldu, parameters,
                    parameter_count, ldp, history_accepted, history_trial, slave_row, into, f_scale,
                    k_scale, f, k, global_f, csr_values, csr_map, output, energy, status: statuses,
                    code: codes, workspace, workspace_size,
                },
                state,
                code,
            )
        },
    )
}

fn scatter_map(prefix: &Ident, name: &str, by_blocks: bool) -> TokenStream {
    symbol(
        prefix,
        name,
        quote!(element: *const i32, n: *const i32, nslave: *const i32, connectivity: *const i32,
            rows: *const i32, row_start: *const i64, column: *const i32, map: *mut i64,
            code: *mut i32),
        quote! {
            scatter_map(
                &ELEMENTS,
                element,
                abi::fortran::SparseAddresses {
                    n, nslave, connectivity, rows, row_start, column, map,
                },
                #by_blocks,
                code,
            )
        },
    )
}

fn history_init(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "history_init",
        quote!(element: *const i32, history: *mut f64, code: *mut i32),
        quote!(history_init(&ELEMENTS, element, history, code)),
    )
}

fn history_transfer(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "history_transfer",
        quote!(from: *const i32, from_output: *const f64, from_history: *const f64, to: *const i32,
            to_output: *const f64, to_history: *mut f64, argument: *mut i32, code: *mut i32),
        quote! {
            transfer(
                &ELEMENTS,
                abi::fortran::Side { element: from, output: from_output },
                from_history,
                abi::fortran::Side { element: to, output: to_output },
                to_history,
                argument,
                code,
            )
        },
    )
}

fn history_augment(prefix: &Ident) -> TokenStream {
    symbol(
        prefix,
        "history_augment",
        quote!(element: *const i32, trial: *const f64, accepted: *mut f64, argument: *mut i32,
            code: *mut i32),
        quote!(augment(&ELEMENTS, element, trial, accepted, argument, code)),
    )
}
