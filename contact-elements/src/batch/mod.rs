//! Many contacts of one element in lanes: first gather, projection and gap of all, then law and coefficients of the closed
//! ones, then the outputs contact after contact.
//!
//! | file | question |
//! |---|---|
//! | `contacts` | what does the host say about its contacts |
//! | `dispatch`, `evaluate` | which lanes, which contacts at once |
//! | `block` | where the values of some contacts stand |
//! | `screen` | which contacts are open wherever their projection lies |
//! | `inputs`, `positions` | what do the host's arrays hold |
//! | `newton` | where is the projection |
//! | `point` | is a contact open, outside, closed or to be evaluated alone |
//! | `closed` | what are law and coefficients of the closed ones |
//! | `outputs` | what reaches the receiver, in the order of the contacts |
//! | `compiled` | what is compiled once for all elements of so many nodes |
//!
//! Each lane has the bits of the scalar evaluation: the same operations in the same order, and none is fused. The kernel of
//! a single call evaluates the contacts that leave the common path.

pub(crate) mod block;
mod closed;
mod compiled;
pub(crate) mod contacts;
pub(crate) mod dispatch;
mod evaluate;
mod inputs;
mod newton;
mod outputs;
mod point;
mod positions;
pub(crate) mod screen;
