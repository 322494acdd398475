//! Four numbers side by side, for the vectors over all unknowns: with AVX2 in one register, elsewhere an array.
//!
//! Both ways round every product and every sum alike, so that they give the same bits.
//!
//! The unknowns of four nodes are D parts of four lanes: lane l of part i belongs to node (4 i + l) / D of the
//! four and to its component (4 i + l) % D.

#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
pub(super) use self::avx2::Lanes;
#[cfg(not(all(target_arch = "x86_64", target_feature = "avx2")))]
pub(super) use self::portable::Lanes;

#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
mod avx2 {
    use core::arch::x86_64::{
        __m256d, _mm256_add_pd, _mm256_mul_pd, _mm256_permute4x64_pd, _mm256_set1_pd,
        _mm256_setr_pd, _mm256_storeu_pd,
    };

    /// Four numbers.
    #[derive(Clone, Copy)]
    pub(in crate::runtime) struct Lanes(__m256d);

    // the module exists only where the whole crate is compiled for AVX2
    impl Lanes {
        #[inline(always)]
        pub(in crate::runtime) fn new([a, b, c, d]: [f64; 4]) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_setr_pd(a, b, c, d) })
        }

        /// The same number four times.
        #[inline(always)]
        pub(in crate::runtime) fn splat(value: f64) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_set1_pd(value) })
        }

        #[inline(always)]
        pub(in crate::runtime) fn times(self, other: Self) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_mul_pd(self.0, other.0) })
        }

        #[inline(always)]
        pub(in crate::runtime) fn plus(self, other: Self) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_add_pd(self.0, other.0) })
        }

        #[inline(always)]
        pub(in crate::runtime) fn store(self, to: &mut [f64; 4]) {
            // SAFETY: AVX2 is there, and the array has four places.
            unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
        }

        /// One number per node to the lanes of a part.
        #[inline(always)]
        pub(in crate::runtime) fn of_nodes<const D: usize>(self, part: usize) -> Self {
            match (D, part) {
                (3, 0) => self.permuted::<0b01_00_00_00>(),
                (3, 1) => self.permuted::<0b10_10_01_01>(),
                (3, 2) => self.permuted::<0b11_11_11_10>(),
                (2, 0) => self.permuted::<0b01_01_00_00>(),
                (2, 1) => self.permuted::<0b11_11_10_10>(),
                _ => self,
            }
        }

        /// The components of one D-vector to the lanes of a part.
        #[inline(always)]
        pub(in crate::runtime) fn of_components<const D: usize>(self, part: usize) -> Self {
            match (D, part) {
                (3, 0) => self.permuted::<0b00_10_01_00>(),
                (3, 1) => self.permuted::<0b01_00_10_01>(),
                (3, 2) => self.permuted::<0b10_01_00_10>(),
                (2, _) => self.permuted::<0b01_00_01_00>(),
                _ => self.permuted::<0>(),
            }
        }

        #[inline(always)]
        fn permuted<const ORDER: i32>(self) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_permute4x64_pd::<ORDER>(self.0) })
        }
    }
}

#[cfg(not(all(target_arch = "x86_64", target_feature = "avx2")))]
mod portable {
    /// Four numbers.
    #[derive(Clone, Copy)]
    pub(in crate::runtime) struct Lanes([f64; 4]);

    impl Lanes {
        #[inline(always)]
        pub(in crate::runtime) fn new(values: [f64; 4]) -> Self {
            Self(values)
        }

        /// The same number four times.
        #[inline(always)]
        pub(in crate::runtime) fn splat(value: f64) -> Self {
            Self([value; 4])
        }

        #[inline(always)]
        pub(in crate::runtime) fn times(self, other: Self) -> Self {
            Self(core::array::from_fn(|l| self.0[l] * other.0[l]))
        }

        #[inline(always)]
        pub(in crate::runtime) fn plus(self, other: Self) -> Self {
            Self(core::array::from_fn(|l| self.0[l] + other.0[l]))
        }

        #[inline(always)]
        pub(in crate::runtime) fn store(self, to: &mut [f64; 4]) {
            *to = self.0;
        }

        /// One number per node to the lanes of a part.
        #[inline(always)]
        pub(in crate::runtime) fn of_nodes<const D: usize>(self, part: usize) -> Self {
            Self(core::array::from_fn(|l| self.0[((4 * part + l) / D) % 4]))
        }

        /// The components of one D-vector to the lanes of a part.
        #[inline(always)]
        pub(in crate::runtime) fn of_components<const D: usize>(self, part: usize) -> Self {
            Self(core::array::from_fn(|l| self.0[((4 * part + l) % D) % 4]))
        }
    }
}
