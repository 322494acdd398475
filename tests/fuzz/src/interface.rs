//! The interface as a host gets it that loads the shared library: symbols by name, and the table of `cte_api`.

use std::path::Path;

use contact_elements::abi::{ApiTable, Arguments};
use libloading::Library;

use crate::numbers::functions;

/// Every function of the library.
#[derive(Clone)]
pub struct Interface {
    /// `cte_abi_version`.
    pub abi_version: unsafe extern "C" fn() -> u32,
    /// `cte_api`.
    pub api: unsafe extern "C" fn(u32, *mut ApiTable) -> i32,
    /// What `cte_api` gives.
    pub table: ApiTable,
    /// The Fortran 77 set.
    pub fortran: Fortran,
    /// One function per element, in the order of the indices.
    pub symbols: Vec<unsafe extern "C" fn(*mut Arguments) -> i32>,
}

/// Integers that Fortran hands over.
type Integer = *const i32;
/// Integers that it gets back.
type Integers = *mut i32;
/// Doubles that it hands over.
type Real = *const f64;
/// Doubles that it gets back.
type Reals = *mut f64;
/// Long integers that it hands over.
type Long = *const i64;
/// Long integers that it gets back.
type Longs = *mut i64;
/// `cte_f77_csr_map_` and `cte_f77_csr_blocks_`.
type ScatterMap = unsafe extern "C" fn(
    Integer,
    Integer,
    Integer,
    Integer,
    Integer,
    Long,
    Integer,
    Longs,
    Integers,
);

/// `cte_f77_*_`.
#[derive(Clone, Copy)]
#[allow(clippy::type_complexity)]
pub struct Fortran {
    /// `cte_f77_find_`.
    pub find: unsafe extern "C" fn(Integer, Integer, Integers, Integers),
    /// `cte_f77_info_`.
    pub info: unsafe extern "C" fn(Integer, Integer, Integers, Integers),
    /// `cte_f77_message_`.
    pub message: unsafe extern "C" fn(Integer, Integer, Integer, Integers, Integer, Integers),
    /// `cte_f77_evaluate_`.
    pub evaluate: unsafe extern "C" fn(
        Integer,
        Integer,
        Integer,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Reals,
        Real,
        Integer,
        Integer,
        Real,
        Real,
        Reals,
        Reals,
        Integer,
        Reals,
        Reals,
        Reals,
        Integer,
        Integers,
        Integers,
    ),
    /// `cte_f77_project_`.
    pub project: unsafe extern "C" fn(
        Integer,
        Integer,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Real,
        Reals,
        Reals,
        Integers,
        Integers,
    ),
    /// `cte_f77_patch_info_`.
    pub patch_info: unsafe extern "C" fn(Integer, Integer, Real, Integers, Integers, Integers),
    /// `cte_f77_patch_evaluate_`.
    pub patch_evaluate: unsafe extern "C" fn(
        Integer,
        Integer,
        Real,
        Integer,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Reals,
        Integer,
        Integer,
        Real,
        Real,
        Reals,
        Reals,
        Integer,
        Reals,
        Reals,
        Reals,
        Integer,
        Integers,
        Integers,
    ),
    /// `cte_f77_batch_`.
    pub batch: unsafe extern "C" fn(
        Integer,
        Integer,
        Integer,
        Integer,
        Integer,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Real,
        Integer,
        Integer,
        Real,
        Reals,
        Real,
        Integer,
        Real,
        Real,
        Reals,
        Reals,
        Reals,
        Reals,
        Long,
        Reals,
        Reals,
        Integers,
        Integers,
        Reals,
        Integer,
        Integers,
        Integers,
    ),
    /// `cte_f77_csr_map_`.
    pub csr_map: ScatterMap,
    /// `cte_f77_csr_blocks_`.
    pub csr_blocks: ScatterMap,
    /// `cte_f77_history_init_`.
    pub history_init: unsafe extern "C" fn(Integer, Reals, Integers),
    /// `cte_f77_history_transfer_`.
    pub history_transfer:
        unsafe extern "C" fn(Integer, Real, Real, Integer, Real, Reals, Integers, Integers),
    /// `cte_f77_history_augment_`.
    pub history_augment: unsafe extern "C" fn(Integer, Real, Reals, Integers, Integers),
}

impl Interface {
    /// Loads the shared library, which stays.
    pub fn load(path: &Path) -> Result<Self, String> {
        let named = |error: libloading::Error| format!("{}: {error}", path.display());
        // SAFETY: the library has no initialisers.
        let library = unsafe { Library::new(path) }.map_err(named)?;
        let library: &'static Library = Box::leak(Box::new(library));
        for name in functions() {
            // SAFETY: only the address is looked up.
            unsafe { library.get::<*const ()>(&name) }.map_err(named)?;
        }
        // SAFETY: the types are those of the header.
        unsafe {
            let api = *library.get("cte_api").map_err(named)?;
            let table = filled(api)?;
            Ok(Self {
                abi_version: *library.get("cte_abi_version").map_err(named)?,
                api,
                table,
                fortran: Fortran {
                    find: *library.get("cte_f77_find_").map_err(named)?,
                    info: *library.get("cte_f77_info_").map_err(named)?,
                    message: *library.get("cte_f77_message_").map_err(named)?,
                    evaluate: *library.get("cte_f77_evaluate_").map_err(named)?,
                    project: *library.get("cte_f77_project_").map_err(named)?,
                    patch_info: *library.get("cte_f77_patch_info_").map_err(named)?,
                    patch_evaluate: *library.get("cte_f77_patch_evaluate_").map_err(named)?,
                    batch: *library.get("cte_f77_batch_").map_err(named)?,
                    csr_map: *library.get("cte_f77_csr_map_").map_err(named)?,
                    csr_blocks: *library.get("cte_f77_csr_blocks_").map_err(named)?,
                    history_init: *library.get("cte_f77_history_init_").map_err(named)?,
                    history_transfer: *library.get("cte_f77_history_transfer_").map_err(named)?,
                    history_augment: *library.get("cte_f77_history_augment_").map_err(named)?,
                },
                symbols: element_symbols(library).map_err(named)?,
            })
        }
    }
}

/// The table of a library.
///
/// # Safety
/// `api` is `cte_api`.
pub unsafe fn filled(
    api: unsafe extern "C" fn(u32, *mut ApiTable) -> i32,
) -> Result<ApiTable, String> {
    let mut table = std::mem::MaybeUninit::<ApiTable>::uninit();
    // SAFETY: the struct begins with its size; on 0 all of it is filled.
    unsafe {
        let size = size_of::<ApiTable>() as u32;
        table.as_mut_ptr().cast::<u32>().write(size);
        match api(1, table.as_mut_ptr()) {
            0 => Ok(table.assume_init()),
            code => Err(format!("cte_api returns {code}")),
        }
    }
}

/// The function of each element, found by the name that `contact_elements_symbols.h` gives it.
fn element_symbols(
    library: &Library,
) -> Result<Vec<unsafe extern "C" fn(*mut Arguments) -> i32>, libloading::Error> {
    let header = include_str!("../../../contact-elements/include/contact_elements_symbols.h");
    let declared = header.lines().filter_map(|line| {
        let (name, _) = line.strip_prefix("int32_t ")?.split_once('(')?;
        Some(name)
    });
    // SAFETY: the type is that of the header.
    declared
        .map(|name| unsafe { library.get(name).map(|symbol| *symbol) })
        .collect()
}
