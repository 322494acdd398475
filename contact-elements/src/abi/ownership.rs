//! Who adds to the entries of a node that the contacts of several threads share.

#[cfg(feature = "threads")]
use core::sync::atomic::{AtomicUsize, Ordering};

#[cfg(feature = "threads")]
use super::journal::Journal;
use crate::evaluation::places::Places;

/// Who adds to shared entries: a part at work adds to those of its own nodes.
#[cfg(feature = "threads")]
#[derive(Clone, Copy, Debug)]
pub(super) struct Ownership<'a> {
    journal: *mut Journal<'a>,
    marks: *const AtomicUsize,
    mark: usize,
}

#[cfg(feature = "threads")]
impl<'a> Ownership<'a> {
    /// One thread adds to all of them.
    pub(super) const FREE: Self = Self {
        journal: core::ptr::null_mut(),
        marks: core::ptr::null(),
        mark: 0,
    };

    /// The ownership of a part.
    ///
    /// # Safety
    /// The journal and the marks live as long as this, there is a mark for every node of the batch, and nothing else
    /// refers to the journal.
    pub(super) unsafe fn new(
        journal: *mut Journal<'a>,
        marks: *const AtomicUsize,
        mark: usize,
    ) -> Self {
        Self {
            journal,
            marks,
            mark,
        }
    }

    /// True where no other part is at work.
    #[inline(always)]
    pub(super) fn is_free(&self) -> bool {
        self.journal.is_null()
    }

    /// True where this part adds to the entries of a node of the batch.
    #[inline(always)]
    pub(super) fn is_mine(&self, node: usize) -> bool {
        // SAFETY: promised by the caller of `new`; the nodes of a batch were checked.
        self.is_free() || unsafe { (*self.marks.add(node)).load(Ordering::Relaxed) } == self.mark
    }

    /// Records a contribution to an entry of the host's vector.
    pub(super) fn note_force(&self, node: usize, entry: usize, value: f64) {
        // SAFETY: promised by the caller of `new`; null where all is this part's.
        if let Some(journal) = unsafe { self.journal.as_mut() } {
            journal.note_force(node, entry, value);
        }
    }

    /// Records contributions to a row of the host's sparse matrix: their places, values and scale.
    #[inline(never)]
    pub(super) fn note_row(&self, node: usize, places: Places<'a>, values: &[f64], scale: f64) {
        // SAFETY: promised by the caller of `new`; null where all is this part's.
        if let Some(journal) = unsafe { self.journal.as_mut() } {
            journal.note_row(node, places, values, scale);
        }
    }
}

/// One thread, which adds to all shared entries.
#[cfg(not(feature = "threads"))]
#[derive(Clone, Copy, Debug)]
pub(super) struct Ownership<'a> {
    of: core::marker::PhantomData<&'a ()>,
}

#[cfg(not(feature = "threads"))]
impl<'a> Ownership<'a> {
    pub(super) const FREE: Self = Self {
        of: core::marker::PhantomData,
    };

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
    pub(super) fn note_row(&self, _: usize, _: Places<'a>, _: &[f64], _: f64) {}
}
