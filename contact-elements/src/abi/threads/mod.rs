//! A batch by several threads, with the bits of one thread.
//!
//! | file | question |
//! |---|---|
//! | `parallel` | which thread evaluates which contacts, and when |
//! | `owners` | who adds to the entries of a node |
//! | `journal` | what is added later, so that every entry gets its contributions in the order of the contacts |
//!
//! All three with the feature `threads` alone; without it the calling thread evaluates the batch.

#[cfg(feature = "threads")]
mod journal;
#[cfg(feature = "threads")]
mod owners;
#[cfg(feature = "threads")]
mod parallel;

use super::batch::{Failures, guarded};
use super::batch_check::Checked;
use super::sizes::Fault;
use super::types::Batch;
use super::{Descriptor, argument, code};

#[cfg(not(feature = "threads"))]
use super::places::Places;
#[cfg(feature = "threads")]
pub(super) use journal::Turn;
#[cfg(feature = "threads")]
use parallel::all;

/// `cte_element_evaluate_batch_threads`.
///
/// # Safety
/// As [`element_evaluate_batch`](super::element_evaluate_batch).
pub unsafe fn element_evaluate_batch_threads(
    element: *const Descriptor,
    n: i64,
    batch: *mut Batch,
    threads: i32,
) -> i32 {
    let evaluate = |checked: Checked<'_>| -> Result<Failures, Fault> {
        let threads = usize::try_from(threads).map_err(|_| (code::INDEX, argument::THREADS, 0))?;
        all(checked, threads)
    };
    // SAFETY: promised by the caller.
    unsafe { guarded(element, n, batch, evaluate) }
}

/// Evaluates all contacts on this thread.
#[cfg(not(feature = "threads"))]
fn all(checked: Checked<'_>, _: usize) -> Result<Failures, Fault> {
    super::batch::all(checked, crate::runtime::Width::widest())
}

/// Who adds to shared entries: one thread, to all of them.
#[cfg(not(feature = "threads"))]
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn;

#[cfg(not(feature = "threads"))]
impl Turn {
    pub(super) const FREE: Self = Self;

    #[inline(always)]
    pub(super) fn is_free(&self) -> bool {
        true
    }
    #[inline(always)]
    pub(super) fn is_mine(&self, _: usize) -> bool {
        true
    }
    #[inline(always)]
    pub(super) fn note_force(&self, _: usize, _: usize, _: f64) {}
    #[inline(always)]
    pub(super) fn note_row(&self, _: usize, _: Places, _: (&[f64], f64)) {}
}
