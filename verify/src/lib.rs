//! Independent proof of the contact elements.
//!
//! - [`oracle`]: residual and tangent of a contact pair from nothing but its declared geometry
//!   and law, differentiated by dual and hyper-dual numbers;
//! - [`configurations`]: reproducible random states and explicit edge cases to compare on.
//!
//! Nothing in these two modules shares a formula, a table or a helper with the code generator.
#![forbid(unsafe_code)]

pub mod configurations;
pub mod oracle;
