//! Lanes of x86-64: four with AVX2, eight with AVX-512.
//!
//! A value of a type exists only in a kernel that [`dispatch`](super::dispatch) chose for a processor with these
//! instructions: that is the reason of every `unsafe` here.

mod eight;
mod four;

pub use eight::Eight;
pub use four::Four;

/// An expression of intrinsics.
macro_rules! lanes {
    ($intrinsics:expr) => {
        // SAFETY: the kernel was chosen for a processor with these instructions, see the module.
        unsafe { $intrinsics }
    };
}

/// What [`Wide`](super::wide::Wide) compiles for the instructions of its lanes.
macro_rules! compiled {
    ($lanes:ident, $instructions:literal) => {
        #[inline(always)]
        fn write<C: Contacts, const D: usize, const P: usize, const N: usize>(
            points: &Points<'_>,
            contacts: &mut C,
            numbers: &[usize],
            records: &Records<N>,
        ) {
            #[target_feature(enable = $instructions)]
            #[inline(never)]
            fn compiled<C: Contacts, const D: usize, const P: usize, const N: usize>(
                points: &Points<'_>,
                contacts: &mut C,
                numbers: &[usize],
                records: &Records<N>,
            ) {
                write::<C, $lanes, D, P, N>(points, contacts, numbers, records);
            }
            lanes!(compiled::<C, D, P, N>(points, contacts, numbers, records))
        }

        #[inline(always)]
        fn positions<C: Contacts, const D: usize, const N: usize>(
            contacts: &C,
            vectors: &[bool; N],
            numbers: &[usize; 8],
            x: &mut [[Self; D]; N],
        ) -> u32 {
            #[target_feature(enable = $instructions)]
            #[inline(never)]
            fn compiled<C: Contacts, const D: usize, const N: usize>(
                contacts: &C,
                vectors: &[bool; N],
                numbers: &[usize; 8],
                x: &mut [[$lanes; D]; N],
            ) -> u32 {
                positions::<C, $lanes, D, N>(contacts, vectors, numbers, x)
            }
            lanes!(compiled::<C, D, N>(contacts, vectors, numbers, x))
        }
    };
}
use {compiled, lanes};
