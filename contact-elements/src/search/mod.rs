//! Global closest point: the least of ½ r·r over the whole domain, found without a start and certified.
//! [eq:global-projection]
//!
//! Boxes of parameters are dropped where the distance, bounded by interval arithmetic over the tables of the
//! geometries, is larger than one already found, or where it falls towards another box. Where F is positive definite over a
//! box it has one minimum, which Newton's method finds. What is left at the end is the closest point, with proof.

mod boxes;
mod closest;
mod descent;
mod enclosure;
mod gathered;
mod interval;
mod pair;
mod region;
mod spread;
mod whole;

pub use closest::{Closest, MOST_BOXES, Verdict};
pub(crate) use gathered::Gathered;
pub(crate) use spread::spread;
pub(crate) use whole::{closest, declared};
