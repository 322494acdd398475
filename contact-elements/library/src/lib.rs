//! The built-in elements: types in the order of their indices, and the lists of all of them.
//!
//! Two crates have them, which are compiled side by side, each as one unit of code. A crate with elements of its own
//! needs `contact-elements` alone.
#![no_std]

#[doc(inline)]
pub use contact_library_basic::*;
#[doc(inline)]
pub use contact_library_extended::*;

contact_macros::library!(lists);
