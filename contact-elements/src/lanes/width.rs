//! How many lanes the processor has, queried once.

/// Lanes of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// One contact after another: the kernel of a single call.
    One,
    /// Four: AVX2.
    Four,
    /// Eight: AVX-512 with its instructions for double words.
    Eight,
}

impl Width {
    /// The widest of this processor.
    #[cfg(target_arch = "x86_64")]
    #[inline]
    pub fn widest() -> Self {
        use core::sync::atomic::{AtomicU8, Ordering};
        static KNOWN: AtomicU8 = AtomicU8::new(0);
        match KNOWN.load(Ordering::Relaxed) {
            1 => Width::One,
            2 => Width::Four,
            3 => Width::Eight,
            _ => {
                let width = asked();
                KNOWN.store(1 + width as u8, Ordering::Relaxed);
                width
            }
        }
    }

    /// The widest of this processor.
    #[cfg(not(target_arch = "x86_64"))]
    #[inline]
    pub fn widest() -> Self {
        Width::One
    }
}

#[cfg(target_arch = "x86_64")]
#[cold]
fn asked() -> Width {
    use core::arch::x86_64::{__cpuid, __cpuid_count, _xgetbv};
    const OSXSAVE_AND_AVX: u32 = 1 << 27 | 1 << 28;
    const AVX2: u32 = 1 << 5;
    const AVX512: u32 = 1 << 16 | 1 << 17 | 1 << 30 | 1 << 31; // F, DQ, BW, VL

    /// # Safety
    /// The processor has XGETBV.
    #[target_feature(enable = "xsave")]
    unsafe fn kept_registers() -> u64 {
        // SAFETY: promised by the caller.
        unsafe { _xgetbv(0) }
    }
    #[allow(unused_unsafe)]
    // SAFETY: every x86-64 has CPUID; XGETBV only where OSXSAVE says so.
    unsafe {
        if __cpuid(0).eax < 7 || __cpuid(1).ecx & OSXSAVE_AND_AVX != OSXSAVE_AND_AVX {
            return Width::One;
        }
        let (kept, more) = (kept_registers(), __cpuid_count(7, 0).ebx);
        if kept & 0b110 != 0b110 || more & AVX2 == 0 {
            Width::One
        } else if kept & 0b1110_0110 != 0b1110_0110 || more & AVX512 != AVX512 {
            Width::Four
        } else {
            Width::Eight
        }
    }
}
