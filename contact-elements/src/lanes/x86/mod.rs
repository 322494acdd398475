//! Lanes of x86-64: four with AVX2, eight with AVX-512.
//!
//! A value of a type exists only in a kernel that the dispatch of the batch chose for a processor with these
//! instructions: that is the reason of every `unsafe` here.

/// An expression of intrinsics.
macro_rules! lanes {
    ($intrinsics:expr) => {
        // SAFETY: the kernel was chosen for a processor with these instructions, see the module.
        unsafe { $intrinsics }
    };
}

pub(crate) use lanes;

mod eight;
mod four;

pub use eight::Eight;
pub use four::Four;
