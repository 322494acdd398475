//! The built-in elements: types in the order of their indices, and the lists of all of them.
//!
//! They live in two crates that are compiled side by side, each as one unit of code. A crate with its own elements
//! needs only `contact-elements`.
#![no_std]

#[doc(inline)]
pub use contact_library_basic::*;
#[doc(inline)]
pub use contact_library_extended::*;

contact_macros::library!(lists);
