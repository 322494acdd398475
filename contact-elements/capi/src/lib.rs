//! The C library: the built-in elements behind the symbols of `contact_elements.h`.
#![no_std]

use contact_elements::elements::*;

contact_macros::library_export!(cte);

/// The kernels have no panicking path; the linker finds no caller and leaves this out.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
