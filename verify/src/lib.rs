//! Independent proof of the contact elements.
//!
//! - [`oracle`]: residual and tangent of a contact pair from nothing but its declared geometry
//!   and law, differentiated by dual and hyper-dual numbers;
//! - [`configurations`]: reproducible random states and explicit edge cases to compare on;
//! - [`subject`]: the elements under test, and which oracle pair each is;
//! - [`interpret`]: the programs of an element, interpreted from their tables;
//! - [`proof`]: what is compared; [`tolerance`]: how closely, and why;
//! - [`certify`]: all of it for a list of elements; [`certificate`]: the result, for people and machines.
//!
//! The first two share no formula, table or helper with the code generator.
#![forbid(unsafe_code)]

mod catalogue;
pub mod certificate;
pub mod certify;
pub mod configurations;
pub mod interpret;
pub mod measure;
pub mod oracle;
pub mod pages;
pub mod progress;
pub mod proof;
pub mod subject;
pub mod tolerance;
