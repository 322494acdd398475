//! The table of all functions: `cte_api_table`.

use super::VERSION;
use super::patch::Patch;
use super::project::Projection;
use super::types::{Arguments, Batch, Info};
use crate::codes::code;
use crate::registered::Registered;

/// `cte_api_table`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct ApiTable {
    pub struct_size: u32,
    pub version: u32,
    pub element_count: unsafe extern "C" fn() -> i32,
    pub element_get: unsafe extern "C" fn(i32) -> *const Registered,
    pub element_find: unsafe extern "C" fn(*const u8, i32, *mut i32) -> i32,
    pub element_info: unsafe extern "C" fn(*const Registered, i32, *mut Info) -> i32,
    pub element_unknown:
        unsafe extern "C" fn(*const Registered, i32, i32, *mut i32, *mut i32) -> i32,
    pub element_parameter: unsafe extern "C" fn(
        *const Registered,
        i32,
        *mut *const u8,
        *mut *const u8,
        *mut f64,
        *mut f64,
        *mut i32,
    ) -> i32,
    pub element_check_parameters:
        unsafe extern "C" fn(*const Registered, *const f64, i32, *mut i32) -> i32,
    pub element_history_init: unsafe extern "C" fn(*const Registered, *mut f64) -> i32,
    pub element_evaluate: unsafe extern "C" fn(*const Registered, *mut Arguments) -> i32,
    pub element_batch_workspace: unsafe extern "C" fn(*const Registered, i32) -> i64,
    pub element_evaluate_batch: unsafe extern "C" fn(*const Registered, i64, *mut Batch) -> i32,
    pub csr_map: unsafe extern "C" fn(
        *const Registered,
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
        unsafe extern "C" fn(*const Registered, *const Arguments, i32, *mut u8, i32) -> i32,
    pub history_transfer: unsafe extern "C" fn(
        *const Registered,
        *const f64,
        *const f64,
        *const Registered,
        *const f64,
        *mut f64,
        *mut i32,
    ) -> i32,
    pub history_augment:
        unsafe extern "C" fn(*const Registered, *const f64, *mut f64, *mut i32) -> i32,
    pub element_project: unsafe extern "C" fn(
        *const Registered,
        *mut Arguments,
        f64,
        *mut Projection,
        *mut f64,
    ) -> i32,
    pub patch_info: unsafe extern "C" fn(*const Patch, *mut Info, *mut i32) -> i32,
    pub patch_evaluate: unsafe extern "C" fn(*const Patch, *mut Arguments) -> i32,
    pub element_evaluate_batch_threads:
        unsafe extern "C" fn(*const Registered, i64, *mut Batch, i32) -> i32,
    pub csr_blocks: unsafe extern "C" fn(
        *const Registered,
        i64,
        i32,
        *const i32,
        i64,
        *const i64,
        *const i32,
        *mut i64,
    ) -> i32,
}

#[cfg(target_pointer_width = "64")]
const _: () = assert!(size_of::<ApiTable>() == 192);

/// `cte_api`.
///
/// # Safety
/// `table` points to a struct or is null.
pub unsafe fn api(major: u32, table: *mut ApiTable, own: ApiTable) -> i32 {
    if table.is_null() {
        return code::NULL;
    }
    if major != VERSION >> 16 {
        return code::VERSION;
    }
    // SAFETY: every struct begins with its size.
    if (unsafe { (*table).struct_size } as usize) < size_of::<ApiTable>() {
        return code::STRUCT_SIZE;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    unsafe { *table = own };
    code::SUCCESS
}
