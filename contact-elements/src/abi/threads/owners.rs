//! Which part of a batch adds to the entries of a node: of the parts at work at one time, the first that has the node.

use core::ptr::NonNull;
use core::sync::atomic::{AtomicUsize, Ordering};

use std::alloc::{Layout, alloc_zeroed, dealloc};

/// A mark for every node: the largest of the parts that have it. Parts that work later have larger marks; of those that
/// work at one time the first has the largest.
pub(super) struct Owners {
    marks: NonNull<AtomicUsize>,
    layout: Layout,
}

// SAFETY: the marks are separate atomic numbers.
unsafe impl Sync for Owners {}

impl Owners {
    /// Zero marks for so many nodes; `None` if there is no memory for them. The memory is zero from the start: a
    /// batch that has few of the nodes does not touch the rest.
    pub(super) fn new(nodes: usize) -> Option<Self> {
        let layout = Layout::array::<AtomicUsize>(nodes.max(1)).ok()?;
        // SAFETY: the size is not zero; zero bytes are valid numbers.
        let marks = NonNull::new(unsafe { alloc_zeroed(layout) })?.cast();
        Some(Self { marks, layout })
    }

    /// Marks nodes as those of a part.
    ///
    /// # Safety
    /// There are so many nodes.
    pub(super) unsafe fn mark(&self, nodes: &[i32], mark: usize) {
        for &node in nodes {
            // SAFETY: promised by the caller.
            let at = unsafe { &*self.first().add(node as usize) };
            if at.load(Ordering::Relaxed) < mark {
                at.fetch_max(mark, Ordering::Relaxed);
            }
        }
    }

    /// The marks.
    pub(super) fn first(&self) -> *const AtomicUsize {
        self.marks.as_ptr()
    }
}

impl Drop for Owners {
    fn drop(&mut self) {
        // SAFETY: allocated with this layout.
        unsafe { dealloc(self.marks.as_ptr().cast(), self.layout) };
    }
}
