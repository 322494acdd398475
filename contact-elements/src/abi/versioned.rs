//! Structs that begin with their size.

/// A struct whose first field is its size as the caller compiled it.
///
/// # Safety
/// The type is `repr(C)` and begins with a `u32`.
pub(super) unsafe trait Versioned {
    /// Its size in interface 0.1, whose fields stood elsewhere. No later version may have this size.
    const SIZE_IN_0_1: usize;
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
