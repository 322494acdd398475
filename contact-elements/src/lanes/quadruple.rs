//! Four numbers side by side, for the vectors over all unknowns: with AVX2 in one register, else on x86-64 in two,
//! elsewhere an array.
//!
//! All ways round every product and every sum alike, so that they give the same bits.
//!
//! The unknowns of four nodes are D parts of four lanes: lane l of part i belongs to node (4 i + l) / D of the
//! four and to its component (4 i + l) % D.

#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
pub(crate) use self::avx2::Lanes;
#[cfg(not(target_arch = "x86_64"))]
pub(crate) use self::portable::Lanes;
#[cfg(all(target_arch = "x86_64", not(target_feature = "avx2")))]
pub(crate) use self::sse2::Lanes;

#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
mod avx2 {
    use core::arch::x86_64::{
        __m256d, _mm256_add_pd, _mm256_mul_pd, _mm256_permute4x64_pd, _mm256_set1_pd,
        _mm256_setr_pd, _mm256_storeu_pd,
    };

    /// Four numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Lanes(__m256d);

    // the module exists only where the whole crate is compiled for AVX2
    impl Lanes {
        #[inline(always)]
        pub(crate) fn new([a, b, c, d]: [f64; 4]) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_setr_pd(a, b, c, d) })
        }

        /// The same number four times.
        #[inline(always)]
        pub(crate) fn splat(value: f64) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_set1_pd(value) })
        }

        #[inline(always)]
        pub(crate) fn times(self, other: Self) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_mul_pd(self.0, other.0) })
        }

        #[inline(always)]
        pub(crate) fn scaled(self, factor: f64) -> Self {
            self.times(Self::splat(factor))
        }

        #[inline(always)]
        pub(crate) fn plus(self, other: Self) -> Self {
            // SAFETY: AVX2 is there.
            Self(unsafe { _mm256_add_pd(self.0, other.0) })
        }

        #[inline(always)]
        pub(crate) fn store(self, to: &mut [f64; 4]) {
            // SAFETY: AVX2 is there, and the array has four places.
            unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
        }

        /// One number per node to the lanes of a part.
        #[inline(always)]
        pub(crate) fn of_nodes<const D: usize>(self, part: usize) -> Self {
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
        pub(crate) fn of_components<const D: usize>(self, part: usize) -> Self {
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

#[cfg(all(target_arch = "x86_64", not(target_feature = "avx2")))]
mod sse2 {
    use core::arch::x86_64::{
        __m128d, _mm_add_pd, _mm_mul_pd, _mm_set1_pd, _mm_setr_pd, _mm_shuffle_pd, _mm_storeu_pd,
    };

    /// Four numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Lanes(__m128d, __m128d);

    // every x86-64 has SSE2
    impl Lanes {
        #[inline(always)]
        pub(crate) fn new([a, b, c, d]: [f64; 4]) -> Self {
            // SAFETY: SSE2 is there.
            unsafe { Self(_mm_setr_pd(a, b), _mm_setr_pd(c, d)) }
        }

        /// The same number four times.
        #[inline(always)]
        pub(crate) fn splat(value: f64) -> Self {
            // SAFETY: SSE2 is there.
            let both = unsafe { _mm_set1_pd(value) };
            Self(both, both)
        }

        #[inline(always)]
        pub(crate) fn times(self, other: Self) -> Self {
            // SAFETY: SSE2 is there.
            unsafe { Self(_mm_mul_pd(self.0, other.0), _mm_mul_pd(self.1, other.1)) }
        }

        #[inline(always)]
        pub(crate) fn scaled(self, factor: f64) -> Self {
            self.times(Self::splat(factor))
        }

        #[inline(always)]
        pub(crate) fn plus(self, other: Self) -> Self {
            // SAFETY: SSE2 is there.
            unsafe { Self(_mm_add_pd(self.0, other.0), _mm_add_pd(self.1, other.1)) }
        }

        #[inline(always)]
        pub(crate) fn store(self, to: &mut [f64; 4]) {
            let [first, second, rest @ ..] = to.as_chunks_mut::<2>().0 else {
                return;
            };
            debug_assert!(rest.is_empty());
            // SAFETY: SSE2 is there, and each array has two places.
            unsafe {
                _mm_storeu_pd(first.as_mut_ptr(), self.0);
                _mm_storeu_pd(second.as_mut_ptr(), self.1);
            }
        }

        /// One number per node to the lanes of a part.
        #[inline(always)]
        pub(crate) fn of_nodes<const D: usize>(self, part: usize) -> Self {
            let Self(low, high) = self;
            match (D, part) {
                (3, 0) => Self(pair::<0b00>(low, low), pair::<0b10>(low, low)),
                (3, 1) => Self(pair::<0b11>(low, low), pair::<0b00>(high, high)),
                (3, 2) => Self(pair::<0b10>(high, high), pair::<0b11>(high, high)),
                (2, 0) => Self(pair::<0b00>(low, low), pair::<0b11>(low, low)),
                (2, 1) => Self(pair::<0b00>(high, high), pair::<0b11>(high, high)),
                _ => self,
            }
        }

        /// The components of one D-vector to the lanes of a part.
        #[inline(always)]
        pub(crate) fn of_components<const D: usize>(self, part: usize) -> Self {
            let Self(low, high) = self;
            match (D, part) {
                (3, 0) => Self(low, pair::<0b00>(high, low)),
                (3, 1) => Self(pair::<0b01>(low, high), low),
                (3, 2) => Self(pair::<0b00>(high, low), pair::<0b01>(low, high)),
                (2, _) => Self(low, low),
                _ => Self(pair::<0b00>(low, low), pair::<0b00>(low, low)),
            }
        }
    }

    /// One number of `a`, one of `b`: the second of it where its bit is set.
    #[inline(always)]
    fn pair<const WHICH: i32>(a: __m128d, b: __m128d) -> __m128d {
        // SAFETY: SSE2 is there.
        unsafe { _mm_shuffle_pd::<WHICH>(a, b) }
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod portable {
    /// Four numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Lanes([f64; 4]);

    impl Lanes {
        #[inline(always)]
        pub(crate) fn new(values: [f64; 4]) -> Self {
            Self(values)
        }

        /// The same number four times.
        #[inline(always)]
        pub(crate) fn splat(value: f64) -> Self {
            Self([value; 4])
        }

        #[inline(always)]
        pub(crate) fn times(self, other: Self) -> Self {
            Self(core::array::from_fn(|l| self.0[l] * other.0[l]))
        }

        #[inline(always)]
        pub(crate) fn scaled(self, factor: f64) -> Self {
            self.times(Self::splat(factor))
        }

        #[inline(always)]
        pub(crate) fn plus(self, other: Self) -> Self {
            Self(core::array::from_fn(|l| self.0[l] + other.0[l]))
        }

        #[inline(always)]
        pub(crate) fn store(self, to: &mut [f64; 4]) {
            *to = self.0;
        }

        /// One number per node to the lanes of a part.
        #[inline(always)]
        pub(crate) fn of_nodes<const D: usize>(self, part: usize) -> Self {
            Self(core::array::from_fn(|l| self.0[((4 * part + l) / D) % 4]))
        }

        /// The components of one D-vector to the lanes of a part.
        #[inline(always)]
        pub(crate) fn of_components<const D: usize>(self, part: usize) -> Self {
            Self(core::array::from_fn(|l| self.0[((4 * part + l) % D) % 4]))
        }
    }
}
