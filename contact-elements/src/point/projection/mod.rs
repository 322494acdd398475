//! Closest point projection. [eq:projection]
//!
//! | file | content |
//! |---|---|
//! | `newton` | Newton's method, and who decides where it finds no stationary point |
//! | `step` | one step of it |
//! | `extent` | how far a step may go |
//! | `constrained` | the search within the parameter domain |
//! | `foot` | where a projection ends |

pub(crate) mod constrained;
pub(crate) mod extent;
pub(crate) mod foot;
pub(crate) mod newton;
pub(crate) mod step;
