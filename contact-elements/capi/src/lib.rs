//! The C library: the built-in elements behind the symbols of `contact_elements.h`.
#![cfg_attr(not(feature = "threads"), no_std)]

use contact_library::*;

contact_macros::library_export!(cte);

/// The kernels have no panicking path; the linker finds no caller and leaves this out.
#[cfg(not(any(test, feature = "threads")))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

// The precompiled core names an unwinding routine that nothing calls: no panic exists, and a panic would abort.
// The stub is weak and hidden, so that it neither leaves this library nor clashes with one of the host.
#[cfg(all(
    not(feature = "threads"),
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
core::arch::global_asm!(
    ".weak rust_eh_personality",
    ".hidden rust_eh_personality",
    "rust_eh_personality:",
    "ret"
);
