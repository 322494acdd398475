//! The C library of a single declared element.
#![no_std]

contact_elements::contact_elements! {
    export one;
    /// Point against a bilinear facet.
    element OnePointQuad4 { slave: point; master: Quad4; normal: Penalty; }
}

/// The kernels have no panicking path; the linker finds no caller and leaves this out.
#[cfg(not(test))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

// The precompiled core names an unwinding routine that nothing calls: no panic exists, and a panic would abort.
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
core::arch::global_asm!(
    ".weak rust_eh_personality",
    ".hidden rust_eh_personality",
    "rust_eh_personality:",
    "ret"
);
