//! One element: what the emitted code says about it, and the kernels that evaluate it.
//!
//! | file | question |
//! |---|---|
//! | `traits` | what does the emitted code provide |
//! | `receiver` | inputs other than the nodes, and the outputs |
//! | `kernel`, `gather` | where do nodes and scratch come from |
//! | `pass` | what do all steps of an evaluation work on |
//! | `driver` | in which order are the points evaluated |
//! | `classify` | open, outside, closed, or why not |
//! | `edge_side` | on which side are the edges of solids |
//! | `sliding`, `rolling`, `angle`, `multiplier` | what do friction, moments, the angle of curves, a multiplier add |
//! | `contraction`, `tangential_contraction`, `rows` | from the coefficients of a point to rows of K |

pub(crate) mod angle;
pub(crate) mod classify;
pub(crate) mod contraction;
#[cfg(test)]
mod contraction_tests;
pub(crate) mod driver;
pub(crate) mod edge_side;
pub(crate) mod gather;
pub(crate) mod kernel;
pub(crate) mod multiplier;
pub(crate) mod pass;
pub(crate) mod receiver;
pub(crate) mod rolling;
pub(crate) mod rows;
pub(crate) mod sliding;
pub(crate) mod stage;
pub(crate) mod tangential_contraction;
pub(crate) mod traits;
