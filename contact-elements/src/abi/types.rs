//! The structs of `contact_elements.h`, field by field.

use super::versioned::Versioned;

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

// SAFETY: all three are `repr(C)` and begin with `struct_size: u32`.
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

// Sizes on every supported (64-bit) platform; the header's clients rely on them.
#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<Info>() == 88);
    assert!(size_of::<Arguments>() == 224);
    assert!(size_of::<Batch>() == 272);
};
