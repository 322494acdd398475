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
}

impl Info {
    /// `CTE_INFO_INIT`.
    pub const EMPTY: Self = Self {
        struct_size: size_of::<Self>() as u32,
        dimension: 0,
        nodes_minimum: 0,
        nodes_maximum: 0,
        slave_nodes: 0,
        master_nodes: 0,
        unknowns: 0,
        parameters: 0,
        history: 0,
        points: 0,
        projected: 0,
        requests: 0,
        symmetric: 0,
        operations: 0,
        workspace: 0,
        formulation: 0,
        name: core::ptr::null(),
        documentation: core::ptr::null(),
    };
}

/// `cte_arguments`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Arguments {
    pub struct_size: u32,
    pub request: u32,
    pub nnode: i32,
    pub parameter_count: i32,
    pub x: *const f64,
    pub u: *const f64,
    pub parameters: *const f64,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub f_scale: f64,
    pub k_scale: f64,
    pub k_row_stride: i64,
    pub k_col_stride: i64,
    pub unknown_map: *const i32,
    pub x_node_stride: i64,
    pub u_node_stride: i64,
    pub slave_row: *const f64,
    pub workspace: *mut f64,
    pub workspace_size: i64,
    pub nslave: i32,
    pub padding: i32,
    pub u_old: *const f64,
    pub v: *const f64,
    pub dt: f64,
    pub dt_ratio: f64,
    pub status: i32,
    pub closed_points: i32,
    pub error_argument: i32,
    pub error_index: i32,
}

impl Arguments {
    /// `CTE_ARGUMENTS_INIT`: no array, no request, scales of 1.
    pub const EMPTY: Self = Self {
        struct_size: size_of::<Self>() as u32,
        request: 0,
        nnode: 0,
        parameter_count: 0,
        x: core::ptr::null(),
        u: core::ptr::null(),
        parameters: core::ptr::null(),
        history_accepted: core::ptr::null(),
        history_trial: core::ptr::null_mut(),
        f: core::ptr::null_mut(),
        k: core::ptr::null_mut(),
        output: core::ptr::null_mut(),
        energy: core::ptr::null_mut(),
        f_scale: 1.0,
        k_scale: 1.0,
        k_row_stride: 0,
        k_col_stride: 0,
        unknown_map: core::ptr::null(),
        x_node_stride: 0,
        u_node_stride: 0,
        slave_row: core::ptr::null(),
        workspace: core::ptr::null_mut(),
        workspace_size: 0,
        nslave: 0,
        padding: 0,
        u_old: core::ptr::null(),
        v: core::ptr::null(),
        dt: 0.0,
        dt_ratio: 0.0,
        status: 0,
        closed_points: 0,
        error_argument: 0,
        error_index: 0,
    };
}

/// `cte_batch`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Batch {
    pub struct_size: u32,
    pub request: u32,
    pub parameter_count: i32,
    pub nslave: i32,
    pub x: *const f64,
    pub u: *const f64,
    pub parameters: *const f64,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub status: *mut i32,
    pub code: *mut i32,
    pub connectivity: *const i32,
    pub global_nodes: i64,
    pub global_f: *mut f64,
    pub csr_values: *mut f64,
    pub csr_map: *const i64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub f_scale: f64,
    pub k_scale: f64,
    pub x_element_stride: i64,
    pub x_node_stride: i64,
    pub x_component_stride: i64,
    pub u_element_stride: i64,
    pub u_node_stride: i64,
    pub u_component_stride: i64,
    pub parameter_element_stride: i64,
    pub f_element_stride: i64,
    pub k_element_stride: i64,
    pub slave_row: *const f64,
    pub workspace: *mut f64,
    pub workspace_size: i64,
    pub failed: i64,
    pub error_argument: i32,
    pub error_index: i32,
}

impl Batch {
    /// `CTE_BATCH_INIT`: no array, no request, scales of 1.
    pub const EMPTY: Self = Self {
        struct_size: size_of::<Self>() as u32,
        request: 0,
        parameter_count: 0,
        nslave: 0,
        x: core::ptr::null(),
        u: core::ptr::null(),
        parameters: core::ptr::null(),
        history_accepted: core::ptr::null(),
        history_trial: core::ptr::null_mut(),
        status: core::ptr::null_mut(),
        code: core::ptr::null_mut(),
        connectivity: core::ptr::null(),
        global_nodes: 0,
        global_f: core::ptr::null_mut(),
        csr_values: core::ptr::null_mut(),
        csr_map: core::ptr::null(),
        f: core::ptr::null_mut(),
        k: core::ptr::null_mut(),
        output: core::ptr::null_mut(),
        energy: core::ptr::null_mut(),
        f_scale: 1.0,
        k_scale: 1.0,
        x_element_stride: 0,
        x_node_stride: 0,
        x_component_stride: 0,
        u_element_stride: 0,
        u_node_stride: 0,
        u_component_stride: 0,
        parameter_element_stride: 0,
        f_element_stride: 0,
        k_element_stride: 0,
        slave_row: core::ptr::null(),
        workspace: core::ptr::null_mut(),
        workspace_size: 0,
        failed: 0,
        error_argument: 0,
        error_index: 0,
    };
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

/// A struct whose first field is its size as the caller compiled it.
///
/// # Safety
/// The type is `repr(C)` and begins with a `u32`.
pub(super) unsafe trait Versioned {
    /// Its size in interface 0.1, whose fields stood elsewhere. No later version may have this size.
    const SIZE_IN_0_1: usize;
}

// SAFETY: all four are `repr(C)` and begin with `struct_size: u32`.
unsafe impl Versioned for Info {
    const SIZE_IN_0_1: usize = 152;
}
// SAFETY: as above.
unsafe impl Versioned for Arguments {
    const SIZE_IN_0_1: usize = 312;
}
// SAFETY: as above.
unsafe impl Versioned for Batch {
    const SIZE_IN_0_1: usize = 336;
}
// SAFETY: as above.
unsafe impl Versioned for Patch {
    const SIZE_IN_0_1: usize = 120;
}

/// True where the caller's struct is one of this version or of a later one that begins like it.
///
/// # Safety
/// `object` points to at least the first field of a struct.
pub(super) unsafe fn is_whole<T: Versioned>(object: *const T) -> bool {
    const { assert!(size_of::<T>() != T::SIZE_IN_0_1) };
    // SAFETY: promised by the caller.
    let size = unsafe { *object.cast::<u32>() } as usize;
    size >= size_of::<T>() && size != T::SIZE_IN_0_1
}

// Sizes on every supported (64-bit) platform; the header's clients rely on them.
#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Info>() == 88);
    assert!(size_of::<Arguments>() == 224);
    assert!(size_of::<Batch>() == 272);
    assert!(size_of::<Patch>() == 56);
    assert!(size_of::<Projection>() == 48);
    assert!(size_of::<ApiTable>() == 192);
};
