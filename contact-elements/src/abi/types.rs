//! The structs of `contact_elements.h`, field by field.

use super::{Descriptor, Patch, Projection};

/// `cte_info`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Info {
    pub struct_size: u32,
    pub dimension: i32,
    pub nodes_minimum: i32,
    pub nodes_maximum: i32,
    pub slave_nodes: i32,
    pub master_nodes: i32,
    pub unknowns: i32,
    pub parameters: i32,
    pub history: i32,
    pub points: i32,
    pub projected: i32,
    pub requests: u32,
    pub symmetric: i32,
    pub operations: i32,
    pub workspace: i64,
    pub formulation: u64,
    pub name: *const u8,
    pub documentation: *const u8,
    pub reserved: [u64; 8],
}

/// `cte_arguments`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Arguments {
    pub struct_size: u32,
    pub request: u32,
    pub nnode: i32,
    pub nslave: i32,
    pub element_id: i64,
    pub step: i32,
    pub increment: i32,
    pub iteration: i32,
    pub parameter_count: i32,
    pub t: f64,
    pub dt: f64,
    pub x: *const f64,
    pub u: *const f64,
    pub u_old: *const f64,
    pub v: *const f64,
    pub x_node_stride: i64,
    pub u_node_stride: i64,
    pub parameters: *const f64,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub slave_row: *const f64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub k_row_stride: i64,
    pub k_col_stride: i64,
    pub unknown_map: *const i32,
    pub f_scale: f64,
    pub k_scale: f64,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub workspace: *mut f64,
    pub workspace_size: i64,
    pub dt_ratio: f64,
    pub status: i32,
    pub closed_points: i32,
    pub error_argument: i32,
    pub error_index: i32,
    pub reserved: [u64; 8],
}

/// `cte_batch`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Batch {
    pub struct_size: u32,
    pub request: u32,
    pub nslave: i32,
    pub parameter_count: i32,
    pub x: *const f64,
    pub u: *const f64,
    pub x_element_stride: i64,
    pub x_node_stride: i64,
    pub x_component_stride: i64,
    pub u_element_stride: i64,
    pub u_node_stride: i64,
    pub u_component_stride: i64,
    pub connectivity: *const i32,
    pub global_nodes: i64,
    pub parameters: *const f64,
    pub parameter_element_stride: i64,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub slave_row: *const f64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub f_element_stride: i64,
    pub k_element_stride: i64,
    pub global_f: *mut f64,
    pub csr_values: *mut f64,
    pub csr_map: *const i64,
    pub f_scale: f64,
    pub k_scale: f64,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub status: *mut i32,
    pub code: *mut i32,
    pub workspace: *mut f64,
    pub workspace_size: i64,
    pub failed: i64,
    pub error_argument: i32,
    pub error_index: i32,
    pub reserved: [u64; 8],
}

/// `cte_api_table`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct ApiTable {
    pub struct_size: u32,
    pub version: u32,
    pub element_count: unsafe extern "C" fn() -> i32,
    pub element_get: unsafe extern "C" fn(i32) -> *const Descriptor,
    pub element_find: unsafe extern "C" fn(*const u8, i32, *mut i32) -> i32,
    pub element_info: unsafe extern "C" fn(*const Descriptor, i32, *mut Info) -> i32,
    pub element_unknown:
        unsafe extern "C" fn(*const Descriptor, i32, i32, *mut i32, *mut i32) -> i32,
    pub element_parameter: unsafe extern "C" fn(
        *const Descriptor,
        i32,
        *mut *const u8,
        *mut *const u8,
        *mut f64,
        *mut f64,
        *mut i32,
    ) -> i32,
    pub element_check_parameters:
        unsafe extern "C" fn(*const Descriptor, *const f64, i32, *mut i32) -> i32,
    pub element_history_init: unsafe extern "C" fn(*const Descriptor, *mut f64) -> i32,
    pub element_evaluate: unsafe extern "C" fn(*const Descriptor, *mut Arguments) -> i32,
    pub element_batch_workspace: unsafe extern "C" fn(*const Descriptor, i32) -> i64,
    pub element_evaluate_batch: unsafe extern "C" fn(*const Descriptor, i64, *mut Batch) -> i32,
    pub csr_map: unsafe extern "C" fn(
        *const Descriptor,
        i64,
        i32,
        *const i32,
        i64,
        *const i64,
        *const i32,
        *mut i64,
    ) -> i32,
    pub code_message: unsafe extern "C" fn(i32) -> *const u8,
    pub status_message: unsafe extern "C" fn(i32) -> *const u8,
    pub argument_name: unsafe extern "C" fn(i32) -> *const u8,
    pub element_message:
        unsafe extern "C" fn(*const Descriptor, *const Arguments, i32, *mut u8, i32) -> i32,
    pub history_transfer: unsafe extern "C" fn(
        *const Descriptor,
        *const f64,
        *const f64,
        *const Descriptor,
        *const f64,
        *mut f64,
        *mut i32,
    ) -> i32,
    pub history_augment:
        unsafe extern "C" fn(*const Descriptor, *const f64, *mut f64, *mut i32) -> i32,
    pub element_project: unsafe extern "C" fn(
        *const Descriptor,
        *mut Arguments,
        f64,
        *mut Projection,
        *mut f64,
    ) -> i32,
    pub patch_info: unsafe extern "C" fn(*const Patch, *mut Info, *mut i32) -> i32,
    pub patch_evaluate: unsafe extern "C" fn(*const Patch, *mut Arguments) -> i32,
    pub element_evaluate_batch_threads:
        unsafe extern "C" fn(*const Descriptor, i64, *mut Batch, i32) -> i32,
    pub csr_blocks: unsafe extern "C" fn(
        *const Descriptor,
        i64,
        i32,
        *const i32,
        i64,
        *const i64,
        *const i32,
        *mut i64,
    ) -> i32,
}

/// True where the caller's struct is at least as large as `T`.
///
/// # Safety
/// `size` points to the first field of a struct, its size as the caller compiled it.
pub(super) unsafe fn is_whole<T>(size: *const u32) -> bool {
    // SAFETY: promised by the caller.
    (unsafe { *size }) as usize >= size_of::<T>()
}

// Sizes on every supported (64-bit) platform; the header's clients rely on them.
#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Info>() == 152);
    assert!(size_of::<Arguments>() == 312);
    assert!(size_of::<Batch>() == 336);
    assert!(size_of::<Projection>() == 48);
    assert!(size_of::<ApiTable>() == 192);
};
