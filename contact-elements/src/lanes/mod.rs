//! Numbers side by side: what the emitted programs compute with, and the instructions for it.
//!
//! | file | content |
//! |---|---|
//! | `real` | what a number must offer to the emitted programs |
//! | `wide`, `x86` | several numbers, one per contact |
//! | `width` | how many of them this processor has |
//! | `quadruple` | four numbers for vectors over all unknowns of one contact |

mod quadruple;
mod real;
mod wide;
mod width;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use quadruple::Lanes;
pub use real::Real;
pub use wide::{Quad, Wide};
pub use width::Width;
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Eight, Four, lanes};
