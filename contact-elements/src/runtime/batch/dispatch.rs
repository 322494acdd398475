//! How many lanes the processor has, asked once.

use super::Contacts;
use super::block::ROOM;
#[cfg(target_arch = "x86_64")]
use super::evaluate;
use crate::runtime::element::Element;

#[cfg(target_arch = "x86_64")]
use super::x86::{Eight, Four};

/// Lanes of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// One contact after the other: the kernel of one.
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

/// Evaluates all contacts in lanes; `width`: at most the widest of the processor.
pub fn evaluate_batch<
    E: Element<D, P, H>,
    C: Contacts,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &mut C,
    width: Width,
    vectors: &[bool; N],
) {
    match width.min(Width::widest()) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: the processor has AVX2.
        Width::Four | Width::Eight if N * D < 8 => unsafe {
            four::<E, C, D, P, H, N>(contacts, vectors)
        },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: the processor has AVX2.
        Width::Four => unsafe { four::<E, C, D, P, H, N>(contacts, vectors) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: the processor has AVX-512.
        Width::Eight => unsafe { eight::<E, C, D, P, H, N>(contacts, vectors) },
        _ => one_by_one(contacts),
    }
}

/// Evaluates all contacts by the kernel of one.
#[inline]
pub fn one_by_one<C: Contacts>(contacts: &mut C) {
    let mut numbers = [0; ROOM];
    while let length @ 1.. = contacts.next(&mut numbers) {
        for &number in numbers.iter().take(length) {
            contacts.evaluate_alone(number);
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn four<
    E: Element<D, P, H>,
    C: Contacts,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &mut C,
    vectors: &[bool; N],
) {
    evaluate::<E, C, Four, D, P, H, N>(contacts, vectors);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn eight<
    E: Element<D, P, H>,
    C: Contacts,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &mut C,
    vectors: &[bool; N],
) {
    evaluate::<E, C, Eight, D, P, H, N>(contacts, vectors);
}
