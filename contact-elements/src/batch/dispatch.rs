//! Which lanes evaluate a batch.

use crate::batch::block::ROOM;
use crate::batch::contacts::Contacts;
#[cfg(target_arch = "x86_64")]
use crate::batch::evaluate::evaluate;
use crate::element::traits::Element;
use crate::lanes::Width;
#[cfg(target_arch = "x86_64")]
use crate::lanes::{Eight, Four};

/// Evaluates all contacts in lanes. `width` is at most the widest of the processor.
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

/// Evaluates all contacts by the kernel of a single call.
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
