//! Memory that notices: every array ends at a page that nobody may touch, or begins after one, and what the library may
//! only read it sees through a view that cannot be written.

use std::ffi::c_void;
use std::os::fd::BorrowedFd;
use std::ptr::null_mut;

use rustix::fs::{MemfdFlags, ftruncate, memfd_create};
use rustix::io::Result;
use rustix::mm::{MapFlags, ProtFlags, mmap, mmap_anonymous};

/// Bytes of a slot.
const ROOM: usize = 1 << 22;
/// Bytes beside an array, on the side without a guard page, that must stay as they were.
const MARGIN: usize = 128;
/// What stands there.
const MARGIN_BYTE: u8 = 0xa5;
/// What stands in outputs before a call: a quiet NaN that no arithmetic makes.
pub const CANARY: u64 = 0x7ff8_dead_beef_cafe;

/// Where an array lies in its slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// Its end is the guard page.
    End,
    /// It begins right behind the guard page.
    Start,
}

impl Edge {
    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Edge::End => Edge::Start,
            Edge::Start => Edge::End,
        }
    }
}

/// Pages between guard pages, seen twice: by the harness and by the library. They stay until the process ends.
#[derive(Debug)]
pub struct Slot {
    host: *mut u8,
    read: *const u8,
}

impl Slot {
    /// New pages.
    pub fn new() -> Result<Self> {
        let file = memfd_create("contact-fuzz", MemfdFlags::CLOEXEC)?;
        ftruncate(&file, ROOM as u64)?;
        let file = std::os::fd::AsFd::as_fd(&file);
        Ok(Self {
            host: view(file, ProtFlags::READ | ProtFlags::WRITE)?,
            read: view(file, ProtFlags::READ)?,
        })
    }

    /// Where `bytes` bytes begin, aligned for a double.
    fn offset(bytes: usize, edge: Edge) -> usize {
        assert!(bytes + MARGIN <= ROOM, "{bytes} bytes do not fit a slot");
        match edge {
            Edge::Start => 0,
            Edge::End => (ROOM - bytes) & !7,
        }
    }

    /// An array that the library may only read.
    pub fn input<T: Copy>(&mut self, values: &[T], edge: Edge) -> *const T {
        let offset = Self::offset(size_of_val(values), edge);
        // SAFETY: both views are ROOM bytes long; the offset is aligned to 8, which is enough for every T in use.
        unsafe {
            let to = self.host.add(offset).cast::<T>();
            std::ptr::copy_nonoverlapping(values.as_ptr(), to, values.len());
            self.read.add(offset).cast()
        }
    }

    /// An array that the library may write, holding `values`.
    pub fn output<T: Copy>(&mut self, values: &[T], edge: Edge) -> Output<T> {
        let mut output = self.room(values.len(), edge);
        output.values_mut().copy_from_slice(values);
        output
    }

    /// An array of doubles that the library may write, holding the canary.
    pub fn canaries(&mut self, length: usize, edge: Edge) -> Output<f64> {
        let mut output = self.room(length, edge);
        output.values_mut().fill(f64::from_bits(CANARY));
        output
    }

    fn room<T: Copy>(&mut self, length: usize, edge: Edge) -> Output<T> {
        let bytes = length * size_of::<T>();
        let offset = Self::offset(bytes, edge);
        let (before, after) = match edge {
            Edge::End => (MARGIN.min(offset), ROOM - offset - bytes),
            Edge::Start => (0, MARGIN),
        };
        // SAFETY: offset + bytes + margins stay within the ROOM bytes of the view.
        let pointer = unsafe {
            let pointer = self.host.add(offset);
            std::ptr::write_bytes(pointer.sub(before), MARGIN_BYTE, before);
            std::ptr::write_bytes(pointer.add(bytes), MARGIN_BYTE, after);
            pointer.cast()
        };
        Output {
            pointer,
            length,
            margins: (before, after),
        }
    }
}

/// An array that the library may write, until its slot is reused.
#[derive(Clone, Copy)]
pub struct Output<T> {
    /// What the library gets.
    pub pointer: *mut T,
    length: usize,
    margins: (usize, usize),
}

impl<T: Copy> Output<T> {
    /// What stands there.
    pub fn values(&self) -> &[T] {
        // SAFETY: `length` entries of a slot, which stays; the library is not running.
        unsafe { std::slice::from_raw_parts(self.pointer, self.length) }
    }

    /// The same, to be changed before a call.
    pub fn values_mut(&mut self) -> &mut [T] {
        // SAFETY: `length` entries of a slot, which stays; the library is not running.
        unsafe { std::slice::from_raw_parts_mut(self.pointer, self.length) }
    }

    /// Whether nothing was written right before or behind the array.
    pub fn check_margins(&self, name: &str) -> std::result::Result<(), String> {
        let (before, after) = self.margins;
        let start = self.pointer.cast::<u8>();
        // SAFETY: the margins lie in the slot, see `room`.
        let (low, high) = unsafe {
            let end = start.add(self.length * size_of::<T>());
            (
                std::slice::from_raw_parts(start.sub(before), before),
                std::slice::from_raw_parts(end, after),
            )
        };
        let intact = |bytes: &[u8]| bytes.iter().all(|&byte| byte == MARGIN_BYTE);
        match (intact(low), intact(high)) {
            (true, true) => Ok(()),
            (false, _) => Err(format!("{name}: written before the array")),
            (_, false) => Err(format!("{name}: written behind the array")),
        }
    }
}

/// Maps the file between two pages that cannot be touched.
fn view(file: BorrowedFd<'_>, protection: ProtFlags) -> Result<*mut u8> {
    let page = rustix::param::page_size();
    // SAFETY: new address space; the file is mapped inside of what was just reserved.
    unsafe {
        let all = ROOM + 2 * page;
        let reserved = mmap_anonymous(null_mut(), all, ProtFlags::empty(), MapFlags::PRIVATE)?;
        let inside = reserved.cast::<u8>().add(page).cast::<c_void>();
        let flags = MapFlags::SHARED | MapFlags::FIXED;
        Ok(mmap(inside, ROOM, protection, flags, file, 0)?.cast())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_views_show_the_same() {
        let mut slot = Slot::new().expect("pages");
        for edge in [Edge::End, Edge::Start] {
            let values = [1.0, 2.0, 3.0];
            let read = slot.input(&values, edge);
            // SAFETY: just made, three entries.
            let seen = unsafe { std::slice::from_raw_parts(read, 3) };
            assert_eq!(seen, values);
        }
    }

    #[test]
    fn margins_notice() {
        let mut slot = Slot::new().expect("pages");
        for (edge, beside) in [(Edge::End, -1), (Edge::Start, 3)] {
            let output = slot.canaries(3, edge);
            assert_eq!(output.check_margins("f"), Ok(()));
            // SAFETY: inside the slot, in its margin.
            unsafe { *output.pointer.offset(beside) = 0.0 };
            assert!(output.check_margins("f").is_err());
        }
    }
}
