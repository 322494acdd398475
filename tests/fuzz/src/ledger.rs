//! What a worker has done, in memory that it shares with its parent, so that a crash takes nothing along.

use std::fs::File;
use std::ptr::null_mut;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

use rustix::mm::{MapFlags, ProtFlags, mmap};

/// Functions of the interface; the last stands for the symbols of all elements.
pub const FUNCTIONS: [&str; 39] = [
    "cte_abi_version",
    "cte_api",
    "cte_element_count",
    "cte_element_get",
    "cte_element_find",
    "cte_element_info",
    "cte_element_unknown",
    "cte_element_parameter",
    "cte_element_check_parameters",
    "cte_element_history_init",
    "cte_history_transfer",
    "cte_history_augment",
    "cte_element_project",
    "cte_patch_info",
    "cte_patch_evaluate",
    "cte_element_evaluate",
    "cte_element_batch_workspace",
    "cte_element_evaluate_batch",
    "cte_element_evaluate_batch_threads",
    "cte_csr_map",
    "cte_csr_blocks",
    "cte_code_message",
    "cte_status_message",
    "cte_argument_name",
    "cte_element_message",
    "cte_f77_find_",
    "cte_f77_info_",
    "cte_f77_message_",
    "cte_f77_evaluate_",
    "cte_f77_project_",
    "cte_f77_patch_info_",
    "cte_f77_patch_evaluate_",
    "cte_f77_batch_",
    "cte_f77_csr_map_",
    "cte_f77_csr_blocks_",
    "cte_f77_history_init_",
    "cte_f77_history_transfer_",
    "cte_f77_history_augment_",
    "element symbols",
];

/// The index of a function in [`FUNCTIONS`].
pub const fn function(name: &str) -> usize {
    let mut index = 0;
    while index < FUNCTIONS.len() {
        if same(FUNCTIONS[index].as_bytes(), name.as_bytes()) {
            return index;
        }
        index += 1;
    }
    panic!("no such function")
}

const fn same(a: &[u8], b: &[u8]) -> bool {
    if a.len() != b.len() {
        return false;
    }
    let mut at = 0;
    while at < a.len() {
        if a[at] != b[at] {
            return false;
        }
        at += 1;
    }
    true
}

/// Room for elements.
pub const ELEMENTS: usize = 256;
/// Room for return codes, the least first.
pub const CODES: usize = 16;
/// The code that stands at 0.
pub const LEAST_CODE: i32 = -14;
/// Room for statuses and verdicts.
pub const STATUSES: usize = 16;

/// Counters; all zero at the beginning.
#[repr(C)]
pub struct Ledger {
    /// The call under way, plus one.
    pub current: AtomicU64,
    /// Calls begun, over all workers in a row: what a watchdog looks at.
    pub begun: AtomicU64,
    /// Calls of each function.
    pub calls: [AtomicU64; FUNCTIONS.len()],
    /// Return codes of each function.
    pub codes: [[AtomicU64; CODES]; FUNCTIONS.len()],
    /// Statuses of contact points, elements and contacts.
    pub statuses: [AtomicU64; STATUSES],
    /// Verdicts of global projections.
    pub verdicts: [AtomicU64; STATUSES],
    /// Evaluations of each element that returned 0.
    pub evaluated: [AtomicU64; ELEMENTS],
    /// Those in contact.
    pub contacts: [AtomicU64; ELEMENTS],
    /// Calls in which documented exceptions were raised.
    pub exceptions: AtomicU64,
    /// Processor time of the slowest call of each function \[ns\], and its number.
    pub slowest: [[AtomicU64; 2]; FUNCTIONS.len()],
}

impl Ledger {
    /// Bytes of a file that holds one.
    pub const SIZE: u64 = size_of::<Self>() as u64;

    /// The ledger in a file of [`Self::SIZE`] bytes; it stays.
    pub fn shared(file: &File) -> rustix::io::Result<&'static Self> {
        let protection = ProtFlags::READ | ProtFlags::WRITE;
        // SAFETY: the file has the size; all bit patterns are counters; the mapping is never taken away.
        unsafe {
            let size = Self::SIZE as usize;
            let pointer = mmap(null_mut(), size, protection, MapFlags::SHARED, file, 0)?;
            Ok(&*pointer.cast())
        }
    }

    /// A ledger of one process.
    pub fn alone() -> &'static Self {
        // SAFETY: zero is a counter.
        Box::leak(Box::new(unsafe { std::mem::zeroed() }))
    }

    /// Notes a return code.
    pub fn code(&self, function: usize, code: i32) {
        let at = usize::try_from(code - LEAST_CODE).unwrap_or(0);
        count(&self.codes[function][at.min(CODES - 1)]);
    }

    /// Notes a status.
    pub fn status(&self, status: i32) {
        let at = usize::try_from(status).unwrap_or(STATUSES - 1);
        count(&self.statuses[at.min(STATUSES - 1)]);
    }

    /// Notes the processor time of a call.
    pub fn time(&self, function: usize, nanoseconds: u64) {
        let [slowest, call] = &self.slowest[function];
        if nanoseconds > slowest.load(Relaxed) {
            slowest.store(nanoseconds, Relaxed);
            call.store(self.current.load(Relaxed).saturating_sub(1), Relaxed);
        }
    }
}

/// One more. There is one writer.
pub fn count(counter: &AtomicU64) {
    counter.store(counter.load(Relaxed) + 1, Relaxed);
}
