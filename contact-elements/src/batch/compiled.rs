//! What is compiled once for all elements with the same number of nodes, for the instructions of each lane type.

use crate::batch::block::{Points, Records};
use crate::batch::contacts::Contacts;
#[cfg(target_arch = "x86_64")]
use crate::batch::outputs::write;
#[cfg(target_arch = "x86_64")]
use crate::batch::positions::positions;
use crate::lanes::Wide;
#[cfg(target_arch = "x86_64")]
use crate::lanes::{Eight, Four, lanes};

/// Lanes of a batch.
pub(crate) trait BatchLanes: Wide {
    /// [`write`](crate::batch::outputs::write), compiled for these lanes.
    fn write<C: Contacts, const D: usize, const P: usize, const N: usize>(
        points: &Points<'_>,
        contacts: &mut C,
        numbers: &[usize],
        records: &Records<N>,
    );

    /// [`positions`](crate::batch::positions::positions), compiled for these lanes.
    fn positions<C: Contacts, const D: usize, const N: usize>(
        contacts: &C,
        vectors: &[bool; N],
        numbers: &[usize; 8],
        x: &mut [[Self; D]; N],
    ) -> u32;
}

/// Both for the lanes of one type.
#[cfg(target_arch = "x86_64")]
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

#[cfg(target_arch = "x86_64")]
impl BatchLanes for Four {
    compiled!(Four, "avx2");
}

#[cfg(target_arch = "x86_64")]
impl BatchLanes for Eight {
    compiled!(Eight, "avx512f,avx512dq,avx512bw,avx512vl");
}
