//! A batch by several threads, with the bits of one thread.
//!
//! | file | question |
//! |---|---|
//! | `parallel` | which thread evaluates which contacts, and when |
//! | `owners` | who adds to the entries of a node |
//! | `journal` in the parent folder | what is added later, so that every entry gets its contributions in the order of the contacts |
//!
//! All three need the feature `threads`; without it the calling thread evaluates the batch.

#[cfg(feature = "threads")]
mod owners;
#[cfg(feature = "threads")]
mod parallel;

use super::batch::{Work, guarded};
use super::types::Batch;
use crate::codes::{argument, code};
use crate::error::Error;
use crate::evaluation::batch::run::Failures;
use crate::registered::Registered;

#[cfg(feature = "threads")]
use parallel::all;

/// `cte_element_evaluate_batch_threads`.
///
/// # Safety
/// As [`element_evaluate_batch`](super::element_evaluate_batch).
pub unsafe fn element_evaluate_batch_threads(
    element: *const Registered,
    n: i64,
    batch: *mut Batch,
    threads: i32,
) -> i32 {
    let evaluate = |work: &Work<'_>| -> Result<Failures, Error> {
        let threads =
            usize::try_from(threads).map_err(|_| Error::new(code::INDEX, argument::THREADS, 0))?;
        all(work, threads)
    };
    // SAFETY: promised by the caller.
    unsafe { guarded(element, n, batch, evaluate) }
}

/// Evaluates all contacts on this thread.
#[cfg(not(feature = "threads"))]
fn all(work: &Work<'_>, _: usize) -> Result<Failures, Error> {
    work.all(crate::lanes::Width::widest())
}
